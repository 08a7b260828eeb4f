#include "random_gl/program.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace random_gl {
namespace {

/// Writes a number so that reading it gives the same number.
std::string decimal(const char* format, double value)
{
    char text[40];
    std::snprintf(text, sizeof text, format, value);
    const bool looks_whole = std::string(text).find_first_of(".en") == std::string::npos;
    return text + std::string(looks_whole ? ".0" : "");
}

} // namespace

std::string written(const Name& name)
{
    return name.text;
}

std::string written(float value)
{
    return decimal("%.9g", static_cast<double>(value)) + "f";
}

std::string written(double value)
{
    return decimal("%.17g", value);
}

std::string written(int value)
{
    return std::to_string(value);
}

std::string written(unsigned value)
{
    return std::to_string(value) + "u";
}

std::size_t Program::add_command(std::string text, std::function<void()> run)
{
    const std::size_t index = commands_.size();
    commands_.push_back({std::move(text), std::move(run), index, false, unit_.value_or(index)});
    return index;
}

void Program::begin_unit()
{
    unit_ = commands_.size();
}

void Program::pair(std::size_t opening, std::size_t closing, bool holds_together)
{
    commands_[opening].partner = closing;
    commands_[closing].partner = opening;
    commands_[opening].holds_together = commands_[closing].holds_together = holds_together;
}

void Program::run(std::span<const std::size_t> kept) const
{
    for (const std::size_t i : kept) {
        commands_[i].run();
    }
}

void Program::run(std::size_t from) const
{
    for (; from < commands_.size(); ++from) {
        commands_[from].run();
    }
}

std::vector<std::size_t> Program::without(std::span<const std::size_t> kept, std::size_t from,
                                          std::size_t to) const
{
    std::vector<bool> falls(commands_.size(), false);
    for (std::size_t place = from; place < std::min(to, kept.size()); ++place) {
        const std::size_t unit = commands_[kept[place]].unit;
        for (std::size_t i = unit; i < commands_.size() && (i == unit || commands_[i].unit == unit); ++i) {
            const std::size_t partner = commands_[i].partner;
            falls[i] = falls[partner] = true;
            if (commands_[i].holds_together) {
                std::fill(falls.begin() + static_cast<long>(std::min(i, partner)),
                          falls.begin() + static_cast<long>(std::max(i, partner)), true);
            }
        }
    }
    std::vector<std::size_t> rest;
    std::copy_if(kept.begin(), kept.end(), std::back_inserter(rest),
                 [&](std::size_t i) { return !falls[i]; });
    return rest;
}

} // namespace random_gl
