#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>

namespace assets {

/// Finds the colours of a triangle's three corners, between which it is shaded smoothly, from what is seen at
/// places of it: by least squares, so that what lies between the corners is off by as little as can be, but
/// as varied as what was seen, and no colour beyond it.
class CornerFit
{
public:
    /// Adds what is seen at a place, in [0, 1]. `parts` is what the place has of each corner, together 1;
    /// `weight` > 0.
    void add(const glm::vec3& colour, const glm::dvec3& parts, double weight);

    /// Returns the colours of the corners; nothing where nothing was seen.
    std::optional<std::array<glm::vec3, 3>> corners() const;

private:
    glm::dvec3 mean() const { return sum_ / weight_; }
    double stretch(const glm::dmat3& off) const;

    glm::dmat3 parts_{0.0};   ///< sum of the outer products of parts
    glm::dmat3 colours_{0.0}; ///< sum of the outer products of colours and parts
    glm::dvec3 sum_{0.0};
    double squares_ = 0.0; ///< of lightness
    glm::dvec3 least_{1.0};
    glm::dvec3 most_{0.0};
    double weight_ = 0.0;
};

} // namespace assets
