#include "app/simulation/hit_log.h"

#include <algorithm>
#include <utility>

namespace app {

void HitLog::append(std::string text)
{
    if (lines_.size() == MAX_LINES) {
        lines_.erase(lines_.begin());
    }
    lines_.push_back({count_, std::move(text)});
}

bool HitLog::print(std::span<const std::string> lines, bool is_asked)
{
    const bool is_new = !std::equal(lines.begin(), lines.end(), last_report_.begin(), last_report_.end());
    if (!is_new && !is_asked) {
        return false;
    }
    last_report_.assign(lines.begin(), lines.end());
    ++count_;
    const std::string head = "Report " + std::to_string(count_);
    if (lines.empty()) {
        append(head + ": nothing is tested.");
        return true;
    }
    append(head + (is_asked ? ", asked for:" : ":"));
    for (const std::string& line : lines) {
        append(line);
    }
    return true;
}

void HitLog::note(std::string line)
{
    ++count_;
    append("Event " + std::to_string(count_) + ": " + std::move(line));
}

} // namespace app
