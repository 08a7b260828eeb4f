#include "tank/mesh_box.h"

#include <cmath>

namespace tank {

bool resembles(const MeshBoxes& boxes, const MeshBoxes& known)
{
    constexpr double TOLERANCE = 0.01; // of the hull's length
    const double length = length_of(box_of(boxes, MeshKind::body));
    const double known_length = length_of(box_of(known, MeshKind::body));
    if (!(length > 0.0)) {
        return false;
    }
    const auto near = [&](float side, float known_side) {
        return std::abs(static_cast<double>(side) / length -
                        static_cast<double>(known_side) / known_length) <= TOLERANCE;
    };
    for (std::size_t mesh = 0; mesh < MESH_KIND_COUNT; ++mesh) {
        for (int axis = 0; axis < 3; ++axis) {
            if (!near(boxes[mesh].minimum[axis], known[mesh].minimum[axis]) ||
                !near(boxes[mesh].maximum[axis], known[mesh].maximum[axis])) {
                return false;
            }
        }
    }
    return true;
}

float roof_or_usual(const TurretRoof& roof, const Box& turret, float x, float z)
{
    const std::optional<float> height = roof(x, z);
    return height ? *height : turret.minimum.y + 0.2f * (turret.maximum.z - turret.minimum.z);
}

} // namespace tank
