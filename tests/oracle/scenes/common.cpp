#include "scenes/common.h"

#include <cmath>

namespace oracle {

void torus(float large, float small, int sides, int rings)
{
    const double turn = 2 * 3.14159265358979323846;
    for (int ring = 0; ring < rings; ++ring) {
        glBegin(GL_TRIANGLE_STRIP);
        for (int side = 0; side <= sides; ++side) {
            for (int r = 0; r < 2; ++r) {
                const double around = turn * (ring + r) / rings, across = -turn * side / sides;
                const double cx = std::cos(around), cz = std::sin(around);
                const double out = std::cos(across), up = std::sin(across);
                const double radius = static_cast<double>(large) + static_cast<double>(small) * out;
                glTexCoord2d(4.0 * (ring + r) / rings, 2.0 * side / sides);
                glNormal3d(cx * out, up, cz * out);
                glVertex3d(cx * radius, static_cast<double>(small) * up, cz * radius);
            }
        }
        glEnd();
    }
}

void cube()
{
    static const float normals[6][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (const float* n : normals) {
        // Two axes that make a right-handed frame with the normal.
        const float u[3] = {n[1], n[2], n[0]};
        const float v[3] = {n[1] * u[2] - n[2] * u[1], n[2] * u[0] - n[0] * u[2], n[0] * u[1] - n[1] * u[0]};
        glColor3f(0.55f + 0.4f * n[0], 0.55f + 0.4f * n[1], 0.55f + 0.4f * n[2]);
        glNormal3fv(n);
        glBegin(GL_TRIANGLE_FAN);
        for (int corner = 0; corner < 4; ++corner) {
            const float s = corner == 1 || corner == 2 ? 1.0f : -1.0f, t = corner >= 2 ? 1.0f : -1.0f;
            glTexCoord2f(0.5f + 0.5f * s, 0.5f + 0.5f * t);
            glVertex3f(n[0] + s * u[0] + t * v[0], n[1] + s * u[1] + t * v[1], n[2] + s * u[2] + t * v[2]);
        }
        glEnd();
    }
}

} // namespace oracle
