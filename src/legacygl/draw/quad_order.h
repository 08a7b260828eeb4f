#pragma once

#include "legacygl/cpu_pipeline/outcodes.h"
#include "legacygl/state/state.h"
#include "legacygl/vertex/assembler.h"
#include "legacygl/vertex/primitives.h"

#include <cstddef>
#include <optional>
#include <span>

namespace legacygl {

/// Knows how Mesa cuts the quads of primitives of a batch that are drawn.
///
/// Its pipeline cuts them where a vertex lies outside of the view volume or the state asks for it. Separate
/// quads are cut from their first corner where that is not so, nothing is flat, and their vertices come one
/// after the other, which they never do in a list.
class MesaQuadOrders final : public QuadOrders
{
public:
    /// flat: whether fragments take the colour of one vertex, which differs from the others'. in_list:
    /// whether the batch is a list's.
    MesaQuadOrders(const State& state, const VertexBatch& batch, std::span<const Primitive> primitives,
                   bool flat, bool in_list);

    QuadOrder of(std::size_t i) override;

private:
    bool all_inside(std::size_t first, std::size_t end);

    const State& state_;
    const VertexBatch& batch_;
    const std::span<const Primitive> primitives_;
    const bool from_first_, emitted_; ///< Whether the state allows that.
    std::optional<Outcodes> outcodes_;
    std::size_t known_until_ = 0; ///< The end of the neighbouring quads that inside_ is about.
    bool inside_ = false;
};

} // namespace legacygl
