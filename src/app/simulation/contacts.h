#pragma once

#include "collision/part_set.h"
#include "collision/sphere_hierarchy.h"

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

namespace app {

/// Follows one projectile from step to step and finds out which parts' spheres it touches. The way between
/// two steps is tested as a segment, so nothing is missed at any speed. Plain data; allocates nothing.
class Contacts
{
public:
    /// Forgets everything: whatever the projectile is inside of when it next moves, it touches.
    void forget() { *this = {}; }

    /// Takes the projectile as being at a place already, whatever it is inside of there.
    void place(const glm::dvec3& position, double radius, const collision::SphereHierarchy& spheres);

    /// Puts the projectile to where its way begins; what it is inside of there it touches in its next move.
    void launch(const glm::dvec3& position);

    /// Moves the projectile to a place, or away for nothing, and calls touch(part, position) once for every
    /// part whose sphere it was not inside of before and has touched on the way, even if it is outside
    /// again; lowest index first. position: where it first was inside.
    template <class Touch>
    void move(const std::optional<glm::dvec3>& position, double radius,
              const collision::SphereHierarchy& spheres, Touch&& touch)
    {
        if (!position) {
            forget();
            return;
        }
        const glm::dvec3 from = last_.value_or(*position);
        const collision::PartSet on_the_way =
            spheres.hit_test(collision::Query::segment(from, *position, radius)).parts;
        collision::PartSet(on_the_way.bits() & ~inside_.bits()).for_each([&](std::size_t part) {
            touch(part, first_place_inside(spheres.parts()[part], from, *position, radius));
        });
        place(*position, radius, spheres);
    }

    /// Returns the parts it is inside of.
    collision::PartSet inside() const { return inside_; }

private:
    static glm::dvec3 first_place_inside(const collision::BoundingSphere& sphere, const glm::dvec3& from,
                                         const glm::dvec3& to, double radius);

    std::optional<glm::dvec3> last_;
    collision::PartSet inside_;
};

} // namespace app
