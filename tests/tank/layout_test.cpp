#include "tank/layout.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <vector>

namespace tank {
namespace {

std::vector<Part> children(const Layout& layout, Part parent)
{
    std::vector<Part> found;
    for_each_child(layout, parent, [&found](Part child) { found.push_back(child); });
    return found;
}

void walk(const Layout& layout, Part part, std::vector<Part>& visited)
{
    visited.push_back(part);
    for_each_child(layout, part, [&](Part child) { walk(layout, child, visited); });
}

TEST(LayoutTest, BodyCarriesTurretAndWheels)
{
    const std::vector<Part> found = children(default_layout(), Part::body);
    ASSERT_EQ(found.size(), 15u);
    EXPECT_EQ(found[0], Part::turret);
    EXPECT_EQ(found[1], Part::wheel_left_1);
    EXPECT_EQ(found[14], Part::wheel_right_7);
}

TEST(LayoutTest, TurretCarriesBothGunsAndNothingElse)
{
    EXPECT_EQ(children(default_layout(), Part::turret),
              (std::vector<Part>{Part::main_gun, Part::secondary_gun}));
    EXPECT_TRUE(children(default_layout(), Part::main_gun).empty());
    EXPECT_TRUE(children(default_layout(), Part::wheel_left_1).empty());
}

TEST(LayoutTest, WalkingTheTreeVisitsEveryPartOnce)
{
    std::vector<Part> visited;
    walk(default_layout(), Part::body, visited);
    ASSERT_EQ(visited.size(), PART_COUNT);
    for (Part part : ALL_PARTS) {
        EXPECT_EQ(std::count(visited.begin(), visited.end(), part), 1) << part_name(part);
    }
}

TEST(LayoutTest, ParentsComeBeforeTheirChildren)
{
    const Layout layout = default_layout();
    EXPECT_EQ(layout[Part::body].parent, Part::body);
    for (Part part : ALL_PARTS) {
        if (part != Part::body) {
            EXPECT_LT(index_of(layout[part].parent), index_of(part)) << part_name(part);
        }
    }
}

TEST(LayoutTest, WheelsStandOnTheGroundInMirroredRows)
{
    const Layout layout = default_layout();
    for (int i = 0; i < WHEELS_PER_SIDE; ++i) {
        const auto offset = static_cast<std::size_t>(i);
        const PartPlacement& left = layout.parts[index_of(Part::wheel_left_1) + offset];
        const PartPlacement& right = layout.parts[index_of(Part::wheel_right_1) + offset];
        EXPECT_FLOAT_EQ(left.pivot.x, 1.38f);
        EXPECT_FLOAT_EQ(left.pivot.y, 0.44f);
        EXPECT_NEAR(left.pivot.z, 2.40f - 0.80f * static_cast<float>(i), 1e-6f);
        EXPECT_EQ(right.pivot, glm::vec3(-left.pivot.x, left.pivot.y, left.pivot.z));
        EXPECT_EQ(left.joint, Joint::wheels_left);
        EXPECT_EQ(right.joint, Joint::wheels_right);
        EXPECT_EQ(left.mesh, MeshKind::wheel);
        EXPECT_EQ(left.axis, right.axis);
        EXPECT_EQ(left.mesh_yaw, 0.0);
        EXPECT_NEAR(right.mesh_yaw, 3.14159265358979, 1e-12);
    }
}

TEST(LayoutTest, AxesHaveUnitLengthAlongOneCoordinate)
{
    const Layout layout = default_layout();
    for (Part part : ALL_PARTS) {
        std::vector<glm::vec3> axes = {layout[part].axis};
        if (layout[part].second) {
            axes.push_back(layout[part].second->axis);
        }
        for (const glm::vec3& axis : axes) {
            EXPECT_EQ(std::abs(axis.x) + std::abs(axis.y) + std::abs(axis.z), 1.0f) << part_name(part);
            EXPECT_EQ(glm::dot(axis, axis), 1.0f);
        }
    }
}

TEST(LayoutTest, OnlyTheSecondaryGunHasASecondJoint)
{
    const Layout layout = default_layout();
    for (Part part : ALL_PARTS) {
        EXPECT_EQ(layout[part].second.has_value(), part == Part::secondary_gun) << part_name(part);
    }
    EXPECT_EQ(layout[Part::secondary_gun].second->joint, Joint::secondary_gun_pitch);
}

} // namespace
} // namespace tank
