#include "app/state/fields.h"

#include "fixtures.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <set>

namespace app {
namespace {

using std::numbers::pi;

TEST(FieldsTest, RowsAreInTheOrderOfTheirIdsWithNamesOfTheirOwn)
{
    std::set<std::string_view> names = {"task", "figure"};
    for (std::size_t i = 0; i < fields().size(); ++i) {
        EXPECT_EQ(static_cast<std::size_t>(fields()[i].id), i);
        EXPECT_TRUE(names.insert(fields()[i].name).second) << fields()[i].name;
        EXPECT_EQ(find_field(fields()[i].name), &fields()[i]);
        EXPECT_FALSE(fields()[i].title.empty());
    }
    for (const FieldAlias& alias : field_aliases()) {
        EXPECT_TRUE(names.insert(alias.name).second) << alias.name;
    }
    EXPECT_EQ(find_field("nothing"), nullptr);
    EXPECT_EQ(find_field(""), nullptr);
}

TEST(FieldsTest, EveryFieldLivesInAPlaceOfItsOwn)
{
    const State start;
    for (const Field& changed : fields()) {
        State state = start;
        const std::int64_t other =
            changed.initial == grid_minimum(changed) ? grid_maximum(changed) : grid_minimum(changed);
        set_grid_value(changed, state, other);
        for (const Field& field : fields()) {
            EXPECT_EQ(grid_value(field, state), field.id == changed.id ? other : field.initial)
                << changed.name << " " << field.name;
        }
        EXPECT_NE(state, start);
    }
}

TEST(FieldsTest, AngleLimitsAreThoseOfTheJoints)
{
    EXPECT_EQ(grid_minimum(field(FieldId::main_gun)), -900);
    EXPECT_EQ(grid_maximum(field(FieldId::main_gun)), 2000);
    EXPECT_EQ(grid_minimum(field(FieldId::secondary_gun)), -12000);
    EXPECT_EQ(grid_maximum(field(FieldId::secondary_gun)), 12000);
    EXPECT_EQ(grid_minimum(field(FieldId::turret)), -18000);
    EXPECT_EQ(grid_maximum(field(FieldId::turret)), 17999);
    EXPECT_EQ(field(FieldId::main_gun).maximum, tank::joint_limits(tank::Joint::main_gun).maximum);
}

TEST(FieldsTest, EveryValueOfTheGridIsGivenBack)
{
    State state;
    for (const Field& field : fields()) {
        const std::int64_t lowest = grid_minimum(field);
        const std::int64_t highest = grid_maximum(field);
        for (std::int64_t value = lowest; value <= highest; ++value) {
            set_grid_value(field, state, value);
            ASSERT_EQ(grid_value(field, state), value) << field.name;
            const double stored = field.get(state);
            ASSERT_GE(stored, field.minimum) << field.name;
            ASSERT_LE(stored, field.maximum) << field.name;
        }
    }
}

TEST(FieldsTest, ValuesBeyondTheLimitsAreClampedOrGoRound)
{
    State state;
    const Field& gun = field(FieldId::main_gun);
    set_grid_value(gun, state, 5000);
    EXPECT_EQ(grid_value(gun, state), 2000);
    EXPECT_EQ(state.joints[tank::Joint::main_gun], gun.maximum);
    set_grid_value(gun, state, std::numeric_limits<std::int64_t>::min());
    EXPECT_EQ(grid_value(gun, state), -900);

    const Field& turret = field(FieldId::turret);
    EXPECT_EQ(grid_within_limits(turret, 18000), -18000);
    EXPECT_EQ(grid_within_limits(turret, 37000), 1000);
    EXPECT_EQ(grid_within_limits(turret, -18001), 17999);
    EXPECT_EQ(grid_within_limits(turret, -36000 * 5 - 1), -1);
    for (std::int64_t extreme :
         {std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()}) {
        const std::int64_t within = grid_within_limits(turret, extreme);
        EXPECT_GE(within, -18000);
        EXPECT_LE(within, 17999);
        EXPECT_EQ((extreme % 36000 - within) % 36000, 0);
    }
}

TEST(FieldsTest, AnAngleThatRoundsToHalfATurnIsItsNegative)
{
    const Field& turret = field(FieldId::turret);
    EXPECT_EQ(to_grid(turret, std::nextafter(pi, 0.0)), -18000);
    EXPECT_EQ(to_grid(turret, -pi), -18000);
    EXPECT_EQ(to_grid(turret, pi), -18000);
}

TEST(FieldsTest, UnitsForPeopleAreRoundedToTheGrid)
{
    const Field& turret = field(FieldId::turret);
    EXPECT_EQ(to_grid_from_unit(turret, 30.0), 3000);
    EXPECT_EQ(to_grid_from_unit(turret, -0.126), -13);
    EXPECT_EQ(to_grid_from_unit(turret, 370.0), 1000);
    EXPECT_EQ(to_grid_from_unit(turret, 180.0), -18000);
    const Field& distance = field(FieldId::distance);
    EXPECT_EQ(to_grid_from_unit(distance, 12.3456), 12346);
    EXPECT_EQ(to_grid_from_unit(distance, 1e300), 400000);
    EXPECT_EQ(to_grid_from_unit(distance, -1e308), 4000);
    const std::int64_t within = to_grid_from_unit(turret, 1.7e308);
    EXPECT_GE(within, -18000);
    EXPECT_LE(within, 17999);
    EXPECT_EQ(to_grid_from_unit(field(FieldId::ground), 7.0), 1);
}

TEST(FieldsTest, SettingAGridValueTwiceChangesNothing)
{
    std::mt19937_64 random(5);
    for (int i = 0; i < 2000; ++i) {
        State state = random_state(random);
        for (const Field& field : fields()) {
            set_grid_value(field, state, grid_value(field, state));
        }
        State again = state;
        for (const Field& field : fields()) {
            set_grid_value(field, again, grid_value(field, again));
        }
        ASSERT_EQ(again, state);
    }
}

} // namespace
} // namespace app
