#include "particles/random.h"

#include <gtest/gtest.h>
#include <set>

namespace particles {
namespace {

// Computed with another program, whose SplitMix64 gives the published numbers for the seed 1234567.
TEST(Random, IsTheSameEverywhere)
{
    Random random(1, 0);
    EXPECT_EQ(random.next_bits(), 4720248854425330031u);
    EXPECT_EQ(random.next_bits(), 1629287585893752162u);
    EXPECT_EQ(Random(0xffffffffffffffff, 0xffffffffffffffff).next_bits(), 8178007490130943153u);
}

TEST(Random, StreamsAndSeedsDiffer)
{
    std::set<std::uint64_t> seen;
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        for (std::uint64_t stream = 0; stream < 50; ++stream) {
            Random random(seed, stream);
            for (int i = 0; i < 10; ++i) {
                EXPECT_TRUE(seen.insert(random.next_bits()).second);
            }
        }
    }
}

TEST(Random, UniformFillsItsRangeEvenly)
{
    Random random(3, 4);
    constexpr int COUNT = 100'000;
    int tenths[10] = {};
    for (int i = 0; i < COUNT; ++i) {
        const double value = random.uniform();
        ASSERT_TRUE(value >= 0.0 && value < 1.0);
        ++tenths[static_cast<int>(value * 10.0)];
    }
    for (const int tenth : tenths) {
        EXPECT_NEAR(tenth, COUNT / 10, 400); // four standard deviations
    }
}

TEST(Random, FirstNumbersOfStreamsAreEvenToo)
{
    constexpr int COUNT = 100'000;
    int halves[2][2] = {};
    for (std::uint64_t stream = 0; stream < COUNT; ++stream) {
        Random random(5, stream);
        const bool first = random.uniform() < 0.5;
        const bool second = random.uniform() < 0.5;
        ++halves[first ? 1 : 0][second ? 1 : 0];
    }
    for (const auto& half : halves) {
        EXPECT_NEAR(half[0], COUNT / 4, 550);
        EXPECT_NEAR(half[1], COUNT / 4, 550);
    }
}

TEST(Random, BallIsFilledEvenly)
{
    Random random(6, 7);
    constexpr int COUNT = 100'000;
    glm::dvec3 sum{0.0};
    int inner = 0;
    for (int i = 0; i < COUNT; ++i) {
        const glm::dvec3 point = random.in_ball();
        const double square = point.x * point.x + point.y * point.y + point.z * point.z;
        ASSERT_LE(square, 1.0);
        inner += square < 0.25 ? 1 : 0;
        sum += point;
    }
    EXPECT_NEAR(inner, COUNT / 8, 420); // the ball of half the radius has an eighth of the volume
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(sum[axis] / COUNT, 0.0, 0.006);
    }
}

} // namespace
} // namespace particles
