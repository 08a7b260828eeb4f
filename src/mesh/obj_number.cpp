#include "mesh/obj_number.h"

#include "base/quoted.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include <fast_float/fast_float.h>

namespace mesh {
namespace {

constexpr std::size_t MAX_WORD_LENGTH = 128; // a double printed with %f and 50 decimals fits
constexpr int MAX_EXPONENT = 400;            // beyond what any double has
constexpr std::size_t MAX_INDEX_DIGITS = 9;

bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

std::size_t count_digits(std::string_view word, std::size_t at)
{
    std::size_t count = 0;
    while (at + count < word.size() && is_digit(word[at + count])) {
        ++count;
    }
    return count;
}

std::size_t sign_length(std::string_view word, std::size_t at)
{
    return at < word.size() && (word[at] == '+' || word[at] == '-') ? 1 : 0;
}

/// Finds the end of sign, digits, point, digits at the start of `word`; 0: it does not start so.
std::size_t mantissa_length(std::string_view word)
{
    std::size_t at = sign_length(word, 0);
    const std::size_t whole = count_digits(word, at);
    at += whole;
    std::size_t fraction = 0;
    if (at < word.size() && word[at] == '.') {
        fraction = count_digits(word, at + 1);
        at += 1 + fraction;
    }
    return whole + fraction > 0 ? at : 0;
}

bool is_letters(std::string_view word, std::string_view lower_case)
{
    return std::equal(word.begin(), word.end(), lower_case.begin(), lower_case.end(),
                      [](char a, char b) { return (a | 0x20) == b; });
}

Cause malformed_number(std::string_view word)
{
    const std::string_view unsigned_word = word.substr(sign_length(word, 0));
    if (is_letters(unsigned_word.substr(0, 3), "nan") || is_letters(unsigned_word.substr(0, 3), "inf")) {
        return base::quoted(word) +
               " is not a number a model can have; export it again from a model without errors";
    }
    if (std::count(word.begin(), word.end(), ',') > 0) {
        return base::quoted(word) + " is not a number; decimals are written with a point, not with a comma";
    }
    return base::quoted(word) + " is not a number";
}

/// Checks the whole of `word` against [sign] (digits [. digits] | . digits) [(e | E) [sign] digits].
Cause check_number(std::string_view word)
{
    if (word.size() > MAX_WORD_LENGTH) {
        return base::quoted(word) + " is too long for a number";
    }
    std::size_t at = mantissa_length(word);
    if (at == 0) {
        return malformed_number(word);
    }
    if (at == word.size()) {
        return {};
    }
    if (word[at] != 'e' && word[at] != 'E') {
        return malformed_number(word);
    }
    ++at;
    at += sign_length(word, at);
    if (at == word.size() || at + count_digits(word, at) != word.size()) {
        return malformed_number(word);
    }
    int exponent = 0;
    for (; at < word.size() && exponent <= MAX_EXPONENT; ++at) {
        exponent = exponent * 10 + (word[at] - '0');
    }
    if (exponent > MAX_EXPONENT) {
        return base::quoted(word) + " has an exponent outside the range of numbers";
    }
    return {};
}

/// Checks one index of a corner: [sign] digits, not zero, not too many of them.
Cause check_index(std::string_view index, std::string_view word)
{
    std::size_t at = sign_length(index, 0);
    const std::size_t digits = count_digits(index, at);
    if (digits == 0 || at + digits != index.size()) {
        return base::quoted(word) + " is not a corner of a face; it should look like 1, 1/2, 1//3 or 1/2/3";
    }
    while (at < index.size() && index[at] == '0') {
        ++at;
    }
    if (at == index.size()) {
        return base::quoted(word) + " has an index 0; indices count from 1, or backwards from -1";
    }
    if (index.size() - at > MAX_INDEX_DIGITS) {
        return base::quoted(word) + " has an index that is out of range";
    }
    return {};
}

/// Checks `word` against v, v/vt, v//vn and v/vt/vn.
Cause check_corner(std::string_view word)
{
    if (word.size() > MAX_WORD_LENGTH) {
        return base::quoted(word) + " is too long for a corner of a face";
    }
    std::size_t begin = 0;
    for (int slot = 0;; ++slot) {
        const std::size_t end = std::min(word.find('/', begin), word.size());
        const bool may_be_empty = slot == 1 && end < word.size(); // the middle of v//vn
        if (!(may_be_empty && begin == end)) {
            if (Cause cause = check_index(word.substr(begin, end - begin), word); !cause.empty()) {
                return cause;
            }
        }
        if (end == word.size()) {
            return {};
        }
        if (slot == 2) {
            return base::quoted(word) +
                   " has more than three indices; it should look like 1, 1/2, 1//3 or 1/2/3";
        }
        begin = end + 1;
    }
}

} // namespace

Cause read_number(std::string_view word, float& value)
{
    if (Cause cause = check_number(word); !cause.empty()) {
        return cause;
    }
    if (word[0] == '+') {
        word.remove_prefix(1); // from_chars takes none
    }
    // As a double, since versions of fast_float differ in what they give for a float that is too small.
    double parsed = 0;
    const auto [end, error] = fast_float::from_chars(word.data(), word.data() + word.size(), parsed);
    if (end != word.data() + word.size() || error == std::errc::invalid_argument) {
        return malformed_number(word); // it accepts all that check_number does; a newer version may not
    }
    if (!(std::fabs(parsed) <= double(std::numeric_limits<float>::max()))) {
        return base::quoted(word) + " is outside the range of numbers a model can have";
    }
    value = static_cast<float>(parsed);
    return {};
}

Cause read_corner(std::string_view word, WrittenCorner& corner)
{
    if (Cause cause = check_corner(word); !cause.empty()) {
        return cause;
    }
    corner = {};
    std::size_t begin = 0;
    for (int* index : {&corner.position, &corner.texture_coordinate, &corner.normal}) {
        const std::size_t end = std::min(word.find('/', begin), word.size());
        begin += word[begin] == '+' ? 1 : 0;                             // from_chars takes none
        std::from_chars(word.data() + begin, word.data() + end, *index); // an empty one stays 0
        if (end == word.size()) {
            break;
        }
        begin = end + 1;
    }
    return {};
}

} // namespace mesh
