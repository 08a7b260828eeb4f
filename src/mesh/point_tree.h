#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <vector>

namespace mesh {

/// Returns twice the signed area of triangle abc: positive when it turns anticlockwise.
/// Exact for coordinates that are floats of similar size, since the products fit a double.
inline double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// A rectangle along the axes; no point is in one that was just made.
struct Box
{
    glm::dvec2 lowest{1e300};
    glm::dvec2 highest{-1e300};

    void include(const glm::dvec2& point);

    /// False only when the box and the triangle, which turns anticlockwise, have no point in common.
    /// Rounds as turn() does: a point for which turn() is not negative at any edge is in no box that is ruled
    /// out.
    bool may_touch(const std::array<glm::dvec2, 3>& triangle) const;
};

/// Finds those of some points of the plane that are marked and near a triangle. A k-d tree with tight boxes,
/// so that neither points in clusters nor long thin triangles make a search long.
class PointTree
{
public:
    /// `points` must outlive the tree unmoved. None is marked.
    explicit PointTree(const std::vector<glm::dvec2>& points);

    /// Marks a point, or takes its mark away.
    void mark(int point, bool marked);

    /// Returns whether `found(point)` holds for any marked point that lies in or on the triangle, which must
    /// turn anticlockwise; it is asked for some others too. `steps_left` is lowered by the boxes and points
    /// looked at.
    template <class Found>
    bool any_near_triangle(const std::array<glm::dvec2, 3>& triangle, Found found,
                           long long& steps_left) const
    {
        return any_in_node({0, 0, static_cast<int>(order_.size())}, triangle, found, steps_left);
    }

private:
    static constexpr int LEAF_SIZE = 4;

    /// A node is named by its index, children of k being 2k + 1 and 2k + 2, and its part of `order_`.
    struct Node
    {
        int index;
        int begin;
        int end;

        bool is_leaf() const { return end - begin <= LEAF_SIZE; }
        int middle() const { return begin + (end - begin) / 2; }
        Node left() const { return {2 * index + 1, begin, middle()}; }
        Node right() const { return {2 * index + 2, middle(), end}; }
    };

    struct Content
    {
        Box box;
        int marked = 0; ///< how many points in it are
    };

    void build(const Node& node);

    template <class Found>
    bool any_in_node(const Node& node, const std::array<glm::dvec2, 3>& triangle, Found& found,
                     long long& steps_left) const
    {
        --steps_left;
        const Content& content = contents_[node.index];
        if (content.marked == 0 || !content.box.may_touch(triangle)) {
            return false;
        }
        if (!node.is_leaf()) {
            return any_in_node(node.left(), triangle, found, steps_left) ||
                   any_in_node(node.right(), triangle, found, steps_left);
        }
        steps_left -= LEAF_SIZE;
        for (int i = node.begin; i < node.end; ++i) {
            if (is_marked_[order_[i]] && found(order_[i])) {
                return true;
            }
        }
        return false;
    }

    const std::vector<glm::dvec2>& points_;
    std::vector<int> order_;        ///< the points, those of each node together
    std::vector<int> place_;        ///< of each point in `order_`
    std::vector<Content> contents_; ///< of each node
    std::vector<char> is_marked_;
};

} // namespace mesh
