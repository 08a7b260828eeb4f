#include "mesh/obj_reader.h"
#include "mesh/polygon.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <map>
#include <numeric>
#include <random>

namespace {

using mesh::CornerTriangle;
using Outline = std::vector<glm::vec3>;

glm::dvec3 twice_area(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    return glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
}

struct Cut
{
    std::vector<CornerTriangle> triangles;
    long long steps = 0;
};

Cut cut(const Outline& outline)
{
    Cut result;
    long long steps_left = mesh::MAX_POLYGON_STEPS;
    EXPECT_TRUE(mesh::triangulate_polygon(outline, result.triangles, steps_left));
    result.steps = mesh::MAX_POLYGON_STEPS - steps_left;
    return result;
}

/// Checks what every answer has to have: n - 2 triangles that are joined along inner edges, and bounded by
/// the outline.
void expect_cut_along_inner_edges(const Outline& outline, const std::vector<CornerTriangle>& triangles)
{
    const int n = int(outline.size());
    ASSERT_EQ(int(triangles.size()), n - 2);
    std::map<std::pair<int, int>, int> edges;
    for (const CornerTriangle& t : triangles) {
        for (int i = 0; i < 3; ++i) {
            ASSERT_TRUE(t[i] >= 0 && t[i] < n);
            ++edges[{t[i], t[(i + 1) % 3]}];
        }
    }
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        const bool on_outline = edge.second == (edge.first + 1) % n;
        EXPECT_EQ(edges.count({edge.second, edge.first}), on_outline ? 0U : 1U);
    }
}

/// Checks that the triangles of a flat polygon cover its inside exactly once: none is turned over, and
/// together they are as large as it is. Triangles joined as above that are all turned the same way cannot
/// overlap then. `tolerance`, in units of squared length, is for outlines whose corners are rounded.
void expect_covered_once(const Outline& outline, const std::vector<CornerTriangle>& triangles,
                         double tolerance = 0)
{
    glm::dvec3 normal(0);
    for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
        normal += twice_area(outline[0], outline[i], outline[i + 1]);
    }
    const double size = glm::length(normal);
    double sum = 0;
    for (const CornerTriangle& t : triangles) {
        const double area = glm::dot(twice_area(outline[t[0]], outline[t[1]], outline[t[2]]), normal / size);
        EXPECT_GE(area, -tolerance);
        sum += std::fabs(area);
    }
    EXPECT_NEAR(sum, size, tolerance * double(triangles.size()) + 1e-12 * size);
}

void expect_well_cut(const Outline& outline)
{
    const Cut result = cut(outline);
    expect_cut_along_inner_edges(outline, result.triangles);
    expect_covered_once(outline, result.triangles);
}

Outline flat(const std::vector<glm::vec2>& points)
{
    Outline outline;
    for (const glm::vec2& p : points) {
        outline.emplace_back(p.x, p.y, 0);
    }
    return outline;
}

double cross(glm::dvec2 a, glm::dvec2 b)
{
    return a.x * b.y - a.y * b.x;
}

