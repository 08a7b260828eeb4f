#include "mesh/polygon.h"

#include "mesh/ear_clipper.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace mesh {
namespace {

/// Twice the polygon's vector area. The corners are taken relative to the first, against cancellation.
glm::dvec3 newell_normal(std::span<const glm::vec3> corners)
{
    const glm::dvec3 origin(corners[0]);
    glm::dvec3 sum(0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        sum += glm::cross(glm::dvec3(corners[i]) - origin, glm::dvec3(corners[i + 1]) - origin);
    }
    return sum;
}

/// Drops the coordinate along which the polygon is seen largest, so that it turns anticlockwise.
std::vector<glm::dvec2> project(std::span<const glm::vec3> corners, const glm::dvec3& normal)
{
    const glm::dvec3 size = glm::abs(normal);
    const int dropped = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    int first = (dropped + 1) % 3;
    int second = (dropped + 2) % 3;
    if (normal[dropped] < 0) {
        std::swap(first, second);
    }
    std::vector<glm::dvec2> points;
    points.reserve(corners.size());
    for (const glm::vec3& corner : corners) {
        points.emplace_back(corner[first], corner[second]);
    }
    return points;
}

bool first_corner_sees_all(const std::vector<glm::dvec2>& points)
{
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        if (!(turn(points[0], points[i], points[i + 1]) > 0)) {
            return false;
        }
    }
    return true;
}

} // namespace

bool triangulate_polygon(std::span<const glm::vec3> corners, std::vector<CornerTriangle>& triangles,
                         long long& steps_left)
{
    const int count = static_cast<int>(corners.size());
    if (count > 3) {
        const glm::dvec3 normal = newell_normal(corners);
        if (normal != glm::dvec3(0)) // otherwise there is no inside to keep to
        {
            std::vector<glm::dvec2> points = project(corners, normal);
            if (!first_corner_sees_all(points)) {
                return EarClipper(std::move(points), steps_left).clip(triangles);
            }
        }
    }
    for (int i = 1; i + 1 < count; ++i) {
        triangles.push_back({0, i, i + 1});
    }
    return true;
}

} // namespace mesh
