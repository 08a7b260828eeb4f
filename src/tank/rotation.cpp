#include "tank/rotation.h"

#include <cmath>

namespace tank {

glm::dmat4 rotation(const glm::dvec3& axis, double radians)
{
    const double length = std::sqrt(axis.x * axis.x + axis.y * axis.y + axis.z * axis.z);
    glm::dmat4 matrix(1.0);
    if (length == 0.0) {
        return matrix;
    }
    const double c = std::cos(radians);
    const double s = std::sin(radians);
    // Columns first, as in GLM and GL: matrix[column][row].
    if (axis.y == 0.0 && axis.z == 0.0) {
        const double sx = axis.x < 0.0 ? -s : s;
        matrix[1][1] = c;
        matrix[1][2] = sx;
        matrix[2][1] = -sx;
        matrix[2][2] = c;
    } else if (axis.x == 0.0 && axis.z == 0.0) {
        const double sy = axis.y < 0.0 ? -s : s;
        matrix[0][0] = c;
        matrix[0][2] = -sy;
        matrix[2][0] = sy;
        matrix[2][2] = c;
    } else if (axis.x == 0.0 && axis.y == 0.0) {
        const double sz = axis.z < 0.0 ? -s : s;
        matrix[0][0] = c;
        matrix[0][1] = sz;
        matrix[1][0] = -sz;
        matrix[1][1] = c;
    } else {
        const glm::dvec3 u = axis / length;
        const glm::dvec3 t = u * (1.0 - c);
        matrix[0] = {t.x * u.x + c, t.x * u.y + s * u.z, t.x * u.z - s * u.y, 0.0};
        matrix[1] = {t.y * u.x - s * u.z, t.y * u.y + c, t.y * u.z + s * u.x, 0.0};
        matrix[2] = {t.z * u.x + s * u.y, t.z * u.y - s * u.x, t.z * u.z + c, 0.0};
    }
    return matrix;
}

} // namespace tank
