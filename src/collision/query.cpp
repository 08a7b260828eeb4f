#include "collision/query.h"

#include <algorithm>
#include <cmath>

namespace collision {

namespace {

bool is_finite(const glm::dvec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool is_near(const glm::dvec3& v)
{
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) <= LARGEST_COORDINATE;
}

} // namespace

Refusal refusal_of(const Query& query)
{
    if (!is_finite(query.origin) || !is_finite(query.end) || !is_finite(query.direction) ||
        !std::isfinite(query.radius)) {
        return Refusal::not_finite;
    }
    if (query.radius < 0.0) {
        return Refusal::negative_radius;
    }
    // A segment's direction follows from its ends and may be twice as long as they are far.
    const bool is_direction_near = query.shape == Shape::segment || is_near(query.direction);
    return is_near(query.origin) && is_near(query.end) && is_direction_near &&
                   query.radius <= LARGEST_COORDINATE
               ? Refusal::none
               : Refusal::too_far;
}

std::string_view refusal_text(Refusal refusal)
{
    switch (refusal) {
    case Refusal::none:
        return "";
    case Refusal::not_finite:
        return "a number in it is not finite";
    case Refusal::too_far:
        return "it reaches further than 1,000,000 km";
    case Refusal::negative_radius:
        return "its radius is negative";
    }
    return "";
}

} // namespace collision
