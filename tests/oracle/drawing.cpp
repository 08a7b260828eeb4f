#include "drawing.h"

#include <GL/gl.h>

#include <cstddef>
#include <utility>

namespace oracle {
namespace {

std::string told;
bool erred = false;

} // namespace

void tell(const std::string& line)
{
    told += line + "\n";
}

unsigned next_error()
{
    const GLenum code = glGetError();
    erred = erred || code != GL_NO_ERROR;
    return code;
}

Drawn draw(const Scene& scene)
{
    told.clear();
    erred = false;
    glViewport(0, 0, scene.size.width, scene.size.height);
    scene.draw();
    for (unsigned code; (code = next_error()) != GL_NO_ERROR;) {
        tell("left error " + std::to_string(code));
    }
    Drawn drawn;
    drawn.rgba.resize(static_cast<std::size_t>(scene.size.width) * scene.size.height * 4);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, scene.size.width, scene.size.height, GL_RGBA, GL_UNSIGNED_BYTE, drawn.rgba.data());
    drawn.told = std::move(told);
    drawn.erred = erred;
    return drawn;
}

} // namespace oracle
