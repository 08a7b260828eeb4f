#include "tank/layout.h"

#include <numbers>

namespace tank {

namespace {

constexpr glm::vec3 PLUS_X{1.0f, 0.0f, 0.0f};
constexpr glm::vec3 MINUS_X{-1.0f, 0.0f, 0.0f};
constexpr glm::vec3 PLUS_Y{0.0f, 1.0f, 0.0f};
constexpr glm::vec3 ORIGIN{0.0f, 0.0f, 0.0f};

constexpr float WHEEL_RADIUS = 0.44f;
constexpr float WHEEL_TRACK_HALF = 1.38f;
constexpr float FIRST_WHEEL_Z = 2.40f;
constexpr float WHEEL_SPACING = 0.80f;

/// Returns the placement of wheel `number` (1 = front). The wheel's mesh shows its outer face towards +X, so
/// the right ones are turned half round; the joint is not, and a positive angle rolls forward on both sides.
PartPlacement wheel(int number, bool left)
{
    const float x = left ? WHEEL_TRACK_HALF : -WHEEL_TRACK_HALF;
    const float z = FIRST_WHEEL_Z - WHEEL_SPACING * static_cast<float>(number - 1);
    return {.parent = Part::body,
            .pivot = {x, WHEEL_RADIUS, z},
            .axis = PLUS_X,
            .mesh_offset = ORIGIN,
            .mesh_yaw = left ? 0.0 : std::numbers::pi,
            .mesh = MeshKind::wheel,
            .joint = left ? Joint::wheels_left : Joint::wheels_right};
}

} // namespace

Layout default_layout()
{
    Layout layout{};
    layout[Part::body] = {.parent = Part::body,
                          .pivot = ORIGIN,
                          .axis = PLUS_Y,
                          .mesh_offset = ORIGIN,
                          .mesh_yaw = 0.0,
                          .mesh = MeshKind::body,
                          .joint = Joint::heading};
    layout[Part::turret] = {.parent = Part::body,
                            .pivot = {0.0f, 1.60f, 0.25f},
                            .axis = PLUS_Y,
                            .mesh_offset = ORIGIN,
                            .mesh_yaw = 0.0,
                            .mesh = MeshKind::turret,
                            .joint = Joint::turret};
    // The gun's mesh is modelled in the turret's coordinates, as the lab's is: its origin is not at its
    // trunnion.
    constexpr glm::vec3 TRUNNION{0.0f, 0.42f, 1.25f};
    layout[Part::main_gun] = {.parent = Part::turret,
                              .pivot = TRUNNION,
                              .axis = MINUS_X,
                              .mesh_offset = -TRUNNION,
                              .mesh_yaw = 0.0,
                              .mesh = MeshKind::main_gun,
                              .joint = Joint::main_gun};
    // The secondary gun runs round its rail, and its cradle pitches on it.
    layout[Part::secondary_gun] = {
        .parent = Part::turret,
        .pivot = {-0.55f, 0.95f, -0.35f},
        .axis = PLUS_Y,
        .mesh_offset = {0.0f, -0.27f, -0.06f},
        .mesh_yaw = 0.0,
        .mesh = MeshKind::secondary_gun,
        .joint = Joint::secondary_gun,
        .second = Turn{.pivot = {0.0f, 0.27f, 0.31f}, .axis = MINUS_X, .joint = Joint::secondary_gun_pitch}};
    for (int i = 0; i < WHEELS_PER_SIDE; ++i) {
        const auto offset = static_cast<std::size_t>(i);
        layout.parts[index_of(Part::wheel_left_1) + offset] = wheel(i + 1, true);
        layout.parts[index_of(Part::wheel_right_1) + offset] = wheel(i + 1, false);
    }
    return layout;
}

MeshBoxes default_boxes()
{
    return {{
        {{-1.780f, 0.000f, -3.765f}, {1.780f, 1.648f, 3.750f}},  // body
        {{-1.568f, -0.020f, -2.738f}, {1.568f, 2.760f, 1.740f}}, // turret
        {{-0.405f, 0.115f, 0.940f}, {0.405f, 0.725f, 6.300f}},   // main gun
        {{-0.085f, 0.180f, -0.242f}, {0.205f, 0.440f, 1.240f}},  // secondary gun
        {{-0.250f, -0.360f, -0.360f}, {0.250f, 0.360f, 0.360f}}, // wheel
    }};
}

Layout scaled(const Layout& layout, double factor)
{
    Layout result = layout;
    for (PartPlacement& placement : result.parts) {
        placement.pivot = glm::vec3(glm::dvec3(placement.pivot) * factor);
        placement.mesh_offset = glm::vec3(glm::dvec3(placement.mesh_offset) * factor);
        if (placement.second) {
            placement.second->pivot = glm::vec3(glm::dvec3(placement.second->pivot) * factor);
        }
    }
    return result;
}

} // namespace tank
