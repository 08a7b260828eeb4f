#include "checks/checks.h"

#include "app/links/tasks.h"
#include "platform/files/asset_files.h"
#include "platform/offscreen/offscreen_target.h"

#include <memory>
#include <string>

#include <gtest/gtest.h>

namespace checks {
namespace {

constexpr int SIDE = 256; // pixels

std::string joined(const CheckResult& result)
{
    std::string text;
    for (const std::string& sentence : result.evidence) {
        text += sentence + "\n";
    }
    return text;
}

class Checks : public ::testing::Test
{
protected:
    void SetUp() override
    {
        std::string error;
        target = platform::open_offscreen_target(SIDE, SIDE, error);
        ASSERT_EQ(error, "");
        ASSERT_EQ(platform::read_asset_folder(ASSETS, assets), "");
        drawn_assets = assets;
    }

    /// Runs a check on a program that draws `drawn_assets`, while it should draw `assets`.
    CheckResult run(std::string_view id)
    {
        scene::SceneRenderer renderer;
        EXPECT_EQ(renderer.load(drawn_assets), "");
        const auto result = run_check(id, {assets, renderer, SIDE, SIDE});
        EXPECT_TRUE(result.has_value());
        return result.value_or(CheckResult{std::string(id), false, {}});
    }

    std::unique_ptr<platform::OffscreenTarget> target;
    assets::Assets assets;
    assets::Assets drawn_assets;
};

TEST_F(Checks, PassOnTheProgramAsItIs)
{
    for (const app::Task& task : app::tasks()) {
        if (task.kind == app::TaskKind::task) {
            const CheckResult result = run(task.id);
            EXPECT_TRUE(result.passed) << task.id << ":\n" << joined(result);
            EXPECT_FALSE(result.evidence.empty());
        }
    }
}

TEST_F(Checks, OfAnUnknownTaskAreNone)
{
    scene::SceneRenderer renderer;
    ASSERT_EQ(renderer.load(assets), "");
    EXPECT_FALSE(run_check("9.9", {assets, renderer, SIDE, SIDE}).has_value());
}

TEST_F(Checks, OfAssemblyFindATurretThatDoesNotCarryTheGun)
{
    drawn_assets.layout[tank::Part::main_gun].parent = tank::Part::body;
    EXPECT_FALSE(run("1.1").passed);
}

TEST_F(Checks, OfAssemblyFindAWrongTreeThatDrawingAndComputingAgreeOn)
{
    assets.layout[tank::Part::wheel_left_3].parent = tank::Part::turret;
    drawn_assets = assets;
    EXPECT_FALSE(run("1.1").passed);
}

TEST_F(Checks, OfAssemblyFindAPartOneCentimetreOff)
{
    drawn_assets.layout[tank::Part::wheel_right_7].pivot.y += 0.01f;
    const CheckResult result = run("1.1");
    EXPECT_FALSE(result.passed);
    EXPECT_NE(joined(result).find("wheel_right_7"), std::string::npos) << joined(result);
}

TEST_F(Checks, OfJointsFindAWrongAxis)
{
    drawn_assets.layout[tank::Part::secondary_gun].axis = {1.0f, 0.0f, 0.0f};
    EXPECT_FALSE(run("1.2").passed);
}

TEST_F(Checks, OfJointsFindAWheelThatTurnsTheOtherWay)
{
    drawn_assets.layout[tank::Part::wheel_right_1].axis = {-1.0f, 0.0f, 0.0f};
    EXPECT_FALSE(run("1.2").passed);
}

TEST_F(Checks, OfJointsFindAPivotBesideTheTrunnion)
{
    drawn_assets.layout[tank::Part::main_gun].pivot.z -= 0.5f;
    drawn_assets.layout[tank::Part::main_gun].mesh_offset.z += 0.5f; // at rest nothing shows
    EXPECT_FALSE(run("1.2").passed);
}

TEST_F(Checks, OfJointsFindASecondaryGunThatPitchesAboutAnotherAxisOrPivotOrNotAtAll)
{
    std::optional<tank::Turn>& pitch = drawn_assets.layout[tank::Part::secondary_gun].second;
    const tank::Turn right = *pitch;
    pitch->axis = -right.axis;
    EXPECT_FALSE(run("1.2").passed);
    *pitch = right;
    pitch->pivot.z -= 0.3f;
    drawn_assets.layout[tank::Part::secondary_gun].mesh_offset.z += 0.3f; // at rest nothing shows
    EXPECT_FALSE(run("1.2").passed);
    drawn_assets.layout = assets.layout;
    drawn_assets.layout[tank::Part::secondary_gun].mesh_offset += right.pivot;
    pitch.reset();
    EXPECT_FALSE(run("1.2").passed);
}

TEST_F(Checks, OfListsFindAWheelDrawnAsAnotherMesh)
{
    drawn_assets.layout[tank::Part::wheel_left_1].mesh = tank::MeshKind::secondary_gun;
    EXPECT_FALSE(run("1.3").passed);
}

TEST_F(Checks, OfListsFindAListThatDrawsNothing)
{
    drawn_assets.high[tank::index_of(tank::MeshKind::turret)] = {};
    EXPECT_FALSE(run("1.3").passed);
}

TEST_F(Checks, OfDrawObjFindALostFace)
{
    drawn_assets.high[tank::index_of(tank::MeshKind::turret)].faces.pop_back();
    EXPECT_FALSE(run("1.4").passed);
}

TEST_F(Checks, OfDrawObjFindOneWrongIndexOfEachKind)
{
    using Index = int mesh::FaceVertex::*;
    for (Index index :
         {&mesh::FaceVertex::position, &mesh::FaceVertex::normal, &mesh::FaceVertex::texture_coordinate}) {
        drawn_assets = assets;
        mesh::FaceVertex& corner =
            drawn_assets.high[tank::index_of(tank::MeshKind::body)].faces[100].vertices[1];
        corner.*index = corner.*index == 0 ? 7 : 0;
        EXPECT_FALSE(run("1.4").passed);
    }
}

} // namespace
} // namespace checks
