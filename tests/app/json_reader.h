#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// Holds a JSON value as strictly read from text.
struct JsonValue
{
    enum class Type
    {
        null,
        boolean,
        number,
        string,
        array,
        object
    } type = Type::null;
    bool boolean = false;
    double number = 0.0;
    std::string text; ///< of a string, decoded; of a number, as written
    std::vector<JsonValue> items;
    std::map<std::string, JsonValue> members;

    /// Returns a member; a null value if there is none.
    const JsonValue& operator[](const std::string& name) const;
    const JsonValue& operator[](std::size_t index) const { return items.at(index); }
    bool has(const std::string& name) const { return members.count(name) > 0; }
};

/// Reads a whole text as JSON by RFC 8259; nothing if it is not, has a key twice in an object, or is not
/// UTF-8.
std::optional<JsonValue> read_json(std::string_view text);

} // namespace app
