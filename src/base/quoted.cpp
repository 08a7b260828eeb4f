#include "base/quoted.h"

namespace base {

std::string quoted(std::string_view text)
{
    constexpr std::size_t MAX_LENGTH = 32;
    std::string result = "'";
    for (const char c : text.substr(0, MAX_LENGTH)) {
        result += c >= ' ' && c <= '~' ? c : '?';
    }
    result += text.size() > MAX_LENGTH ? "...'" : "'";
    return result;
}

} // namespace base
