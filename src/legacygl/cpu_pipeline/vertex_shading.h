#pragma once

#include "legacygl/cpu_pipeline/clipping.h"
#include "legacygl/cpu_pipeline/shaded_vertex.h"
#include "legacygl/cpu_pipeline/viewport_transform.h"
#include "legacygl/shader/shader_key.h"
#include "legacygl/state/state.h"
#include "legacygl/vertex/assembler.h"

#include <vector>

namespace legacygl {

/// Transforms and lights vertices on the CPU, as the fixed-function shader of the key would.
///
/// Used where a primitive must be cut or replaced between the vertices and the fragments: ES has nothing
/// there. The values come from the same functions that fill the shader's uniforms.
class VertexShading
{
public:
    VertexShading(const State& state, const ShaderKey& key);

    /// Shades all vertices of a batch, each with the material it was given; what the batch's vertices lack is
    /// what is current.
    std::vector<ShadedVertex> shade(const VertexBatch& batch);

    const ClipVolume& volume() const { return volume_; }
    const ViewportTransform& viewport() const { return viewport_; }

private:
    ShadedVertex shade(const CurrentAttributes& attributes) const;
    void fill_lighting_values();
    void set_materials(const std::array<Material, 2>& materials);
    void place(const glm::vec4& position, ShadedVertex& vertex) const;
    void texture(int unit, const CurrentAttributes& attributes, const glm::vec4& eye, const glm::vec4& sphere,
                 ShadedVertex& vertex) const;
    glm::vec3 eye_normal(const glm::vec4& normal) const;
    float point_size(const glm::vec4& eye) const;

    const State& state_;
    const ShaderKey key_;
    const TransformLayout layout_;
    const ViewportTransform viewport_;
    const ClipVolume volume_;
    LightingState lighting_; ///< With the materials that the vertices have got so far.
    std::vector<glm::vec4> transform_values_, lighting_values_, texturing_values_;
};

} // namespace legacygl
