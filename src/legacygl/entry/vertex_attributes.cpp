// Attributes newer than OpenGL 1.1: texture coordinates of other units, secondary colours and fog
// coordinates (OpenGL 1.5, 2.7); and edge flags (2.6.2).

#define GL_GLEXT_PROTOTYPES
#include "legacygl/context/dispatch.h"
#include "legacygl/vertex/component.h"

using namespace legacygl;

namespace {

/// Sets a unit's texture coordinates; a vertex has two at least.
template <class... T> void multi_tex_coord(const char* name, GLenum unit, T... values)
{
    constexpr int COMPONENTS = sizeof...(T) < 2 ? 2 : sizeof...(T);
    const auto set = [](VertexAssembler& to, GLenum u, T... v) {
        if (u >= GL_TEXTURE0 && u < GL_TEXTURE0 + TEXTURE_UNIT_COUNT) {
            to.attribute(texture_coordinate(static_cast<int>(u - GL_TEXTURE0)), COMPONENTS,
                         vector_of(number(v)...));
        }
    };
    dispatch_vertex(name, set, unit, values...);
}

void secondary_color(const char* name, float r, float g, float b)
{
    dispatch_vertex(
        name,
        [](VertexAssembler& to, float x, float y, float z) {
            to.attribute(Attribute::secondary_color, 3, {x, y, z, 1});
        },
        r, g, b);
}

void fog_coordinate(const char* name, float f)
{
    dispatch_vertex(
        name, [](VertexAssembler& to, float x) { to.attribute(Attribute::fog_coordinate, 1, {x, 0, 0, 1}); },
        f);
}

} // namespace

extern "C" {

#define MULTI_TEX_COORD(suffix, type)                                                                        \
    void glMultiTexCoord1##suffix(GLenum unit, type s)                                                       \
    {                                                                                                        \
        multi_tex_coord("glMultiTexCoord1" #suffix, unit, s);                                                \
    }                                                                                                        \
    void glMultiTexCoord2##suffix(GLenum unit, type s, type t)                                               \
    {                                                                                                        \
        multi_tex_coord("glMultiTexCoord2" #suffix, unit, s, t);                                             \
    }                                                                                                        \
    void glMultiTexCoord3##suffix(GLenum unit, type s, type t, type r)                                       \
    {                                                                                                        \
        multi_tex_coord("glMultiTexCoord3" #suffix, unit, s, t, r);                                          \
    }                                                                                                        \
    void glMultiTexCoord4##suffix(GLenum unit, type s, type t, type r, type q)                               \
    {                                                                                                        \
        multi_tex_coord("glMultiTexCoord4" #suffix, unit, s, t, r, q);                                       \
    }                                                                                                        \
    void glMultiTexCoord1##suffix##v(GLenum unit, const type* v)                                             \
    {                                                                                                        \
        multi_tex_coord("glMultiTexCoord1" #suffix "v", unit, v[0]);                                         \
    }                                                                                                        \
    void glMultiTexCoord2##suffix##v(GLenum unit, const type* v)                                             \
    {                                                                                                        \
        multi_tex_coord("glMultiTexCoord2" #suffix "v", unit, v[0], v[1]);                                   \
    }                                                                                                        \
    void glMultiTexCoord3##suffix##v(GLenum unit, const type* v)                                             \
    {                                                                                                        \
        multi_tex_coord("glMultiTexCoord3" #suffix "v", unit, v[0], v[1], v[2]);                             \
    }                                                                                                        \
    void glMultiTexCoord4##suffix##v(GLenum unit, const type* v)                                             \
    {                                                                                                        \
        multi_tex_coord("glMultiTexCoord4" #suffix "v", unit, v[0], v[1], v[2], v[3]);                       \
    }
MULTI_TEX_COORD(s, GLshort)
MULTI_TEX_COORD(i, GLint)
MULTI_TEX_COORD(f, GLfloat)
MULTI_TEX_COORD(d, GLdouble)
#undef MULTI_TEX_COORD

#define SECONDARY_COLOR(suffix, type)                                                                        \
    void glSecondaryColor3##suffix(type r, type g, type b)                                                   \
    {                                                                                                        \
        secondary_color("glSecondaryColor3" #suffix, component(r), component(g), component(b));              \
    }                                                                                                        \
    void glSecondaryColor3##suffix##v(const type* v)                                                         \
    {                                                                                                        \
        secondary_color("glSecondaryColor3" #suffix "v", component(v[0]), component(v[1]), component(v[2])); \
    }
SECONDARY_COLOR(b, GLbyte)
SECONDARY_COLOR(s, GLshort)
SECONDARY_COLOR(i, GLint)
SECONDARY_COLOR(f, GLfloat)
SECONDARY_COLOR(d, GLdouble)
SECONDARY_COLOR(ub, GLubyte)
SECONDARY_COLOR(us, GLushort)
SECONDARY_COLOR(ui, GLuint)
#undef SECONDARY_COLOR

void glEdgeFlag(GLboolean flag)
{
    dispatch_vertex(
        __func__,
        [](VertexAssembler& to, GLboolean f) { to.attribute(Attribute::edge_flag, 1, {f ? 1 : 0, 0, 0, 1}); },
        flag);
}

void glEdgeFlagv(const GLboolean* flag)
{
    glEdgeFlag(*flag);
}

void glFogCoordf(GLfloat coord)
{
    fog_coordinate(__func__, coord);
}

void glFogCoordfv(const GLfloat* coord)
{
    fog_coordinate(__func__, *coord);
}

void glFogCoordd(GLdouble coord)
{
    fog_coordinate(__func__, static_cast<float>(coord));
}

void glFogCoorddv(const GLdouble* coord)
{
    fog_coordinate(__func__, static_cast<float>(*coord));
}

} // extern "C"
