#pragma once

#include "legacygl/backend/backend.h"
#include "legacygl/cpu_pipeline/primitive_pipeline.h"
#include "legacygl/state/state.h"
#include "legacygl/vertex/assembler.h"

#include <optional>

namespace legacygl {

/// Returns what ES cannot do itself for some of the primitives of a batch, so that the pipeline on the CPU
/// has to; nothing when it can do all. batch: the vertices that the traits are of.
std::optional<RasterWork> raster_work(const State& state, Backend& backend, const BatchTraits& traits,
                                      const VertexBatch& batch);

} // namespace legacygl
