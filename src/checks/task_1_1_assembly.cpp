#include "app/commands/update.h"
#include "checks/check_text.h"
#include "checks/lab_1_checks.h"

#include <string_view>

namespace checks {
namespace {

using tank::Part;

/// A pose to look at, given by commands of the table.
struct Pose
{
    std::string_view name;
    struct
    {
        std::string_view command;
        double value;
    } settings[6];
};

constexpr Pose POSES[] = {
    {"at rest", {}},
    {"with every joint turned",
     {{"heading", 37.0}, {"turret", -50.0}, {"gun", 12.0}, {"secondary_gun", 70.0}, {"wheels", 33.0}}},
    {"elsewhere, its gun low",
     {{"x", 3.0},
      {"z", -2.0},
      {"heading", 160.0},
      {"turret", 95.0},
      {"gun", -6.0},
      {"secondary_gun", -40.0}}},
};

app::State state_of(const CheckSubject& subject, const Pose& pose)
{
    app::State state;
    for (const auto& setting : pose.settings) {
        if (!setting.command.empty()) {
            app::apply(state, subject.assets, setting.command, setting.value);
        }
    }
    return state;
}

PartSet missing(const PartCalls& calls)
{
    PartSet parts;
    for (Part part : tank::ALL_PARTS) {
        parts[tank::index_of(part)] = !calls[tank::index_of(part)].has_value();
    }
    return parts;
}

void check_pose(const CheckSubject& subject, const Pose& pose, Evidence& evidence)
{
    const app::State state = state_of(subject, pose);
    const FrameCapture capture = capture_frame(subject, state);
    const PartCalls calls = find_part_calls(subject, capture, state);
    const std::string where = "The tank " + std::string(pose.name);
    evidence.require(capture.tank_list_calls.size() == tank::PART_COUNT,
                     where + " is drawn by 18 calls of its display lists.",
                     where + " is drawn by " + std::to_string(capture.tank_list_calls.size()) +
                         " calls of its display lists instead of 18.");
    evidence.require(found_count(calls) == tank::PART_COUNT,
                     where + " has every part where the chain of pivots and angles from the body puts it.",
                     where + " lacks " + named(missing(calls)) +
                         " where the chain of pivots and angles from the body puts it.");
}

/// What the lab says hangs on what; written here once more, so that a fault in the table of parts is found.
PartSet part_and_what_it_carries(Part part)
{
    PartSet set;
    set.set(tank::index_of(part));
    if (part == Part::body) {
        set.set();
    } else if (part == Part::turret) {
        set.set(tank::index_of(Part::main_gun));
        set.set(tank::index_of(Part::secondary_gun));
    }
    return set;
}

/// Tells whether some push of the frame holds exactly these parts.
bool has_scope_of(const FrameCapture& capture, const PartCalls& calls, Part part, const PartSet& wanted)
{
    const TankListCall& own = capture.tank_list_calls[*calls[tank::index_of(part)]];
    for (int scope : own.scopes) {
        PartSet within;
        for (Part other : tank::ALL_PARTS) {
            const TankListCall& call = capture.tank_list_calls[*calls[tank::index_of(other)]];
            within[tank::index_of(other)] = call.stands_within(scope);
        }
        if (within == wanted) {
            return true;
        }
    }
    return false;
}

void check_nesting(const CheckSubject& subject, Evidence& evidence)
{
    const app::State state = state_of(subject, POSES[1]);
    const FrameCapture capture = capture_frame(subject, state);
    const PartCalls calls = find_part_calls(subject, capture, state);
    evidence.require(capture.matrix_stack_balanced, "Every glPushMatrix of the frame has its glPopMatrix.",
                     "Pushes and pops of the frame do not match.");
    if (found_count(calls) != tank::PART_COUNT) {
        return; // said already, and failed
    }
    PartSet without_scope;
    for (Part part : tank::ALL_PARTS) {
        if (!has_scope_of(capture, calls, part, part_and_what_it_carries(part))) {
            without_scope.set(tank::index_of(part));
        }
    }
    evidence.require(without_scope.none(),
                     "A push and a pop enclose each part with exactly what it carries: the body all, the "
                     "turret both guns.",
                     "No push and pop encloses exactly these and what they carry: " + named(without_scope) +
                         ".");
}

/// Returns the parts that are drawn elsewhere when one thing is set, the camera staying where it is.
PartSet moved_by(const CheckSubject& subject, std::string_view command, double value)
{
    const app::State before;
    app::State after = before;
    app::apply(after, subject.assets, command, value);
    const FrameCapture capture = capture_frame(subject, after);
    return missing(find_part_calls(subject, capture, before));
}

void check_carrying(const CheckSubject& subject, Evidence& evidence)
{
    // The body's own turning could go unseen if it were round; it is not.
    const PartSet by_heading = moved_by(subject, "heading", 25.0);
    evidence.require(by_heading.all(), "Turning the tank moves all 18 parts.",
                     "Turning the tank leaves parts where they were: " + named(~by_heading) + ".");
    const PartSet by_turret = moved_by(subject, "turret", 25.0);
    evidence.require(by_turret == part_and_what_it_carries(Part::turret),
                     "Turning the turret moves it and both guns, no wheel and not the body.",
                     "Turning the turret moves " + named(by_turret) + ".");
}

} // namespace

void check_assembly(const CheckSubject& subject, Evidence& evidence)
{
    for (const Pose& pose : POSES) {
        check_pose(subject, pose, evidence);
    }
    check_nesting(subject, evidence);
    check_carrying(subject, evidence);
}

} // namespace checks
