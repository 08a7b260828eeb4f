#pragma once

#include "fixtures.h"
#include "recording_gl.h"
#include "scene/scene_renderer.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

using recording_gl::Call;
using recording_gl::ListCall;

/// A renderer that has loaded a small tank, and what OpenGL is called.
class SceneRenderer : public ::testing::Test
{
protected:
    void SetUp() override
    {
        recording_gl::reset();
        ASSERT_EQ(renderer.load(assets), "");
        loading = recording_gl::take_calls();
    }

    std::vector<Call> draw(int width = 640, int height = 400)
    {
        renderer.draw(app::make_frame(state, assets), width, height);
        return recording_gl::take_calls();
    }

    bool is_of_tank(const ListCall& call) const
    {
        for (std::size_t mesh = 0; mesh < tank::MESH_KIND_COUNT; ++mesh) {
            if (call.list == renderer.tank_lists().list(static_cast<tank::MeshKind>(mesh))) {
                return true;
            }
        }
        return false;
    }

    /// The list calls of the frame, with what loading and the frame itself have enabled.
    recording_gl::Replay replay(const std::vector<Call>& frame) const
    {
        std::vector<Call> all = loading;
        all.insert(all.end(), frame.begin(), frame.end());
        return recording_gl::replay(all);
    }

    assets::Assets assets = scene_test::assets();
    app::State state;
    scene::SceneRenderer renderer;
    std::vector<Call> loading;
};

/// Returns the first call of that name, or null.
inline const Call* first_named(const std::vector<Call>& calls, std::string_view name)
{
    const auto found =
        std::find_if(calls.begin(), calls.end(), [&](const Call& call) { return call.name == name; });
    return found == calls.end() ? nullptr : &*found;
}
