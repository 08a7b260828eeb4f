#include "app/links/tasks.h"

#include "app/commands/commands.h"
#include "app/links/links.h"
#include "app/report/facts.h"
#include "app/report/state_json.h"
#include "fixtures.h"
#include "parsed_json.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>

namespace app {
namespace {

TEST(TasksTest, AllThirteenTasksAndAllFiguresAreThereOnceEachInTheHandoutsOrder)
{
    constexpr std::string_view IDS[] = {"1.1", "1.2", "1.3", "1.4", "2.1", "2.2", "2.3", "2.4", "2.5",
                                        "2.6", "3.1", "3.2", "3.3", "1",   "2",   "3",   "4",   "5a",
                                        "5b",  "5c",  "5d",  "6",   "7a",  "7b",  "7c",  "7d",  "8"};
    ASSERT_EQ(tasks().size(), std::size(IDS));
    for (std::size_t i = 0; i < std::size(IDS); ++i) {
        EXPECT_EQ(tasks()[i].id, IDS[i]);
        EXPECT_EQ(tasks()[i].kind, i < 13 ? TaskKind::task : TaskKind::figure);
        EXPECT_EQ(find_task(tasks()[i].kind, IDS[i]), i);
    }
    EXPECT_FALSE(find_task(TaskKind::task, "9.9"));
    EXPECT_FALSE(find_task(TaskKind::task, ""));
    EXPECT_FALSE(find_task(TaskKind::figure, "1.1"));
}

TEST(TasksTest, LinksHaveNoFaultsAndAreInTheirShortForm)
{
    for (const Task& task : tasks()) {
        State state;
        EXPECT_TRUE(open_link(state, task.link).messages.empty()) << task.id;
        EXPECT_FALSE(state.task) << task.id;
        EXPECT_EQ(link(state), task.link) << task.id;
    }
}

TEST(TasksTest, CommandsToTryExist)
{
    for (const Task& task : tasks()) {
        for (std::string_view name : task.commands) {
            if (!name.empty()) {
                EXPECT_NE(find_command(name), nullptr) << task.id << ": " << name;
            }
        }
        EXPECT_FALSE(task.title.empty());
        EXPECT_FALSE(task.text.empty());
    }
}

Simulation opened(std::string_view fragment)
{
    Simulation simulation(assets::own_assets());
    EXPECT_TRUE(simulation.open_link(fragment).messages.empty()) << fragment;
    return simulation;
}

collision::PartSet parts(std::initializer_list<tank::Part> list)
{
    collision::PartSet set;
    for (tank::Part part : list) {
        set.insert(tank::index_of(part));
    }
    return set;
}

TEST(TasksTest, EveryTaskAndFigureShowsEvidence)
{
    for (const Task& task : tasks()) {
        const Simulation simulation = opened(std::string(link_key(task.kind)) + "=" + std::string(task.id));
        EXPECT_GE(facts(simulation).size(), 3u) << task.id;
        EXPECT_FALSE(parsed_json(state_json(simulation)).is_discarded()) << task.id;
    }
}

TEST(TasksTest, PointsAreWhereTheFiguresSay)
{
    const Simulation outside = opened("figure=5b");
    EXPECT_FALSE(outside.report().explanation.root.is_inside);
    const Simulation in_none = opened("figure=5c");
    EXPECT_TRUE(in_none.report().explanation.root.is_inside);
    EXPECT_TRUE(in_none.report().explanation.hits.is_empty());
    EXPECT_FALSE(opened("figure=5d").report().explanation.hits.is_empty());
    for (std::string_view figure : {"figure=7a", "figure=7b", "figure=7c", "figure=7d"}) {
        EXPECT_EQ(opened(figure).report().explanation.hits, parts({tank::Part::body, tank::Part::turret}));
    }
    EXPECT_EQ(opened("figure=7a").frame().triangles.size(), 0u);
    const Simulation rejected = opened("figure=7d");
    ASSERT_EQ(rejected.report().triangles.size(), 2u);
    for (const TriangleTest& test : rejected.report().triangles) {
        EXPECT_FALSE(test.is_inside) << tank::part_name(test.part);
        EXPECT_GT(test.distance, 0.1);
    }
    EXPECT_EQ(rejected.frame().triangles.size(), 2u);
    // And one in the middle of the body is not rejected.
    const Simulation hit = opened("probe=point&point_x=0&point_y=1.1&point_z=0&triangles=on");
    ASSERT_FALSE(hit.report().triangles.empty());
    EXPECT_EQ(hit.report().triangles[0].part, tank::Part::body);
    EXPECT_TRUE(hit.report().triangles[0].is_inside);
}

TEST(TasksTest, TheTasksAboutHitsHitSomething)
{
    for (std::string_view task : {"task=2.3", "task=2.4", "task=2.5"}) {
        EXPECT_FALSE(opened(task).report().explanation.hits.is_empty()) << task;
    }
    const Simulation sparks = opened("task=2.6");
    EXPECT_GT(sparks.touches(), 0u);
    EXPECT_FALSE(sparks.frame().particles.empty());
}

TEST(TasksTest, TheTasksAboutLevelsUseTheHandoutsCamera)
{
    for (std::string_view task : {"task=3.2", "task=3.3"}) {
        const Frame frame = opened(task).frame();
        EXPECT_EQ(frame.camera.near_plane, 1.0) << task;
        EXPECT_EQ(frame.camera.eye.x, 0.0) << task;
        EXPECT_EQ(frame.camera.eye.y, frame.camera.centre.y) << task;
        EXPECT_EQ(frame.camera.eye.z, opened(task).state().camera.distance) << task; // the tank is at z = 0
    }
    EXPECT_EQ(opened("task=3.2").frame().tanks[0].level, lod::Level::low);
    EXPECT_EQ(opened("task=3.1").frame().tanks.size(), 2u);
    Simulation crossing = opened("task=3.3");
    EXPECT_EQ(crossing.frame().tanks[0].level, lod::Level::high);
    crossing.apply("zoom_out", 1.0);
    for (int i = 0; i < 60; ++i) {
        crossing.step();
    }
    EXPECT_EQ(crossing.frame().tanks[0].level, lod::Level::low);
    EXPECT_EQ(crossing.level_switches(), 1u);
}

TEST(TasksTest, SourcesExist)
{
    for (const Task& task : tasks()) {
        const std::filesystem::path path = std::filesystem::path(REPOSITORY) / task.source;
        EXPECT_TRUE(std::filesystem::is_regular_file(path)) << task.id << ": " << path;
    }
}

} // namespace
} // namespace app
