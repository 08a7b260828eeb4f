#pragma once

#include "legacygl/shader/shader_key.h"

#include <string>

namespace legacygl {

/// Returns text that mixes the border's colour into a unit's texel t<unit>, where a wrap mode lets it show
/// (OpenGL 1.5, 3.8.7 and 3.8.8); empty where none does. ES clamps to the edge: beside the edge a linear
/// filter then sees the edge's texel where OpenGL sees the border, so that the border's weight is all that is
/// missing.
std::string border_text(const ShaderKey& key, int unit);

} // namespace legacygl
