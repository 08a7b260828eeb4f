#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string_view>

namespace collision {

/// Names what a query has the form of.
enum class Shape : std::uint8_t
{
    point,
    segment, ///< with both ends; of no length it is a point
    ray,     ///< begins at the origin and never ends
    line,    ///< without ends
};

/// Holds what is tested against spheres: a point, segment, ray or line, and how thick it is. Metres.
struct Query
{
    Shape shape;
    glm::dvec3 origin;    ///< the point, the segment's first end, the ray's origin, a point of the line
    glm::dvec3 end;       ///< the segment's second end; else the same as `origin`
    glm::dvec3 direction; ///< of any length; from end to end for a segment, 0 for a point
    double radius;        ///< 0 or more: of a projectile, all along its way

    static Query point(const glm::dvec3& point, double radius = 0.0)
    {
        return {Shape::point, point, point, glm::dvec3(0.0), radius};
    }
    static Query segment(const glm::dvec3& a, const glm::dvec3& b, double radius = 0.0)
    {
        return {Shape::segment, a, b, b - a, radius};
    }
    static Query ray(const glm::dvec3& origin, const glm::dvec3& direction, double radius = 0.0)
    {
        return {Shape::ray, origin, origin, direction, radius};
    }
    static Query line(const glm::dvec3& point, const glm::dvec3& direction, double radius = 0.0)
    {
        return {Shape::line, point, point, direction, radius};
    }
};

/// Says why a query is not answered.
enum class Refusal : std::uint8_t
{
    none,
    not_finite,      ///< a number in it is infinite or not a number
    too_far,         ///< a coordinate or the radius is beyond MAX_COORDINATE
    negative_radius, ///< less than nothing cannot touch anything
};

/// Metres; there a double still steps by 0.1 micrometres, and nothing that is squared can overflow.
constexpr double MAX_COORDINATE = 1e9;

/// Returns why the query cannot be answered, or Refusal::none.
Refusal refusal_of(const Query& query);

/// Returns the reason as the end of a sentence, such as "a number in it is not finite"; "" for none.
std::string_view refusal_text(Refusal refusal);

} // namespace collision
