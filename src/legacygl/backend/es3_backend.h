#pragma once

#include "legacygl/backend/backend.h"

#include <legacygl/legacygl.h>

#include <memory>
#include <string>

namespace legacygl {

/// Makes the backend that draws through OpenGL ES 3 / WebGL 2, for the ES context that is current.
/// Returns null when a function is missing; message then says which.
std::unique_ptr<Backend> make_es3_backend(LegacyGLLoader loader, int width, int height, LegacyGLTarget target,
                                          std::string& message);

} // namespace legacygl
