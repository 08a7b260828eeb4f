#pragma once

#include "scene.h"

#include <string>
#include <vector>

namespace oracle {

/// What a scene left.
struct Drawn
{
    std::vector<unsigned char> rgba; ///< Its pixels, four bytes each, the bottom row first.
    std::string told;                ///< What it told, and the errors it left, a line each.
    bool erred = false;              ///< Whether it made an OpenGL error.
};

/// Draws a scene into the current context, which is new and of the scene's size.
Drawn draw(const Scene& scene);

} // namespace oracle
