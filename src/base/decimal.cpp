#include "base/decimal.h"

#include <algorithm>

namespace base {

namespace {

constexpr std::size_t MAX_WHOLE_DIGITS = 12;

bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

bool all_digits(std::string_view text)
{
    return std::all_of(text.begin(), text.end(), is_digit);
}

/// Says what kind of non-number a text is; it has no sign any more.
DecimalError why_no_number(std::string_view text)
{
    if (!text.empty() && text.find_first_not_of("0123456789.,") == text.npos && text.find(',') != text.npos) {
        return DecimalError::comma;
    }
    const std::size_t e = text.find_first_of("eE");
    if (e != text.npos && e > 0 && text.substr(0, e).find_first_not_of("0123456789.") == text.npos) {
        const std::string_view power = text.substr(e + 1);
        const std::string_view digits =
            !power.empty() && (power[0] == '+' || power[0] == '-') ? power.substr(1) : power;
        if (!digits.empty() && all_digits(digits)) {
            return DecimalError::exponent;
        }
    }
    return DecimalError::no_number;
}

} // namespace

std::string write_decimal(std::int64_t value, int decimals)
{
    std::uint64_t magnitude =
        value < 0 ? 0 - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
    std::string reversed;
    bool significant = false; // zeros at the end of the fraction are not written
    for (int i = 0; i < decimals; ++i, magnitude /= 10) {
        const auto digit = static_cast<char>('0' + magnitude % 10);
        significant = significant || digit != '0';
        if (significant) {
            reversed.push_back(digit);
        }
    }
    if (significant) {
        reversed.push_back('.');
    }
    do {
        reversed.push_back(static_cast<char>('0' + magnitude % 10));
        magnitude /= 10;
    } while (magnitude != 0);
    if (value < 0) {
        reversed.push_back('-');
    }
    std::reverse(reversed.begin(), reversed.end());
    return reversed;
}

Decimal read_decimal(std::string_view text, int decimals)
{
    if (text.empty()) {
        return {DecimalError::empty, 0};
    }
    const bool negative = text[0] == '-';
    if (negative || text[0] == '+') {
        text.remove_prefix(1);
    }
    const std::size_t point = std::min(text.find('.'), text.size());
    std::string_view whole = text.substr(0, point);
    const std::string_view fraction = text.substr(std::min(point + 1, text.size()));
    if ((whole.empty() && fraction.empty()) || !all_digits(whole) || !all_digits(fraction)) {
        return {why_no_number(text), 0};
    }
    whole.remove_prefix(std::min(whole.find_first_not_of('0'), whole.size()));
    if (whole.size() > MAX_WHOLE_DIGITS) {
        return {DecimalError::too_large, 0};
    }
    std::int64_t value = 0;
    for (char digit : whole) {
        value = value * 10 + (digit - '0');
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(decimals); ++i) {
        value = value * 10 + (i < fraction.size() ? fraction[i] - '0' : 0);
    }
    if (fraction.size() > static_cast<std::size_t>(decimals) &&
        fraction[static_cast<std::size_t>(decimals)] >= '5') {
        ++value;
    }
    return {DecimalError::none, negative ? -value : value};
}

} // namespace base
