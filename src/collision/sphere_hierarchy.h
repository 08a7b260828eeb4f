#pragma once

#include "collision/bounding_sphere.h"
#include "collision/part_set.h"
#include "collision/query.h"

#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <span>
#include <vector>

namespace collision {

/// Holds the short answer to a query.
struct HitResult
{
    Refusal refusal = Refusal::none; ///< otherwise the rest is empty
    bool is_root_entered = false;    ///< inside the sphere around the whole
    PartSet parts;                   ///< whose spheres it is inside of

    friend bool operator==(const HitResult&, const HitResult&) = default;
};

/// Holds how a query was tested against one sphere. Metres.
struct SphereTest
{
    BoundingSphere sphere;
    glm::dvec3 closest_point{0.0}; ///< of the point, segment, ray or line to the centre
    double parameter = 0.0;        ///< of that point: origin + parameter * direction; 0 for a point
    double distance = 0.0;         ///< from that point to the centre
    double depth = 0.0;            ///< sphere's radius + query's radius - distance; 0 or more when inside
    bool is_inside = false;        ///< also when exactly on the sphere
};

/// Holds the full answer to a query: what was tested, and how it came out.
struct Explanation
{
    Refusal refusal = Refusal::none; ///< otherwise the rest is empty
    SphereTest root;
    std::vector<SphereTest> parts; ///< of every part, or of none when the root was not entered
    PartSet hits;                  ///< the parts that came out as inside
};

/// Counts what refit() has computed since the hierarchy was made.
struct RefitCounts
{
    std::uint64_t parts = 0; ///< spheres of parts that were moved
    std::uint64_t roots = 0; ///< spheres around the whole that were fitted
};

/// Holds the bounding spheres of something made of parts: one sphere around the whole, then one for each
/// part, whichever part hangs on whichever. A query is tested against the whole first and, only if inside,
/// against every part.
///
/// The sphere around the whole, the root, is the smallest around those of the parts, so that it contains them
/// in every pose, grown by ROOT_MARGIN. The lab's sphere for the whole, from all vertices at rest, need not
/// contain what has turned since; it is carried along to be shown.
class SphereHierarchy
{
public:
    /// So much, in metres, is added to the root's radius (and 1e-12 of it): more than what rounding can do to
    /// the distance from a line up to 1e6 m away, so that never a part is hit and the root is not.
    static constexpr double ROOT_MARGIN = 1e-9;

    SphereHierarchy() = default;

    /// Takes each part's sphere in the coordinates of its mesh. All matrices are the identity at first.
    /// An empty sphere is a part that nothing hits. Precondition: at most MAX_PARTS, all finite.
    explicit SphereHierarchy(std::span<const BoundingSphere> local_spheres);

    /// Sets the sphere that whole() carries along with a part. In the coordinates of that part's mesh.
    /// Precondition: the part exists.
    void carry_whole(const BoundingSphere& local_sphere, std::size_t part);

    /// Moves the spheres to where the matrices take the parts' meshes. Computes only what has changed: the
    /// spheres of parts with another matrix than last time and, if one of these moved, the root. Allocates
    /// nothing.
    /// Precondition: as many matrices as parts, all affine and finite.
    void refit(std::span<const glm::mat4> part_matrices);

    std::size_t part_count() const { return parts_.size(); }

    /// Returns the sphere that tests begin with; empty when all parts are.
    const BoundingSphere& root() const { return root_; }

    /// Returns the parts' spheres where they are now, by index of the part.
    std::span<const BoundingSphere> parts() const { return parts_; }

    /// Returns the carried sphere where it is now; empty when none was set.
    const BoundingSphere& whole() const { return whole_; }

    const RefitCounts& refit_counts() const { return counts_; }

    /// Tests the query against the root and, if inside, against every part. Allocates nothing.
    HitResult hit_test(const Query& query) const;

    /// Does the same and tells all of it. Agrees with hit_test() about what is inside.
    Explanation explain(const Query& query) const;

private:
    void fit_root();

    std::vector<BoundingSphere> local_;
    std::vector<glm::mat4> matrices_;
    std::vector<BoundingSphere> parts_;
    BoundingSphere root_;
    BoundingSphere whole_local_;
    BoundingSphere whole_;
    std::size_t whole_part_ = 0;
    RefitCounts counts_;
};

} // namespace collision
