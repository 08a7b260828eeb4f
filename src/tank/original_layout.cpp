#include "tank/original_layout.h"

#include <numbers>

namespace tank {

namespace {

constexpr float WHEEL_X = 24.0f;
constexpr float LOW_WHEEL_X = 26.0f;
constexpr float WHEEL_Y = -10.0f;
constexpr float FIRST_WHEEL_Z = 43.0f;
constexpr float LAST_WHEEL_Z = -57.0f;
constexpr glm::vec3 AXLE{0.0f, -0.05f, 0.385f}; ///< in the wheel's mesh

/// Returns the placement of wheel `number` (1 = front). The wheel's mesh reaches outwards along -X from its
/// hub, so the left ones are turned half round; the joint is not.
PartPlacement wheel(int number, bool left, float x)
{
    const float part = static_cast<float>(number - 1) / static_cast<float>(WHEELS_PER_SIDE - 1);
    return {.parent = Part::body,
            .pivot = {left ? x : -x, WHEEL_Y, FIRST_WHEEL_Z + part * (LAST_WHEEL_Z - FIRST_WHEEL_Z)},
            .axis = {1.0f, 0.0f, 0.0f},
            .mesh_offset = -AXLE,
            .mesh_yaw = left ? std::numbers::pi : 0.0,
            .mesh = MeshKind::wheel,
            .joint = left ? Joint::wheels_left : Joint::wheels_right};
}

Layout layout_with_wheels_at(float wheel_x, const TurretRoof& roof)
{
    const MeshBoxes boxes = original_boxes();
    Layout layout = default_layout(); // the same tree, axes and joints
    layout[Part::body].pivot = {0.0f, -box_of(boxes, MeshKind::body).minimum.y, 0.0f};
    layout[Part::turret].pivot = {0.0f, 14.0f, 0.0f};
    // The mesh belongs at (53.7, -102, 11) from the turret; the trunnion is where the gun enters it.
    constexpr glm::vec3 TRUNNION{0.0f, 7.0f, 25.0f};
    layout[Part::main_gun].pivot = TRUNNION;
    layout[Part::main_gun].mesh_offset = glm::vec3(53.7f, -102.0f, 11.0f) - TRUNNION;
    constexpr float GUN_X = -12.0f;
    constexpr float GUN_Z = -14.5f;
    const float roof_y = roof_or_usual(roof, box_of(boxes, MeshKind::turret), GUN_X, GUN_Z);
    // It pitches about its mesh's origin, which is near its rear end, but at half its height.
    const Box& gun = box_of(boxes, MeshKind::secondary_gun);
    const float half = 0.5f * (gun.maximum.y - gun.minimum.y);
    layout[Part::secondary_gun].pivot = {GUN_X, roof_y, GUN_Z};
    layout[Part::secondary_gun].second->pivot = {0.0f, half, 10.0f};
    layout[Part::secondary_gun].mesh_offset = {0.0f, -gun.minimum.y - half, 0.0f};
    for (int i = 0; i < WHEELS_PER_SIDE; ++i) {
        const auto offset = static_cast<std::size_t>(i);
        layout.parts[index_of(Part::wheel_left_1) + offset] = wheel(i + 1, true, wheel_x);
        layout.parts[index_of(Part::wheel_right_1) + offset] = wheel(i + 1, false, wheel_x);
    }
    return layout;
}

} // namespace

MeshBoxes original_boxes()
{
    return {{
        {{-39.4f, -19.0f, -92.9f}, {39.4f, 17.9f, 79.1f}}, // body
        {{-35.0f, -3.0f, -64.4f}, {35.5f, 92.4f, 39.6f}},  // turret, with two whip antennas
        {{-59.9f, 102.6f, 9.5f}, {-47.1f, 116.2f, 97.4f}}, // main gun
        {{-3.1f, 0.3f, -2.6f}, {3.5f, 9.0f, 34.2f}},       // secondary gun
        {{-14.0f, -7.5f, -7.0f}, {0.9f, 7.4f, 7.8f}},      // wheel
    }};
}

Layout original_layout(const TurretRoof& roof)
{
    return layout_with_wheels_at(WHEEL_X, roof);
}

Layout original_low_layout(const TurretRoof& roof)
{
    return layout_with_wheels_at(LOW_WHEEL_X, roof);
}

} // namespace tank
