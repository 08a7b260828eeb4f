#include "legacygl/backend/es3_shader.h"

namespace legacygl {
namespace {

GLuint compile(const Es3Functions& gl, GLenum type, const std::string& text, std::string& message)
{
    const GLuint shader = gl.CreateShader(type);
    const char* source = text.c_str();
    gl.ShaderSource(shader, 1, &source, nullptr);
    gl.CompileShader(shader);
    GLint compiled = 0;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (!compiled) {
        char log[1024] = "";
        gl.GetShaderInfoLog(shader, sizeof log, nullptr, log);
        message = log;
    }
    return shader;
}

} // namespace

GLuint link_program(const Es3Functions& gl, const std::string& vertex, const std::string& fragment,
                    std::string& message)
{
    const GLuint shaders[2] = {compile(gl, GL_VERTEX_SHADER, vertex, message),
                               compile(gl, GL_FRAGMENT_SHADER, fragment, message)};
    const GLuint program = gl.CreateProgram();
    for (GLuint shader : shaders) {
        gl.AttachShader(program, shader);
        gl.DeleteShader(shader);
    }
    gl.LinkProgram(program);
    GLint linked = 0;
    gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked) {
        return program;
    }
    if (message.empty()) {
        char log[1024] = "";
        gl.GetProgramInfoLog(program, sizeof log, nullptr, log);
        message = log;
    }
    gl.DeleteProgram(program);
    return 0;
}

} // namespace legacygl
