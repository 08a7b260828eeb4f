#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace app {

enum class TaskKind : std::uint8_t
{
    task,   ///< opened by `task=`
    figure, ///< a figure of the handout, opened by `figure=`
};

/// Describes one task or figure of the lab: what its link opens and what the reader should see.
struct Task
{
    TaskKind kind;
    std::string_view id; ///< as in the handout: "1.2", "5b"
    std::string_view title;
    std::string_view text;                     ///< one or two sentences: what to see and to try
    std::array<std::string_view, 10> commands; ///< names of the commands to try; unused ones are empty
    std::string_view link;   ///< the state it begins with, as a fragment without task or figure
    std::string_view source; ///< where it lives, from the top of the repository
};

/// Returns the table of tasks and figures, in the handout's order.
std::span<const Task> tasks();

/// Returns the link key of a kind: "task" or "figure".
constexpr std::string_view link_key(TaskKind kind)
{
    return kind == TaskKind::task ? "task" : "figure";
}

/// Returns the row of the task or figure with that id, or nothing.
std::optional<std::size_t> find_task(TaskKind kind, std::string_view id);

} // namespace app
