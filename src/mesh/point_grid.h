#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>
#include <limits>
#include <vector>

namespace mesh {

/// Finds, among points of the plane, those near a triangle: a grid of cells, each with a list of the points
/// in it.
class PointGrid
{
public:
    /// Prepares an empty grid over `points`, with about one cell for each of the `expected` points to come.
    /// `points` are copied from when inserted, and must outlive the grid unmoved.
    void reset(const std::vector<glm::dvec2>& points, int expected)
    {
        points_ = points.data();
        lowest_ = glm::dvec2(std::numeric_limits<double>::max());
        glm::dvec2 highest = -lowest_;
        for (const glm::dvec2& point : points) {
            lowest_ = {std::min(lowest_.x, point.x), std::min(lowest_.y, point.y)};
            highest = {std::max(highest.x, point.x), std::max(highest.y, point.y)};
        }
        side_ = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(expected))), 1, 512);
        cell_ = (highest - lowest_) / static_cast<double>(side_);
        first_in_cell_.assign(static_cast<std::size_t>(side_) * side_, none);
        next_in_cell_.assign(points.size(), not_inserted);
    }

    /// Adds point number `index`; nothing happens when it is in the grid.
    void insert(int index)
    {
        if (next_in_cell_[index] != not_inserted)
            return;
        int& first = first_in_cell_[cell_index(column_of(points_[index].x), row_of(points_[index].y))];
        next_in_cell_[index] = first;
        first = index;
    }

    /// Returns whether `found(index)` holds for any point that may lie in or on the triangle; it is asked for
    /// all that do and for some that do not. Points for which `keep(index)` is false are taken out of the
    /// grid on the way. `steps_left` is lowered by one for each point and cell looked at.
    template <class Keep, class Found>
    bool any_near_triangle(const std::array<glm::dvec2, 3>& triangle, Keep keep, Found found,
                           long long& steps_left)
    {
        const auto [lowest, highest] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
        const int last_row = row_of(highest);
        for (int row = row_of(lowest); row <= last_row; ++row) {
            const Interval columns = columns_of(triangle, row);
            for (int column = columns.first; column <= columns.last; ++column) {
                --steps_left;
                for (int* link = &first_in_cell_[cell_index(column, row)]; *link != none;) {
                    --steps_left;
                    const int point = *link;
                    if (!keep(point)) {
                        *link = next_in_cell_[point];
                        next_in_cell_[point] = not_inserted;
                    } else if (found(point))
                        return true;
                    else
                        link = &next_in_cell_[point];
                }
            }
        }
        return false;
    }

private:
    static constexpr int none = -1;
    static constexpr int not_inserted = -2;

    struct Interval
    {
        int first;
        int last;
    };

    static int cell_of(double distance, double cell, int side)
    {
        return cell > 0 ? static_cast<int>(std::clamp(distance / cell, 0.0, side - 1.0)) : 0;
    }
    int column_of(double x) const { return cell_of(x - lowest_.x, cell_.x, side_); }
    int row_of(double y) const { return cell_of(y - lowest_.y, cell_.y, side_); }
    std::size_t cell_index(int column, int row) const
    {
        return static_cast<std::size_t>(row) * side_ + column;
    }

    /// The columns in which the triangle meets a row; a little more, against rounding.
    Interval columns_of(const std::array<glm::dvec2, 3>& triangle, int row) const
    {
        constexpr double margin = 0.01; // of a cell
        const double bottom = lowest_.y + (row - margin) * cell_.y;
        const double top = lowest_.y + (row + 1 + margin) * cell_.y;
        double left = std::numeric_limits<double>::max();
        double right = -left;
        const auto include = [&](double x) {
            left = std::min(left, x);
            right = std::max(right, x);
        };
        for (int i = 0; i < 3; ++i) {
            const glm::dvec2 from = triangle[i];
            const glm::dvec2 to = triangle[(i + 1) % 3];
            if (from.y >= bottom && from.y <= top)
                include(from.x);
            for (const double y : {bottom, top})
                if ((from.y < y) != (to.y < y))
                    include(from.x + (to.x - from.x) * ((y - from.y) / (to.y - from.y)));
        }
        if (left > right)
            return {0, -1};
        return {column_of(left - margin * cell_.x), column_of(right + margin * cell_.x)};
    }

    const glm::dvec2* points_ = nullptr;
    glm::dvec2 lowest_{0};
    glm::dvec2 cell_{0}; ///< size of a cell
    int side_ = 1;       ///< cells in a row and in a column
    std::vector<int> first_in_cell_;
    std::vector<int> next_in_cell_; ///< for each point the next in its cell, or none, or not_inserted
};

} // namespace mesh
