#include "base/quoted.h"

namespace base {

std::string quoted(std::string_view text)
{
    constexpr std::size_t longest = 32;
    std::string result = "'";
    for (const char c : text.substr(0, longest)) {
        result += c >= ' ' && c <= '~' ? c : '?';
    }
    result += text.size() > longest ? "...'" : "'";
    return result;
}

} // namespace base
