#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace platform {

/// Writes a picture as a PNG file.
/// rgba: 4 bytes a pixel, rows bottom first as glReadPixels gives them, width * height * 4 bytes.
/// The alpha channel is not written: a picture is what a screen shows, and a screen is opaque.
/// Returns "" or a sentence that says what failed; no half-written file stays behind then.
std::string write_png(const std::string& path, int width, int height, std::span<const std::uint8_t> rgba);

} // namespace platform
