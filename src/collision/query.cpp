#include "collision/query.h"

#include <cmath>

namespace collision {

namespace {

bool is_finite(const glm::dvec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// False for not-a-number, too.
bool is_near(const glm::dvec3& v)
{
    return std::abs(v.x) <= MAX_COORDINATE && std::abs(v.y) <= MAX_COORDINATE &&
           std::abs(v.z) <= MAX_COORDINATE;
}

} // namespace

Refusal refusal_of(const Query& query)
{
    // The good ones first, which are nearly all.
    // A segment's direction follows from its ends and may be twice as long as they are far.
    const glm::dvec3& other = query.shape == Shape::segment ? query.end : query.direction;
    if (is_near(query.origin) && is_near(other) && query.radius >= 0.0 && query.radius <= MAX_COORDINATE) {
        return Refusal::none;
    }
    if (!is_finite(query.origin) || !is_finite(query.end) || !is_finite(query.direction) ||
        !std::isfinite(query.radius)) {
        return Refusal::not_finite;
    }
    return query.radius < 0.0 ? Refusal::negative_radius : Refusal::too_far;
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
