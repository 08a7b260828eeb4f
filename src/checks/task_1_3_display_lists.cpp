#include "checks/lab_1_checks.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace checks {
namespace {

using tank::MeshKind;

/// How often a frame has to call each mesh's list.
constexpr std::array<std::size_t, tank::MESH_KIND_COUNT> WANTED_CALLS = {1, 1, 1, 1, 14};

bool makes_vertices(const LegacyGLCall& call)
{
    return std::string_view(call.name).starts_with("glVertex");
}

void check_names(const CheckSubject& subject, Evidence& evidence)
{
    std::array<unsigned, tank::MESH_KIND_COUNT> lists{};
    for (std::size_t i = 0; i < lists.size(); ++i) {
        lists[i] = subject.renderer.tank_lists().list(static_cast<MeshKind>(i));
    }
    std::sort(lists.begin(), lists.end());
    const bool distinct = std::adjacent_find(lists.begin(), lists.end()) == lists.end();
    evidence.require(distinct && lists[0] != 0, "The five meshes have five display lists of their own.",
                     "The five meshes do not have a display list each.");
}

void check_calls(const FrameCapture& capture, Evidence& evidence)
{
    std::array<std::size_t, tank::MESH_KIND_COUNT> calls{};
    std::size_t empty = 0;
    for (std::size_t i = 0; i < capture.tank_list_calls.size(); ++i) {
        ++calls[tank::index_of(capture.tank_list_calls[i].mesh)];
        const auto of_list = capture.calls_of_list(capture.tank_list_calls[i]);
        empty += std::any_of(of_list.begin(), of_list.end(), makes_vertices) ? 0u : 1u;
    }
    std::string counts;
    for (std::size_t count : calls) {
        counts += (counts.empty() ? "" : ", ") + std::to_string(count);
    }
    evidence.require(calls == WANTED_CALLS,
                     "A frame calls the lists of body, turret, main gun and secondary gun once each, the "
                     "wheel's fourteen times.",
                     "A frame calls the lists of body, turret, main gun, secondary gun and wheel " + counts +
                         " times instead of 1, 1, 1, 1, 14.");
    evidence.require(empty == 0, "Every one of these calls draws something.",
                     std::to_string(empty) + " of these calls draw nothing.");
}

/// Between the tank's first list and its last, vertices may come from lists only.
void check_nothing_else_draws(const FrameCapture& capture, Evidence& evidence)
{
    if (capture.tank_list_calls.empty()) {
        return; // said already, and failed
    }
    const std::size_t first = capture.tank_list_calls.front().index;
    const std::size_t last = capture.tank_list_calls.back().index;
    const auto between = capture.calls.subspan(first, last - first);
    const auto direct = std::count_if(between.begin(), between.end(), [](const LegacyGLCall& call) {
        return call.list_depth == 0 && makes_vertices(call);
    });
    evidence.require(direct == 0, "No vertex of the tank is given outside a list.",
                     std::to_string(direct) + " vertices of the tank are given outside its lists.");
}

void check_compiled_once(const FrameCapture& capture, Evidence& evidence)
{
    const bool compiles =
        std::any_of(capture.calls.begin(), capture.calls.end(), [](const LegacyGLCall& call) {
            return std::string_view(call.name) == "glNewList" || std::string_view(call.name) == "glGenLists";
        });
    evidence.require(!compiles, "A frame compiles no list: that was done once.",
                     "A frame compiles lists again.");
}

} // namespace

void check_display_lists(const CheckSubject& subject, Evidence& evidence)
{
    check_names(subject, evidence);
    const FrameCapture capture = capture_frame(subject, app::State{});
    check_calls(capture, evidence);
    check_nothing_else_draws(capture, evidence);
    check_compiled_once(capture, evidence);
}

} // namespace checks
