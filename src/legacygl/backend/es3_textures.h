#pragma once

#include "legacygl/backend/backend.h"
#include "legacygl/backend/es3_functions.h"

#include <array>
#include <cstdint>
#include <span>

namespace legacygl {

/// The textures of a backend, and which of them are bound where.
class Es3Textures
{
public:
    Es3Textures(const Es3Functions& functions, LegacyGLCounters& counters)
        : gl_(functions), counters_(counters)
    {}

    TextureId create();
    void destroy(TextureId id);
    /// See Backend::texture_image.
    void image(TextureId id, int level, int width, int height, std::span<const std::uint8_t> rgba);
    void generate_mipmap(TextureId id);
    void sampling(TextureId id, const Sampling& sampling);
    /// Binds the texture to the unit, which is then the active one if anything had to be done.
    void bind(TextureId id, int unit = 0);
    /// Forgets what is bound, which others changed.
    void forget_binding();

private:
    const Es3Functions& gl_;
    LegacyGLCounters& counters_;
    std::array<TextureId, SAMPLER_COUNT> bound_{};
    int active_unit_ = -1; ///< -1: not known.
};

} // namespace legacygl
