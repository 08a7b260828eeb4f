#pragma once

#include "app/state/state.h"
#include "app/view/frame.h"
#include "assets/assets.h"
#include "scene/scene_renderer.h"
#include "tank/part.h"

#include <array>
#include <cstddef>
#include <glm/mat4x4.hpp>
#include <optional>
#include <span>
#include <vector>

#include <legacygl/legacygl.h>

namespace checks {

/// The running program as the checks see it: they draw with its renderer and its data, through legacygl's
/// current context, but from states of their own.
struct CheckSubject
{
    const assets::Assets& assets;
    const scene::SceneRenderer& renderer;
    int width;  ///< of the target, pixels
    int height; ///< of the target, pixels
};

/// A call of one of the tank's display lists, made by the program itself and not by a list.
struct TankListCall
{
    tank::MeshKind mesh;
    unsigned list;
    glm::mat4 modelview; ///< when it was called
    std::vector<int>
        scopes;        ///< the pushes it stands within, outermost first; each push of the frame has a number
    std::size_t index; ///< in FrameCapture::calls
    std::size_t end;   ///< of what the list called, and those of the track's links after a body's

    /// Returns whether the call stands within that push.
    bool stands_within(int scope) const;
};

/// What one frame called.
struct FrameCapture
{
    std::span<const LegacyGLCall> calls;       ///< valid until the next frame is captured
    std::vector<TankListCall> tank_list_calls; ///< of the high tank, in their order
    std::vector<TankListCall> low_list_calls;  ///< of the low tank
    bool matrix_stack_balanced;                ///< as many pops as pushes, and never more

    /// Returns the calls that the list made which one of these called; after a body's, those for the track's
    /// links.
    std::span<const LegacyGLCall> calls_of_list(const TankListCall& call) const
    {
        return calls.subspan(call.index + 1, call.end - call.index - 1);
    }
};

/// Draws a frame and notes what was called. Precondition: legacygl has a current context.
FrameCapture capture_frame(const CheckSubject& subject, const app::Frame& frame);

/// Draws what a state says by itself, without what a Simulation finds out about it.
FrameCapture capture_frame(const CheckSubject& subject, const app::State& state);

/// For each part, which of the frame's list calls drew it.
using PartCalls = std::array<std::optional<std::size_t>, tank::PART_COUNT>;

/// Finds for each part the call of its mesh's list under view * part_matrices(...).mesh(part).
/// Entries differ by at most `tolerance` (metres, and for the rotation as much); a call is found once.
PartCalls find_part_calls(const CheckSubject& subject, const FrameCapture& capture, const app::State& state,
                          float tolerance = 2e-4f);

/// Does the same for one tank of a frame, among calls of either model's lists.
PartCalls find_part_calls(const CheckSubject& subject, std::span<const TankListCall> calls,
                          const app::CameraView& camera, const app::TankInFrame& tank,
                          float tolerance = 2e-4f);

/// Returns how many parts were found.
std::size_t found_count(const PartCalls& calls);

} // namespace checks
