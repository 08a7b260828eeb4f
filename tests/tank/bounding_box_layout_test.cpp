// The rule that lays out unknown meshes, held to the two tanks whose layouts are known.
#include "tank/bounding_box_layout.h"

#include "tank/original_layout.h"
#include "tank/part_matrices.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace tank {
namespace {

glm::vec3 middle_of(const Box& box)
{
    return 0.5f * (box.minimum + box.maximum);
}

/// Returns the middle of a part's box in the assembled tank, from the middle of the body's.
glm::vec3 middle_from_body(const Layout& layout, const MeshBoxes& boxes, Part part)
{
    const PartMatrices matrices = part_matrices(layout, {}, {});
    const auto place = [&](Part of) {
        return glm::vec3(matrices.mesh(of) * glm::vec4(middle_of(box_of(boxes, layout[of].mesh)), 1.0f));
    };
    return place(part) - place(Part::body);
}

/// Expects that the rule puts every part near where the known layout has it. tolerance: of the body's length.
void expect_near(const Layout& known, const MeshBoxes& boxes, const TurretRoof& roof, double tolerance)
{
    const Layout found = bounding_box_layout(boxes, roof);
    const double length = length_of(box_of(boxes, MeshKind::body));
    for (Part part : ALL_PARTS) {
        const glm::vec3 off = middle_from_body(found, boxes, part) - middle_from_body(known, boxes, part);
        EXPECT_LT(glm::length(off), tolerance * length)
            << part_name(part) << ": " << off.x << ", " << off.y << ", " << off.z;
        EXPECT_EQ(found[part].parent, known[part].parent);
        EXPECT_EQ(found[part].axis, known[part].axis);
        EXPECT_NEAR(found[part].mesh_yaw, known[part].mesh_yaw, 1e-12) << part_name(part);
    }
}

TEST(BoundingBoxLayoutTest, PutsOurPartsWhereTheyBelong)
{
    const TurretRoof roof = [](float, float) { return std::optional(0.95f); };
    expect_near(default_layout(), default_boxes(), roof, 0.05);
}

TEST(BoundingBoxLayoutTest, PutsTheLabsPartsWhereTheyBelong)
{
    const TurretRoof roof = [](float, float) { return std::optional(15.0f); };
    expect_near(original_layout(roof), original_boxes(), roof, 0.05);
}

TEST(BoundingBoxLayoutTest, DoesNotCareWhereAMeshLiesInItsFile)
{
    const TurretRoof roof = [](float, float) { return std::optional(0.95f); };
    const Layout layout = bounding_box_layout(default_boxes(), roof);
    MeshBoxes moved = default_boxes();
    for (MeshKind mesh : {MeshKind::body, MeshKind::main_gun, MeshKind::secondary_gun}) {
        const glm::vec3 shift(3.0f, -20.0f, 7.0f);
        moved[index_of(mesh)].minimum += shift;
        moved[index_of(mesh)].maximum += shift;
    }
    const Layout other = bounding_box_layout(moved, roof);
    for (Part part : ALL_PARTS) {
        EXPECT_LT(glm::distance(middle_from_body(layout, default_boxes(), part),
                                middle_from_body(other, moved, part)),
                  1e-4f)
            << part_name(part);
    }
}

TEST(BoundingBoxLayoutTest, TakesAUsualHeightWhereThereIsNoRoof)
{
    const Layout layout = bounding_box_layout(default_boxes(), [](float, float) { return std::nullopt; });
    EXPECT_NEAR(layout[Part::secondary_gun].pivot.y, 0.2f * 4.478f, 1e-4f);
}

TEST(BoundingBoxLayoutTest, PitchesTheSecondaryGunOnTheRoofAboutItsRearEndAtHalfItsHeight)
{
    const TurretRoof roof = [](float, float) { return std::optional(0.95f); };
    const MeshBoxes boxes = default_boxes();
    const Layout layout = bounding_box_layout(boxes, roof);
    const Box& box = box_of(boxes, MeshKind::secondary_gun);
    const glm::vec3 rear{middle_of(box).x, middle_of(box).y, box.minimum.z};
    const float roof_y = 0.95f + layout[Part::turret].pivot.y + layout[Part::turret].mesh_offset.y;
    for (double pitch : {0.0, 0.5, joint_limits(Joint::secondary_gun_pitch).maximum}) {
        JointAngles angles;
        angles[Joint::secondary_gun] = 0.7;
        angles[Joint::secondary_gun_pitch] = pitch;
        const glm::mat4 mesh = part_matrices(layout, {}, angles).mesh(Part::secondary_gun);
        const auto place = [&](const glm::vec3& point) { return glm::vec3(mesh * glm::vec4(point, 1.0f)); };
        const glm::vec3& pivot = layout[Part::secondary_gun].pivot;
        EXPECT_NEAR(place(rear).x, pivot.x, 1e-5f) << pitch;
        EXPECT_NEAR(place(rear).y, roof_y + 0.5f * (box.maximum.y - box.minimum.y), 1e-5f) << pitch;
        for (float y : {box.minimum.y, box.maximum.y}) {
            for (float z : {box.minimum.z, box.maximum.z}) {
                EXPECT_GE(place({rear.x, y, z}).y, roof_y - 1e-5f) << pitch;
            }
        }
    }
}

TEST(BoundingBoxLayoutTest, GivesNumbersForBoxesWithoutSize)
{
    const Layout layout = bounding_box_layout(MeshBoxes{}, [](float, float) { return std::nullopt; });
    for (Part part : ALL_PARTS) {
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_TRUE(std::isfinite(layout[part].pivot[axis]));
            EXPECT_TRUE(std::isfinite(layout[part].mesh_offset[axis]));
        }
    }
}

TEST(MeshBoxTest, ResemblesWhatDiffersInTheUnitAlone)
{
    MeshBoxes boxes = original_boxes();
    for (Box& box : boxes) {
        box = {0.1f * box.minimum, 0.1f * box.maximum};
    }
    EXPECT_TRUE(resembles(boxes, original_boxes()));
    EXPECT_FALSE(resembles(boxes, default_boxes()));
    boxes[index_of(MeshKind::wheel)].maximum.y += 0.2f;
    EXPECT_FALSE(resembles(boxes, original_boxes()));
    EXPECT_FALSE(resembles(MeshBoxes{}, original_boxes()));
}

TEST(LayoutTest, ScaledIsAsMuchLargerAndTurnsTheSame)
{
    const Layout layout = default_layout();
    const Layout doubled = scaled(layout, 2.0);
    for (Part part : ALL_PARTS) {
        EXPECT_EQ(doubled[part].pivot, 2.0f * layout[part].pivot);
        EXPECT_EQ(doubled[part].mesh_offset, 2.0f * layout[part].mesh_offset);
        EXPECT_EQ(doubled[part].axis, layout[part].axis);
        EXPECT_EQ(doubled[part].mesh_yaw, layout[part].mesh_yaw);
        ASSERT_EQ(doubled[part].second.has_value(), layout[part].second.has_value());
        if (layout[part].second) {
            EXPECT_EQ(doubled[part].second->pivot, 2.0f * layout[part].second->pivot);
            EXPECT_EQ(doubled[part].second->axis, layout[part].second->axis);
        }
    }
}

} // namespace
} // namespace tank
