#pragma once

#include "legacygl/backend/es3_functions.h"

#include <string>

namespace legacygl {

/// Compiles and links a program. Returns 0 and fills message when that fails.
GLuint link_program(const Es3Functions& gl, const std::string& vertex, const std::string& fragment,
                    std::string& message);

} // namespace legacygl
