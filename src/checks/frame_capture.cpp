#include "checks/frame_capture.h"

#include "tank/part_matrices.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <string_view>

namespace checks {
namespace {

glm::mat4 modelview_of(const LegacyGLCall& call)
{
    glm::mat4 matrix;
    std::copy(std::begin(call.modelview), std::end(call.modelview), &matrix[0][0]);
    return matrix;
}

/// Returns the mesh of the high tank whose list this is.
std::optional<tank::MeshKind> mesh_of(unsigned list, const scene::TankLists& lists)
{
    for (std::size_t i = 0; i < tank::MESH_KIND_COUNT; ++i) {
        const auto mesh = static_cast<tank::MeshKind>(i);
        if (list != 0 && lists.list(mesh) == list) {
            return mesh;
        }
    }
    return std::nullopt;
}

bool calls_track_list(const LegacyGLCall& call, const scene::TankLists& lists)
{
    return std::string_view(call.name) == "glCallList" &&
           lists.is_track_list(static_cast<unsigned>(call.arguments[0]));
}

/// Counts call i as the last list's if it follows what that has called so far.
void extend(std::vector<TankListCall>& list_calls, std::size_t i)
{
    if (!list_calls.empty() && list_calls.back().end == i) {
        list_calls.back().end = i + 1;
    }
}

/// Fills in what follows from the calls.
void digest(FrameCapture& capture, const scene::TankLists& lists)
{
    std::vector<int> scopes;
    int pushes = 0;
    capture.matrix_stack_balanced = true;
    for (std::size_t i = 0; i < capture.calls.size(); ++i) {
        const LegacyGLCall& call = capture.calls[i];
        const std::string_view name = call.name;
        if (call.list_depth != 0 || calls_track_list(call, lists)) {
            extend(capture.tank_list_calls, i);
            extend(capture.low_list_calls, i);
            continue;
        }
        if (name == "glPushMatrix") {
            scopes.push_back(pushes++);
        } else if (name == "glPopMatrix") {
            if (scopes.empty()) {
                capture.matrix_stack_balanced = false;
            } else {
                scopes.pop_back();
            }
        } else if (name == "glCallList") {
            const auto list = static_cast<unsigned>(call.arguments[0]);
            if (const auto mesh = mesh_of(list, lists)) {
                capture.tank_list_calls.push_back({*mesh, list, modelview_of(call), scopes, i, i + 1});
            }
            if (const auto mesh = lists.low_mesh_of(list)) {
                capture.low_list_calls.push_back({*mesh, list, modelview_of(call), scopes, i, i + 1});
            }
        }
    }
    capture.matrix_stack_balanced = capture.matrix_stack_balanced && scopes.empty();
}

bool nearly_equal(const glm::mat4& a, const glm::mat4& b, float tolerance)
{
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            // Written so that a NaN is not equal.
            if (!(std::fabs(a[column][row] - b[column][row]) <= tolerance)) {
                return false;
            }
        }
    }
    return true;
}

} // namespace

bool TankListCall::stands_within(int scope) const
{
    return std::find(scopes.begin(), scopes.end(), scope) != scopes.end();
}

FrameCapture capture_frame(const CheckSubject& subject, const app::State& state)
{
    return capture_frame(subject, app::make_frame(state, subject.assets));
}

FrameCapture capture_frame(const CheckSubject& subject, const app::Frame& frame)
{
    LegacyGLContext* context = legacygl_current();
    legacygl_capture_begin(context);
    subject.renderer.draw(frame, subject.width, subject.height);
    std::size_t count = 0;
    const LegacyGLCall* calls = legacygl_capture_end(context, &count);
    FrameCapture capture{};
    capture.calls = {calls, count};
    digest(capture, subject.renderer.tank_lists());
    return capture;
}

PartCalls find_part_calls(const CheckSubject& subject, std::span<const TankListCall> calls,
                          const app::CameraView& camera, const app::TankInFrame& tank, float tolerance)
{
    const glm::dmat4 view = glm::lookAt(camera.eye, camera.centre, camera.up);
    const tank::PartMatrices matrices =
        tank::part_matrices(subject.assets.layout_of(tank.level), {tank.position}, tank.joints);
    std::vector<bool> taken(calls.size(), false);
    PartCalls found{};
    for (tank::Part part : tank::ALL_PARTS) {
        const glm::mat4 expected(view * glm::dmat4(matrices.mesh(part)));
        for (std::size_t i = 0; i < calls.size(); ++i) {
            if (!taken[i] && calls[i].mesh == subject.assets.layout[part].mesh &&
                nearly_equal(calls[i].modelview, expected, tolerance)) {
                taken[i] = true;
                found[tank::index_of(part)] = i;
                break;
            }
        }
    }
    return found;
}

PartCalls find_part_calls(const CheckSubject& subject, const FrameCapture& capture, const app::State& state,
                          float tolerance)
{
    const app::Frame frame = app::make_frame(state, subject.assets);
    return find_part_calls(subject, capture.tank_list_calls, frame.camera, frame.tanks[0], tolerance);
}

std::size_t found_count(const PartCalls& calls)
{
    return static_cast<std::size_t>(
        std::count_if(calls.begin(), calls.end(), [](const auto& call) { return call.has_value(); }));
}

} // namespace checks
