#pragma once

#include "platform/checks.h"

#include <string>
#include <string_view>

namespace platform {

/// Returns a task as {id, title, text, commands, link, source, passed, evidence}: passed is null when nothing
/// has checked it, evidence an array of sentences. An unknown id gives null.
/// link: opens the task, such as "task=1.2". commands: names of commands to try.
std::string task_json(std::string_view id, const CheckResults& results);

/// Returns all tasks, without the handout's figures, as an array of what task_json gives.
std::string tasks_json(const CheckResults& results);

} // namespace platform
