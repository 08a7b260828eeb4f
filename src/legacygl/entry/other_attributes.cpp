// Attributes newer than OpenGL 1.1: texture coordinates of other units, secondary colours and fog
// coordinates (OpenGL 1.5, 2.7); and edge flags (2.6.2).

#define GL_GLEXT_PROTOTYPES
#include "legacygl/component.h"
#include "legacygl/dispatch.h"

using namespace legacygl;

namespace {

constexpr float number(auto value)
{
    return static_cast<float>(value);
}

void multi_tex_coord(const char* name, GLenum unit, int components, glm::vec4 v)
{
    const auto set = [](VertexAssembler& to, GLenum u, int n, float s, float t, float r, float q) {
        if (u >= GL_TEXTURE0 && u < GL_TEXTURE0 + TEXTURE_UNIT_COUNT)
            to.attribute(texture_coordinate(static_cast<int>(u - GL_TEXTURE0)), n, {s, t, r, q});
    };
    dispatch_vertex(name, set, unit, components, v.x, v.y, v.z, v.w);
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
        name,
        [](VertexAssembler& to, float x) {
            to.attribute(Attribute::fog_coordinate, 1, {x, 0, 0, 1});
        },
        f);
}

} // namespace

extern "C" {

#define MULTI_TEX_COORD(suffix, type)                                                                        \
    void glMultiTexCoord1##suffix(GLenum unit, type s)                                                       \
    {                                                                                                        \
        multi_tex_coord("glMultiTexCoord1" #suffix, unit, 2, {number(s), 0, 0, 1});                          \
    }                                                                                                        \
    void glMultiTexCoord2##suffix(GLenum unit, type s, type t)                                               \
    {                                                                                                        \
        multi_tex_coord("glMultiTexCoord2" #suffix, unit, 2, {number(s), number(t), 0, 1});                  \
    }                                                                                                        \
    void glMultiTexCoord3##suffix(GLenum unit, type s, type t, type r)                                       \
    {                                                                                                        \
        multi_tex_coord("glMultiTexCoord3" #suffix, unit, 3, {number(s), number(t), number(r), 1});          \
    }                                                                                                        \
    void glMultiTexCoord4##suffix(GLenum unit, type s, type t, type r, type q)                               \
    {                                                                                                        \
        multi_tex_coord("glMultiTexCoord4" #suffix, unit, 4, {number(s), number(t), number(r), number(q)});  \
    }                                                                                                        \
    void glMultiTexCoord1##suffix##v(GLenum unit, const type* v)                                             \
    {                                                                                                        \
        multi_tex_coord("glMultiTexCoord1" #suffix "v", unit, 2, {number(v[0]), 0, 0, 1});                   \
    }                                                                                                        \
    void glMultiTexCoord2##suffix##v(GLenum unit, const type* v)                                             \
    {                                                                                                        \
        multi_tex_coord("glMultiTexCoord2" #suffix "v", unit, 2, {number(v[0]), number(v[1]), 0, 1});        \
    }                                                                                                        \
    void glMultiTexCoord3##suffix##v(GLenum unit, const type* v)                                             \
    {                                                                                                        \
        multi_tex_coord("glMultiTexCoord3" #suffix "v", unit, 3,                                             \
                        {number(v[0]), number(v[1]), number(v[2]), 1});                                      \
    }                                                                                                        \
    void glMultiTexCoord4##suffix##v(GLenum unit, const type* v)                                             \
    {                                                                                                        \
        multi_tex_coord("glMultiTexCoord4" #suffix "v", unit, 4,                                             \
                        {number(v[0]), number(v[1]), number(v[2]), number(v[3])});                           \
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
        [](VertexAssembler& to, GLboolean f) {
            to.attribute(Attribute::edge_flag, 1, {f ? 1 : 0, 0, 0, 1});
        },
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
