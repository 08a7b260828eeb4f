#include "legacygl/cpu_pipeline/clipping.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace legacygl {
namespace {

float dot(const glm::vec4& a, const glm::vec4& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}

/// Returns the vertex at t on the way from one to another.
ShadedVertex cut(const ViewportTransform& viewport, const ShadedVertex& from, const ShadedVertex& to, float t)
{
    ShadedVertex out;
    out.clip = from.clip + t * (to.clip - from.clip);
    out.window = viewport.window_of_cut(out.clip);
    out.moved = true;
    out.varyings = mix(from.varyings, to.varyings, t);
    out.point_size = from.point_size + t * (to.point_size - from.point_size);
    return out;
}

/// Cuts where the edge from one vertex to the next crosses the plane, from the nearer end.
ShadedVertex cut_edge(const ViewportTransform& viewport, const ShadedVertex& previous,
                      float previous_distance, const ShadedVertex& vertex, float distance)
{
    const float difference = distance - previous_distance;
    if (std::fabs(distance) < std::fabs(previous_distance)) {
        return cut(viewport, vertex, previous, distance / difference);
    }
    return cut(viewport, previous, vertex, -previous_distance / difference);
}

/// Cuts the polygon by one plane. Returns false when a distance is not a number.
bool clip_by_plane(const glm::vec4& plane, bool user_plane, const ViewportTransform& viewport,
                   const ClippedPolygon& in, ClippedPolygon& out)
{
    out.count = 0;
    const auto add = [&out](const ShadedVertex& vertex, bool edge) {
        out.edges[out.count] = edge;
        out.vertices[out.count++] = vertex;
    };
    float previous_distance = dot(in.vertices[0].clip, plane);
    if (!std::isfinite(previous_distance)) {
        return false;
    }
    for (int i = 0; i < in.count; ++i) {
        const ShadedVertex &previous = in.vertices[i], &vertex = in.vertices[(i + 1) % in.count];
        const float distance = dot(vertex.clip, plane);
        if (!std::isfinite(distance)) {
            return false;
        }
        const bool leaves = previous_distance >= 0 && distance < 0;
        const bool enters = !(previous_distance >= 0) && !(distance < 0);
        if (previous_distance >= 0) {
            add(previous, in.edges[i]);
        }
        if ((leaves || enters) && out.count < ClippedPolygon::MAXIMUM) {
            add(cut_edge(viewport, previous, previous_distance, vertex, distance),
                leaves && user_plane ? true : in.edges[i]);
            out.vertices[out.count - 1].edge_flag = leaves ? user_plane : previous.edge_flag;
        }
        previous_distance = distance;
    }
    return true;
}

} // namespace

ClipVolume::ClipVolume(const TransformState& state)
    : planes_{glm::vec4(-1, 0, 0, 1), {1, 0, 0, 1}, {0, -1, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {0, 0, -1, 1}}
{
    const float* inverse = state.projection.top().inverse();
    for (int i = 0; i < CLIP_PLANE_COUNT; ++i) {
        const ClipPlane& plane = state.clip_planes[i];
        enabled_user_planes_ |= static_cast<std::uint32_t>(plane.enabled) << i;
        for (int column = 0; column < 4; ++column) {
            const float* m = inverse + 4 * column;
            planes_[VIEW_PLANES + i][column] = plane.equation.x * m[0] + plane.equation.y * m[1] +
                                               plane.equation.z * m[2] + plane.equation.w * m[3];
        }
    }
}

std::uint32_t ClipVolume::outside(const glm::vec4& p) const
{
    std::uint32_t mask = 0;
    const bool beyond[VIEW_PLANES] = {p.x > p.w, p.x + p.w<0, p.y> p.w, p.y + p.w < 0, p.z + p.w<0, p.z> p.w};
    for (int i = 0; i < VIEW_PLANES; ++i) {
        mask |= static_cast<std::uint32_t>(beyond[i]) << i;
    }
    for (int i = 0; i < CLIP_PLANE_COUNT; ++i) {
        if (!(enabled_user_planes_ >> i & 1)) {
            continue;
        }
        const glm::vec4& plane = planes_[VIEW_PLANES + i];
        const float distance = fused(plane.w, p.w, fused(plane.z, p.z, fused(plane.y, p.y, plane.x * p.x)));
        mask |= static_cast<std::uint32_t>(distance < 0) << (VIEW_PLANES + i);
    }
    return mask;
}

bool clip_polygon(const ClipVolume& volume, const ViewportTransform& viewport, ClippedPolygon& polygon)
{
    std::uint32_t some = 0, all = ~0u;
    for (int i = 0; i < polygon.count; ++i) {
        some |= polygon.vertices[i].outside;
        all &= polygon.vertices[i].outside;
    }
    if (all != 0) {
        return false;
    }
    if (some == 0) {
        return true;
    }
    ClippedPolygon other;
    for (int plane = 0; plane < ClipVolume::PLANES && polygon.count >= 3; ++plane) {
        if (!(some >> plane & 1)) {
            continue;
        }
        if (!clip_by_plane(volume.plane(plane), ClipVolume::is_user_plane(plane), viewport, polygon, other)) {
            return false;
        }
        std::swap(polygon, other);
    }
    return polygon.count >= 3;
}

bool clip_line(const ClipVolume& volume, const ViewportTransform& viewport, std::array<ShadedVertex, 2>& line)
{
    const std::uint32_t some = line[0].outside | line[1].outside;
    if (some == 0) {
        return true;
    }
    if (line[0].outside & line[1].outside) {
        return false;
    }
    float t0 = 0, t1 = 0;
    for (int plane = 0; plane < ClipVolume::PLANES; ++plane) {
        if (!(some >> plane & 1)) {
            continue;
        }
        const float d0 = dot(line[0].clip, volume.plane(plane)), d1 = dot(line[1].clip, volume.plane(plane));
        if (!std::isfinite(d0) || !std::isfinite(d1)) {
            return false;
        }
        if (d1 < 0) {
            t1 = std::max(t1, d1 / (d1 - d0));
        }
        if (d0 < 0) {
            t0 = std::max(t0, d0 / (d0 - d1));
        }
        if (t0 + t1 >= 1) {
            return false;
        }
    }
    const std::array<ShadedVertex, 2> whole = line;
    if (whole[0].outside) {
        line[0] = cut(viewport, whole[0], whole[1], t0);
    }
    if (whole[1].outside) {
        line[1] = cut(viewport, whole[1], whole[0], t1);
    }
    return true;
}

} // namespace legacygl
