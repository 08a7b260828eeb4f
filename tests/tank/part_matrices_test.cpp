#include "tank/part_matrices.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>
#include <numbers>

namespace tank {
namespace {

using std::numbers::pi;

constexpr float TOLERANCE = 1e-6f;

glm::vec3 to_world(const glm::mat4& matrix, glm::vec3 point)
{
    return glm::vec3(matrix * glm::vec4(point, 1.0f));
}

void expect_near(glm::vec3 actual, glm::vec3 expected, std::string_view what = "")
{
    EXPECT_NEAR(actual.x, expected.x, TOLERANCE) << what;
    EXPECT_NEAR(actual.y, expected.y, TOLERANCE) << what;
    EXPECT_NEAR(actual.z, expected.z, TOLERANCE) << what;
}

bool is_wheel(Part part)
{
    return index_of(part) >= index_of(Part::wheel_left_1);
}

JointAngles with(Joint joint, double radians)
{
    JointAngles angles;
    angles[joint] = radians;
    return angles;
}

const Layout LAYOUT = default_layout();
const PartMatrices AT_REST = part_matrices(LAYOUT, {}, {});

TEST(PartMatricesTest, AtRestPartsStandAtTheSumOfTheirPivots)
{
    expect_near(to_world(AT_REST.joint(Part::body), {}), {0, 0, 0});
    expect_near(to_world(AT_REST.joint(Part::turret), {}), {0, 1.60f, 0.25f});
    expect_near(to_world(AT_REST.joint(Part::main_gun), {}), {0, 2.02f, 1.50f});
    expect_near(to_world(AT_REST.joint(Part::secondary_gun), {}), {-0.55f, 2.82f, 0.21f});
    expect_near(to_world(AT_REST.joint(Part::wheel_left_3), {}), {1.38f, 0.44f, 0.80f});
    expect_near(to_world(AT_REST.joint(Part::wheel_right_7), {}), {-1.38f, 0.44f, -2.40f});
}

TEST(PartMatricesTest, MeshOffsetsMoveMeshesAndNotJoints)
{
    // The gun's mesh is in turret coordinates: at rest its origin is the turret's.
    expect_near(to_world(AT_REST.mesh(Part::main_gun), {}), {0, 1.60f, 0.25f});
    expect_near(to_world(AT_REST.mesh(Part::secondary_gun), {}), {-0.55f, 2.55f, 0.15f});
}

TEST(PartMatricesTest, RightWheelsShowTheirOuterFacesToTheRight)
{
    expect_near(to_world(AT_REST.mesh(Part::wheel_left_1), {0.2f, 0, 0.1f}), {1.58f, 0.44f, 2.50f});
    expect_near(to_world(AT_REST.mesh(Part::wheel_right_1), {0.2f, 0, 0.1f}), {-1.58f, 0.44f, 2.30f});
}

TEST(PartMatricesTest, TurretBy90DegreesCarriesBothGunsToTheLeftAndNoWheel)
{
    const PartMatrices turned = part_matrices(LAYOUT, {}, with(Joint::turret, pi / 2.0));
    // About (0, *, 0.25): z ahead of the pivot becomes x, x becomes -z.
    expect_near(to_world(turned.joint(Part::main_gun), {}), {1.25f, 2.02f, 0.25f});
    expect_near(to_world(turned.mesh(Part::main_gun), {0, 0.42f, 5.0f}), {5.0f, 2.02f, 0.25f});
    expect_near(to_world(turned.joint(Part::secondary_gun), {}), {-0.04f, 2.82f, 0.80f});
    for (Part part : ALL_PARTS) {
        if (is_wheel(part) || part == Part::body) {
            EXPECT_EQ(turned.mesh(part), AT_REST.mesh(part)) << part_name(part);
        } else {
            EXPECT_NE(turned.mesh(part), AT_REST.mesh(part)) << part_name(part);
        }
    }
}

TEST(PartMatricesTest, HeadingCarriesEverything)
{
    const PartMatrices turned = part_matrices(LAYOUT, {}, with(Joint::heading, pi / 2.0));
    for (Part part : ALL_PARTS) {
        const glm::vec3 before = to_world(AT_REST.mesh(part), {0.1f, 0.2f, 0.3f});
        expect_near(to_world(turned.mesh(part), {0.1f, 0.2f, 0.3f}), {before.z, before.y, -before.x},
                    part_name(part));
    }
}

TEST(PartMatricesTest, TheRootMovesEverythingAndTheHeadingTurnsAboutIt)
{
    const PartMatrices moved =
        part_matrices(LAYOUT, {.position = {10, 1, -30}}, with(Joint::heading, pi / 2.0));
    expect_near(to_world(moved.joint(Part::body), {}), {10, 1, -30});
    expect_near(to_world(moved.joint(Part::wheel_left_1), {}), {12.4f, 1.44f, -31.38f});
}

TEST(PartMatricesTest, TheGunRisesAboutItsTrunnion)
{
    const PartMatrices raised = part_matrices(LAYOUT, {}, with(Joint::main_gun, 0.3));
    // Points of the mesh on the trunnion's axis stay; the muzzle goes up and back.
    for (float x : {-0.4f, 0.0f, 0.4f}) {
        const glm::vec3 on_axis{x, 0.42f, 1.25f};
        expect_near(to_world(raised.mesh(Part::main_gun), on_axis),
                    to_world(AT_REST.mesh(Part::main_gun), on_axis));
    }
    const glm::vec3 muzzle{0.0f, 0.42f, 6.25f};
    const auto up = static_cast<float>(5.0 * std::sin(0.3));
    const auto ahead = static_cast<float>(5.0 * std::cos(0.3));
    expect_near(to_world(raised.mesh(Part::main_gun), muzzle), {0, 2.02f + up, 1.50f + ahead});
    EXPECT_EQ(raised.mesh(Part::turret), AT_REST.mesh(Part::turret));
    EXPECT_EQ(raised.mesh(Part::secondary_gun), AT_REST.mesh(Part::secondary_gun));
}

TEST(PartMatricesTest, TheSecondaryGunTurnsLeftAboutItsOwnAxis)
{
    const PartMatrices turned = part_matrices(LAYOUT, {}, with(Joint::secondary_gun, pi / 2.0));
    expect_near(to_world(turned.mesh(Part::secondary_gun), {0, 0, 1}), {-0.55f + 1.25f, 2.55f, -0.10f});
    EXPECT_EQ(turned.mesh(Part::main_gun), AT_REST.mesh(Part::main_gun));
}

TEST(PartMatricesTest, TheSecondaryGunRisesAboutItsTrunnionAndNothingElseDoes)
{
    const PartMatrices raised = part_matrices(LAYOUT, {}, with(Joint::secondary_gun_pitch, 0.5));
    // The mesh's origin is below and behind its trunnion: points on that one's axis stay, the muzzle goes up.
    for (float x : {-0.1f, 0.0f, 0.1f}) {
        const glm::vec3 on_axis{x, 0.27f, 0.06f};
        expect_near(to_world(raised.mesh(Part::secondary_gun), on_axis),
                    to_world(AT_REST.mesh(Part::secondary_gun), on_axis));
    }
    const auto up = static_cast<float>(1.0 * std::sin(0.5));
    const auto ahead = static_cast<float>(1.0 * std::cos(0.5));
    expect_near(to_world(raised.mesh(Part::secondary_gun), {0.0f, 0.27f, 1.06f}),
                {-0.55f, 2.82f + up, 0.21f + ahead});
    for (Part part : ALL_PARTS) {
        if (part != Part::secondary_gun) {
            EXPECT_EQ(raised.mesh(part), AT_REST.mesh(part)) << part_name(part);
        }
    }
}

TEST(PartMatricesTest, TheSecondaryGunPitchesWithinItsYawAndNotItYawsWithinItsPitch)
{
    JointAngles angles = with(Joint::secondary_gun, pi / 2.0);
    angles[Joint::secondary_gun_pitch] = pi / 6.0;
    const PartMatrices posed = part_matrices(LAYOUT, {}, angles);
    // A metre before the trunnion: turned to the left first, and up from there; no more ahead than at rest.
    const auto up = static_cast<float>(std::sin(pi / 6.0));
    const auto left = static_cast<float>(std::cos(pi / 6.0));
    expect_near(to_world(posed.mesh(Part::secondary_gun), {0.0f, 0.27f, 1.06f}),
                {-0.55f + 0.31f + left, 2.82f + up, -0.10f});
    // The trunnion's axis has gone round with the yaw and is level, whatever the pitch.
    const glm::vec3 axis = to_world(posed.mesh(Part::secondary_gun), {1.0f, 0.27f, 0.06f}) -
                           to_world(posed.mesh(Part::secondary_gun), {0.0f, 0.27f, 0.06f});
    expect_near(axis, {0.0f, 0.0f, -1.0f});
}

TEST(PartMatricesTest, WheelsRollForwardOnBothSidesAndEachSideAlone)
{
    const PartMatrices rolled = part_matrices(LAYOUT, {}, with(Joint::wheels_left, pi / 2.0));
    // Rolling forward, the top of the wheel moves ahead.
    expect_near(to_world(rolled.joint(Part::wheel_left_2), {0, 0.3f, 0}), {1.38f, 0.44f, 1.90f});
    EXPECT_EQ(rolled.mesh(Part::wheel_right_2), AT_REST.mesh(Part::wheel_right_2));

    const PartMatrices other = part_matrices(LAYOUT, {}, with(Joint::wheels_right, pi / 2.0));
    expect_near(to_world(other.joint(Part::wheel_right_2), {0, 0.3f, 0}), {-1.38f, 0.44f, 1.90f});
    expect_near(to_world(other.mesh(Part::wheel_right_2), {0, 0.3f, 0}), {-1.38f, 0.44f, 1.90f});
    EXPECT_EQ(other.mesh(Part::wheel_left_2), AT_REST.mesh(Part::wheel_left_2));
}

TEST(PartMatricesTest, EveryMatrixIsRigid)
{
    JointAngles angles;
    for (std::size_t i = 0; i < JOINT_COUNT; ++i) {
        angles.radians[i] = 0.3 + 0.4 * static_cast<double>(i);
    }
    const PartMatrices posed = part_matrices(LAYOUT, {.position = {3, 0, 4}}, angles);
    for (Part part : ALL_PARTS) {
        for (const glm::mat4& matrix : {posed.joint(part), posed.mesh(part)}) {
            const glm::mat3 turn(matrix);
            const glm::mat3 product = glm::transpose(turn) * turn;
            for (int column = 0; column < 3; ++column) {
                for (int row = 0; row < 3; ++row) {
                    EXPECT_NEAR(product[column][row], column == row ? 1.0f : 0.0f, TOLERANCE)
                        << part_name(part);
                }
            }
            EXPECT_NEAR(glm::determinant(turn), 1.0f, TOLERANCE);
        }
    }
}

} // namespace
} // namespace tank
