#pragma once

#include "legacygl/backend/backend.h"
#include "legacygl/shader/shader_key.h"

namespace legacygl {

/// Returns the GLSL ES 3.00 text of the fixed-function pipeline for the key. Pure: one key, one text.
///
/// OpenGL 1.5, 2.14 (lighting) and 3.8.13 (texture environments). The order of the operations is that of
/// the programs that Mesa generates, so that the last bits agree.
ProgramText make_program_text(const ShaderKey& key);

} // namespace legacygl
