#pragma once

#include "legacygl/backend/backend.h"
#include "legacygl/cpu_pipeline/primitive_pipeline.h"
#include "legacygl/draw/target_copy.h"
#include "legacygl/list/list_geometry.h"
#include "legacygl/shader/shader_key.h"
#include "legacygl/state/change.h"
#include "legacygl/state/state.h"

#include <array>
#include <optional>
#include <unordered_map>
#include <vector>

namespace legacygl {

/// Turns state and vertices into draws of the backend, recomputing only what changed.
class Renderer
{
public:
    explicit Renderer(Backend& backend) : backend_(backend) {}

    /// Says what a command changed, as bits of change.
    void changed(std::uint32_t what) { changed_ |= what; }

    /// Returns the attributes that the state makes use of, as bits of Attribute.
    std::uint32_t attributes_read(const State& state);

    void draw(const State& state, const VertexBatch& batch);
    void draw(const State& state, ListGeometry& geometry);
    void clear(const State& state, GLbitfield buffers);
    void forget_objects();

private:
    struct Group
    {
        std::vector<glm::vec4> values;
        std::uint64_t revision = 0;
    };

    const ShaderKey& key_for(const State& state, PrimitiveClass primitive, std::uint32_t varying);
    const ShaderKey& use(const ShaderKey& key);
    const DrawState& prepare(const State& state, const ShaderKey& key);
    void draw_batch(const State& state, const VertexBatch& batch, std::span<const Primitive> primitives,
                    std::uint32_t varying);
    void draw_shaded(const State& state, const VertexBatch& batch, const RasterWork& work, bool in_list);
    void draw_shaded(const State& state, const VertexBatch& batch, std::span<const Primitive> primitives,
                     std::uint32_t varying, const RasterWork& work, bool in_list);
    void draw_shaded(const State& state, const ShaderKey& shading, const RasterWork& work,
                     const RasterOutput& output);
    void draw_shaded(const State& state, const ShaderKey& shading, const RasterWork& work,
                     const RasterOutput& output, const ShadedDraw& draw);
    bool copy_target(const State& state, const PixelBox& box);
    ProgramId program(const ShaderKey& key);
    TextureId texture(Texture& texture);
    template <class Fill> void refill(UniformGroup group, int size, Fill fill);
    template <class Draw>
    void for_each_program(const State& state, std::uint32_t varying, std::span<const DrawRun> runs,
                          Draw draw);

    Backend& backend_;
    std::uint32_t changed_ = change::everything;
    std::optional<ShaderKey> key_;        ///< Of the last draw, while nothing changed.
    TransformLayout layout_{ShaderKey{}}; ///< Of key_.
    bool keeps_length_ = false;           ///< What the modelview gave to the key.
    std::unordered_map<ShaderKey, ProgramId, ShaderKeyHash> programs_;
    std::array<Group, UNIFORM_GROUP_COUNT> groups_;
    DrawState draw_state_;
    std::uint32_t stipple_counter_ = 0;
    TargetCopy target_copy_;
    glm::vec4 target_copy_origin_{0, 0, 0, 0};
    std::vector<DrawRun> runs_;          ///< Scratch, kept so that a steady frame allocates nothing.
    std::vector<std::uint32_t> indices_; ///< Scratch.
};

/// Returns the state of the ES pipeline that the state asks for.
Pipeline make_pipeline(const State& state);

} // namespace legacygl
