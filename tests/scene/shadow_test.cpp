#include "scene/surroundings/shadow.h"

#include "fixtures.h"
#include "recording_gl.h"
#include "scene/drawing/lights.h"
#include "tank/part_matrices.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <GL/gl.h>
#include <gtest/gtest.h>

namespace {

using recording_gl::ListCall;

class Shadow : public ::testing::Test
{
protected:
    void SetUp() override
    {
        recording_gl::reset();
        ASSERT_TRUE(lists.load_shapes(assets.meshes(scene::shadow_level(assets))));
        recording_gl::take_calls();
    }

    /// Returns the calls of lists that draw the shadow; the modelview matrix is the identity before.
    std::vector<ListCall> draw()
    {
        scene::draw_shadow(app::make_frame(state, assets), assets, lists);
        replay = recording_gl::replay(recording_gl::take_calls());
        return replay.list_calls;
    }

    assets::Assets assets = scene_test::assets();
    app::State state;
    scene::TankLists lists;
    recording_gl::Replay replay;
};

/// Returns which of the layers a call belongs to: the stencil's reference value.
double layer_of(const ListCall& call)
{
    return call.settings.at("glStencilFunc")[1];
}

TEST_F(Shadow, LiesInTheGroundsPlaneAlongTheSunsRaysFromEveryPart)
{
    state.joints.radians = {0.3, -0.8, 0.2, 1.1, 2.0, -2.0};
    state.x = 4.0;
    state.z = -7.0;
    const std::vector<ListCall> calls = draw();
    const tank::PartMatrices matrices = tank::part_matrices(assets.layout, {{4.0, 0.0, -7.0}}, state.joints);
    ASSERT_EQ(calls.size() % tank::PART_COUNT, 0u);
    const glm::dvec3 ray = glm::dvec3(scene::TO_SUN) / static_cast<double>(scene::TO_SUN.y);
    std::map<unsigned, std::size_t> drawn;
    for (const ListCall& call : calls) {
        ++drawn[call.list];
        bool is_some_part = false;
        for (tank::Part part : tank::ALL_PARTS) {
            bool is_this_part = call.list == lists.shape_list(assets.layout[part].mesh);
            for (const glm::dvec4& corner : {glm::dvec4(0, 0, 0, 1), glm::dvec4(1, 2, 3, 1)}) {
                const glm::dvec4 thrown = call.modelview * corner;
                const glm::dvec4 place = glm::dmat4(matrices.mesh(part)) * corner;
                // A sun's disc of two or three degrees: 0.05 m to any side for each metre of height.
                const double reach = 0.05 * std::abs(place.y) + 1e-5;
                is_this_part = is_this_part && std::abs(thrown.y) < 1e-9 &&
                               std::abs(thrown.x - (place.x - place.y * ray.x)) < reach &&
                               std::abs(thrown.z - (place.z - place.y * ray.z)) < reach;
            }
            is_some_part = is_some_part || is_this_part;
        }
        EXPECT_TRUE(is_some_part);
    }
    EXPECT_EQ(drawn.size(), tank::MESH_KIND_COUNT);
    EXPECT_EQ(replay.final_stack_depth, 0u);
}

TEST_F(Shadow, DarkensEachPixelOnceInEachLayer)
{
    state.show.detail = app::Detail::both;
    std::map<double, std::size_t> parts_of_layer;
    for (const ListCall& call : draw()) {
        EXPECT_TRUE(call.is_enabled(GL_STENCIL_TEST));
        EXPECT_EQ(call.settings.at("glStencilFunc")[0], double(GL_GREATER));
        EXPECT_EQ(call.settings.at("glStencilOp"), (std::vector<double>{GL_KEEP, GL_KEEP, GL_REPLACE}));
        EXPECT_TRUE(call.is_enabled(GL_BLEND));
        EXPECT_FALSE(call.depth_writes);
        ++parts_of_layer[layer_of(call)];
    }
    ASSERT_GT(parts_of_layer.size(), 1u); // the edge is soft
    double layer = 1.0;                   // above the stencil that was cleared, one after the other
    for (const auto& [reference, parts] : parts_of_layer) {
        EXPECT_EQ(reference, layer);
        EXPECT_EQ(parts, 2 * tank::PART_COUNT); // of both tanks: where their shadows meet is no darker
        layer += 1.0;
    }
}

TEST_F(Shadow, IsThrownByTheSameShapesWhateverTheLevel)
{
    state.show.detail = app::Detail::high;
    const std::vector<ListCall> high = draw();
    state.show.detail = app::Detail::low;
    const std::vector<ListCall> low = draw();
    ASSERT_EQ(high.size(), low.size());
    for (std::size_t i = 0; i < high.size(); ++i) {
        EXPECT_EQ(high[i].list, low[i].list);
        EXPECT_EQ(high[i].modelview, low[i].modelview);
    }
}

TEST_F(Shadow, IsThrownByTheHighModelWhereThereIsNoLowOne)
{
    EXPECT_EQ(scene::shadow_level(assets), lod::Level::low);
    assets.has_low_model = false;
    EXPECT_EQ(scene::shadow_level(assets), lod::Level::high);
}

TEST_F(Shadow, IsThatOfThePartsThatAreDrawn)
{
    state.show.parts = app::PartsShown::main_gun;
    std::set<unsigned> drawn;
    for (const ListCall& call : draw()) {
        drawn.insert(call.list);
    }
    EXPECT_EQ(drawn, (std::set<unsigned>{lists.shape_list(tank::MeshKind::main_gun)}));
}

TEST_F(Shadow, TakesFewerLayersForAFarEye)
{
    const std::size_t near_calls = draw().size();
    state.camera.distance = 300.0;
    const std::size_t far_calls = draw().size();
    EXPECT_GE(far_calls, tank::PART_COUNT);
    EXPECT_LE(4 * far_calls, near_calls);
}

TEST_F(Shadow, IsNotDrawnWithoutAStencil)
{
    recording_gl::have_no_stencil(); // every triangle would darken what others have darkened
    EXPECT_TRUE(draw().empty());
}

} // namespace
