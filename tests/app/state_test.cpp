#include "app/state/state.h"

#include "app/state/fields.h"
#include "fixtures.h"

#include <gtest/gtest.h>
#include <type_traits>

namespace app {
namespace {

static_assert(std::is_trivially_copyable_v<State>);

TEST(StateTest, StartsWithTheDefaultsOfTheTable)
{
    const State state;
    for (const Field& field : fields()) {
        EXPECT_EQ(grid_value(field, state), field.initial) << field.name;
    }
    EXPECT_FALSE(state.task.has_value());
    EXPECT_TRUE(state.held.none());
    EXPECT_EQ(state.tick, 0u);
}

TEST(StateTest, EqualStatesHaveEqualBytesWhateverTheirRevision)
{
    State one;
    State other;
    EXPECT_EQ(one, other);
    EXPECT_EQ(serialised(one), serialised(other));
    one.x = 0.0;
    other.x = -0.0;
    EXPECT_EQ(one, other);
    EXPECT_EQ(hash(one), hash(other));
}

TEST(StateTest, EveryChangeChangesTheBytes)
{
    const State start;
    std::vector<State> changed;
    for (const Field& field : fields()) {
        changed.emplace_back();
        const std::int64_t other =
            field.initial == grid_minimum(field) ? grid_maximum(field) : grid_minimum(field);
        set_grid_value(field, changed.back(), other);
    }
    changed.emplace_back().task = 0;
    changed.emplace_back().task = 1;
    changed.emplace_back().held[3] = true;
    changed.emplace_back().tick = 1;
    changed.emplace_back().seed = 2;
    changed.push_back(start);
    for (std::size_t i = 0; i < changed.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_NE(changed[i], changed[j]) << i << " " << j;
            EXPECT_NE(serialised(changed[i]), serialised(changed[j])) << i << " " << j;
            EXPECT_NE(hash(changed[i]), hash(changed[j])) << i << " " << j;
        }
    }
}

TEST(StateTest, TheSmallestDifferenceOfAFieldIsSeen)
{
    State one;
    State other;
    other.z = 5e-324;
    EXPECT_NE(one, other);
    EXPECT_NE(hash(one), hash(other));
}

} // namespace
} // namespace app
