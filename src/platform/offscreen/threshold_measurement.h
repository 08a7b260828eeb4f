#pragma once

#include "app/simulation/simulation.h"
#include "lod/threshold_search.h"
#include "scene/scene_renderer.h"

namespace platform {

/// Searches the threshold distance d of the tank: from how far away on the pictures of its high and its low
/// model show no difference. Both are drawn in the simulation's state, but at the distances of the search and
/// turned twelve ways at each; the way with the greatest difference counts. Prints a line for each distance.
/// A context of width x height pixels must be current, and the renderer loaded in it.
lod::ThresholdResult measure_threshold(app::Simulation& simulation, const scene::SceneRenderer& renderer,
                                       int width, int height);

/// Prints what came out, in a sentence.
void print_threshold(const lod::ThresholdResult& result);

} // namespace platform
