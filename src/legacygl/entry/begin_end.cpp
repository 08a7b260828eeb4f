// glBegin, glEnd and what a vertex is made of (OpenGL 1.5, 2.6 and 2.7).

#include "legacygl/context/dispatch.h"
#include "legacygl/vertex/component.h"

using namespace legacygl;

namespace {

template <class... T> void vertex(const char* name, T... values)
{
    dispatch_vertex(
        name, [](VertexAssembler& to, T... v) { to.vertex(sizeof...(T), vector_of(number(v)...)); },
        values...);
}

/// Sets a colour or a normal, whose integers stand for fractions.
template <Attribute attribute, class... T> void fractions(const char* name, T... values)
{
    dispatch_vertex(
        name,
        [](VertexAssembler& to, T... v) {
            to.attribute(attribute, sizeof...(T), vector_of(component(v)...));
        },
        values...);
}

/// Sets texture coordinates; a vertex has two at least.
template <class... T> void tex_coord(const char* name, T... values)
{
    constexpr int COMPONENTS = sizeof...(T) < 2 ? 2 : sizeof...(T);
    dispatch_vertex(
        name,
        [](VertexAssembler& to, T... v) {
            to.attribute(Attribute::texture_coordinate_0, COMPONENTS, vector_of(number(v)...));
        },
        values...);
}

} // namespace

extern "C" {

void glBegin(GLenum mode)
{
    Context* gl = current_context;
    if (!gl) {
        return;
    }
    if (gl->capture.active()) {
        gl->note("glBegin", mode);
    }
    if (gl->compiler) {
        gl->compiler->vertices().begin(mode);
        if (!gl->compiler->executes()) {
            return;
        }
    }
    gl->begin(mode);
}

void glEnd()
{
    Context* gl = current_context;
    if (!gl) {
        return;
    }
    if (gl->capture.active()) {
        gl->note("glEnd");
    }
    if (gl->compiler) {
        gl->compiler->vertices().end();
        if (!gl->compiler->executes()) {
            return;
        }
    }
    gl->end();
}

#define VERTEX(suffix, type)                                                                                 \
    void glVertex2##suffix(type x, type y)                                                                   \
    {                                                                                                        \
        vertex("glVertex2" #suffix, x, y);                                                                   \
    }                                                                                                        \
    void glVertex3##suffix(type x, type y, type z)                                                           \
    {                                                                                                        \
        vertex("glVertex3" #suffix, x, y, z);                                                                \
    }                                                                                                        \
    void glVertex4##suffix(type x, type y, type z, type w)                                                   \
    {                                                                                                        \
        vertex("glVertex4" #suffix, x, y, z, w);                                                             \
    }                                                                                                        \
    void glVertex2##suffix##v(const type* v)                                                                 \
    {                                                                                                        \
        vertex("glVertex2" #suffix "v", v[0], v[1]);                                                         \
    }                                                                                                        \
    void glVertex3##suffix##v(const type* v)                                                                 \
    {                                                                                                        \
        vertex("glVertex3" #suffix "v", v[0], v[1], v[2]);                                                   \
    }                                                                                                        \
    void glVertex4##suffix##v(const type* v)                                                                 \
    {                                                                                                        \
        vertex("glVertex4" #suffix "v", v[0], v[1], v[2], v[3]);                                             \
    }
VERTEX(s, GLshort)
VERTEX(i, GLint)
VERTEX(f, GLfloat)
VERTEX(d, GLdouble)
#undef VERTEX

#define NORMAL(suffix, type)                                                                                 \
    void glNormal3##suffix(type x, type y, type z)                                                           \
    {                                                                                                        \
        fractions<Attribute::normal>("glNormal3" #suffix, x, y, z);                                          \
    }                                                                                                        \
    void glNormal3##suffix##v(const type* v)                                                                 \
    {                                                                                                        \
        fractions<Attribute::normal>("glNormal3" #suffix "v", v[0], v[1], v[2]);                             \
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
        fractions<Attribute::color>("glColor3" #suffix, r, g, b);                                            \
    }                                                                                                        \
    void glColor4##suffix(type r, type g, type b, type a)                                                    \
    {                                                                                                        \
        fractions<Attribute::color>("glColor4" #suffix, r, g, b, a);                                         \
    }                                                                                                        \
    void glColor3##suffix##v(const type* v)                                                                  \
    {                                                                                                        \
        fractions<Attribute::color>("glColor3" #suffix "v", v[0], v[1], v[2]);                               \
    }                                                                                                        \
    void glColor4##suffix##v(const type* v)                                                                  \
    {                                                                                                        \
        fractions<Attribute::color>("glColor4" #suffix "v", v[0], v[1], v[2], v[3]);                         \
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
        tex_coord("glTexCoord1" #suffix, s);                                                                 \
    }                                                                                                        \
    void glTexCoord2##suffix(type s, type t)                                                                 \
    {                                                                                                        \
        tex_coord("glTexCoord2" #suffix, s, t);                                                              \
    }                                                                                                        \
    void glTexCoord3##suffix(type s, type t, type r)                                                         \
    {                                                                                                        \
        tex_coord("glTexCoord3" #suffix, s, t, r);                                                           \
    }                                                                                                        \
    void glTexCoord4##suffix(type s, type t, type r, type q)                                                 \
    {                                                                                                        \
        tex_coord("glTexCoord4" #suffix, s, t, r, q);                                                        \
    }                                                                                                        \
    void glTexCoord1##suffix##v(const type* v)                                                               \
    {                                                                                                        \
        tex_coord("glTexCoord1" #suffix "v", v[0]);                                                          \
    }                                                                                                        \
    void glTexCoord2##suffix##v(const type* v)                                                               \
    {                                                                                                        \
        tex_coord("glTexCoord2" #suffix "v", v[0], v[1]);                                                    \
    }                                                                                                        \
    void glTexCoord3##suffix##v(const type* v)                                                               \
    {                                                                                                        \
        tex_coord("glTexCoord3" #suffix "v", v[0], v[1], v[2]);                                              \
    }                                                                                                        \
    void glTexCoord4##suffix##v(const type* v)                                                               \
    {                                                                                                        \
        tex_coord("glTexCoord4" #suffix "v", v[0], v[1], v[2], v[3]);                                        \
    }
TEX_COORD(s, GLshort)
TEX_COORD(i, GLint)
TEX_COORD(f, GLfloat)
TEX_COORD(d, GLdouble)
#undef TEX_COORD

} // extern "C"
