#pragma once

#include "scene.h"

#include <string>

namespace oracle {

/// The size of the program's own pictures.
constexpr Size PROGRAM_SIZE = {640, 400};

/// Draws what a link describes, as the program draws it.
void draw_link(const std::string& link);

/// Adds a scene that draws a link.
void add_link(const std::string& name, const std::string& link);

} // namespace oracle
