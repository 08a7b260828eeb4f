#include "drawing.h"

#include <GL/gl.h>

#include <cstddef>
#include <utility>

namespace oracle {
namespace {

std::string told;

} // namespace

void tell(const std::string& line)
{
    told += line + "\n";
}

Drawn draw(const Scene& scene)
{
    told.clear();
    glViewport(0, 0, scene.size.width, scene.size.height);
    scene.draw();
    for (GLenum code; (code = glGetError()) != GL_NO_ERROR;)
        tell("left error " + std::to_string(code));
    Drawn drawn;
    drawn.rgba.resize(static_cast<std::size_t>(scene.size.width) * scene.size.height * 4);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, scene.size.width, scene.size.height, GL_RGBA, GL_UNSIGNED_BYTE, drawn.rgba.data());
    drawn.told = std::move(told);
    return drawn;
}

} // namespace oracle
