#include "mesh/point_tree.h"

#include <algorithm>
#include <numeric>

namespace mesh {

void Box::include(const glm::dvec2& point)
{
    lowest = {std::min(lowest.x, point.x), std::min(lowest.y, point.y)};
    highest = {std::max(highest.x, point.x), std::max(highest.y, point.y)};
}

bool Box::may_touch(const std::array<glm::dvec2, 3>& triangle) const
{
    for (int i = 0; i < 3; ++i) {
        const glm::dvec2 from = triangle[i];
        const glm::dvec2 to = triangle[(i + 1) % 3];
        const glm::dvec2 furthest_left(to.y > from.y ? lowest.x : highest.x,
                                       to.x > from.x ? highest.y : lowest.y);
        if (turn(from, to, furthest_left) < 0) {
            return false;
        }
    }
    const auto [left, right] = std::minmax({triangle[0].x, triangle[1].x, triangle[2].x});
    const auto [bottom, top] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
    return left <= highest.x && right >= lowest.x && bottom <= highest.y && top >= lowest.y;
}

PointTree::PointTree(const std::vector<glm::dvec2>& points)
    : points_(points), order_(points.size()), place_(points.size()), is_marked_(points.size(), 0)
{
    std::iota(order_.begin(), order_.end(), 0);
    build({0, 0, static_cast<int>(order_.size())});
    for (int i = 0; i < static_cast<int>(order_.size()); ++i) {
        place_[order_[i]] = i;
    }
}

void PointTree::build(const Node& node)
{
    if (contents_.size() <= static_cast<std::size_t>(node.index)) {
        contents_.resize(node.index + 1);
    }
    Box box;
    for (int i = node.begin; i < node.end; ++i) {
        box.include(points_[order_[i]]);
    }
    contents_[node.index].box = box;
    if (node.is_leaf()) {
        return;
    }
    const glm::dvec2 size = box.highest - box.lowest;
    const int axis = size.x >= size.y ? 0 : 1;
    std::nth_element(order_.begin() + node.begin, order_.begin() + node.middle(), order_.begin() + node.end,
                     [&](int a, int b) { return points_[a][axis] < points_[b][axis]; });
    build(node.left());
    build(node.right());
}

void PointTree::mark(int point, bool marked)
{
    if ((is_marked_[point] != 0) == marked) {
        return;
    }
    is_marked_[point] = marked ? 1 : 0;
    Node node{0, 0, static_cast<int>(order_.size())};
    contents_[0].marked += marked ? 1 : -1;
    while (!node.is_leaf()) {
        node = place_[point] < node.middle() ? node.left() : node.right();
        contents_[node.index].marked += marked ? 1 : -1;
    }
}

} // namespace mesh
