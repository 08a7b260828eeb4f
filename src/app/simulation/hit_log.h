#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace app {

/// A line that was printed, and the number of the report it belongs to.
struct LogLine
{
    std::uint64_t report;
    std::string text;
};

/// Holds the last lines printed about hits, oldest first. Never the same line twice in a row: each report
/// begins with its number, and one that says what the last one said is not printed unless asked for.
class HitLog
{
public:
    /// More lines than this are not kept.
    static constexpr std::size_t MAX_LINES = 200;

    /// Prints a report if it says something else than the last one, or if asked for. Returns whether it did.
    bool print(std::span<const std::string> lines, bool is_asked);

    /// Prints an event.
    void note(std::string line);

    std::span<const LogLine> lines() const { return lines_; }

    /// Counts what was printed: reports and events.
    std::uint64_t count() const { return count_; }

private:
    void append(std::string text);

    std::vector<LogLine> lines_;
    std::vector<std::string> last_report_;
    std::uint64_t count_ = 0;
};

} // namespace app
