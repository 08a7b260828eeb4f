#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace base {

/// Writes JSON text piece by piece; commas come by themselves. The caller closes what it opens.
/// Numbers are whole or decimals of a grid, so that no locale and no rounding is involved.
class JsonWriter
{
public:
    JsonWriter& begin_object();
    JsonWriter& end_object();
    JsonWriter& begin_array();
    JsonWriter& end_array();

    /// Begins a member of the object; its value follows.
    JsonWriter& key(std::string_view name);

    /// Writes a string, escaped. Bytes that are not UTF-8 become U+FFFD, so that the text always is.
    JsonWriter& string(std::string_view text);

    JsonWriter& number(std::int64_t value);
    JsonWriter& number(std::uint64_t value);

    /// Writes value / 10^decimals.
    JsonWriter& decimal(std::int64_t value, int decimals);

    JsonWriter& boolean(bool value);
    JsonWriter& null();

    /// Returns the text and leaves the writer empty.
    std::string take();

private:
    void begin_value();

    std::string text_;
    bool needs_comma_ = false;
};

} // namespace base
