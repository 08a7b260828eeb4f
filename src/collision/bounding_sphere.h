#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <span>

namespace collision {

/// Holds a sphere that contains something: the lab's BoundingSphere. Metres.
/// In double, since a sphere of a centimetre a thousand kilometres away has no place in floats.
struct BoundingSphere
{
    glm::dvec3 centre{0.0};
    double radius = -1.0; ///< negative: the sphere is empty and contains nothing, not even its centre

    bool is_empty() const { return radius < 0.0; }

    /// Returns whether the point is inside or exactly on the sphere.
    bool contains(const glm::dvec3& point) const;

    friend bool operator==(const BoundingSphere&, const BoundingSphere&) = default;
};

/// Computes the bounding sphere by the lab's algorithm: its centre is the average of all vertices, its
/// radius the largest distance from there to a vertex.
/// Every point is inside: the radius is rounded up to a float, so that converting it loses nothing.
/// No points: the empty sphere. One point, or all at one place: radius 0. Precondition: all are finite.
BoundingSphere average_sphere(std::span<const glm::vec3> points);

/// Points and the matrix that places them, such as the vertices of one part of a tank in a pose.
struct PlacedPoints
{
    std::span<const glm::vec3> points;
    glm::mat4 matrix; ///< affine
};

/// Computes the same over the points of several parts together, each placed by its matrix: the lab's sphere
/// for the whole tank.
BoundingSphere average_sphere(std::span<const PlacedPoints> parts);

} // namespace collision
