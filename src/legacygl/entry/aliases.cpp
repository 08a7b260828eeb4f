// Names that functions had as extensions, before OpenGL took them in, for programs of that time.

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>

extern "C" {

#define ALIAS_MULTI_TEX_COORD(suffix, type)                                                                  \
    void glMultiTexCoord1##suffix##ARB(GLenum unit, type s)                                                  \
    {                                                                                                        \
        glMultiTexCoord1##suffix(unit, s);                                                                   \
    }                                                                                                        \
    void glMultiTexCoord2##suffix##ARB(GLenum unit, type s, type t)                                          \
    {                                                                                                        \
        glMultiTexCoord2##suffix(unit, s, t);                                                                \
    }                                                                                                        \
    void glMultiTexCoord3##suffix##ARB(GLenum unit, type s, type t, type r)                                  \
    {                                                                                                        \
        glMultiTexCoord3##suffix(unit, s, t, r);                                                             \
    }                                                                                                        \
    void glMultiTexCoord4##suffix##ARB(GLenum unit, type s, type t, type r, type q)                          \
    {                                                                                                        \
        glMultiTexCoord4##suffix(unit, s, t, r, q);                                                          \
    }                                                                                                        \
    void glMultiTexCoord1##suffix##vARB(GLenum unit, const type* v)                                          \
    {                                                                                                        \
        glMultiTexCoord1##suffix##v(unit, v);                                                                \
    }                                                                                                        \
    void glMultiTexCoord2##suffix##vARB(GLenum unit, const type* v)                                          \
    {                                                                                                        \
        glMultiTexCoord2##suffix##v(unit, v);                                                                \
    }                                                                                                        \
    void glMultiTexCoord3##suffix##vARB(GLenum unit, const type* v)                                          \
    {                                                                                                        \
        glMultiTexCoord3##suffix##v(unit, v);                                                                \
    }                                                                                                        \
    void glMultiTexCoord4##suffix##vARB(GLenum unit, const type* v)                                          \
    {                                                                                                        \
        glMultiTexCoord4##suffix##v(unit, v);                                                                \
    }
ALIAS_MULTI_TEX_COORD(s, GLshort)
ALIAS_MULTI_TEX_COORD(i, GLint)
ALIAS_MULTI_TEX_COORD(f, GLfloat)
ALIAS_MULTI_TEX_COORD(d, GLdouble)
#undef ALIAS_MULTI_TEX_COORD

#define ALIAS_SECONDARY_COLOR(suffix, type)                                                                  \
    void glSecondaryColor3##suffix##EXT(type r, type g, type b)                                              \
    {                                                                                                        \
        glSecondaryColor3##suffix(r, g, b);                                                                  \
    }                                                                                                        \
    void glSecondaryColor3##suffix##vEXT(const type* v)                                                      \
    {                                                                                                        \
        glSecondaryColor3##suffix##v(v);                                                                     \
    }
ALIAS_SECONDARY_COLOR(b, GLbyte)
ALIAS_SECONDARY_COLOR(s, GLshort)
ALIAS_SECONDARY_COLOR(i, GLint)
ALIAS_SECONDARY_COLOR(f, GLfloat)
ALIAS_SECONDARY_COLOR(d, GLdouble)
ALIAS_SECONDARY_COLOR(ub, GLubyte)
ALIAS_SECONDARY_COLOR(us, GLushort)
ALIAS_SECONDARY_COLOR(ui, GLuint)
#undef ALIAS_SECONDARY_COLOR

/// The extension's bias is a fraction of the depth range, of which 24 bits hold 2^24 - 1 units.
void glPolygonOffsetEXT(GLfloat factor, GLfloat bias)
{
    glPolygonOffset(factor, bias * 16777215.0f);
}

// How many elements an array has was only a hint.
void glColorPointerEXT(GLint size, GLenum type, GLsizei stride, GLsizei, const void* pointer)
{
    glColorPointer(size, type, stride, pointer);
}

void glEdgeFlagPointerEXT(GLsizei stride, GLsizei, const GLboolean* pointer)
{
    glEdgeFlagPointer(stride, pointer);
}

void glIndexPointerEXT(GLenum type, GLsizei stride, GLsizei, const void* pointer)
{
    glIndexPointer(type, stride, pointer);
}

void glNormalPointerEXT(GLenum type, GLsizei stride, GLsizei, const void* pointer)
{
    glNormalPointer(type, stride, pointer);
}

void glTexCoordPointerEXT(GLint size, GLenum type, GLsizei stride, GLsizei, const void* pointer)
{
    glTexCoordPointer(size, type, stride, pointer);
}

void glVertexPointerEXT(GLint size, GLenum type, GLsizei stride, GLsizei, const void* pointer)
{
    glVertexPointer(size, type, stride, pointer);
}

void glActiveTextureARB(GLenum texture)
{
    glActiveTexture(texture);
}

GLboolean glAreTexturesResidentEXT(GLsizei n, const GLuint* textures, GLboolean* residences)
{
    return glAreTexturesResident(n, textures, residences);
}

void glArrayElementEXT(GLint i)
{
    glArrayElement(i);
}

void glBindBufferARB(GLenum target, GLuint buffer)
{
    glBindBuffer(target, buffer);
}

void glBindTextureEXT(GLenum target, GLuint texture)
{
    glBindTexture(target, texture);
}

void glBlendColorEXT(GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha)
{
    glBlendColor(red, green, blue, alpha);
}

void glBlendEquationSeparateEXT(GLenum rgb, GLenum alpha)
{
    glBlendEquationSeparate(rgb, alpha);
}

void glBlendEquationSeparateATI(GLenum rgb, GLenum alpha)
{
    glBlendEquationSeparate(rgb, alpha);
}

void glBlendEquationEXT(GLenum mode)
{
    glBlendEquation(mode);
}

void glBlendFuncSeparateEXT(GLenum sfactorRGB, GLenum dfactorRGB, GLenum sfactorAlpha, GLenum dfactorAlpha)
{
    glBlendFuncSeparate(sfactorRGB, dfactorRGB, sfactorAlpha, dfactorAlpha);
}

void glBufferDataARB(GLenum target, GLsizeiptr size, const void* data, GLenum usage)
{
    glBufferData(target, size, data, usage);
}

void glBufferSubDataARB(GLenum target, GLintptr offset, GLsizeiptr size, const void* data)
{
    glBufferSubData(target, offset, size, data);
}

void glClientActiveTextureARB(GLenum texture)
{
    glClientActiveTexture(texture);
}

void glCopyTexImage1DEXT(GLenum target, GLint level, GLenum internalformat, GLint x, GLint y, GLsizei width,
                         GLint border)
{
    glCopyTexImage1D(target, level, internalformat, x, y, width, border);
}

void glCopyTexImage2DEXT(GLenum target, GLint level, GLenum internalformat, GLint x, GLint y, GLsizei width,
                         GLsizei height, GLint border)
{
    glCopyTexImage2D(target, level, internalformat, x, y, width, height, border);
}

void glCopyTexSubImage1DEXT(GLenum target, GLint level, GLint xoffset, GLint x, GLint y, GLsizei width)
{
    glCopyTexSubImage1D(target, level, xoffset, x, y, width);
}

void glCopyTexSubImage2DEXT(GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint x, GLint y,
                            GLsizei width, GLsizei height)
{
    glCopyTexSubImage2D(target, level, xoffset, yoffset, x, y, width, height);
}

void glDeleteBuffersARB(GLsizei n, const GLuint* buffers)
{
    glDeleteBuffers(n, buffers);
}

void glDeleteTexturesEXT(GLsizei n, const GLuint* textures)
{
    glDeleteTextures(n, textures);
}

void glDrawArraysEXT(GLenum mode, GLint first, GLsizei count)
{
    glDrawArrays(mode, first, count);
}

void glDrawRangeElementsEXT(GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type,
                            const void* indices)
{
    glDrawRangeElements(mode, start, end, count, type, indices);
}

void glFogCoordPointerEXT(GLenum type, GLsizei stride, const void* pointer)
{
    glFogCoordPointer(type, stride, pointer);
}

void glFogCoorddEXT(GLdouble coord)
{
    glFogCoordd(coord);
}

void glFogCoorddvEXT(const GLdouble* coord)
{
    glFogCoorddv(coord);
}

void glFogCoordfEXT(GLfloat coord)
{
    glFogCoordf(coord);
}

void glFogCoordfvEXT(const GLfloat* coord)
{
    glFogCoordfv(coord);
}

void glGenBuffersARB(GLsizei n, GLuint* buffers)
{
    glGenBuffers(n, buffers);
}

void glGenTexturesEXT(GLsizei n, GLuint* textures)
{
    glGenTextures(n, textures);
}

void glGetBufferParameterivARB(GLenum target, GLenum pname, GLint* params)
{
    glGetBufferParameteriv(target, pname, params);
}

void glGetBufferSubDataARB(GLenum target, GLintptr offset, GLsizeiptr size, void* data)
{
    glGetBufferSubData(target, offset, size, data);
}

void glGetPointervEXT(GLenum pname, void** params)
{
    glGetPointerv(pname, params);
}

GLboolean glIsBufferARB(GLuint buffer)
{
    return glIsBuffer(buffer);
}

GLboolean glIsTextureEXT(GLuint texture)
{
    return glIsTexture(texture);
}

void glLoadTransposeMatrixdARB(const GLdouble* m)
{
    glLoadTransposeMatrixd(m);
}

void glLoadTransposeMatrixfARB(const GLfloat* m)
{
    glLoadTransposeMatrixf(m);
}

void* glMapBufferARB(GLenum target, GLenum access)
{
    return glMapBuffer(target, access);
}

void glMultTransposeMatrixdARB(const GLdouble* m)
{
    glMultTransposeMatrixd(m);
}

void glMultTransposeMatrixfARB(const GLfloat* m)
{
    glMultTransposeMatrixf(m);
}

void glMultiDrawArraysEXT(GLenum mode, const GLint* first, const GLsizei* count, GLsizei primcount)
{
    glMultiDrawArrays(mode, first, count, primcount);
}

void glMultiDrawElementsEXT(GLenum mode, const GLsizei* count, GLenum type, const void* const* indices,
                            GLsizei primcount)
{
    glMultiDrawElements(mode, count, type, indices, primcount);
}

void glPrioritizeTexturesEXT(GLsizei n, const GLuint* textures, const GLclampf* priorities)
{
    glPrioritizeTextures(n, textures, priorities);
}

void glSampleCoverageARB(GLfloat value, GLboolean invert)
{
    glSampleCoverage(value, invert);
}

void glSecondaryColorPointerEXT(GLint size, GLenum type, GLsizei stride, const void* pointer)
{
    glSecondaryColorPointer(size, type, stride, pointer);
}

void glTexSubImage1DEXT(GLenum target, GLint level, GLint xoffset, GLsizei width, GLenum format, GLenum type,
                        const void* pixels)
{
    glTexSubImage1D(target, level, xoffset, width, format, type, pixels);
}

void glTexSubImage2DEXT(GLenum target, GLint level, GLint xoffset, GLint yoffset, GLsizei width,
                        GLsizei height, GLenum format, GLenum type, const void* pixels)
{
    glTexSubImage2D(target, level, xoffset, yoffset, width, height, format, type, pixels);
}

GLboolean glUnmapBufferARB(GLenum target)
{
    return glUnmapBuffer(target);
}

} // extern "C"
