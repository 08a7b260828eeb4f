#pragma once

#include <legacygl/legacygl.h>

#ifdef __EMSCRIPTEN__
#include <GLES3/gl3.h>
#include <webgl/webgl1.h>
#include <webgl/webgl2.h>
#else
#include <GLES3/gl3.h>
#endif

#include <string>

namespace legacygl {

/// The OpenGL ES 3.0 functions that legacygl stands on: X(result, name, parameters).
/// They are never called by their own names, which are ours: on the web through Emscripten's aliases,
/// natively through pointers that a loader finds.
#define LEGACYGL_ES3_FUNCTIONS(X)                                                                            \
    X(void, ActiveTexture, (GLenum))                                                                         \
    X(void, AttachShader, (GLuint, GLuint))                                                                  \
    X(void, BindBuffer, (GLenum, GLuint))                                                                    \
    X(void, BindFramebuffer, (GLenum, GLuint))                                                               \
    X(void, BindRenderbuffer, (GLenum, GLuint))                                                              \
    X(void, BindTexture, (GLenum, GLuint))                                                                   \
    X(void, BindVertexArray, (GLuint))                                                                       \
    X(void, BlendColor, (GLfloat, GLfloat, GLfloat, GLfloat))                                                \
    X(void, BlendEquationSeparate, (GLenum, GLenum))                                                         \
    X(void, BlendFuncSeparate, (GLenum, GLenum, GLenum, GLenum))                                             \
    X(void, BlitFramebuffer, (GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLbitfield, GLenum))   \
    X(void, BufferData, (GLenum, GLsizeiptr, const void*, GLenum))                                           \
    X(void, BufferSubData, (GLenum, GLintptr, GLsizeiptr, const void*))                                      \
    X(GLenum, CheckFramebufferStatus, (GLenum))                                                              \
    X(void, Clear, (GLbitfield))                                                                             \
    X(void, ClearColor, (GLfloat, GLfloat, GLfloat, GLfloat))                                                \
    X(void, ClearDepthf, (GLfloat))                                                                          \
    X(void, ClearStencil, (GLint))                                                                           \
    X(void, ColorMask, (GLboolean, GLboolean, GLboolean, GLboolean))                                         \
    X(void, CompileShader, (GLuint))                                                                         \
    X(GLuint, CreateProgram, ())                                                                             \
    X(GLuint, CreateShader, (GLenum))                                                                        \
    X(void, CullFace, (GLenum))                                                                              \
    X(void, DeleteBuffers, (GLsizei, const GLuint*))                                                         \
    X(void, DeleteFramebuffers, (GLsizei, const GLuint*))                                                    \
    X(void, DeleteProgram, (GLuint))                                                                         \
    X(void, DeleteRenderbuffers, (GLsizei, const GLuint*))                                                   \
    X(void, DeleteShader, (GLuint))                                                                          \
    X(void, DeleteTextures, (GLsizei, const GLuint*))                                                        \
    X(void, DeleteVertexArrays, (GLsizei, const GLuint*))                                                    \
    X(void, DepthFunc, (GLenum))                                                                             \
    X(void, DepthMask, (GLboolean))                                                                          \
    X(void, DepthRangef, (GLfloat, GLfloat))                                                                 \
    X(void, Disable, (GLenum))                                                                               \
    X(void, DrawArrays, (GLenum, GLint, GLsizei))                                                            \
    X(void, DrawBuffers, (GLsizei, const GLenum*))                                                           \
    X(void, DrawElements, (GLenum, GLsizei, GLenum, const void*))                                            \
    X(void, Enable, (GLenum))                                                                                \
    X(void, EnableVertexAttribArray, (GLuint))                                                               \
    X(void, Finish, ())                                                                                      \
    X(void, Flush, ())                                                                                       \
    X(void, FramebufferRenderbuffer, (GLenum, GLenum, GLenum, GLuint))                                       \
    X(void, FramebufferTexture2D, (GLenum, GLenum, GLenum, GLuint, GLint))                                   \
    X(void, FrontFace, (GLenum))                                                                             \
    X(void, GenBuffers, (GLsizei, GLuint*))                                                                  \
    X(void, GenFramebuffers, (GLsizei, GLuint*))                                                             \
    X(void, GenRenderbuffers, (GLsizei, GLuint*))                                                            \
    X(void, GenTextures, (GLsizei, GLuint*))                                                                 \
    X(void, GenVertexArrays, (GLsizei, GLuint*))                                                             \
    X(void, GenerateMipmap, (GLenum))                                                                        \
    X(GLenum, GetError, ())                                                                                  \
    X(void, GetIntegerv, (GLenum, GLint*))                                                                   \
    X(void, GetProgramInfoLog, (GLuint, GLsizei, GLsizei*, char*))                                           \
    X(void, GetProgramiv, (GLuint, GLenum, GLint*))                                                          \
    X(void, GetShaderInfoLog, (GLuint, GLsizei, GLsizei*, char*))                                            \
    X(void, GetShaderiv, (GLuint, GLenum, GLint*))                                                           \
    X(GLint, GetUniformLocation, (GLuint, const char*))                                                      \
    X(void, LineWidth, (GLfloat))                                                                            \
    X(void, LinkProgram, (GLuint))                                                                           \
    X(void, PixelStorei, (GLenum, GLint))                                                                    \
    X(void, PolygonOffset, (GLfloat, GLfloat))                                                               \
    X(void, ReadPixels, (GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void*))                             \
    X(void, RenderbufferStorage, (GLenum, GLenum, GLsizei, GLsizei))                                         \
    X(void, Scissor, (GLint, GLint, GLsizei, GLsizei))                                                       \
    X(void, StencilFunc, (GLenum, GLint, GLuint))                                                            \
    X(void, StencilMask, (GLuint))                                                                           \
    X(void, StencilOp, (GLenum, GLenum, GLenum))                                                             \
    X(void, ShaderSource, (GLuint, GLsizei, const char* const*, const GLint*))                               \
    X(void, TexImage2D, (GLenum, GLint, GLint, GLsizei, GLsizei, GLint, GLenum, GLenum, const void*))        \
    X(void, TexParameterf, (GLenum, GLenum, GLfloat))                                                        \
    X(void, TexParameteri, (GLenum, GLenum, GLint))                                                          \
    X(void, Uniform1i, (GLint, GLint))                                                                       \
    X(void, Uniform4fv, (GLint, GLsizei, const GLfloat*))                                                    \
    X(void, UseProgram, (GLuint))                                                                            \
    X(void, VertexAttrib4f, (GLuint, GLfloat, GLfloat, GLfloat, GLfloat))                                    \
    X(void, VertexAttribPointer, (GLuint, GLint, GLenum, GLboolean, GLsizei, const void*))                   \
    X(void, Viewport, (GLint, GLint, GLsizei, GLsizei))

/// Those functions: on the web known when compiling, so that a call is a direct one; natively pointers.
struct Es3Functions
{
#ifdef __EMSCRIPTEN__
#define LEGACYGL_MEMBER(result, name, parameters)                                                            \
    static constexpr result(*name) parameters = emscripten_gl##name;
#else
#define LEGACYGL_MEMBER(result, name, parameters) result(*name) parameters = nullptr;
#endif
    LEGACYGL_ES3_FUNCTIONS(LEGACYGL_MEMBER)
#undef LEGACYGL_MEMBER

    /// Finds the native ones. Returns the name of the first function that is missing, or "".
    /// A loader that returns non-null for any name (EGL's may) cannot be caught here.
    std::string load(LegacyGLLoader loader);
};

} // namespace legacygl
