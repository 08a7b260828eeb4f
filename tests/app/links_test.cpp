#include "app/links/links.h"

#include "app/commands/update.h"
#include "app/links/tasks.h"
#include "app/state/fields.h"
#include "fixtures.h"
#include "link_invariants.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace app {
namespace {

using Messages = std::vector<std::string>;

struct Opened
{
    State state;
    Messages messages;
};

Opened opened(std::string_view fragment)
{
    Opened result;
    result.messages = open_link(result.state, fragment).messages;
    return result;
}

std::int64_t value(const State& state, FieldId id)
{
    return grid_value(field(id), state);
}

TEST(LinksTest, TheDefaultStateHasAnEmptyLink)
{
    EXPECT_EQ(link(State()), "");
    for (std::string_view fragment : {"", "#", "&&;", "# ", "+"}) {
        EXPECT_EQ(opened(fragment).state, State()) << fragment;
        EXPECT_TRUE(opened(fragment).messages.empty()) << fragment;
    }
}

TEST(LinksTest, OnlyWhatDiffersIsWrittenInTheOrderOfTheTable)
{
    const Opened result = opened("distance=40&gun=8&turret=30&x=0");
    EXPECT_TRUE(result.messages.empty());
    EXPECT_EQ(link(result.state), "turret=30&gun=8&distance=40");
    EXPECT_EQ(value(result.state, FieldId::turret), 3000);
    EXPECT_EQ(value(result.state, FieldId::distance), 40000);
}

TEST(LinksTest, SharingAndOpeningGivesTheSnappedStateExactly)
{
    std::mt19937_64 random(11);
    for (int i = 0; i < 5000; ++i) {
        const State shared = random_state(random);
        const std::string text = link(shared);
        State back = random_state(random); // whatever was there before
        ASSERT_TRUE(open_link(back, text).messages.empty()) << text;
        ASSERT_EQ(back, snapped(shared)) << text;
        ASSERT_EQ(serialised(back), serialised(snapped(shared))) << text;
        ASSERT_EQ(link(back), text);
        ASSERT_EQ(link(snapped(shared)), text);
        ASSERT_EQ(snapped(back), back);
        ASSERT_LE(text.size(), MAX_LINK_BYTES);
    }
}

TEST(LinksTest, StatesReachedByKeysRoundTripToo)
{
    std::mt19937_64 random(12);
    State state;
    for (int i = 0; i < 3000; ++i) {
        const Command& command = commands()[random() % commands().size()];
        const bool is_switch = command.kind == CommandKind::hold || command.kind == CommandKind::press;
        const double amount =
            is_switch ? static_cast<double>(random() % 2) : next_unit(random) * 400.0 - 200.0;
        const std::string fault = apply(state, assets::tiny_assets(), command, amount).refusal;
        ASSERT_TRUE(fault.empty() || command.group == Group::projectile) << fault; // nothing in that way
        step(state, assets::tiny_assets());
        State back;
        ASSERT_TRUE(open_link(back, link(state)).messages.empty());
        ASSERT_EQ(back, snapped(state)) << link(state);
    }
}

TEST(LinksTest, EveryFieldRoundTripsAtItsEnds)
{
    for (const Field& field : fields()) {
        for (std::int64_t end : {grid_minimum(field), grid_maximum(field)}) {
            State state;
            set_grid_value(field, state, end);
            EXPECT_EQ(opened(link(state)).state, state) << link(state);
            EXPECT_TRUE(opened(link(state)).messages.empty()) << link(state);
        }
    }
}

TEST(LinksTest, SnappedIsWithinHalfAStep)
{
    std::mt19937_64 random(13);
    for (int i = 0; i < 1000; ++i) {
        const State state = random_state(random);
        const State snap = snapped(state);
        for (const Field& field : fields()) {
            const double step_size = field.unit.numerator / field.unit.denominator;
            const double off = std::remainder(field.get(snap) - field.get(state),
                                              field.wraps ? 2.0 * std::numbers::pi : 1e9);
            ASSERT_LE(std::abs(off), 0.5 * step_size * (1.0 + 1e-9)) << field.name;
        }
    }
}

TEST(LinksTest, OneKeySetsTheWheelsOfBothSides)
{
    const Opened result = opened("wheels=90&wheels_right=45");
    EXPECT_TRUE(result.messages.empty());
    EXPECT_EQ(value(result.state, FieldId::wheels_left), 9000);
    EXPECT_EQ(value(result.state, FieldId::wheels_right), 4500);
}

TEST(LinksTest, FormsThatMailersAndPeopleMakeAreTolerated)
{
    const State expected = opened("turret=30&gun=-8.5").state;
    for (std::string_view fragment : {
             "#turret=30&gun=-8.5",
             "turret=30;gun=-8.5",
             "&&turret=30&;&gun=-8.5&",
             "turret=+30&gun=-08.50",
             "turret%3D30%26gun=1&turret=30&gun=-8.5",
             "turret=%2B30&gun=%2d8%2E5",
             "%74urret=30&gun=-8.5",
             "Turret=30&GUN=-8.5",
             "turret=30.&gun=-8.5000000000000000000000000000000000000001",
             " turret = 30 &+gun+=+-8.5+",
             "gun=-8.499999999999999999&turret=29.996",
         }) {
        EXPECT_EQ(opened(fragment).state, expected) << fragment;
    }
    EXPECT_TRUE(opened("&&turret=30&;&gun=-8.5&").messages.empty());
    EXPECT_TRUE(opened("turret=%2B30").messages.empty());
}

TEST(LinksTest, AnglesGoRoundWithoutAWord)
{
    EXPECT_EQ(opened("turret=370").state, opened("turret=10").state);
    EXPECT_EQ(opened("turret=180").state, opened("turret=-180").state);
    EXPECT_TRUE(opened("turret=370").messages.empty());
    EXPECT_EQ(link(opened("turret=180").state), "turret=-180");
}

TEST(LinksTest, ValuesBeyondALimitAreClampedAndNamed)
{
    const Opened high = opened("gun=45");
    EXPECT_EQ(value(high.state, FieldId::main_gun), 2000);
    EXPECT_EQ(high.messages, Messages{"gun=\"45\" is above the limit; 20 degrees is used."});
    const Opened low = opened("distance=-3");
    EXPECT_EQ(value(low.state, FieldId::distance), 4000);
    EXPECT_EQ(low.messages, Messages{"distance=\"-3\" is below the limit; 4 metres is used."});
    EXPECT_TRUE(opened("gun=20").messages.empty());
    EXPECT_TRUE(opened("gun=20.004").messages.empty());
    EXPECT_FALSE(opened("gun=20.005").messages.empty());
}

TEST(LinksTest, UnknownKeysAndBadValuesAreNamedAndTheRestIsUsed)
{
    const State rest = opened("turret=30").state;
    const struct
    {
        std::string_view fragment;
        std::string message;
    } cases[] = {
        {"turret=30&turet=20", "\"turet\" is not something a link can set and is ignored."},
        {"turret=30&=20", "\"\" is not something a link can set and is ignored."},
        {"turret=30&gun", "\"gun\" has no value and is ignored."},
        {"turret=30&gun=", "\"gun\" has no value and is ignored."},
        {"turret=30&gun=up", "gun=\"up\" is not a number and is ignored."},
        {"turret=30&gun=nan", "gun=\"nan\" is not a number and is ignored."},
        {"turret=30&gun=inf", "gun=\"inf\" is not a number and is ignored."},
        {"turret=30&gun=3=4", "gun=\"3=4\" is not a number and is ignored."},
        {"turret=30&gun=8,5", "gun=\"8,5\" has a comma; write a point instead. It is ignored."},
        {"turret=30&gun=1e1", "gun=\"1e1\" has an exponent; write the number out. It is ignored."},
        {"turret=30&x=99999999999999999999",
         "x=\"99999999999999999999\" has too many digits and is ignored."},
        {"turret=30&ground=maybe", "ground=\"maybe\" is not one of off or on and is ignored."},
        {"turret=30&gun=%4", "\"gun=%4\" has a % without two hexadecimal digits and is ignored."},
        {"turret=30&gun=%zz1", "\"gun=%zz1\" has a % without two hexadecimal digits and is ignored."},
        {"turret=30&task=7.7", "There is no task \"7.7\"; it is ignored."},
        {"turret=30&figure=99", "There is no figure \"99\"; it is ignored."},
        {"turret=30&wheels=x", "wheels=\"x\" is not a number and is ignored."},
    };
    for (const auto& one : cases) {
        const Opened result = opened(one.fragment);
        EXPECT_EQ(result.state, rest) << one.fragment;
        EXPECT_EQ(result.messages, Messages{one.message}) << one.fragment;
    }
}

TEST(LinksTest, OfDuplicatesTheLastIsUsedAndNamed)
{
    const Opened result = opened("turret=10&gun=5&turret=20&turret=30");
    EXPECT_EQ(link(result.state), "turret=30&gun=5");
    EXPECT_EQ(result.messages, Messages{"\"turret\" is given more than once; the last value is used."});
}

TEST(LinksTest, ATaskIsLoadedFirstAndOtherKeysChangeIt)
{
    const std::optional<std::size_t> task = find_task(TaskKind::task, "1.1");
    ASSERT_TRUE(task);
    const State start = starting_state(task);
    EXPECT_NE(value(start, FieldId::turret), 0);
    EXPECT_EQ(opened("task=1.1").state, start);
    EXPECT_EQ(link(start), "task=1.1");

    const Opened changed = opened("turret=0&task=1.1");
    EXPECT_TRUE(changed.messages.empty());
    EXPECT_EQ(changed.state.task, task);
    EXPECT_EQ(value(changed.state, FieldId::turret), 0);
    EXPECT_EQ(value(changed.state, FieldId::orbit), value(start, FieldId::orbit));
    EXPECT_EQ(link(changed.state), "task=1.1&turret=0");
}

TEST(LinksTest, OfTwoTasksTheLastIsUsed)
{
    const Opened result = opened("task=1.1&task=1.2");
    EXPECT_EQ(result.state, opened("task=1.2").state);
    EXPECT_EQ(result.messages.size(), 1u);
    EXPECT_EQ(opened("task=1.1&task=9").state, opened("task=1.1").state);
}

TEST(LinksTest, OpeningReplacesEverythingAndCountsARevision)
{
    State state;
    apply(state, assets::tiny_assets(), "turret_left", 1.0);
    step(state, assets::tiny_assets());
    const LinkResult result = open_link(state, "gun=5");
    EXPECT_TRUE(result.messages.empty());
    EXPECT_TRUE(result.outcome.opened);
    EXPECT_EQ(state, opened("gun=5").state);
    EXPECT_TRUE(state.held.none());
    EXPECT_EQ(state.tick, 0u);
}

TEST(LinksTest, ALinkThatIsTooLongIsRefusedAsAWhole)
{
    State state = opened("turret=30").state;
    const State before = state;
    const LinkResult result = open_link(state, std::string(MAX_LINK_BYTES + 1, 'a'));
    EXPECT_EQ(result.messages, Messages{"The link is longer than 4096 characters and is not used."});
    EXPECT_EQ(state, before);
    EXPECT_FALSE(result.outcome.opened);
}

TEST(LinksTest, ManyFaultsAreCountedAndNotAllListed)
{
    std::string fragment;
    for (int i = 0; i < 300; ++i) {
        fragment += "bad" + std::to_string(i) + "&";
    }
    const Opened result = opened(fragment);
    ASSERT_EQ(result.messages.size(), 11u);
    EXPECT_EQ(result.messages.back(), "The link has 290 more faults.");
}

TEST(LinksTest, AnyBytesAreReadWithoutHarm)
{
    std::mt19937_64 random(17);
    constexpr std::string_view PIECES[] = {
        "turret", "gun", "task", "figure", "wheels", "=", "&",  ";",   "#",    "%",      "%00", "%ff", "+",
        "-",      ".",   "1",    "9999",   "1.1",    ",", "e5", "nan", "\xff", "ground", "on",  "off", " "};
    for (int i = 0; i < 5000; ++i) {
        std::string fragment;
        for (std::uint64_t n = random() % 12; n > 0; --n) {
            fragment += random() % 8 == 0 ? std::string(1, static_cast<char>(random()))
                                          : PIECES[random() % std::size(PIECES)];
        }
        ASSERT_EQ(broken_link(fragment), "") << fragment;
    }
}

} // namespace
} // namespace app
