#pragma once

#include <span>
#include <string>

#include <legacygl/legacygl.h>

namespace checks {

/// Returns captured calls as a JSON array of {name, list_depth, arguments}, in their order.
/// glCallList has `modelview` besides: 16 numbers, column by column. What lists call between glBegin and
/// glEnd is not listed: their glBegin has `vertices`, how many it was.
std::string capture_json(std::span<const LegacyGLCall> calls);

} // namespace checks
