#pragma once

#include "legacygl/backend/backend.h"
#include "legacygl/cpu_pipeline/pixel_box.h"

#include <cstdint>
#include <vector>

namespace legacygl {

/// A texture that holds what the target shows within a box: what a logic op combines fragments with.
class TargetCopy
{
public:
    /// Reads the box from the target's front or back. box: not empty. Returns the texture; its first texel is
    /// the box's first pixel.
    TextureId read(Backend& backend, bool front, const PixelBox& box);

private:
    TextureObject texture_;
    std::vector<std::uint8_t> pixels_; ///< Scratch.
};

} // namespace legacygl
