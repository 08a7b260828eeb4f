#pragma once

#include "legacygl/shader/shader_key.h"

#include <string>

namespace legacygl {

/// Returns the statements of the vertex shader that make a unit's texture coordinates (OpenGL 1.5, 2.11.4).
std::string texture_coordinate_text(const ShaderKey& key, int unit);

/// Returns the statements of the fragment shader that apply all texture environments to `c`, in order
/// (OpenGL 1.5, 3.8.13).
std::string texture_environment_text(const ShaderKey& key);

} // namespace legacygl
