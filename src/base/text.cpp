#include "base/text.h"

namespace base {

std::string in_quotes(std::string_view text)
{
    constexpr std::size_t LONGEST = 40;
    std::string_view shown = text;
    if (shown.size() > LONGEST) {
        std::size_t end = LONGEST;
        while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) {
            --end;
        }
        shown = text.substr(0, end);
    }
    std::string result = "\"";
    for (const char c : shown) {
        const unsigned char byte = static_cast<unsigned char>(c);
        result += byte < ' ' || byte == 0x7f ? '?' : c;
    }
    result += shown.size() < text.size() ? "...\"" : "\"";
    return result;
}

std::string listed(std::span<const std::string_view> items, std::string_view conjunction)
{
    std::string result;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (i > 0 && i + 1 == items.size()) {
            result += ' ';
            result += conjunction;
            result += ' ';
        } else if (i > 0) {
            result += ", ";
        }
        result += items[i];
    }
    return result;
}

std::string lower_case(std::string_view text)
{
    std::string result(text);
    for (char& c : result) {
        if (c >= 'A' && c <= 'Z') {
            c = static_cast<char>(c - 'A' + 'a');
        }
    }
    return result;
}

} // namespace base
