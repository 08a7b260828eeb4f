// User clip planes (OpenGL 1.5, 2.12).

#include "legacygl/context/dispatch.h"

using namespace legacygl;

namespace {

using Equation = std::array<double, 4>;

/// Planes are transformed by the inverse of what points are transformed by, as rows.
glm::vec4 plane_in_eye_space(const Equation& plane, const float* inverse)
{
    glm::vec4 out;
    for (int column = 0; column < 4; ++column) {
        const float* m = inverse + 4 * column;
        out[column] = static_cast<float>(plane[0]) * m[0] + static_cast<float>(plane[1]) * m[1] +
                      static_cast<float>(plane[2]) * m[2] + static_cast<float>(plane[3]) * m[3];
    }
    return out;
}

bool is_clip_plane(GLenum name)
{
    return name >= GL_CLIP_PLANE0 && name < GL_CLIP_PLANE0 + CLIP_PLANE_COUNT;
}

} // namespace

extern "C" {

void glClipPlane(GLenum plane, const GLdouble* equation)
{
    dispatch(
        __func__,
        [](Context& gl, GLenum p, const Equation& e) {
            if (!is_clip_plane(p)) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            gl.state.transform.clip_planes[p - GL_CLIP_PLANE0].equation =
                plane_in_eye_space(e, gl.state.transform.modelview.top().inverse());
        },
        plane, Equation{equation[0], equation[1], equation[2], equation[3]});
}

void glGetClipPlane(GLenum plane, GLdouble* equation)
{
    dispatch_now(
        __func__,
        [equation](Context& gl, GLenum p) {
            if (!is_clip_plane(p)) {
                return gl.set_error(GL_INVALID_ENUM);
            }
            for (int i = 0; i < 4; ++i) {
                equation[i] =
                    static_cast<double>(gl.state.transform.clip_planes[p - GL_CLIP_PLANE0].equation[i]);
            }
        },
        plane);
}

} // extern "C"
