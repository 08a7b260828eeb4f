#pragma once

#include "legacygl/shader/shader_key.h"

#include <glm/vec4.hpp>

#include <span>

namespace legacygl {

/// Returns the whole number of pixels that an aliased point of the size covers in both directions.
float rasterised_point_size(float size);

/// Fills a slot of the uniform array `transform`. layout: the key's; out has layout.size elements.
void fill_transform(const State& state, const ShaderKey& key, const TransformLayout& layout,
                    std::span<glm::vec4> out);

/// Fills the uniform array `lighting`; out has lighting_layout::size(key.light_count) elements.
void fill_lighting(const LightingState& lighting, const ShaderKey& key, std::span<glm::vec4> out);

/// Fills the uniform array `texturing`; out has texturing_layout::SIZE elements.
void fill_texturing(const State& state, std::span<glm::vec4> out);

/// Fills the uniform array `fragments`; out has fragments_layout::size() elements, with the stipple or
/// without. target_copy_origin: where in the window the first texel of the target's copy lies.
void fill_fragments(const State& state, glm::vec4 target_copy_origin, std::span<glm::vec4> out);

} // namespace legacygl
