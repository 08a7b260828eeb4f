#include "app/simulation/simulation.h"

#include "app/commands/update.h"
#include "app/report/state_json.h"
#include "collision/transformed_sphere.h"
#include "fixtures.h"
#include "parsed_json.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <limits>

namespace app {
namespace {

using collision::BoundingSphere;

/// Opens the fragment and expects no messages.
void open(Simulation& simulation, std::string_view fragment)
{
    EXPECT_TRUE(simulation.open_link(fragment).messages.empty()) << fragment;
}

void random_pose(Simulation& simulation, std::mt19937_64& random)
{
    for (std::string_view name : {"turret", "gun", "secondary_gun", "secondary_gun_pitch", "wheels_left",
                                  "wheels_right", "heading", "x", "z"}) {
        ASSERT_EQ(simulation.apply(name, next_unit(random) * 360.0 - 180.0).refusal, "");
    }
}

TEST(SimulationTest, EveryVertexOfTheTankIsInsideItsPartsSphereAndThatInTheRootInEveryPose)
{
    const assets::Assets& assets = assets::own_assets();
    Simulation simulation(assets);
    std::mt19937_64 random(51);
    for (int pose = 0; pose < 2000; ++pose) {
        random_pose(simulation, random);
        ASSERT_EQ(simulation.apply("fit", pose % 2).refusal, "");
        const collision::SphereHierarchy& spheres = simulation.spheres().hierarchy();
        for (tank::Part part : tank::ALL_PARTS) {
            const BoundingSphere& sphere = spheres.parts()[tank::index_of(part)];
            ASSERT_LE(glm::distance(sphere.centre, spheres.root().centre) + sphere.radius,
                      spheres.root().radius + 1e-9);
            const auto& vertices = assets.high[tank::index_of(assets.layout[part].mesh)].positions;
            const glm::dmat4 matrix(simulation.spheres().matrices().mesh(part));
            for (std::size_t i = static_cast<std::size_t>(pose) % 17; i < vertices.size(); i += 17) {
                const glm::dvec3 vertex(matrix * glm::dvec4(glm::dvec3(vertices[i]), 1.0));
                ASSERT_LE(glm::distance(vertex, sphere.centre), sphere.radius * (1.0 + 1e-12));
            }
        }
    }
}

TEST(SimulationTest, SpheresAreThoseOfTheHighMeshesMovedWithTheirParts)
{
    const assets::Assets& assets = assets::own_assets();
    Simulation simulation(assets);
    for (std::string_view fragment :
         {"turret=90&gun=20&wheels=45&heading=30&x=7&z=-3", "turret=-50&detail=low&distance=300"}) {
        open(simulation, fragment);
        const State& state = simulation.state();
        const tank::PartMatrices matrices =
            tank::part_matrices(assets.layout, {{state.x, 0.0, state.z}}, state.joints);
        for (tank::Part part : tank::ALL_PARTS) {
            const BoundingSphere local =
                collision::average_sphere(assets.high[tank::index_of(assets.layout[part].mesh)].positions);
            EXPECT_EQ(simulation.spheres().hierarchy().parts()[tank::index_of(part)],
                      collision::transformed(local, matrices.mesh(part)))
                << tank::part_name(part);
        }
    }
}

TEST(SimulationTest, OnlyWhatMovedIsRefitted)
{
    Simulation simulation(assets::own_assets());
    const auto counts = [&] { return simulation.spheres().hierarchy().refit_counts(); };
    const collision::RefitCounts start = counts();
    for (int i = 0; i < 100; ++i) {
        simulation.step();
    }
    EXPECT_EQ(counts().parts, start.parts);
    EXPECT_EQ(counts().roots, start.roots);
    simulation.apply("gun", 5.0);
    EXPECT_EQ(counts().parts, start.parts + 1);
    simulation.apply("turret", 5.0); // carries both guns
    EXPECT_EQ(counts().parts, start.parts + 4);
    simulation.apply("orbit", 5.0);
    EXPECT_EQ(counts().parts, start.parts + 4);
}

TEST(SimulationTest, HeldKeysMoveTheSpheresWithTheParts)
{
    Simulation simulation(assets::own_assets());
    const glm::dvec3 gun = simulation.spheres().hierarchy().parts()[2].centre;
    simulation.apply("turret_left", 1.0);
    for (int i = 0; i < 135; ++i) { // a quarter turn at 40 degrees a second
        simulation.step();
    }
    const glm::dvec3 turned = simulation.spheres().hierarchy().parts()[2].centre;
    const double pivot_z = 0.25;
    EXPECT_NEAR(turned.x, gun.z - pivot_z, 1e-5);
    EXPECT_NEAR(turned.z - pivot_z, -gun.x, 1e-5);
}

TEST(SimulationTest, TheReportTellsTheWholeFirstAndItsPartsOnlyIfInside)
{
    Simulation simulation(assets::own_assets());
    open(simulation, "probe=point&point_x=50");
    std::vector<std::string> lines = report_lines(simulation.report());
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_TRUE(simulation.report().explanation.parts.empty());
    EXPECT_NE(lines[0].find("outside the whole tank"), std::string::npos) << lines[0];

    open(simulation, "probe=point&point_x=0.9&point_y=3.4&point_z=1");
    lines = report_lines(simulation.report());
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_EQ(simulation.report().explanation.parts.size(), tank::PART_COUNT);
    EXPECT_NE(lines[0].find("(0.9, 3.4, 1) is inside the whole tank: centre"), std::string::npos) << lines[0];
    EXPECT_EQ(lines[1].find("It penetrates body: centre"), 0u) << lines[1];
    EXPECT_EQ(lines[2].find("It penetrates turret: centre"), 0u) << lines[2];
    for (std::string_view word : {"radius", "distance", "depth"}) {
        EXPECT_NE(lines[2].find(word), std::string::npos) << lines[2];
    }
    EXPECT_EQ(lines[2].find("parameter"), std::string::npos);
    EXPECT_TRUE(report_lines(Simulation(assets::own_assets()).report()).empty());
}

TEST(SimulationTest, TheReportOfALineHasTheClosestPointAndItsParameter)
{
    Simulation simulation(assets::own_assets());
    for (std::string_view probe : {"segment", "ray", "line"}) {
        open(simulation, "probe=" + std::string(probe));
        const std::vector<std::string> lines = report_lines(simulation.report());
        ASSERT_GE(lines.size(), 2u);
        for (const std::string& line : lines) {
            EXPECT_NE(line.find("closest point"), std::string::npos) << line;
            EXPECT_NE(line.find("parameter"), std::string::npos) << line;
        }
    }
    // The line has no ends: turned away from the tank it hits from behind, where a ray does not.
    constexpr std::string_view AWAY = "&line_ax=20&line_ay=2&line_az=0&line_bx=30&line_by=2&line_bz=0";
    open(simulation, "probe=line" + std::string(AWAY));
    EXPECT_FALSE(simulation.report().explanation.hits.is_empty());
    open(simulation, "probe=ray" + std::string(AWAY));
    EXPECT_TRUE(simulation.report().explanation.hits.is_empty());
}

TEST(SimulationTest, ALineWithBothEndsEqualIsAPointAndSaysSo)
{
    Simulation simulation(assets::own_assets());
    for (std::string_view probe : {"segment", "ray", "line"}) {
        open(simulation,
             "probe=" + std::string(probe) + "&line_ax=0&line_ay=2&line_az=0&line_bx=0&line_by=2&line_bz=0");
        const HitReport of_line = simulation.report();
        EXPECT_NE(report_lines(of_line)[0].find("a point"), std::string::npos);
        open(simulation, "probe=point&point_x=0&point_y=2&point_z=0");
        EXPECT_EQ(simulation.report().explanation.hits, of_line.explanation.hits);
    }
}

TEST(SimulationTest, NoLineIsPrintedTwiceInARow)
{
    Simulation simulation(assets::own_assets());
    std::mt19937_64 random(53);
    for (int i = 0; i < 3000; ++i) {
        const Command& command = commands()[random() % commands().size()];
        const bool is_switch = command.kind == CommandKind::hold || command.kind == CommandKind::press;
        simulation.apply(command, is_switch ? static_cast<double>(random() % 2) : next_unit(random) * 10 - 5);
        if (random() % 3 == 0) {
            simulation.apply("print_report", 1.0);
        }
        simulation.step();
        const std::span<const LogLine> lines = simulation.log().lines();
        ASSERT_LE(lines.size(), HitLog::MAX_LINES);
        for (std::size_t line = 1; line < lines.size(); ++line) {
            ASSERT_NE(lines[line].text, lines[line - 1].text);
        }
    }
    EXPECT_GT(simulation.log().count(), 100u);
}

TEST(SimulationTest, ReportsArePrintedOnLoadOnEveryChangeAndByKeyAndNotOtherwise)
{
    Simulation simulation(assets::own_assets());
    EXPECT_EQ(simulation.log().count(), 0u);
    open(simulation, "probe=point&point_x=1");
    EXPECT_EQ(simulation.log().count(), 1u);
    for (int i = 0; i < 100; ++i) {
        simulation.step();
    }
    simulation.apply("orbit", 30.0);
    EXPECT_EQ(simulation.log().count(), 1u);
    simulation.apply("point_x", 1.1);
    EXPECT_EQ(simulation.log().count(), 2u);
    simulation.apply("turret", 30.0); // the spheres move, not the point
    EXPECT_EQ(simulation.log().count(), 3u);
    simulation.apply("print_report", 1.0);
    simulation.apply("print_report", 1.0);
    EXPECT_EQ(simulation.log().count(), 5u);
    simulation.apply("print_report", 0.0);
    EXPECT_EQ(simulation.log().count(), 5u);
    simulation.apply("projectile_up", 1.0);
    simulation.step();
    simulation.step();
    EXPECT_EQ(simulation.log().count(), 7u);
}

TEST(SimulationTest, NotANumberNeverReachesTheProjectile)
{
    Simulation simulation(assets::own_assets());
    open(simulation, "probe=point&point_x=1");
    for (std::string_view name : {"point_x", "point_y", "point_z", "point_radius", "line_ax", "line_bz",
                                  "speed", "aim_x", "threshold", "projectile_x_by"}) {
        EXPECT_NE(simulation.apply(name, std::numeric_limits<double>::quiet_NaN()).refusal, "") << name;
        EXPECT_NE(simulation.apply(name, std::numeric_limits<double>::infinity()).refusal, "") << name;
    }
    EXPECT_EQ(simulation.open_link("probe=point&point_x=nan").messages.size(), 1u);
    EXPECT_EQ(simulation.open_link("point_x=99999&threshold=0.2").messages.size(), 2u); // clamped and named
    EXPECT_EQ(simulation.state().projectile.point.x, field(FieldId::point_x).maximum);
    EXPECT_EQ(simulation.state().show.threshold, 1.0);
}

TEST(SimulationTest, KeysMoveWhatTheHandleSays)
{
    Simulation simulation(assets::own_assets());
    const Projectile start = simulation.state().projectile;
    for (int handle = 0; handle < 3; ++handle) {
        open(simulation, "");
        simulation.apply("handle", handle);
        simulation.apply("projectile_x_by", 1.0);
        simulation.apply("projectile_y_by", 2.0);
        simulation.apply("projectile_z_by", -3.0);
        const Projectile& moved = simulation.state().projectile;
        const glm::dvec3 by(1.0, 2.0, -3.0);
        EXPECT_EQ(moved.point, start.point + (handle == 0 ? by : glm::dvec3(0.0)));
        EXPECT_EQ(moved.a, start.a + (handle == 1 ? by : glm::dvec3(0.0)));
        EXPECT_EQ(moved.b, start.b + (handle == 2 ? by : glm::dvec3(0.0)));
    }
}

TEST(SimulationTest, TheFrameShowsWhatIsPenetratedAndWires)
{
    Simulation simulation(assets::own_assets());
    open(simulation, "probe=point&point_x=0.9&point_y=3.4&point_z=1");
    Frame frame = simulation.frame();
    ASSERT_EQ(frame.spheres.size(), 3u); // root, body, turret
    EXPECT_EQ(frame.closest_points.size(), 3u);
    for (const SphereInFrame& sphere : frame.spheres) {
        EXPECT_TRUE(sphere.is_penetrated);
    }
    open(simulation, "spheres=all");
    frame = simulation.frame();
    EXPECT_EQ(frame.spheres.size(), 19u);
    double last = std::numeric_limits<double>::infinity();
    for (const SphereInFrame& sphere : frame.spheres) {
        EXPECT_FALSE(sphere.is_penetrated);
        EXPECT_LE(glm::distance(sphere.centre, frame.camera.eye), last);
        last = glm::distance(sphere.centre, frame.camera.eye);
    }
    open(simulation, "spheres=whole");
    ASSERT_EQ(simulation.frame().spheres.size(), 1u);
    EXPECT_TRUE(simulation.frame().spheres[0].is_root);
    open(simulation, "spheres=parts&parts=body");
    ASSERT_EQ(simulation.frame().spheres.size(), 1u);
    EXPECT_EQ(simulation.frame().spheres[0].part, tank::Part::body);
    open(simulation, "spheres=off&probe=point&point_x=0.9&point_y=3.4&point_z=1");
    EXPECT_TRUE(simulation.frame().spheres.empty());
}

/// Returns how many sparks are alight, those of an event before included.
std::size_t sparks_alight(const Simulation& simulation)
{
    std::size_t count = 0;
    for (const particles::ParticleSystem* system : simulation.sparks().systems()) {
        count += system->view().count();
    }
    return count;
}

TEST(SimulationTest, AnOpenedLinkHasItsOwnSparksAloneWhateverWasOpenBefore)
{
    constexpr std::string_view UNDER_WAY = "task=2.6&speed=30&event=fire&tick=16";
    Simulation simulation(assets::own_assets());
    open(simulation, UNDER_WAY);
    const std::size_t sparks = sparks_alight(simulation);
    ASSERT_GT(sparks, 50u);
    open(simulation, UNDER_WAY);
    EXPECT_EQ(sparks_alight(simulation), sparks);
    open(simulation, "task=2.6&speed=30&event=fire&tick=12");
    EXPECT_EQ(sparks_alight(simulation), 0u) << "nothing is met yet";
    open(simulation, UNDER_WAY);
    open(simulation, "turret=10");
    EXPECT_EQ(sparks_alight(simulation), 0u);
}

TEST(SimulationTest, TheLevelThatIsShownIsThatOfTheFrame)
{
    Simulation simulation(assets::own_assets());
    for (std::string_view fragment : {"", "distance=400", "detail=low", "detail=high&distance=400",
                                      "detail=both&distance=400", "task=3.2"}) {
        open(simulation, fragment);
        EXPECT_EQ(simulation.shown_level(), simulation.frame().tanks[0].level) << fragment;
    }
}

TEST(SimulationTest, JsonHasTheHits)
{
    Simulation simulation(assets::own_assets());
    open(simulation, "task=2.5");
    const nlohmann::json state = parsed_json(state_json(simulation));
    ASSERT_FALSE(state.is_discarded());
    EXPECT_EQ(state["probe"], "segment");
    EXPECT_EQ(state["hits"]["report"]["root"]["part"], "tank");
    EXPECT_EQ(state["hits"]["report"]["root"]["inside"], true);
    EXPECT_GE(state["hits"]["report"]["parts"].size(), 1u);
    const nlohmann::json hits = parsed_json(hits_json(simulation));
    ASSERT_FALSE(hits.is_discarded());
    EXPECT_EQ(hits["log"].size(), hits["lines"].size() + 1);
    open(simulation, "");
    const nlohmann::json none = parsed_json(hits_json(simulation));
    ASSERT_FALSE(none.is_discarded());
    EXPECT_TRUE(none["report"].is_null());
}

} // namespace
} // namespace app
