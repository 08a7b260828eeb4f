#include "legacygl/vertex/primitives.h"

#include <gtest/gtest.h>

namespace {

using namespace legacygl;
using Indices = std::vector<std::uint32_t>;

Indices cut(GLenum mode, std::uint32_t count)
{
    Indices out;
    append_indices(mode, 10, count, out);
    return out;
}

TEST(Primitives, AreCutWithTheProvokingVertexLast)
{
    EXPECT_EQ(cut(GL_POINTS, 2), (Indices{10, 11}));
    EXPECT_EQ(cut(GL_LINES, 5), (Indices{10, 11, 12, 13}));
    EXPECT_EQ(cut(GL_LINE_STRIP, 3), (Indices{10, 11, 11, 12}));
    EXPECT_EQ(cut(GL_LINE_LOOP, 3), (Indices{10, 11, 11, 12, 12, 10}));
    EXPECT_EQ(cut(GL_TRIANGLES, 5), (Indices{10, 11, 12}));
    EXPECT_EQ(cut(GL_TRIANGLE_STRIP, 5), (Indices{10, 11, 12, 12, 11, 13, 12, 13, 14}));
    EXPECT_EQ(cut(GL_TRIANGLE_FAN, 4), (Indices{10, 11, 12, 10, 12, 13}));
    EXPECT_EQ(cut(GL_QUADS, 4), (Indices{10, 11, 13, 11, 12, 13}));
    EXPECT_EQ(cut(GL_QUAD_STRIP, 4), (Indices{10, 11, 13, 12, 10, 13}));
    EXPECT_EQ(cut(GL_POLYGON, 4), (Indices{11, 12, 10, 12, 13, 10}));
}

TEST(Primitives, TooFewVerticesDrawNothing)
{
    for (GLenum mode = GL_LINES; mode <= GL_POLYGON; ++mode) {
        EXPECT_TRUE(cut(mode, 0).empty()) << mode;
        EXPECT_TRUE(cut(mode, 1).empty()) << mode;
    }
    EXPECT_EQ(cut(GL_LINE_LOOP, 2), (Indices{10, 11, 11, 10}));
    EXPECT_TRUE(cut(GL_QUADS, 3).empty());
}

TEST(Runs, WholeTrianglesInARowNeedNoIndices)
{
    const Primitive primitives[] = {{GL_TRIANGLES, 0, 6, true, true}, {GL_TRIANGLES, 6, 3, true, true}};
    std::vector<DrawRun> runs;
    Indices indices;
    make_runs(primitives, runs, indices);
    ASSERT_EQ(runs.size(), 1u);
    EXPECT_FALSE(runs[0].indexed);
    EXPECT_EQ(runs[0].count, 9u);
    EXPECT_TRUE(indices.empty());
}

TEST(Runs, KeepTheOrderOfClassesAndJoinWithinOne)
{
    const Primitive primitives[] = {{GL_TRIANGLES, 0, 4, true, true}, // One vertex too many.
                                    {GL_TRIANGLES, 4, 3, true, true},
                                    {GL_TRIANGLE_FAN, 7, 4, true, true},
                                    {GL_LINES, 11, 2, true, true},
                                    {GL_TRIANGLES, 13, 3, true, true}};
    std::vector<DrawRun> runs;
    Indices indices;
    make_runs(primitives, runs, indices);
    ASSERT_EQ(runs.size(), 3u);
    EXPECT_TRUE(runs[0].indexed);
    EXPECT_EQ(indices, (Indices{0, 1, 2, 4, 5, 6, 7, 8, 9, 7, 9, 10}));
    EXPECT_EQ(runs[1].primitive, PrimitiveClass::lines);
    EXPECT_EQ(runs[2].first, 13u);
}

} // namespace
