#pragma once

#include "app/simulation/hit_log.h"

#include <cstdint>

namespace platform {

/// Prints what a simulation logs on the standard output, each line once.
class LogPrinter
{
public:
    /// Prints the lines that have come since the last call.
    void print(const app::HitLog& log);

private:
    std::uint64_t printed_ = 0; ///< reports
};

} // namespace platform
