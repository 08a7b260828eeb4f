// Colour indices and accumulation, as far as they are state that a target of colours only keeps (OpenGL 1.5,
// 2.7, 4.2.2 and 4.2.3).

#include "legacygl/context/dispatch.h"

#include <algorithm>

using namespace legacygl;

namespace {

void set_index(const char* name, GLfloat index)
{
    dispatch<Where::anywhere>(name, [](Context& gl, GLfloat i) { gl.state.color_index.current = i; }, index);
}

} // namespace

extern "C" {

#define INDEX(suffix, type)                                                                                  \
    void glIndex##suffix(type c)                                                                             \
    {                                                                                                        \
        set_index("glIndex" #suffix, static_cast<GLfloat>(c));                                               \
    }                                                                                                        \
    void glIndex##suffix##v(const type* c)                                                                   \
    {                                                                                                        \
        set_index("glIndex" #suffix "v", static_cast<GLfloat>(*c));                                          \
    }
INDEX(ub, GLubyte)
INDEX(s, GLshort)
INDEX(i, GLint)
INDEX(f, GLfloat)
INDEX(d, GLdouble)
#undef INDEX

void glIndexMask(GLuint mask)
{
    dispatch(__func__, [](Context& gl, GLuint m) { gl.state.color_index.write_mask = m; }, mask);
}

void glClearIndex(GLfloat c)
{
    dispatch(__func__, [](Context& gl, GLfloat i) { gl.state.color_index.clear = i; }, c);
}

void glClearAccum(GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha)
{
    dispatch(
        __func__,
        [](Context& gl, float r, float g, float b, float a) {
            const auto clamp = [](float v) { return std::clamp(v, -1.0f, 1.0f); };
            gl.state.fragment.clear_accumulation = {clamp(r), clamp(g), clamp(b), clamp(a)};
        },
        red, green, blue, alpha);
}

} // extern "C"
