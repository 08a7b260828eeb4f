#include "app/commands/update.h"

#include "app/view/frame.h"

#include "app/links/links.h"
#include "fixtures.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

namespace app {
namespace {

using std::numbers::pi;
using tank::Joint;

void steps(State& state, int count)
{
    for (int i = 0; i < count; ++i) {
        step(state, assets::tiny_assets());
    }
}

void expect_done(State& state, std::string_view name, double value)
{
    EXPECT_EQ(apply(state, assets::tiny_assets(), name, value).refusal, "") << name;
}

/// What moves the tank on the ground rolls its wheels, too: driving_test.cpp.
bool drives(const Command& command)
{
    return command.moves[0].along_heading || command.moves[0].field == FieldId::heading;
}

TEST(UpdateTest, HoldingForTicksMovesByRateTimesTime)
{
    for (const Command& command : commands()) {
        if (command.kind != CommandKind::hold || command.moves[0].relative || drives(command)) {
            continue;
        }
        State state;
        const State start = state;
        expect_done(state, command.name, 1.0);
        steps(state, 17);
        expect_done(state, command.name, 0.0);
        steps(state, 10);
        for (const Move& move : command.moves) {
            const Field& moved = field(move.field);
            const double expected = moved.get(start) + 17.0 * move.rate / 60.0;
            EXPECT_NEAR(moved.get(state), std::clamp(expected, moved.minimum, moved.maximum), 1e-12)
                << command.name;
            moved.set(state, moved.get(start));
        }
        state.tick = 0;
        EXPECT_EQ(state, start) << command.name << " moved something else too";
    }
}

TEST(UpdateTest, HoldingReachesTheLimitsAndNeverPassesThem)
{
    for (const Command& command : commands()) {
        if (command.kind != CommandKind::hold) {
            continue;
        }
        State state;
        expect_done(state, command.name, 1.0);
        for (int i = 0; i < 10000; ++i) { // the projectile has the longest way
            step(state, assets::tiny_assets());
            for (const Field& field : fields()) {
                ASSERT_GE(field.get(state), field.minimum) << command.name;
                ASSERT_LE(field.get(state), field.maximum) << command.name;
            }
        }
        const Move& last = command.moves.back(); // heading 0: z is the way ahead
        const Field& moved = field(last.field);
        if (!moved.wraps) {
            EXPECT_EQ(moved.get(state), last.rate > 0.0 ? moved.maximum : moved.minimum) << command.name;
        }
    }
}

TEST(UpdateTest, TurretGoesRoundAndComesBack)
{
    State state;
    expect_done(state, "turret_left", 1.0);
    steps(state, 9 * 60); // 40 degrees a second: once round
    EXPECT_NEAR(state.joints[Joint::turret], 0.0, 1e-9);
    steps(state, 5 * 60);
    EXPECT_NEAR(state.joints[Joint::turret], -160.0 * pi / 180.0, 1e-9);
}

TEST(UpdateTest, OppositeHoldsCancelExactly)
{
    for (std::size_t i = 0; i + 1 < commands().size(); ++i) {
        const Command& one = commands()[i];
        const Command& other = commands()[i + 1];
        if (one.kind != CommandKind::hold || other.kind != CommandKind::hold ||
            one.moves[0].field != other.moves[0].field) {
            continue;
        }
        State state;
        const State start = state;
        expect_done(state, one.name, 1.0);
        expect_done(state, other.name, 1.0);
        for (int tick = 0; tick < 60; ++tick) {
            EXPECT_FALSE(step(state, assets::tiny_assets()).is_visible()) << one.name;
        }
        for (const Field& field : fields()) {
            EXPECT_EQ(field.get(state), field.get(start)) << one.name << " " << field.name;
        }
    }
}

TEST(UpdateTest, ZoomingInUndoesZoomingOut)
{
    State state;
    const double start = state.camera.distance;
    expect_done(state, "zoom_out", 1.0);
    steps(state, 60);
    EXPECT_NEAR(state.camera.distance, start * std::pow(1.02, 60), 1e-9);
    expect_done(state, "zoom_out", 0.0);
    expect_done(state, "zoom_in", 1.0);
    steps(state, 60);
    EXPECT_NEAR(state.camera.distance, start, 1e-12);
}

TEST(UpdateTest, MouseCommandsAddWhatTheySay)
{
    State state;
    const State start = state;
    expect_done(state, "orbit_by", -10.0);
    EXPECT_NEAR(state.camera.orbit, start.camera.orbit - 10.0 * pi / 180.0, 1e-14);
    expect_done(state, "orbit_by", 3600.0 + 10.0);
    EXPECT_NEAR(state.camera.orbit, start.camera.orbit, 1e-12);
    expect_done(state, "tilt_by", 5.0);
    EXPECT_NEAR(state.camera.tilt, start.camera.tilt + 5.0 * pi / 180.0, 1e-14);
    expect_done(state, "tilt_by", 1000.0);
    EXPECT_EQ(state.camera.tilt, field(FieldId::tilt).maximum);
    expect_done(state, "zoom_by", 2.0);
    EXPECT_NEAR(state.camera.distance, start.camera.distance / 1.21, 1e-12);
    expect_done(state, "zoom_by", -2.0);
    EXPECT_NEAR(state.camera.distance, start.camera.distance, 1e-12);
    expect_done(state, "zoom_by", 0.5);
    EXPECT_NEAR(state.camera.distance, start.camera.distance / 1.05, 1e-12);
}

TEST(UpdateTest, HugeAmountsReachTheLimitsAndStayFinite)
{
    for (const Command& command : commands()) {
        if (command.kind != CommandKind::add && command.kind != CommandKind::set) {
            continue;
        }
        for (double value : {1e300, -1e300, std::numeric_limits<double>::max(), 5e-324}) {
            State state;
            expect_done(state, command.name, value);
            for (const Field& field : fields()) {
                ASSERT_GE(field.get(state), field.minimum) << command.name;
                ASSERT_LE(field.get(state), field.maximum) << command.name;
            }
        }
    }
}

TEST(UpdateTest, SettingGivesTheStateOfTheLinkWithTheSameNumber)
{
    State set;
    expect_done(set, "turret", 30.0);
    expect_done(set, "gun", 8.0);
    expect_done(set, "distance", 40.25);
    expect_done(set, "wheels", -12.34);
    expect_done(set, "ground", 0.0);
    State opened;
    EXPECT_TRUE(
        open_link(opened, "turret=30&gun=8&distance=40.25&wheels_left=-12.34&wheels_right=-12.34&ground=off")
            .messages.empty());
    EXPECT_EQ(set, opened);
}

TEST(UpdateTest, SettingBeyondALimitClamps)
{
    State state;
    expect_done(state, "gun", 90.0);
    EXPECT_EQ(state.joints[Joint::main_gun], tank::joint_limits(Joint::main_gun).maximum);
    expect_done(state, "turret", 370.0);
    EXPECT_NEAR(state.joints[Joint::turret], 10.0 * pi / 180.0, 1e-14);
}

TEST(UpdateTest, UnknownNamesGiveASentenceAndChangeNothing)
{
    State state;
    const State start = state;
    EXPECT_EQ(apply(state, assets::tiny_assets(), "turet", 1.0).refusal, "There is no command \"turet\".");
    EXPECT_EQ(apply(state, assets::tiny_assets(), "", 1.0).refusal, "There is no command \"\".");
    EXPECT_EQ(state, start);
}

TEST(UpdateTest, NotANumberAndInfinityAreRefusedByEveryCommand)
{
    for (const Command& command : commands()) {
        State state;
        const State start = state;
        const std::string name(command.name);
        EXPECT_EQ(apply(state, assets::tiny_assets(), command, std::nan("")).refusal,
                  name + " needs a number, not NaN.");
        EXPECT_EQ(
            apply(state, assets::tiny_assets(), command, std::numeric_limits<double>::infinity()).refusal,
            name + " needs a number, not infinity.");
        EXPECT_NE(
            apply(state, assets::tiny_assets(), command, -std::numeric_limits<double>::infinity()).refusal,
            "");
        EXPECT_EQ(state, start);
    }
}

TEST(UpdateTest, HoldsAndPressesTakeOnlyOneAndZero)
{
    State state;
    const State start = state;
    EXPECT_NE(apply(state, assets::tiny_assets(), "turret_left", 0.5).refusal, "");
    EXPECT_NE(apply(state, assets::tiny_assets(), "turret_left", -1.0).refusal, "");
    EXPECT_NE(apply(state, assets::tiny_assets(), "reset_view", 2.0).refusal, "");
    EXPECT_EQ(state, start);
    expect_done(state, "toggle_ground", 0.0); // the key coming up
    EXPECT_EQ(state, start);
}

TEST(UpdateTest, SaysWhetherAnythingCanBeSeenOfACommandOrTick)
{
    State state;
    const auto sees = [&](std::string_view command, double value) {
        return apply(state, assets::tiny_assets(), command, value).is_visible();
    };
    EXPECT_FALSE(step(state, assets::tiny_assets()).is_visible());
    EXPECT_EQ(state.tick, 1u);
    EXPECT_FALSE(sees("turret", 0.0)); // already there
    EXPECT_TRUE(sees("turret", 10.0));
    EXPECT_TRUE(sees("gun_up", 1.0));
    EXPECT_FALSE(sees("gun_up", 1.0));
    EXPECT_TRUE(step(state, assets::tiny_assets()).is_visible());
    steps(state, 1000); // against the limit nothing changes any more
    EXPECT_FALSE(step(state, assets::tiny_assets()).is_visible());
}

TEST(UpdateTest, ReleaseAllStopsEverything)
{
    State state;
    for (const Command& command : commands()) {
        if (command.kind == CommandKind::hold) {
            expect_done(state, command.name, 1.0);
        }
    }
    EXPECT_TRUE(state.held.any());
    expect_done(state, "release_all", 1.0);
    EXPECT_TRUE(state.held.none());
    const State start = state;
    steps(state, 5);
    state.tick = start.tick;
    EXPECT_EQ(state, start);
}

TEST(UpdateTest, ResetsBringBackWhatTheTaskBeganWith)
{
    State state;
    open_link(state, "task=1.1");
    const State start = state;
    expect_done(state, "turret", -100.0);
    expect_done(state, "x", 12.0);
    expect_done(state, "orbit", -100.0);
    expect_done(state, "distance", 100.0);
    const double orbit = state.camera.orbit;
    expect_done(state, "reset_pose", 1.0);
    EXPECT_EQ(state.joints, start.joints);
    EXPECT_EQ(state.x, start.x);
    EXPECT_EQ(state.camera.orbit, orbit);
    expect_done(state, "reset_view", 1.0);
    EXPECT_EQ(state, start);
    EXPECT_NE(state.joints[Joint::turret], 0.0); // the task's turret is turned
}

TEST(UpdateTest, ToggleGroundTogglesTheGround)
{
    State state;
    const bool ground = state.show.ground;
    expect_done(state, "toggle_ground", 1.0);
    EXPECT_EQ(state.show.ground, !ground);
    expect_done(state, "toggle_ground", 1.0);
    EXPECT_EQ(state.show.ground, ground);
}

/// Plays commands at their ticks, in frames of a given number of ticks each.
State play(int ticks_a_frame)
{
    struct Event
    {
        std::uint64_t tick;
        std::string_view name;
        double value;
    };
    constexpr Event EVENTS[] = {
        {0, "turret_left", 1.0},     {7, "gun_up", 1.0},    {13, "turret_left", 0.0},
        {20, "wheels_forward", 1.0}, {31, "zoom_out", 1.0}, {31, "orbit_right", 1.0},
        {44, "orbit_by", 12.5},      {50, "zoom_out", 0.0}, {77, "turn_left", 1.0},
        {90, "release_all", 1.0},    {90, "zoom_by", 1.3},  {111, "tilt_up", 1.0},
    };
    State state;
    open_link(state, "orbit=40&distance=12");
    std::size_t next = 0;
    while (state.tick < 240) {
        for (int i = 0; i < ticks_a_frame && state.tick < 240; ++i) {
            while (next < std::size(EVENTS) && EVENTS[next].tick == state.tick) {
                expect_done(state, EVENTS[next].name, EVENTS[next].value);
                ++next;
            }
            step(state, assets::tiny_assets());
        }
        make_frame(state, assets::tiny_assets()); // drawing changes nothing
    }
    return state;
}

TEST(UpdateTest, SameCommandsGiveTheSameHashWhateverTheFrames)
{
    const State expected = play(1);
    for (int ticks_a_frame : {2, 3, 7, 240}) {
        EXPECT_EQ(play(ticks_a_frame), expected);
        EXPECT_EQ(hash(play(ticks_a_frame)), hash(expected));
    }
}

TEST(UpdateTest, SameCommandsGiveTheSameBitsEverywhere)
{
    // The same natively and in wasm: only sums, products, quotients and exact remainders are involved.
    const State state = play(1);
    EXPECT_EQ(state.joints[Joint::turret], 0x1.35c8c852ed4ffp-3);
    EXPECT_EQ(state.joints[Joint::main_gun], 0x1.28ad94868e98ap-2);
    EXPECT_EQ(state.joints[Joint::wheels_left], -0x1.6324739531891p+1); // rolled by turning, too
    EXPECT_EQ(state.joints[Joint::heading], 0x1.d0ad2c7c63f7cp-4);
    EXPECT_EQ(state.camera.orbit, 0x1.f22fd0ecbedfp+0);
    EXPECT_EQ(state.camera.distance, 0x1.edbf437258735p+3);
}

} // namespace
} // namespace app
