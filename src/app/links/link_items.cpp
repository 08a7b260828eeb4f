#include "app/links/link_items.h"

#include "base/decimal.h"
#include "base/text.h"

#include <algorithm>
#include <utility>

namespace app {
namespace {

constexpr std::size_t MAX_MESSAGES = 10;

std::optional<int> hex_digit(char c)
{
    if (c >= '0' && c <= '9') {
        return c - '0';
    }
    if (c >= 'a' && c <= 'f') {
        return c - 'a' + 10;
    }
    if (c >= 'A' && c <= 'F') {
        return c - 'A' + 10;
    }
    return std::nullopt;
}

/// Returns the text with every %41 made a byte, or nothing if a '%' has no two digits after it.
std::optional<std::string> percent_decoded(std::string_view text)
{
    std::string decoded;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            decoded.push_back(text[i]);
            continue;
        }
        if (i + 2 >= text.size()) {
            return std::nullopt;
        }
        const std::optional<int> high = hex_digit(text[i + 1]);
        const std::optional<int> low = hex_digit(text[i + 2]);
        if (!high || !low) {
            return std::nullopt;
        }
        decoded.push_back(static_cast<char>(*high * 16 + *low));
        i += 2;
    }
    return decoded;
}

/// Removes spaces at both ends, and '+', which stands for one in a form and for nothing before a number.
std::string_view trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(" +");
    if (first == text.npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(" +") - first + 1);
}

std::string with_unit(const Field& field, std::int64_t value)
{
    std::string text = base::write_decimal(value, field.unit.decimals);
    if (!field.unit.name.empty()) {
        text += ' ';
        text += field.unit.name;
    }
    return text;
}

/// Says why a value is not a number, as the end of a sentence that begins with the key and the value.
std::string_view reason(base::DecimalError error)
{
    switch (error) {
    case base::DecimalError::comma:
        return " has a comma; write a point instead. It is ignored.";
    case base::DecimalError::exponent:
        return " has an exponent; write the number out. It is ignored.";
    case base::DecimalError::too_large:
        return " has too many digits and is ignored.";
    default:
        return " is not a number and is ignored.";
    }
}

} // namespace

void Messages::add(std::string message)
{
    if (std::find(messages_.begin(), messages_.end(), message) != messages_.end()) {
        return;
    }
    if (messages_.size() < MAX_MESSAGES) {
        messages_.push_back(std::move(message));
    } else {
        ++more_;
    }
}

std::vector<std::string> Messages::take()
{
    if (more_ > 0) {
        messages_.push_back("The link has " + base::write_decimal(more_, 0) + " more faults.");
    }
    return std::move(messages_);
}

std::vector<Item> read_items(std::string_view fragment, Messages& messages)
{
    std::vector<Item> items;
    while (!fragment.empty()) {
        const std::size_t end = std::min(fragment.find_first_of("&;"), fragment.size());
        const std::string_view text = fragment.substr(0, end);
        fragment.remove_prefix(std::min(end + 1, fragment.size()));
        const std::optional<std::string> decoded = percent_decoded(text);
        if (!decoded) {
            messages.add(base::in_quotes(text) + " has a % without two hexadecimal digits and is ignored.");
            continue;
        }
        const std::string_view item = *decoded;
        const std::size_t equals = std::min(item.find('='), item.size());
        const std::string_view key = trimmed(item.substr(0, equals));
        const std::string_view value = trimmed(item.substr(std::min(equals + 1, item.size())));
        if (key.empty() && value.empty()) {
            continue;
        }
        items.push_back({base::lower_case(key), std::string(value)});
    }
    return items;
}

void report_duplicates(std::span<const Item> items, Messages& messages)
{
    for (std::size_t i = 0; i < items.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (items[j].key == items[i].key) {
                messages.add(base::in_quotes(items[i].key) +
                             " is given more than once; the last value is used.");
                break;
            }
        }
    }
}

std::optional<std::int64_t> read_value(const Field& field, const Item& item, Messages& messages)
{
    if (item.value.empty()) {
        messages.add(base::in_quotes(item.key) + " has no value and is ignored.");
        return std::nullopt;
    }
    const std::string shown = item.key + "=" + base::in_quotes(item.value);
    if (!field.choices.empty()) {
        const auto found =
            std::find(field.choices.begin(), field.choices.end(), base::lower_case(item.value));
        if (found == field.choices.end()) {
            messages.add(shown + " is not one of " + base::listed(field.choices, "or") + " and is ignored.");
            return std::nullopt;
        }
        return found - field.choices.begin();
    }
    const base::Decimal number = base::read_decimal(item.value, field.unit.decimals);
    if (number.error != base::DecimalError::none) {
        messages.add(shown + std::string(reason(number.error)));
        return std::nullopt;
    }
    const std::int64_t within = grid_within_limits(field, number.value);
    if (!field.wraps && within != number.value) {
        messages.add(shown + (number.value < within ? " is below" : " is above") + " the limit; " +
                     with_unit(field, within) + " is used.");
    }
    return within;
}

std::optional<std::int64_t> read_count(const Item& item, std::int64_t lowest, std::int64_t highest,
                                       Messages& messages)
{
    const std::string shown = item.key + "=" + base::in_quotes(item.value);
    const base::Decimal number = base::read_decimal(item.value, 0);
    if (number.error != base::DecimalError::none) {
        messages.add(item.value.empty() ? base::in_quotes(item.key) + " has no value and is ignored."
                                        : shown + std::string(reason(number.error)));
        return std::nullopt;
    }
    const std::int64_t within = std::clamp(number.value, lowest, highest);
    if (within != number.value) {
        messages.add(shown + (number.value < within ? " is below" : " is above") + " the limit; " +
                     base::write_decimal(within, 0) + " is used.");
    }
    return within;
}

} // namespace app
