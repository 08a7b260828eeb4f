#pragma once

#include "legacygl/cpu_pipeline/shaded_vertex.h"
#include "legacygl/cpu_pipeline/viewport_transform.h"
#include "legacygl/state/transform.h"

#include <array>
#include <cstdint>
#include <vector>

namespace legacygl {

/// The planes that primitives are clipped against, in clip coordinates: x, y and z within ±w (bits 0 to 5),
/// then the user's (OpenGL 1.5, 2.12).
class ClipVolume
{
public:
    static constexpr int VIEW_PLANES = 6, PLANES = VIEW_PLANES + CLIP_PLANE_COUNT;
    static constexpr std::uint32_t SIDES = 0xf, ALL = ~0u; ///< Planes as bits: of x and y; all.

    explicit ClipVolume(const TransformState& state);

    /// Returns which planes the point is beyond, as bits.
    std::uint32_t outside(const glm::vec4& clip) const;
    static bool is_user_plane(int plane) { return plane >= VIEW_PLANES; }
    /// Returns whether one of the user's planes is among those that outside() told.
    static bool has_user_plane(std::uint32_t outside) { return outside >> VIEW_PLANES != 0; }
    const glm::vec4& plane(int i) const { return planes_[i]; }

private:
    std::array<glm::vec4, PLANES> planes_{};
    std::uint32_t enabled_user_planes_ = 0;
};

/// A convex polygon, and which of its edges (from its i-th vertex on) are edges of the polygon that was
/// drawn.
struct ClippedPolygon
{
    static constexpr int MAXIMUM = 3 + ClipVolume::PLANES;
    int count = 0;
    std::array<ShadedVertex, MAXIMUM> vertices;
    std::array<bool, MAXIMUM> edges{};
};

/// Cuts off what is outside of the volume, in the order and with the sums of Mesa's clipper, so that its
/// vertices come out. An edge along a user plane is an edge of the polygon; one along the view volume is
/// not. Returns false when nothing is left.
bool clip_polygon(const ClipVolume& volume, const ViewportTransform& viewport, ClippedPolygon& polygon);

/// Cuts a line. Returns false when nothing is left.
bool clip_line(const ClipVolume& volume, const ViewportTransform& viewport,
               std::array<ShadedVertex, 2>& line);

} // namespace legacygl
