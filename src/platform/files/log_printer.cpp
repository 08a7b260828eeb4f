#include "platform/files/log_printer.h"

#include <cstdio>

namespace platform {

void LogPrinter::print(const app::HitLog& log)
{
    if (log.count() == printed_) {
        return;
    }
    for (const app::LogLine& line : log.lines()) {
        if (line.report > printed_) {
            std::printf("%s\n", line.text.c_str());
        }
    }
    std::fflush(stdout); // a pipe shall see it as it happens
    printed_ = log.count();
}

} // namespace platform
