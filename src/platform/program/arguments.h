#pragma once

#include <getopt.h>
#include <optional>
#include <string>

namespace platform {

/// What a program is given: an option with its value, or something that is none.
struct Argument
{
    int option = 0;    ///< as the table of options has it, or NO_OPTION
    std::string value; ///< of the option, "" where it is missing; or what is no option
};

inline constexpr int NO_OPTION = 1;
inline constexpr int FIRST_OPTION = 256; ///< Options have numbers from here on; those below are letters.

/// Reads a program's arguments by getopt_long, which keeps the place itself: one list can be read in a
/// process.
class Arguments
{
public:
    /// `arguments` begins with the program's name; `known` ends with an empty row.
    Arguments(int count, char* const* arguments, const option* known);

    /// Returns the next one. Returns nothing after the last one, and where one is wrong, which fault() then
    /// says.
    std::optional<Argument> next();

    /// Returns "" or a sentence that names the argument that is wrong.
    const std::string& fault() const { return fault_; }

private:
    int count_;
    char* const* arguments_;
    const option* known_;
    bool options_ended_ = false;
    std::string fault_;
};

/// Takes the link that a program is to open. Returns "" or a sentence, where it has one already.
std::string take_link(const std::string& given, std::optional<std::string>& link);

} // namespace platform
