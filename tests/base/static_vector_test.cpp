#include "base/static_vector.h"

#include <gtest/gtest.h>
#include <vector>

namespace base {
namespace {

TEST(StaticVectorTest, HoldsWhatWasAddedInOrder)
{
    StaticVector<int, 3> values;
    EXPECT_TRUE(values.empty());
    values.push_back(7) += 1;
    values.push_back(9);
    EXPECT_EQ(std::vector<int>(values.begin(), values.end()), (std::vector<int>{8, 9}));
    EXPECT_EQ(values.size(), 2u);
    EXPECT_EQ(values.back(), 9);
    values.truncate(1);
    EXPECT_EQ(values.size(), 1u);
    values.clear();
    EXPECT_TRUE(values.empty());
}

TEST(StaticVectorTest, IsMadeOfAListAtCompileTime)
{
    constexpr StaticVector<int, 4> VALUES{1, 2, 3};
    static_assert(VALUES.size() == 3 && VALUES[2] == 3);
    const StaticVector<int, 4> copy = VALUES;
    EXPECT_EQ(copy.size(), 3u);
}

} // namespace
} // namespace base