bool edges_cross(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d)
{
    const auto side = [](glm::dvec2 p, glm::dvec2 q, glm::dvec2 r) { return cross(q - p, r - p); };
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

/// A polygon that does not cross itself through random points: crossing edges are uncrossed until there are
/// none.
std::vector<glm::vec2> random_simple_polygon(std::mt19937& random, int n)
{
    std::vector<glm::vec2> p;
    for (int i = 0; i < n; ++i) {
        p.emplace_back(float(random() % 100'003) / 97, float(random() % 100'003) / 97);
    }
    for (bool crossed = true; crossed;) {
        crossed = false;
        for (int i = 0; i < n; ++i) {
            for (int j = i + 1; j < n; ++j) {
                if (edges_cross(p[i], p[i + 1], p[j], p[(j + 1) % n])) {
                    std::reverse(p.begin() + i + 1, p.begin() + j + 1);
                    crossed = true;
                }
            }
        }
    }
    return p;
}

/// The outline of random connected cells of a board, filled where it has holes; full of corners on one line.
std::vector<glm::vec2> random_outline_of_cells(std::mt19937& random, int side)
{
    std::vector<std::vector<bool>> filled(side + 2, std::vector<bool>(side + 2, false));
    const auto neighbours = [&](int x, int y) {
        return filled[x - 1][y] + filled[x + 1][y] + filled[x][y - 1] + filled[x][y + 1];
    };
    filled[side / 2][side / 2] = true;
    for (int i = 0; i < side * side * 4; ++i) {
        const int x = 1 + int(random() % unsigned(side));
        const int y = 1 + int(random() % unsigned(side));
        // A cell with one filled neighbour and no filled corner beside it can enclose nothing and touch
        // nothing.
        int around = 0;
        for (int dx = -1; dx <= 1; ++dx) {
            for (int dy = -1; dy <= 1; ++dy) {
                around += filled[x + dx][y + dy] ? 1 : 0;
            }
        }
        if (!filled[x][y] && neighbours(x, y) == 1 && around <= 2) {
            filled[x][y] = true;
        }
    }
    // Walk round with the filled cells on the left, starting at the lowest edge of the first column that has
    // one.
    int x = 0;
    int y = 0;
    while (!filled[x][y]) {
        y == side ? (++x, y = 0) : ++y;
    }
    std::vector<glm::vec2> outline;
    const glm::ivec2 start(x, y);
    glm::ivec2 at = start;
    glm::ivec2 step(1, 0);
    const auto cell_left_of = [&](glm::ivec2 corner, glm::ivec2 direction) {
        const int cx = direction.x + direction.y > 0 ? (direction.x > 0 ? corner.x : corner.x - 1)
                                                     : (direction.x < 0 ? corner.x - 1 : corner.x);
        const int cy = direction.x != 0 ? (direction.x > 0 ? corner.y : corner.y - 1)
                                        : (direction.y > 0 ? corner.y : corner.y - 1);
        return bool(filled[cx][cy]);
    };
    do {
        outline.emplace_back(at);
        at += step;
        const glm::ivec2 left(-step.y, step.x);
        if (cell_left_of(at, -left)) {
            step = -left;
        } else if (!cell_left_of(at, step)) {
            step = left;
        }
    } while (at != start);
    return outline;
}

TEST(TriangulatePolygon, LeavesATriangleAsItIs)
{
    EXPECT_EQ(cut(flat({{0, 0}, {1, 0}, {0, 1}})).triangles, (std::vector<CornerTriangle>{{0, 1, 2}}));
}

TEST(TriangulatePolygon, CutsConvexPolygonsAsAFanFromTheFirstCorner)
{
    EXPECT_EQ(cut(flat({{0, 0}, {2, 0}, {3, 1}, {2, 2}, {0, 2}})).triangles,
              (std::vector<CornerTriangle>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

TEST(TriangulatePolygon, CutsEveryConcaveQuadThroughItsReflexCorner)
{
    const std::vector<glm::vec2> dart = {{0, 0}, {4, -2}, {1, 0}, {4, 2}};
    for (int turned = 0; turned < 4; ++turned) {
        for (const bool clockwise : {false, true}) {
            std::vector<glm::vec2> p = dart;
            std::rotate(p.begin(), p.begin() + turned, p.end());
            if (clockwise) {
                std::reverse(p.begin(), p.end());
            }
            expect_well_cut(flat(p));
        }
    }
}

TEST(TriangulatePolygon, CutsInEveryCoordinatePlaneAndAcrossThem)
{
    const std::vector<glm::vec2> l = {{2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 0}};
    for (const glm::vec3 u :
         {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1), glm::vec3(1, 2, -1)}) {
        for (const glm::vec3 v :
             {glm::vec3(0, 1, 0), glm::vec3(0, 0, 1), glm::vec3(-1, 0, 0), glm::vec3(3, -1, 1)}) {
            if (glm::length(glm::cross(u, v)) > 0) {
                Outline outline;
                for (const glm::vec2& p : l) {
                    outline.push_back(glm::vec3(5, 6, 7) + u * p.x + v * p.y);
                }
                expect_well_cut(outline);
            }
        }
    }
}

TEST(TriangulatePolygon, CutsCornersOnOneLine)
{
    expect_well_cut(flat({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}})); // from a corner
    expect_well_cut(
        flat({{1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}, {0, 0}})); // every side halved
    expect_well_cut(flat({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {0, 4}}));     // a triangle
}

TEST(TriangulatePolygon, CutsAPolygonWithABridgeToItsHole)
{
    // A square with a square hole; the bridge runs from (0, 0) to (1, 1), there and back.
    const Outline outline =
        flat({{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}});
    expect_well_cut(outline);
    for (int turned = 1; turned < 10; ++turned) {
        Outline rotated = outline;
        std::rotate(rotated.begin(), rotated.begin() + turned, rotated.end());
        expect_well_cut(rotated);
    }
}

TEST(TriangulatePolygon, CutsRandomPolygonsThatDoNotCrossThemselves)
{
    std::mt19937 random(1);
    for (int i = 0; i < 400; ++i) {
        expect_well_cut(flat(random_simple_polygon(random, 4 + i % 60)));
    }
}

TEST(TriangulatePolygon, CutsRandomOutlinesOfCells)
{
    std::mt19937 random(2);
    std::size_t longest = 0;
    for (int i = 0; i < 200; ++i) {
        const std::vector<glm::vec2> outline = random_outline_of_cells(random, 3 + i % 20);
        longest = std::max(longest, outline.size());
        expect_well_cut(flat(outline));
    }
    EXPECT_GT(longest, 100U); // the generator does grow something
}

TEST(TriangulatePolygon, CutsAnyPolygonWithoutAreaSomehow)
{
    const std::vector<Outline> outlines = {
        Outline(7, glm::vec3(1, 2, 3)),                                 // one point
        flat({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {2, 0}}),                 // a line, there and back
        flat({{0, 0}, {1, 1}, {1, 0}, {0, 1}}),                         // a bow tie
        flat({{0, 0}, {3, 0}, {1, 0}, {2, 0}, {0, 0}, {5, 0}, {0, 0}}), // a muddle on a line
        Outline(5, glm::vec3(3e38F, -3e38F, 3e38F)),                    // far out
        {{3e38F, 0, 0}, {0, 3e38F, 0}, {-3e38F, 0, 0}, {0, 1e-40F, 0}, {0, -1e38F, 0}} // of every size
    };
    for (const Outline& outline : outlines) {
        expect_cut_along_inner_edges(outline, cut(outline).triangles);
    }
}

TEST(TriangulatePolygon, CutsAnyPolygonThatCrossesItselfSomehow)
{
    std::mt19937 random(3);
    for (int i = 0; i < 500; ++i) {
        Outline outline;
        const int n = 4 + int(random() % 40);
        const unsigned grid = 2 + random() % 9; // a coarse one makes many corners coincide
        for (int j = 0; j < n; ++j) {
            outline.emplace_back(float(random() % grid), float(random() % grid), float(random() % grid));
        }
        expect_cut_along_inner_edges(outline, cut(outline).triangles);
    }
}

// Large polygons: the work must not grow with the square of the number of corners.

constexpr int MANY_CORNERS = 20'000;
constexpr long long steps_a_corner =
    150; // some searches of 13 levels; a corner compared with all others takes 20,000

TEST(TriangulatePolygon, CutsALargeRegularPolygonInGoodTime)
{
    Outline outline;
    for (int i = 0; i < MANY_CORNERS; ++i) {
        const double angle = 2 * 3.14159265358979 * i / MANY_CORNERS;
        outline.emplace_back(std::cos(angle), 0.5, std::sin(angle)); // rounded, it is not quite convex
    }
    const Cut result = cut(outline);
    expect_cut_along_inner_edges(outline, result.triangles);
    expect_covered_once(outline, result.triangles, 1e-10);
    EXPECT_LT(result.steps, steps_a_corner * MANY_CORNERS);
}

TEST(TriangulatePolygon, CutsALargeStarInGoodTime)
{
    Outline outline;
    for (int i = 0; i < MANY_CORNERS; ++i) {
        const double angle = 2 * 3.14159265358979 * i / MANY_CORNERS;
        const double radius = i % 2 == 0 ? 1000 : 10;
        outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    }
    const Cut result = cut(outline);
    expect_cut_along_inner_edges(outline, result.triangles);
    expect_covered_once(outline, result.triangles);
    EXPECT_LT(result.steps, steps_a_corner * MANY_CORNERS);
}

TEST(TriangulatePolygon, CutsALargeCombInGoodTime)
{
    std::vector<glm::vec2> p;
    for (int i = 0; i < MANY_CORNERS / 2; ++i) {
        p.emplace_back(float(i), 0);
        p.emplace_back(float(i) + 0.5f, 5000);
    }
    p.emplace_back(float(MANY_CORNERS), -1);
    const Cut result = cut(flat(p));
    expect_covered_once(flat(p), result.triangles);
    EXPECT_LT(result.steps, steps_a_corner * MANY_CORNERS);
}

TEST(TriangulatePolygon, CutsALargeSpiralInGoodTime)
{
    std::vector<glm::vec2> p;
    for (int i = 0; i < MANY_CORNERS; ++i) // out along one side of the band, back along the other
    {
        const int along = i < MANY_CORNERS / 2 ? i : MANY_CORNERS - 1 - i;
        const double angle = along * 0.02;
        const double radius = 10 + angle + (i < MANY_CORNERS / 2 ? 0 : 2);
        p.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    const Cut result = cut(flat(p));
    expect_covered_once(flat(p), result.triangles);
    EXPECT_LT(result.steps, steps_a_corner * MANY_CORNERS);
}

TEST(TriangulatePolygon, GivesUpOnALargeTangleBeforeItTakesLong)
{
    std::mt19937 random(4);
    Outline outline;
    for (int i = 0; i < 200'000; ++i) {
        outline.emplace_back(float(random() % 1000), float(random() % 1000), 0);
    }
    std::vector<CornerTriangle> triangles;
    long long steps_left = mesh::MAX_POLYGON_STEPS;
    EXPECT_FALSE(mesh::triangulate_polygon(outline, triangles, steps_left));
    EXPECT_LT(-steps_left, mesh::MAX_POLYGON_STEPS / 100); // it stops soon after it has used them up
}

} // namespace
