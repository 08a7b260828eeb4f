#include "programs.h"

#include <GL/gl.h>

#include <vector>

namespace bench {

const float* long_list_vertices()
{
    static const std::vector<float> vertices = [] {
        std::vector<float> made;
        made.reserve(static_cast<std::size_t>(LONG_TRIANGLES) * 3 * LONG_FLOATS);
        for (int i = 0; i < LONG_TRIANGLES * 3; ++i) {
            const auto x = static_cast<float>(i % 317) / 317.0f, y = static_cast<float>(i % 1009) / 1009.0f;
            made.insert(made.end(), {2 * x - 1, 2 * y - 1, x * y, x, y, 1 - x, y, x});
        }
        return made;
    }();
    return vertices.data();
}

void long_list()
{
    const float* v = long_list_vertices();
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < LONG_TRIANGLES * 3; ++i, v += LONG_FLOATS) {
        glNormal3fv(v + 3);
        glTexCoord2fv(v + 6);
        glVertex3fv(v);
    }
    glEnd();
}

} // namespace bench
