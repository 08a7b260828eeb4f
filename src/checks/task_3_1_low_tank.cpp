#include "app/simulation/simulation.h"
#include "checks/check_picture.h"
#include "checks/check_text.h"
#include "checks/drawn_vertices.h"
#include "checks/lab_3_checks.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <string_view>
#include <vector>

namespace checks {
namespace {

using tank::Part;

constexpr std::string_view POSES[] = {
    "task=3.1",
    "task=3.1&turret=70&gun=15&secondary_gun=-60&wheels=40&heading=25",
    "task=3.1&x=3&z=-2&turret=-120&gun=-7&heading=170",
};

PartSet missing(const PartCalls& calls)
{
    PartSet parts;
    for (Part part : tank::ALL_PARTS) {
        parts[tank::index_of(part)] = !calls[tank::index_of(part)].has_value();
    }
    return parts;
}

void check_pose(const CheckSubject& subject, std::string_view link, Evidence& evidence)
{
    app::Simulation simulation(subject.assets);
    simulation.open_link(link);
    const app::Frame frame = simulation.frame();
    const FrameCapture capture = capture_frame(subject, frame);
    const PartSet high =
        missing(find_part_calls(subject, capture.tank_list_calls, frame.camera, frame.tanks[0]));
    const PartSet low =
        missing(find_part_calls(subject, capture.low_list_calls, frame.camera, frame.tanks[1]));
    const std::string pose = "In the pose " + std::string(link) + " ";
    evidence.require(frame.tanks.size() == 2 && high.none() && low.none() &&
                         capture.tank_list_calls.size() == tank::PART_COUNT &&
                         capture.low_list_calls.size() == tank::PART_COUNT,
                     pose + "both tanks stand side by side, each part of the low one where the same joints "
                            "put it.",
                     pose + "parts are not drawn where the joints put them; high: " + named(high) +
                         ", low: " + named(low) + ".");
}

/// What was set when the lists of the low tank were called.
struct LowCalls
{
    std::size_t lit = 0;
    std::size_t textured = 0;
    std::size_t uncoloured = 0; ///< corners without a colour of their list's own
    std::set<std::vector<double>> colours;
    std::size_t corners = 0;
};

LowCalls low_calls(const FrameCapture& capture)
{
    constexpr double LIGHTING = 0x0B50; // <GL/gl.h> is scene's alone
    constexpr double TEXTURE_2D = 0x0DE1;
    LowCalls found;
    bool lit = false;
    bool textured = false;
    std::size_t next = 0;
    for (std::size_t i = 0; i < capture.calls.size() && next < capture.low_list_calls.size(); ++i) {
        const LegacyGLCall& call = capture.calls[i];
        const std::string_view name = call.name;
        if (name == "glEnable" || name == "glDisable") {
            lit = call.arguments[0] == LIGHTING ? name == "glEnable" : lit;
            textured = call.arguments[0] == TEXTURE_2D ? name == "glEnable" : textured;
        } else if (i == capture.low_list_calls[next].index) {
            found.lit += lit ? 1u : 0u;
            found.textured += textured ? 1u : 0u;
            bool is_coloured = false;
            for (const LegacyGLCall& of_list : capture.calls_of_list(capture.low_list_calls[next])) {
                // A list gives glColor3ub back as glColor4f.
                if (std::string_view(of_list.name).starts_with("glColor")) {
                    found.colours.insert({of_list.arguments, of_list.arguments + 3});
                    is_coloured = true;
                } else if (std::string_view(of_list.name).starts_with("glVertex")) {
                    ++found.corners;
                    found.uncoloured += is_coloured ? 0u : 1u;
                }
            }
            ++next;
        }
    }
    return found;
}

std::size_t high_corners(const FrameCapture& capture)
{
    std::size_t corners = 0;
    for (const TankListCall& call : capture.tank_list_calls) {
        for (const LegacyGLCall& of_list : capture.calls_of_list(call)) {
            corners += std::string_view(of_list.name).starts_with("glVertex") ? 1u : 0u;
        }
    }
    return corners;
}

/// Returns how many draw calls the tank of a level takes by itself: without ground, markers and the other
/// one.
std::uint64_t draw_calls_of(const CheckSubject& subject, std::string_view level)
{
    const auto draw_calls = [&](const app::Frame& frame) {
        const std::uint64_t before = legacygl_counters(legacygl_current()).draw_calls;
        picture_of(subject, frame);
        return legacygl_counters(legacygl_current()).draw_calls - before;
    };
    app::Simulation simulation(subject.assets);
    simulation.open_link("ground=off&detail=" + std::string(level));
    app::Frame frame = simulation.frame();
    const std::uint64_t with_tank = draw_calls(frame);
    frame.tanks.clear();
    return with_tank - draw_calls(frame);
}

void check_draw_calls(const CheckSubject& subject, Evidence& evidence)
{
    constexpr std::uint64_t MOST = 25;
    const std::uint64_t high = draw_calls_of(subject, "high");
    const std::uint64_t low = draw_calls_of(subject, "low");
    const std::string counts =
        std::to_string(high) + " draw calls for the high tank, " + std::to_string(low) + " for the low one";
    evidence.require(high > 0 && high <= MOST && low > 0 && low <= MOST, "It takes " + counts + ".",
                     "It takes " + counts + "; " + std::to_string(MOST) + " have to be enough.");
}

void check_drawing(const CheckSubject& subject, Evidence& evidence)
{
    app::Simulation simulation(subject.assets);
    simulation.open_link(POSES[0]);
    const FrameCapture capture = capture_frame(subject, simulation.frame());
    const LowCalls low = low_calls(capture);
    const std::size_t high_triangles = high_corners(capture) / 3;
    const std::size_t low_triangles = low.corners / 3;
    evidence.require(low.lit == 0 && low.textured == 0,
                     "The low tank is drawn without lighting and without texture.",
                     std::to_string(low.lit) + " parts of the low tank are lit, " +
                         std::to_string(low.textured) + " textured.");
    evidence.require(low.uncoloured == 0 && low.colours.size() >= 4,
                     "glColor3ub gives its corners " + std::to_string(low.colours.size()) + " colours.",
                     "glColor3ub gives its corners only " + std::to_string(low.colours.size()) +
                         " colours; " + std::to_string(low.uncoloured) + " have none.");
    evidence.require(low_triangles > 0 && low_triangles * 8 < high_triangles,
                     "18 calls of lists draw " + std::to_string(low_triangles) +
                         " triangles, of the high tank " + std::to_string(high_triangles) + ".",
                     "The low tank has " + std::to_string(low_triangles) + " triangles, the high one " +
                         std::to_string(high_triangles) + ".");
}

} // namespace

void check_low_tank(const CheckSubject& subject, Evidence& evidence)
{
    for (std::string_view pose : POSES) {
        check_pose(subject, pose, evidence);
    }
    check_drawing(subject, evidence);
    check_draw_calls(subject, evidence);
}

} // namespace checks
