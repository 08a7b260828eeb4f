#pragma once

#include "checks/checks.h"

#include <string>
#include <string_view>

namespace checks {

/// Returns a task, or a figure of the handout, as app::write_task() has it, and besides `passed`, null when
/// nothing has checked it, and `evidence`, an array of sentences. An unknown id gives null.
std::string task_json(std::string_view id, const CheckResults& results);

/// Returns all tasks and figures as an array of what task_json gives.
std::string tasks_json(const CheckResults& results);

} // namespace checks
