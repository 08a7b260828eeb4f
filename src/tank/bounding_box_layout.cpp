#include "tank/bounding_box_layout.h"

#include <cmath>
#include <numbers>

namespace tank {

namespace {

glm::vec3 middle_of(const Box& box)
{
    return 0.5f * box.minimum + 0.5f * box.maximum;
}

glm::vec3 size_of(const Box& box)
{
    return box.maximum - box.minimum;
}

/// Returns where the turret's axis meets its floor, in its mesh.
glm::vec3 turret_axis(const Box& box)
{
    const glm::vec3 middle = middle_of(box);
    const glm::vec3 size = size_of(box);
    const bool origin_is_axis = std::abs(middle.x) <= 0.25f * size.x && std::abs(middle.z) <= 0.25f * size.z;
    return {origin_is_axis ? 0.0f : middle.x, box.minimum.y,
            origin_is_axis ? 0.0f : middle.z + size.z / 9.0f};
}

void place_turret(Layout& layout, const Box& body, const Box& box)
{
    const glm::vec3 size = size_of(body);
    layout[Part::turret].pivot = {0.0f, 0.9f * size.y, size.z / 27.0f};
    layout[Part::turret].mesh_offset = -turret_axis(box);
}

void place_main_gun(Layout& layout, const Box& turret, const Box& box)
{
    const glm::vec3 axis = turret_axis(turret);
    const float length = size_of(turret).z;
    layout[Part::main_gun].pivot = {middle_of(turret).x - axis.x, 0.1f * length,
                                    turret.maximum.z - axis.z - length / 8.0f};
    const glm::vec3 middle = middle_of(box);
    layout[Part::main_gun].mesh_offset = {-middle.x, -middle.y, -(box.minimum.z + size_of(box).z / 18.0f)};
}

void place_secondary_gun(Layout& layout, const Box& turret, const Box& box, const TurretRoof& roof)
{
    const glm::vec3 axis = turret_axis(turret);
    const glm::vec3 size = size_of(turret);
    const float x = -size.x / 6.0f;
    const float z = -size.z / 9.0f;
    const float height = roof_or_usual(roof, turret, axis.x + x, axis.z + z);
    PartPlacement& gun = layout[Part::secondary_gun];
    gun.pivot = {x, height - axis.y, z};
    gun.second->pivot = {0.0f, 0.5f * size_of(box).y, 0.0f};
    gun.mesh_offset = {-middle_of(box).x, -middle_of(box).y, -box.minimum.z};
}

void place_wheels(Layout& layout, const Box& body, const Box& box)
{
    const glm::vec3 hull = size_of(body);
    const glm::vec3 size = size_of(box);
    const glm::vec3 middle = middle_of(box);
    const bool reaches_to_minus_x = middle.x < -0.25f * size.x;
    const float x = hull.x * (0.5f - 1.0f / 30.0f) - 0.5f * size.x;
    const float y = hull.y / 20.0f + 0.5f * size.y;
    for (int i = 0; i < WHEELS_PER_SIDE; ++i) {
        const float part = static_cast<float>(i) / static_cast<float>(WHEELS_PER_SIDE - 1);
        const float z = hull.z * (0.3f - 0.6f * part); // from the body's middle
        for (const bool left : {true, false}) {
            const Part first = left ? Part::wheel_left_1 : Part::wheel_right_1;
            PartPlacement& wheel = layout.parts[index_of(first) + static_cast<std::size_t>(i)];
            wheel.pivot = {left ? x : -x, y, z};
            wheel.mesh_offset = -middle;
            wheel.mesh_yaw = left == reaches_to_minus_x ? std::numbers::pi : 0.0;
        }
    }
}

} // namespace

Layout bounding_box_layout(const MeshBoxes& boxes, const TurretRoof& roof)
{
    const Box& body = box_of(boxes, MeshKind::body);
    const Box& turret = box_of(boxes, MeshKind::turret);
    Layout layout = default_layout(); // the same tree, axes and joints
    const glm::vec3 middle = middle_of(body);
    layout[Part::body].pivot = {0.0f, 0.0f, 0.0f};
    layout[Part::body].mesh_offset = {-middle.x, -body.minimum.y, -middle.z};
    place_turret(layout, body, turret);
    place_main_gun(layout, turret, box_of(boxes, MeshKind::main_gun));
    place_secondary_gun(layout, turret, box_of(boxes, MeshKind::secondary_gun), roof);
    place_wheels(layout, body, box_of(boxes, MeshKind::wheel));
    return layout;
}

} // namespace tank
