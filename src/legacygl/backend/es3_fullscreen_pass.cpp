#include "legacygl/backend/es3_fullscreen_pass.h"

#include "legacygl/backend/es3_shader.h"

#include <algorithm>
#include <string>

namespace legacygl {
namespace {

/// One triangle whose corners lie so far out that the viewport is inside.
constexpr const char* VERTEX = R"(#version 300 es
void main()
{
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0;
    gl_Position = vec4(corner, 0.0, 1.0);
}
)";

} // namespace

GLuint Es3FullscreenPass::use(const char* fragment)
{
    auto found = std::find_if(programs_.begin(), programs_.end(),
                              [&](const Program& program) { return program.fragment == fragment; });
    if (found == programs_.end()) {
        std::string message;
        found = programs_.insert(found, {fragment, link_program(gl_, VERTEX, fragment, message)});
    }
    gl_.UseProgram(found->name);
    return found->name;
}

void Es3FullscreenPass::draw()
{
    if (vertex_array_ == 0) {
        gl_.GenVertexArrays(1, &vertex_array_);
    }
    gl_.BindVertexArray(vertex_array_);
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

void Es3FullscreenPass::destroy()
{
    for (const Program& program : programs_) {
        gl_.DeleteProgram(program.name);
    }
    gl_.DeleteVertexArrays(1, &vertex_array_);
    forget();
}

void Es3FullscreenPass::forget()
{
    programs_.clear();
    vertex_array_ = 0;
}

} // namespace legacygl
