#pragma once

#include "legacygl/state/pixel_store.h"
#include "legacygl/state/raster.h"
#include "legacygl/state/texturing.h"

#include <cstdint>

namespace legacygl {

/// Reads a stipple of 32 × 32 bits from client memory, as GL_BITMAP of colour indices (OpenGL 1.5, 3.6.4).
StippleRows unpack_stipple(const PixelStore& unpack, const std::uint8_t* bits);

/// Writes a stipple into client memory; bits outside of it stay as they are.
void pack_stipple(const StippleRows& rows, const PixelStore& pack, std::uint8_t* bits);

} // namespace legacygl
