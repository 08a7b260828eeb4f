#pragma once

#include "mesh/point_tree.h"
#include "mesh/polygon.h"

#include <glm/vec2.hpp>
#include <vector>

namespace mesh {

/// Cuts one flat polygon by clipping ears: corners whose two neighbours see each other through the polygon.
/// Corners wait in a queue. One that is no ear becomes one only when a neighbour is clipped (or, where the
/// polygon touches itself, when what it touches is), so each is looked at a few times only.
class EarClipper
{
public:
    /// `points` turn anticlockwise as a whole; at least 3. `steps_left`: see triangulate_polygon.
    EarClipper(std::vector<glm::dvec2> points, long long& steps_left);

    /// Appends the triangles. False when the steps ran out. Call once.
    [[nodiscard]] bool clip(std::vector<CornerTriangle>& triangles);

private:
    struct Corner
    {
        int previous;
        int next;
        bool convex;
        bool clipped;
        bool waiting;
    };

    /// What may lie in an ear: nothing but its own corners; or other corners on its outline.
    enum class Contact
    {
        none,
        outline,
    };

    void classify(int corner);
    void wait(int corner);
    void wait_all();
    bool is_ear(int corner, Contact allowed);
    int corner_to_force();
    void clip_corner(int corner, std::vector<CornerTriangle>& triangles);

    std::vector<glm::dvec2> points_;
    std::vector<Corner> corners_;
    std::vector<int> queue_; ///< corners to look at, from queue_front_ on
    std::size_t queue_front_ = 0;
    PointTree reflex_;    ///< marked: the corners left that are not convex; only they can be in an ear's way
    int some_corner_ = 0; ///< one that is not clipped
    int remaining_ = 0;
    long long& steps_left_;
};

} // namespace mesh
