#include "collision/part_set.h"

#include <gtest/gtest.h>
#include <vector>

namespace collision {
namespace {

TEST(PartSetTest, HoldsWhatWasPutInUpToTheLast)
{
    PartSet set;
    EXPECT_TRUE(set.is_empty());
    EXPECT_EQ(set.count(), 0);
    set.insert(0);
    set.insert(17);
    set.insert(63);
    set.insert(17);
    EXPECT_FALSE(set.is_empty());
    EXPECT_EQ(set.count(), 3);
    EXPECT_TRUE(set.contains(0));
    EXPECT_TRUE(set.contains(17));
    EXPECT_TRUE(set.contains(63));
    EXPECT_FALSE(set.contains(1));
    EXPECT_FALSE(set.contains(64));
    EXPECT_FALSE(set.contains(1000));
    EXPECT_EQ(set, PartSet(std::uint64_t{1} << 63 | 1u << 17 | 1u));
}

TEST(PartSetTest, IsVisitedInOrder)
{
    PartSet set;
    for (const std::size_t part : {40u, 3u, 63u, 0u}) {
        set.insert(part);
    }
    std::vector<std::size_t> seen;
    set.for_each([&](std::size_t part) { seen.push_back(part); });
    EXPECT_EQ(seen, (std::vector<std::size_t>{0, 3, 40, 63}));
    PartSet().for_each([](std::size_t) { FAIL(); });
}

} // namespace
} // namespace collision
