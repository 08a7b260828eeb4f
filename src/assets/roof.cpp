#include "assets/roof.h"

namespace assets {

namespace {

/// Returns the height of the triangle at (x, z), or nothing where it is not.
std::optional<double> height_at(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, double x,
                                double z)
{
    // Barycentric coordinates of the place in the triangle as seen from above.
    const double area = (b.x - a.x) * (c.z - a.z) - (c.x - a.x) * (b.z - a.z);
    if (area == 0.0) {
        return std::nullopt;
    }
    const double of_b = ((x - a.x) * (c.z - a.z) - (c.x - a.x) * (z - a.z)) / area;
    const double of_c = ((b.x - a.x) * (z - a.z) - (x - a.x) * (b.z - a.z)) / area;
    if (of_b < 0.0 || of_c < 0.0 || of_b + of_c > 1.0) {
        return std::nullopt;
    }
    return a.y + of_b * (b.y - a.y) + of_c * (c.y - a.y);
}

} // namespace

tank::TurretRoof roof_of(const mesh::ObjMesh& turret)
{
    return [&turret](float x, float z) {
        const double place_x = static_cast<double>(x);
        const double place_z = static_cast<double>(z);
        std::optional<float> highest;
        for (const mesh::Face& face : turret.faces) {
            const auto corner = [&](std::size_t i) {
                return glm::dvec3(turret.positions[static_cast<std::size_t>(face.vertices[i].position)]);
            };
            const std::optional<double> height = height_at(corner(0), corner(1), corner(2), place_x, place_z);
            if (height && (!highest || static_cast<float>(*height) > *highest)) {
                highest = static_cast<float>(*height);
            }
        }
        return highest;
    };
}

} // namespace assets
