// Entry points that are declared by <GL/gl.h> and not implemented yet: they link, set GL_INVALID_OPERATION
// and say so once on stderr. The end of <legacygl/legacygl.h> lists them.

#include "legacygl/context/unimplemented.h"

#include <cstdio>

void legacygl::report_unimplemented(bool& said, const char* what)
{
    if (!said) {
        std::fprintf(stderr, "legacygl: %s is not implemented and sets GL_INVALID_OPERATION\n", what);
    }
    said = true;
    if (current_context) {
        current_context->refuse_unsupported();
    }
}

extern "C" {

#define LEGACYGL_UNDONE(name, parameters)                                                                    \
    void name parameters                                                                                     \
    {                                                                                                        \
        LEGACYGL_REFUSE(#name);                                                                              \
    }

// Raster positions and images.
LEGACYGL_UNDONE(glRasterPos2d, (GLdouble, GLdouble))
LEGACYGL_UNDONE(glRasterPos2f, (GLfloat, GLfloat))
LEGACYGL_UNDONE(glRasterPos2i, (GLint, GLint))
LEGACYGL_UNDONE(glRasterPos2s, (GLshort, GLshort))
LEGACYGL_UNDONE(glRasterPos3d, (GLdouble, GLdouble, GLdouble))
LEGACYGL_UNDONE(glRasterPos3f, (GLfloat, GLfloat, GLfloat))
LEGACYGL_UNDONE(glRasterPos3i, (GLint, GLint, GLint))
LEGACYGL_UNDONE(glRasterPos3s, (GLshort, GLshort, GLshort))
LEGACYGL_UNDONE(glRasterPos4d, (GLdouble, GLdouble, GLdouble, GLdouble))
LEGACYGL_UNDONE(glRasterPos4f, (GLfloat, GLfloat, GLfloat, GLfloat))
LEGACYGL_UNDONE(glRasterPos4i, (GLint, GLint, GLint, GLint))
LEGACYGL_UNDONE(glRasterPos4s, (GLshort, GLshort, GLshort, GLshort))
LEGACYGL_UNDONE(glRasterPos2dv, (const GLdouble*))
LEGACYGL_UNDONE(glRasterPos2fv, (const GLfloat*))
LEGACYGL_UNDONE(glRasterPos2iv, (const GLint*))
LEGACYGL_UNDONE(glRasterPos2sv, (const GLshort*))
LEGACYGL_UNDONE(glRasterPos3dv, (const GLdouble*))
LEGACYGL_UNDONE(glRasterPos3fv, (const GLfloat*))
LEGACYGL_UNDONE(glRasterPos3iv, (const GLint*))
LEGACYGL_UNDONE(glRasterPos3sv, (const GLshort*))
LEGACYGL_UNDONE(glRasterPos4dv, (const GLdouble*))
LEGACYGL_UNDONE(glRasterPos4fv, (const GLfloat*))
LEGACYGL_UNDONE(glRasterPos4iv, (const GLint*))
LEGACYGL_UNDONE(glRasterPos4sv, (const GLshort*))
LEGACYGL_UNDONE(glPixelZoom, (GLfloat, GLfloat))
LEGACYGL_UNDONE(glPixelTransferf, (GLenum, GLfloat))
LEGACYGL_UNDONE(glPixelTransferi, (GLenum, GLint))
LEGACYGL_UNDONE(glPixelMapfv, (GLenum, GLsizei, const GLfloat*))
LEGACYGL_UNDONE(glPixelMapuiv, (GLenum, GLsizei, const GLuint*))
LEGACYGL_UNDONE(glPixelMapusv, (GLenum, GLsizei, const GLushort*))
LEGACYGL_UNDONE(glGetPixelMapfv, (GLenum, GLfloat*))
LEGACYGL_UNDONE(glGetPixelMapuiv, (GLenum, GLuint*))
LEGACYGL_UNDONE(glGetPixelMapusv, (GLenum, GLushort*))
LEGACYGL_UNDONE(glBitmap, (GLsizei, GLsizei, GLfloat, GLfloat, GLfloat, GLfloat, const GLubyte*))
LEGACYGL_UNDONE(glDrawPixels, (GLsizei, GLsizei, GLenum, GLenum, const GLvoid*))
LEGACYGL_UNDONE(glCopyPixels, (GLint, GLint, GLsizei, GLsizei, GLenum))

// Selection and feedback.
LEGACYGL_UNDONE(glFeedbackBuffer, (GLsizei, GLenum, GLfloat*))
LEGACYGL_UNDONE(glPassThrough, (GLfloat))
LEGACYGL_UNDONE(glSelectBuffer, (GLsizei, GLuint*))

// Evaluators.
LEGACYGL_UNDONE(glMap1d, (GLenum, GLdouble, GLdouble, GLint, GLint, const GLdouble*))
LEGACYGL_UNDONE(glMap1f, (GLenum, GLfloat, GLfloat, GLint, GLint, const GLfloat*))
LEGACYGL_UNDONE(glMap2d,
                (GLenum, GLdouble, GLdouble, GLint, GLint, GLdouble, GLdouble, GLint, GLint, const GLdouble*))
LEGACYGL_UNDONE(glMap2f,
                (GLenum, GLfloat, GLfloat, GLint, GLint, GLfloat, GLfloat, GLint, GLint, const GLfloat*))
LEGACYGL_UNDONE(glGetMapdv, (GLenum, GLenum, GLdouble*))
LEGACYGL_UNDONE(glGetMapfv, (GLenum, GLenum, GLfloat*))
LEGACYGL_UNDONE(glGetMapiv, (GLenum, GLenum, GLint*))
LEGACYGL_UNDONE(glEvalCoord1d, (GLdouble))
LEGACYGL_UNDONE(glEvalCoord1f, (GLfloat))
LEGACYGL_UNDONE(glEvalCoord1dv, (const GLdouble*))
LEGACYGL_UNDONE(glEvalCoord1fv, (const GLfloat*))
LEGACYGL_UNDONE(glEvalCoord2d, (GLdouble, GLdouble))
LEGACYGL_UNDONE(glEvalCoord2f, (GLfloat, GLfloat))
LEGACYGL_UNDONE(glEvalCoord2dv, (const GLdouble*))
LEGACYGL_UNDONE(glEvalCoord2fv, (const GLfloat*))
LEGACYGL_UNDONE(glMapGrid1d, (GLint, GLdouble, GLdouble))
LEGACYGL_UNDONE(glMapGrid1f, (GLint, GLfloat, GLfloat))
LEGACYGL_UNDONE(glMapGrid2d, (GLint, GLdouble, GLdouble, GLint, GLdouble, GLdouble))
LEGACYGL_UNDONE(glMapGrid2f, (GLint, GLfloat, GLfloat, GLint, GLfloat, GLfloat))
LEGACYGL_UNDONE(glEvalPoint1, (GLint))
LEGACYGL_UNDONE(glEvalPoint2, (GLint, GLint))
LEGACYGL_UNDONE(glEvalMesh1, (GLenum, GLint, GLint))
LEGACYGL_UNDONE(glEvalMesh2, (GLenum, GLint, GLint, GLint, GLint))

// Accumulation.
LEGACYGL_UNDONE(glAccum, (GLenum, GLfloat))

// Newer than OpenGL 1.1: volumes, compressed images and the imaging subset.
LEGACYGL_UNDONE(glTexImage3D,
                (GLenum, GLint, GLint, GLsizei, GLsizei, GLsizei, GLint, GLenum, GLenum, const GLvoid*))
LEGACYGL_UNDONE(glTexSubImage3D, (GLenum, GLint, GLint, GLint, GLint, GLsizei, GLsizei, GLsizei, GLenum,
                                  GLenum, const GLvoid*))
LEGACYGL_UNDONE(glCopyTexSubImage3D, (GLenum, GLint, GLint, GLint, GLint, GLint, GLint, GLsizei, GLsizei))
LEGACYGL_UNDONE(glColorTable, (GLenum, GLenum, GLsizei, GLenum, GLenum, const GLvoid*))
LEGACYGL_UNDONE(glColorSubTable, (GLenum, GLsizei, GLsizei, GLenum, GLenum, const GLvoid*))
LEGACYGL_UNDONE(glColorTableParameteriv, (GLenum, GLenum, const GLint*))
LEGACYGL_UNDONE(glColorTableParameterfv, (GLenum, GLenum, const GLfloat*))
LEGACYGL_UNDONE(glCopyColorSubTable, (GLenum, GLsizei, GLint, GLint, GLsizei))
LEGACYGL_UNDONE(glCopyColorTable, (GLenum, GLenum, GLint, GLint, GLsizei))
LEGACYGL_UNDONE(glGetColorTable, (GLenum, GLenum, GLenum, GLvoid*))
LEGACYGL_UNDONE(glGetColorTableParameterfv, (GLenum, GLenum, GLfloat*))
LEGACYGL_UNDONE(glGetColorTableParameteriv, (GLenum, GLenum, GLint*))
LEGACYGL_UNDONE(glHistogram, (GLenum, GLsizei, GLenum, GLboolean))
LEGACYGL_UNDONE(glResetHistogram, (GLenum))
LEGACYGL_UNDONE(glGetHistogram, (GLenum, GLboolean, GLenum, GLenum, GLvoid*))
LEGACYGL_UNDONE(glGetHistogramParameterfv, (GLenum, GLenum, GLfloat*))
LEGACYGL_UNDONE(glGetHistogramParameteriv, (GLenum, GLenum, GLint*))
LEGACYGL_UNDONE(glMinmax, (GLenum, GLenum, GLboolean))
LEGACYGL_UNDONE(glResetMinmax, (GLenum))
LEGACYGL_UNDONE(glGetMinmax, (GLenum, GLboolean, GLenum, GLenum, GLvoid*))
LEGACYGL_UNDONE(glGetMinmaxParameterfv, (GLenum, GLenum, GLfloat*))
LEGACYGL_UNDONE(glGetMinmaxParameteriv, (GLenum, GLenum, GLint*))
LEGACYGL_UNDONE(glConvolutionFilter1D, (GLenum, GLenum, GLsizei, GLenum, GLenum, const GLvoid*))
LEGACYGL_UNDONE(glConvolutionFilter2D, (GLenum, GLenum, GLsizei, GLsizei, GLenum, GLenum, const GLvoid*))
LEGACYGL_UNDONE(glConvolutionParameterf, (GLenum, GLenum, GLfloat))
LEGACYGL_UNDONE(glConvolutionParameterfv, (GLenum, GLenum, const GLfloat*))
LEGACYGL_UNDONE(glConvolutionParameteri, (GLenum, GLenum, GLint))
LEGACYGL_UNDONE(glConvolutionParameteriv, (GLenum, GLenum, const GLint*))
LEGACYGL_UNDONE(glCopyConvolutionFilter1D, (GLenum, GLenum, GLint, GLint, GLsizei))
LEGACYGL_UNDONE(glCopyConvolutionFilter2D, (GLenum, GLenum, GLint, GLint, GLsizei, GLsizei))
LEGACYGL_UNDONE(glGetConvolutionFilter, (GLenum, GLenum, GLenum, GLvoid*))
LEGACYGL_UNDONE(glGetConvolutionParameterfv, (GLenum, GLenum, GLfloat*))
LEGACYGL_UNDONE(glGetConvolutionParameteriv, (GLenum, GLenum, GLint*))
LEGACYGL_UNDONE(glSeparableFilter2D,
                (GLenum, GLenum, GLsizei, GLsizei, GLenum, GLenum, const GLvoid*, const GLvoid*))
LEGACYGL_UNDONE(glGetSeparableFilter, (GLenum, GLenum, GLenum, GLvoid*, GLvoid*, GLvoid*))
LEGACYGL_UNDONE(glCompressedTexImage1D, (GLenum, GLint, GLenum, GLsizei, GLint, GLsizei, const GLvoid*))
LEGACYGL_UNDONE(glCompressedTexImage2D,
                (GLenum, GLint, GLenum, GLsizei, GLsizei, GLint, GLsizei, const GLvoid*))
LEGACYGL_UNDONE(glCompressedTexImage3D,
                (GLenum, GLint, GLenum, GLsizei, GLsizei, GLsizei, GLint, GLsizei, const GLvoid*))
LEGACYGL_UNDONE(glCompressedTexSubImage1D, (GLenum, GLint, GLint, GLsizei, GLenum, GLsizei, const GLvoid*))
LEGACYGL_UNDONE(glCompressedTexSubImage2D,
                (GLenum, GLint, GLint, GLint, GLsizei, GLsizei, GLenum, GLsizei, const GLvoid*))
LEGACYGL_UNDONE(glCompressedTexSubImage3D, (GLenum, GLint, GLint, GLint, GLint, GLsizei, GLsizei, GLsizei,
                                            GLenum, GLsizei, const GLvoid*))
LEGACYGL_UNDONE(glGetCompressedTexImage, (GLenum, GLint, GLvoid*))

#undef LEGACYGL_UNDONE

} // extern "C"
