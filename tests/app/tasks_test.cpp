#include "app/tasks.h"

#include "app/commands.h"
#include "app/links.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>

namespace app {
namespace {

TEST(TasksTest, TheTasksOfAssemblingAreThereOnceEach)
{
    for (std::string_view id : {"1.1", "1.2", "1.3", "1.4"}) {
        const auto same = [id](const Task& task) { return task.kind == TaskKind::task && task.id == id; };
        EXPECT_EQ(std::count_if(tasks().begin(), tasks().end(), same), 1) << id;
        const std::optional<std::size_t> found = find_task(TaskKind::task, id);
        ASSERT_TRUE(found);
        EXPECT_EQ(tasks()[*found].id, id);
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

TEST(TasksTest, SourcesExist)
{
    for (const Task& task : tasks()) {
        const std::filesystem::path path = std::filesystem::path(REPOSITORY) / task.source;
        EXPECT_TRUE(std::filesystem::is_regular_file(path)) << task.id << ": " << path;
    }
}

} // namespace
} // namespace app
