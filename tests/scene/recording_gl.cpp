#include "recording_gl.h"

#include <cstddef>
#include <initializer_list>
#include <utility>

#include <GL/gl.h>
#include <GL/glu.h>

namespace {

struct Recorder
{
    std::vector<recording_gl::Call> calls;
    unsigned next_name = 1;
    unsigned compiled = 0;
    unsigned error = 0;
    const unsigned char* array = nullptr; ///< of glInterleavedArrays
    bool list_names = true;
    bool on = true;
    int stencil_bits = 8;
};

Recorder recorder;

void note(const char* name, std::initializer_list<double> arguments = {})
{
    if (recorder.on) {
        recorder.calls.push_back({name, arguments, recorder.compiled, {}});
    }
}

double number(GLfloat value)
{
    return static_cast<double>(value);
}

void note_vector(const char* name, GLenum first, GLenum second, const GLfloat* v)
{
    note(name, {double(first), double(second), number(v[0]), number(v[1]), number(v[2]), number(v[3])});
}

} // namespace

namespace recording_gl {

void reset()
{
    recorder = {};
}

const std::vector<Call>& calls()
{
    return recorder.calls;
}

std::vector<Call> take_calls()
{
    return std::exchange(recorder.calls, {});
}

void record(bool on)
{
    recorder.on = on;
}

void have_no_list_names()
{
    recorder.list_names = false;
}

void have_no_stencil()
{
    recorder.stencil_bits = 0;
}

void set_error(unsigned error)
{
    recorder.error = error;
}

} // namespace recording_gl

