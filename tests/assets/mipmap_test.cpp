#include "assets/mipmap.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace assets {
namespace {

void expect_colour(const glm::vec3& colour, const glm::vec3& of_255)
{
    EXPECT_LT(glm::distance(255.0f * colour, of_255), 0.01f)
        << colour.r << ", " << colour.g << ", " << colour.b;
}

/// Four by two pixels; the fourth channel is not a colour.
const image::Image IMAGE{.width = 4, .height = 2, .channels = 4, .pixels = {100, 0,  0, 9, 200, 0,  0, 9,
                                                                            0,   40, 0, 9, 0,   80, 0, 9, //
                                                                            100, 0,  0, 9, 200, 0,  0, 9,
                                                                            0,   40, 0, 9, 0,   80, 0, 9}};

TEST(Mipmap, OfSideOneIsTheImage)
{
    const Mipmap mipmap(IMAGE, 1);
    expect_colour(mipmap.colour_at({0.125f, 0.25f}), {100, 0, 0});
    expect_colour(mipmap.colour_at({0.875f, 0.75f}), {0, 80, 0});
}

TEST(Mipmap, AveragesSquares)
{
    const Mipmap mipmap(IMAGE, 2);
    expect_colour(mipmap.colour_at({0.25f, 0.5f}), {150, 0, 0});
    expect_colour(mipmap.colour_at({0.75f, 0.5f}), {0, 60, 0});
}

TEST(Mipmap, CutsSquaresOffAtTheFarEdges)
{
    const Mipmap mipmap(IMAGE, 3); // three columns and one; two rows
    expect_colour(mipmap.colour_at({0.25f, 0.5f}), {100, 40.0f / 3.0f, 0});
    expect_colour(mipmap.colour_at({0.75f, 0.5f}), {0, 80, 0});
}

TEST(Mipmap, IsSmoothBetweenPixelsAndRepeats)
{
    const Mipmap mipmap(IMAGE, 1);
    expect_colour(mipmap.colour_at({0.25f, 0.25f}), {150, 0, 0});
    expect_colour(mipmap.colour_at({0.0f, 0.25f}), {50, 40, 0}); // between the last and the first
    expect_colour(mipmap.colour_at({-0.75f, 3.25f}), {150, 0, 0});
    expect_colour(mipmap.colour_at({1.0f, 0.0f}), {50, 40, 0});
}

} // namespace
} // namespace assets
