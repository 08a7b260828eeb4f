#pragma once

#include "legacygl/shader/shader_key.h"

#include <string>

namespace legacygl {

/// Returns the statements that light a vertex: from `eye`, `n` and `color` to `front_color` and its like
/// (OpenGL 1.5, 2.14.1).
std::string lighting_text(const ShaderKey& key);

/// Returns the statements that define `n`, the normal in the coordinates that lighting uses.
std::string normal_text(const ShaderKey& key);

} // namespace legacygl
