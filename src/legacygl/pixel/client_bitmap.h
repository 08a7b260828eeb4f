#pragma once

#include "legacygl/state/pixel_store.h"

#include <cstdint>

namespace legacygl {

/// Returns pixel (x, y) of a bitmap in client memory that is `width` pixels wide where the store gives no row
/// length (OpenGL 1.5, 3.6.4).
bool read_bit(const PixelStore& store, int width, int x, int y, const std::uint8_t* bits);

/// Sets that pixel and leaves those beside it.
void write_bit(const PixelStore& store, int width, int x, int y, bool value, std::uint8_t* bits);

} // namespace legacygl
