// glBegin, glEnd and what a vertex is made of (OpenGL 1.5, 2.6 and 2.7).

#include "legacygl/component.h"
#include "legacygl/dispatch.h"

using namespace legacygl;

namespace {

void vertex(const char* name, int components, glm::vec4 v)
{
    dispatch_vertex(
        name,
        [](VertexAssembler& to, int n, float x, float y, float z, float w) {
            to.vertex(n, {x, y, z, w});
        },
        components, v.x, v.y, v.z, v.w);
}

template <Attribute attribute> void current(const char* name, int components, glm::vec4 v)
{
    dispatch_vertex(
        name,
        [](VertexAssembler& to, int n, float x, float y, float z, float w) {
            to.attribute(attribute, n, {x, y, z, w});
        },
        components, v.x, v.y, v.z, v.w);
}

constexpr float number(auto value)
{
    return static_cast<float>(value);
}

} // namespace

extern "C" {

void glBegin(GLenum mode)
{
    Context* gl = current_context;
    if (!gl)
        return;
    if (gl->capture.active())
        gl->note("glBegin", mode);
    if (gl->compiler) {
        gl->compiler->vertices().begin(mode);
        if (!gl->compiler->executes())
            return;
    }
    gl->begin(mode);
}

void glEnd()
{
    Context* gl = current_context;
    if (!gl)
        return;
    if (gl->capture.active())
        gl->note("glEnd");
    if (gl->compiler) {
        gl->compiler->vertices().end();
        if (!gl->compiler->executes())
            return;
    }
    gl->end();
}

#define VERTEX(suffix, type)                                                                                 \
    void glVertex2##suffix(type x, type y)                                                                   \
    {                                                                                                        \
        vertex("glVertex2" #suffix, 2, {number(x), number(y), 0, 1});                                        \
    }                                                                                                        \
    void glVertex3##suffix(type x, type y, type z)                                                           \
    {                                                                                                        \
        vertex("glVertex3" #suffix, 3, {number(x), number(y), number(z), 1});                                \
    }                                                                                                        \
    void glVertex4##suffix(type x, type y, type z, type w)                                                   \
    {                                                                                                        \
        vertex("glVertex4" #suffix, 4, {number(x), number(y), number(z), number(w)});                        \
    }                                                                                                        \
    void glVertex2##suffix##v(const type* v)                                                                 \
    {                                                                                                        \
        vertex("glVertex2" #suffix "v", 2, {number(v[0]), number(v[1]), 0, 1});                              \
    }                                                                                                        \
    void glVertex3##suffix##v(const type* v)                                                                 \
    {                                                                                                        \
        vertex("glVertex3" #suffix "v", 3, {number(v[0]), number(v[1]), number(v[2]), 1});                   \
    }                                                                                                        \
    void glVertex4##suffix##v(const type* v)                                                                 \
    {                                                                                                        \
        vertex("glVertex4" #suffix "v", 4, {number(v[0]), number(v[1]), number(v[2]), number(v[3])});        \
    }
VERTEX(s, GLshort)
VERTEX(i, GLint)
VERTEX(f, GLfloat)
VERTEX(d, GLdouble)
#undef VERTEX

#define NORMAL(suffix, type)                                                                                 \
    void glNormal3##suffix(type x, type y, type z)                                                           \
    {                                                                                                        \
        current<Attribute::normal>("glNormal3" #suffix, 3, {component(x), component(y), component(z), 1});   \
    }                                                                                                        \
    void glNormal3##suffix##v(const type* v)                                                                 \
    {                                                                                                        \
        current<Attribute::normal>("glNormal3" #suffix "v", 3,                                               \
                                   {component(v[0]), component(v[1]), component(v[2]), 1});                  \
    }
NORMAL(b, GLbyte)
NORMAL(s, GLshort)
NORMAL(i, GLint)
NORMAL(f, GLfloat)
NORMAL(d, GLdouble)
#undef NORMAL

#define COLOR(suffix, type)                                                                                  \
    void glColor3##suffix(type r, type g, type b)                                                            \
    {                                                                                                        \
        current<Attribute::color>("glColor3" #suffix, 3, {component(r), component(g), component(b), 1});     \
    }                                                                                                        \
    void glColor4##suffix(type r, type g, type b, type a)                                                    \
    {                                                                                                        \
        current<Attribute::color>("glColor4" #suffix, 4,                                                     \
                                  {component(r), component(g), component(b), component(a)});                 \
    }                                                                                                        \
    void glColor3##suffix##v(const type* v)                                                                  \
    {                                                                                                        \
        current<Attribute::color>("glColor3" #suffix "v", 3,                                                 \
                                  {component(v[0]), component(v[1]), component(v[2]), 1});                   \
    }                                                                                                        \
    void glColor4##suffix##v(const type* v)                                                                  \
    {                                                                                                        \
        current<Attribute::color>("glColor4" #suffix "v", 4,                                                 \
                                  {component(v[0]), component(v[1]), component(v[2]), component(v[3])});     \
    }
COLOR(b, GLbyte)
COLOR(s, GLshort)
COLOR(i, GLint)
COLOR(f, GLfloat)
COLOR(d, GLdouble)
COLOR(ub, GLubyte)
COLOR(us, GLushort)
COLOR(ui, GLuint)
#undef COLOR

#define TEX_COORD(suffix, type)                                                                              \
    void glTexCoord1##suffix(type s)                                                                         \
    {                                                                                                        \
        current<Attribute::texture_coordinate_0>("glTexCoord1" #suffix, 2, {number(s), 0, 0, 1});            \
    }                                                                                                        \
    void glTexCoord2##suffix(type s, type t)                                                                 \
    {                                                                                                        \
        current<Attribute::texture_coordinate_0>("glTexCoord2" #suffix, 2, {number(s), number(t), 0, 1});    \
    }                                                                                                        \
    void glTexCoord3##suffix(type s, type t, type r)                                                         \
    {                                                                                                        \
        current<Attribute::texture_coordinate_0>("glTexCoord3" #suffix, 3,                                   \
                                                 {number(s), number(t), number(r), 1});                      \
    }                                                                                                        \
    void glTexCoord4##suffix(type s, type t, type r, type q)                                                 \
    {                                                                                                        \
        current<Attribute::texture_coordinate_0>("glTexCoord4" #suffix, 4,                                   \
                                                 {number(s), number(t), number(r), number(q)});              \
    }                                                                                                        \
    void glTexCoord1##suffix##v(const type* v)                                                               \
    {                                                                                                        \
        current<Attribute::texture_coordinate_0>("glTexCoord1" #suffix "v", 2, {number(v[0]), 0, 0, 1});     \
    }                                                                                                        \
    void glTexCoord2##suffix##v(const type* v)                                                               \
    {                                                                                                        \
        current<Attribute::texture_coordinate_0>("glTexCoord2" #suffix "v", 2,                               \
                                                 {number(v[0]), number(v[1]), 0, 1});                        \
    }                                                                                                        \
    void glTexCoord3##suffix##v(const type* v)                                                               \
    {                                                                                                        \
        current<Attribute::texture_coordinate_0>("glTexCoord3" #suffix "v", 3,                               \
                                                 {number(v[0]), number(v[1]), number(v[2]), 1});             \
    }                                                                                                        \
    void glTexCoord4##suffix##v(const type* v)                                                               \
    {                                                                                                        \
        current<Attribute::texture_coordinate_0>("glTexCoord4" #suffix "v", 4,                               \
                                                 {number(v[0]), number(v[1]), number(v[2]), number(v[3])});  \
    }
TEX_COORD(s, GLshort)
TEX_COORD(i, GLint)
TEX_COORD(f, GLfloat)
TEX_COORD(d, GLdouble)
#undef TEX_COORD

} // extern "C"
