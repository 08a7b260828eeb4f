#pragma once

#include <glm/vec3.hpp>

namespace scene {

/// The round shapes that spheres and marks are drawn with, compiled once into display lists of the current
/// context. They set normals and no colour. Lengths in metres.
class Shapes
{
public:
    /// Compiles the lists. Returns false when OpenGL has no names for lists, or GLU no memory, left.
    bool load();

    /// Draws a bounding sphere: its faces, or wires along circles of latitude and longitude.
    void draw_sphere(const glm::dvec3& centre, double radius) const { draw_at(SPHERE, centre, radius); }
    void draw_wire_sphere(const glm::dvec3& centre, double radius) const
    {
        draw_at(WIRE_SPHERE, centre, radius);
    }

    /// Draws a small ball that marks a place.
    void draw_ball(const glm::dvec3& centre, double radius) const { draw_at(BALL, centre, radius); }

    /// Draws a cone without a base, from its base to its tip. direction: of unit length.
    void draw_cone(const glm::dvec3& base, const glm::dvec3& direction, double radius, double length) const;

    /// Draws a ring, a line, in the plane of two axes. Their lengths are the ring's radius.
    void draw_ring(const glm::dvec3& centre, const glm::dvec3& x, const glm::dvec3& y) const;

    /// Returns the names of the lists of spheres, for those who check what was drawn.
    unsigned sphere_list() const { return first_list_ + SPHERE; }
    unsigned wire_sphere_list() const { return first_list_ + WIRE_SPHERE; }

private:
    enum List : unsigned
    {
        SPHERE,
        WIRE_SPHERE,
        BALL,
        CONE,
        RING,
        LIST_COUNT
    };

    void draw_at(List list, const glm::dvec3& centre, double radius) const;

    unsigned first_list_ = 0;
};

} // namespace scene
