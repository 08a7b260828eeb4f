#pragma once

#include <string>
#include <vector>

namespace platform_test {

/// What a program that has ended left behind.
struct Finished
{
    int status; ///< its exit status; -1 when a signal ended it
    std::string out;
    std::string err;
};

/// Runs a program to its end.
/// environment: "NAME=value" sets, "NAME" alone removes a variable.
Finished run(const std::vector<std::string>& command, const std::vector<std::string>& environment = {});

} // namespace platform_test
