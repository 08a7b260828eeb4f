#pragma once

#include "checks/frame_capture.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace checks {

/// What the check of one of the lab's tasks found.
struct CheckResult
{
    std::string id; ///< of the task, such as "1.2"
    bool passed;
    std::vector<std::string> evidence; ///< sentences for people, at least one
};

/// What the last check of each task found, in no order.
using CheckResults = std::vector<CheckResult>;

/// Puts a result into the others, in the place of an older one of the same task.
void remember(CheckResults& results, CheckResult result);

/// Returns the result of a task, or null.
const CheckResult* find_result(const CheckResults& results, std::string_view id);

/// Checks a task of the lab, such as "1.2": does with states of its own, by the program's commands, what a
/// person would do, and judges the calls that drawing them made.
/// Draws over the target; what it showed has to be drawn again.
/// Returns nothing for an id that has no check. Precondition: legacygl has a current context.
std::optional<CheckResult> run_check(std::string_view id, const CheckSubject& subject);

} // namespace checks