extern "C" {

void glBegin(GLenum mode)
{
    note("glBegin", {double(mode)});
}
void glEnd()
{
    note("glEnd");
}
void glVertex3f(GLfloat x, GLfloat y, GLfloat z)
{
    note("glVertex3f", {number(x), number(y), number(z)});
}
void glNormal3f(GLfloat x, GLfloat y, GLfloat z)
{
    note("glNormal3f", {number(x), number(y), number(z)});
}
void glTexCoord2f(GLfloat s, GLfloat t)
{
    note("glTexCoord2f", {number(s), number(t)});
}
void glColor3f(GLfloat r, GLfloat g, GLfloat b)
{
    note("glColor3f", {number(r), number(g), number(b)});
}
void glVertex3d(GLdouble x, GLdouble y, GLdouble z)
{
    note("glVertex3d", {x, y, z});
}
void glColor3ub(GLubyte r, GLubyte g, GLubyte b)
{
    note("glColor3ub", {double(r), double(g), double(b)});
}
void glColor4ub(GLubyte r, GLubyte g, GLubyte b, GLubyte a)
{
    note("glColor4ub", {double(r), double(g), double(b), double(a)});
}
void glColor4f(GLfloat r, GLfloat g, GLfloat b, GLfloat a)
{
    note("glColor4f", {number(r), number(g), number(b), number(a)});
}

GLuint glGenLists(GLsizei range)
{
    note("glGenLists", {double(range)});
    if (!recorder.list_names) {
        return 0;
    }
    return std::exchange(recorder.next_name, recorder.next_name + static_cast<unsigned>(range));
}
void glNewList(GLuint list, GLenum mode)
{
    note("glNewList", {double(list), double(mode)});
    recorder.compiled = list;
}
void glEndList()
{
    recorder.compiled = 0;
    note("glEndList");
}
void glCallList(GLuint list)
{
    note("glCallList", {double(list)});
}
void glDeleteLists(GLuint list, GLsizei range)
{
    note("glDeleteLists", {double(list), double(range)});
}

void glMatrixMode(GLenum mode)
{
    note("glMatrixMode", {double(mode)});
}
void glLoadIdentity()
{
    note("glLoadIdentity");
}
void glPushMatrix()
{
    note("glPushMatrix");
}
void glPopMatrix()
{
    note("glPopMatrix");
}
void glTranslatef(GLfloat x, GLfloat y, GLfloat z)
{
    note("glTranslate", {number(x), number(y), number(z)});
}
void glTranslated(GLdouble x, GLdouble y, GLdouble z)
{
    note("glTranslate", {x, y, z});
}
void glRotatef(GLfloat angle, GLfloat x, GLfloat y, GLfloat z)
{
    note("glRotate", {number(angle), number(x), number(y), number(z)});
}
void glScaled(GLdouble x, GLdouble y, GLdouble z)
{
    note("glScale", {x, y, z});
}
void glMultMatrixd(const GLdouble* m)
{
    note("glMultMatrixd");
    if (recorder.on) {
        recorder.calls.back().arguments.assign(m, m + 16);
    }
}
void glMultMatrixf(const GLfloat* m)
{
    note("glMultMatrixf");
    if (recorder.on) {
        recorder.calls.back().arguments.assign(m, m + 16);
    }
}
void glViewport(GLint x, GLint y, GLsizei width, GLsizei height)
{
    note("glViewport", {double(x), double(y), double(width), double(height)});
}
void glScissor(GLint x, GLint y, GLsizei width, GLsizei height)
{
    note("glScissor", {double(x), double(y), double(width), double(height)});
}
void gluPerspective(GLdouble fovy, GLdouble aspect, GLdouble z_near, GLdouble z_far)
{
    note("gluPerspective", {fovy, aspect, z_near, z_far});
}
void gluLookAt(GLdouble ex, GLdouble ey, GLdouble ez, GLdouble cx, GLdouble cy, GLdouble cz, GLdouble ux,
               GLdouble uy, GLdouble uz)
{
    note("gluLookAt", {ex, ey, ez, cx, cy, cz, ux, uy, uz});
}

void glEnable(GLenum capability)
{
    note("glEnable", {double(capability)});
}
void glDisable(GLenum capability)
{
    note("glDisable", {double(capability)});
}
void glDepthFunc(GLenum function)
{
    note("glDepthFunc", {double(function)});
}
void glDepthMask(GLboolean flag)
{
    note("glDepthMask", {double(flag)});
}
void glStencilFunc(GLenum function, GLint reference, GLuint mask)
{
    note("glStencilFunc", {double(function), double(reference), double(mask)});
}
void glStencilOp(GLenum fail, GLenum depth_fail, GLenum pass)
{
    note("glStencilOp", {double(fail), double(depth_fail), double(pass)});
}
void glBlendFunc(GLenum source, GLenum destination)
{
    note("glBlendFunc", {double(source), double(destination)});
}
void glPolygonMode(GLenum face, GLenum mode)
{
    note("glPolygonMode", {double(face), double(mode)});
}
void glLineWidth(GLfloat width)
{
    note("glLineWidth", {number(width)});
}
void glCullFace(GLenum mode)
{
    note("glCullFace", {double(mode)});
}
void glFrontFace(GLenum mode)
{
    note("glFrontFace", {double(mode)});
}
void glShadeModel(GLenum mode)
{
    note("glShadeModel", {double(mode)});
}
void glClear(GLbitfield mask)
{
    note("glClear", {double(mask)});
}
void glClearColor(GLclampf r, GLclampf g, GLclampf b, GLclampf a)
{
    note("glClearColor", {number(r), number(g), number(b), number(a)});
}

void glLightfv(GLenum light, GLenum name, const GLfloat* v)
{
    note_vector("glLightfv", light, name, v);
}
void glLightModelfv(GLenum name, const GLfloat* v)
{
    note_vector("glLightModelfv", name, 0, v);
}
void glMaterialfv(GLenum face, GLenum name, const GLfloat* v)
{
    note_vector("glMaterialfv", face, name, v);
}
void glMaterialf(GLenum face, GLenum name, GLfloat v)
{
    note("glMaterialf", {double(face), double(name), number(v)});
}
void glColorMaterial(GLenum face, GLenum mode)
{
    note("glColorMaterial", {double(face), double(mode)});
}

void glDeleteTextures(GLsizei count, const GLuint* names)
{
    note("glDeleteTextures", {double(count), double(names[0])});
}
void glGenTextures(GLsizei count, GLuint* names)
{
    note("glGenTextures", {double(count)});
    for (GLsizei i = 0; i < count; ++i) {
        names[i] = recorder.next_name++;
    }
}
void glBindTexture(GLenum target, GLuint name)
{
    note("glBindTexture", {double(target), double(name)});
}
void glTexParameteri(GLenum target, GLenum name, GLint value)
{
    note("glTexParameteri", {double(target), double(name), double(value)});
}
void glTexEnvi(GLenum target, GLenum name, GLint value)
{
    note("glTexEnvi", {double(target), double(name), double(value)});
}
void glTexImage2D(GLenum, GLint level, GLint internal_format, GLsizei width, GLsizei height, GLint,
                  GLenum format, GLenum type, const void* pixels)
{
    note("glTexImage2D", {double(level), double(internal_format), double(width), double(height),
                          double(format), double(type)});
    if (recorder.on && format == GL_RGBA && type == GL_UNSIGNED_BYTE) {
        const auto* bytes = static_cast<const GLubyte*>(pixels);
        for (GLsizei i = 0; i < width * height * 4; ++i) {
            recorder.calls.back().arguments.push_back(double(bytes[i]));
        }
    }
}

void glInterleavedArrays(GLenum format, GLsizei stride, const void* pointer)
{
    note("glInterleavedArrays", {double(format), double(stride)});
    recorder.array = static_cast<const unsigned char*>(pointer);
}
void glDisableClientState(GLenum array)
{
    note("glDisableClientState", {double(array)});
}
void glDrawArrays(GLenum mode, GLint first, GLsizei count)
{
    note("glDrawArrays", {double(mode), double(first), double(count)});
    if (recorder.on) {
        recorder.calls.back().arrays.assign(recorder.array + 24 * first,
                                            recorder.array + 24 * (first + count));
    }
}

GLUquadric* gluNewQuadric()
{
    static char quadric;
    note("gluNewQuadric");
    return reinterpret_cast<GLUquadric*>(&quadric);
}
void gluDeleteQuadric(GLUquadric*)
{
    note("gluDeleteQuadric");
}
void gluQuadricDrawStyle(GLUquadric*, GLenum style)
{
    note("gluQuadricDrawStyle", {double(style)});
}
void gluSphere(GLUquadric*, GLdouble radius, GLint slices, GLint stacks)
{
    note("gluSphere", {radius, double(slices), double(stacks)});
}
void gluCylinder(GLUquadric*, GLdouble base, GLdouble top, GLdouble height, GLint slices, GLint stacks)
{
    note("gluCylinder", {base, top, height, double(slices), double(stacks)});
}

void glGetIntegerv(GLenum name, GLint* value)
{
    *value = name == GL_STENCIL_BITS ? recorder.stencil_bits : 0;
}
GLenum glGetError()
{
    return std::exchange(recorder.error, GL_NO_ERROR);
}
void glReadPixels(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type, void* pixels)
{
    note("glReadPixels", {double(x), double(y), double(width), double(height), double(format), double(type)});
    for (GLsizei i = 0; i < width * height * 4; ++i) {
        static_cast<GLubyte*>(pixels)[i] = static_cast<GLubyte>(i);
    }
}

} // extern "C"
