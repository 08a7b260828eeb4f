// The functions of <GL/glu.h> that are not implemented yet. They link, say so once on stderr, and do nothing:
//
// - tessellators: gluNewTess (returns null), gluDeleteTess, gluTessBeginPolygon, gluTessEndPolygon,
//   gluTessBeginContour, gluTessEndContour, gluTessVertex, gluTessNormal, gluTessProperty,
//   gluGetTessProperty, gluTessCallback, gluBeginPolygon, gluNextContour, gluEndPolygon;
// - NURBS: gluNewNurbsRenderer (returns null), gluDeleteNurbsRenderer, gluBeginCurve, gluEndCurve,
//   gluBeginSurface, gluEndSurface, gluBeginTrim, gluEndTrim, gluNurbsCurve, gluNurbsSurface, gluPwlCurve,
//   gluNurbsProperty, gluGetNurbsProperty, gluLoadSamplingMatrices, gluNurbsCallback, gluNurbsCallbackData,
//   gluNurbsCallbackDataEXT;
// - 3D textures, which are not OpenGL 1.1: gluBuild3DMipmaps and gluBuild3DMipmapLevels return
//   GLU_INVALID_OPERATION.

#include <GL/gl.h>
#include <GL/glu.h>

#include <cstdio>

namespace {

/// Says once that a function does nothing; each call site has its own memory of that.
void say(bool& said, const char* name)
{
    if (!said) {
        std::fprintf(stderr, "legacygl: %s is not implemented and does nothing\n", name);
    }
    said = true;
}

} // namespace

#define SAY_UNIMPLEMENTED()                                                                                  \
    static bool said = false;                                                                                \
    say(said, __func__)

GLUtesselator* gluNewTess()
{
    SAY_UNIMPLEMENTED();
    return nullptr;
}
GLUnurbs* gluNewNurbsRenderer()
{
    SAY_UNIMPLEMENTED();
    return nullptr;
}
GLint gluBuild3DMipmaps(GLenum, GLint, GLsizei, GLsizei, GLsizei, GLenum, GLenum, const void*)
{
    SAY_UNIMPLEMENTED();
    return GLU_INVALID_OPERATION;
}
GLint gluBuild3DMipmapLevels(GLenum, GLint, GLsizei, GLsizei, GLsizei, GLenum, GLenum, GLint, GLint, GLint,
                             const void*)
{
    SAY_UNIMPLEMENTED();
    return GLU_INVALID_OPERATION;
}

void gluDeleteTess(GLUtesselator*)
{
    SAY_UNIMPLEMENTED();
}
void gluTessBeginPolygon(GLUtesselator*, GLvoid*)
{
    SAY_UNIMPLEMENTED();
}
void gluTessEndPolygon(GLUtesselator*)
{
    SAY_UNIMPLEMENTED();
}
void gluTessBeginContour(GLUtesselator*)
{
    SAY_UNIMPLEMENTED();
}
void gluTessEndContour(GLUtesselator*)
{
    SAY_UNIMPLEMENTED();
}
void gluTessVertex(GLUtesselator*, GLdouble*, GLvoid*)
{
    SAY_UNIMPLEMENTED();
}
void gluTessNormal(GLUtesselator*, GLdouble, GLdouble, GLdouble)
{
    SAY_UNIMPLEMENTED();
}
void gluTessProperty(GLUtesselator*, GLenum, GLdouble)
{
    SAY_UNIMPLEMENTED();
}
void gluGetTessProperty(GLUtesselator*, GLenum, GLdouble*)
{
    SAY_UNIMPLEMENTED();
}
void gluTessCallback(GLUtesselator*, GLenum, _GLUfuncptr)
{
    SAY_UNIMPLEMENTED();
}
void gluBeginPolygon(GLUtesselator*)
{
    SAY_UNIMPLEMENTED();
}
void gluNextContour(GLUtesselator*, GLenum)
{
    SAY_UNIMPLEMENTED();
}
void gluEndPolygon(GLUtesselator*)
{
    SAY_UNIMPLEMENTED();
}
void gluDeleteNurbsRenderer(GLUnurbs*)
{
    SAY_UNIMPLEMENTED();
}
void gluBeginCurve(GLUnurbs*)
{
    SAY_UNIMPLEMENTED();
}
void gluEndCurve(GLUnurbs*)
{
    SAY_UNIMPLEMENTED();
}
void gluBeginSurface(GLUnurbs*)
{
    SAY_UNIMPLEMENTED();
}
void gluEndSurface(GLUnurbs*)
{
    SAY_UNIMPLEMENTED();
}
void gluBeginTrim(GLUnurbs*)
{
    SAY_UNIMPLEMENTED();
}
void gluEndTrim(GLUnurbs*)
{
    SAY_UNIMPLEMENTED();
}
void gluNurbsCurve(GLUnurbs*, GLint, GLfloat*, GLint, GLfloat*, GLint, GLenum)
{
    SAY_UNIMPLEMENTED();
}
void gluNurbsSurface(GLUnurbs*, GLint, GLfloat*, GLint, GLfloat*, GLint, GLint, GLfloat*, GLint, GLint,
                     GLenum)
{
    SAY_UNIMPLEMENTED();
}
void gluPwlCurve(GLUnurbs*, GLint, GLfloat*, GLint, GLenum)
{
    SAY_UNIMPLEMENTED();
}
void gluNurbsProperty(GLUnurbs*, GLenum, GLfloat)
{
    SAY_UNIMPLEMENTED();
}
void gluGetNurbsProperty(GLUnurbs*, GLenum, GLfloat*)
{
    SAY_UNIMPLEMENTED();
}
void gluLoadSamplingMatrices(GLUnurbs*, const GLfloat*, const GLfloat*, const GLint*)
{
    SAY_UNIMPLEMENTED();
}
void gluNurbsCallback(GLUnurbs*, GLenum, _GLUfuncptr)
{
    SAY_UNIMPLEMENTED();
}
void gluNurbsCallbackData(GLUnurbs*, GLvoid*)
{
    SAY_UNIMPLEMENTED();
}
void gluNurbsCallbackDataEXT(GLUnurbs*, GLvoid*)
{
    SAY_UNIMPLEMENTED();
}
