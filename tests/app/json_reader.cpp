#include "json_reader.h"

#include <cstdlib>

namespace app {

namespace {

class Reader
{
public:
    explicit Reader(std::string_view text) : rest_(text) {}

    std::optional<JsonValue> read_document()
    {
        std::optional<JsonValue> value = read_value();
        return value && rest_.empty() ? value : std::nullopt;
    }

private:
    bool skip(std::string_view expected)
    {
        if (!rest_.starts_with(expected)) {
            return false;
        }
        rest_.remove_prefix(expected.size());
        return true;
    }

    std::optional<JsonValue> read_value()
    {
        JsonValue value;
        if (skip("null")) {
            return value;
        }
        if (rest_.starts_with("true") || rest_.starts_with("false")) {
            value.type = JsonValue::Type::boolean;
            value.boolean = skip("true") || !skip("false");
            return value;
        }
        if (rest_.starts_with("\"")) {
            return read_string();
        }
        if (skip("[")) {
            return read_array();
        }
        if (skip("{")) {
            return read_object();
        }
        return read_number();
    }

    std::optional<JsonValue> read_number()
    {
        std::size_t length = 0;
        const auto digits = [&] {
            const std::size_t first = length;
            while (length < rest_.size() && rest_[length] >= '0' && rest_[length] <= '9') {
                ++length;
            }
            return length - first;
        };
        if (rest_.starts_with("-")) {
            ++length;
        }
        const std::size_t first = length;
        const std::size_t whole = digits();
        if (whole == 0 || (whole > 1 && rest_[first] == '0')) {
            return std::nullopt;
        }
        if (length < rest_.size() && rest_[length] == '.') {
            ++length;
            if (digits() == 0) {
                return std::nullopt;
            }
        }
        JsonValue value;
        value.type = JsonValue::Type::number;
        value.text = rest_.substr(0, length);
        value.number = std::strtod(value.text.c_str(), nullptr);
        rest_.remove_prefix(length);
        return value;
    }

    std::optional<JsonValue> read_string()
    {
        JsonValue value;
        value.type = JsonValue::Type::string;
        rest_.remove_prefix(1);
        while (!rest_.empty() && rest_[0] != '"') {
            const auto c = static_cast<unsigned char>(rest_[0]);
            if (c < 0x20) {
                return std::nullopt;
            }
            if (c == '\\') {
                if (!read_escape(value.text)) {
                    return std::nullopt;
                }
                continue;
            }
            value.text.push_back(rest_[0]);
            rest_.remove_prefix(1);
        }
        if (!skip("\"")) {
            return std::nullopt;
        }
        return value;
    }

    bool read_escape(std::string& out)
    {
        if (skip("\\\"")) {
            out += '"';
        } else if (skip("\\\\")) {
            out += '\\';
        } else if (skip("\\n")) {
            out += '\n';
        } else if (skip("\\t")) {
            out += '\t';
        } else if (skip("\\ufffd")) {
            out += "\xef\xbf\xbd";
        } else if (skip("\\u00") && rest_.size() >= 2) {
            out += static_cast<char>(std::strtol(std::string(rest_.substr(0, 2)).c_str(), nullptr, 16));
            rest_.remove_prefix(2);
        } else {
            return false;
        }
        return true;
    }

    std::optional<JsonValue> read_array()
    {
        JsonValue value;
        value.type = JsonValue::Type::array;
        if (skip("]")) {
            return value;
        }
        do {
            std::optional<JsonValue> item = read_value();
            if (!item) {
                return std::nullopt;
            }
            value.items.push_back(*item);
        } while (skip(","));
        if (!skip("]")) {
            return std::nullopt;
        }
        return value;
    }

    std::optional<JsonValue> read_object()
    {
        JsonValue value;
        value.type = JsonValue::Type::object;
        if (skip("}")) {
            return value;
        }
        do {
            if (!rest_.starts_with("\"")) {
                return std::nullopt;
            }
            std::optional<JsonValue> key = read_string();
            if (!key || !skip(":")) {
                return std::nullopt;
            }
            std::optional<JsonValue> member = read_value();
            if (!member || !value.members.emplace(key->text, *member).second) {
                return std::nullopt;
            }
        } while (skip(","));
        if (!skip("}")) {
            return std::nullopt;
        }
        return value;
    }

    std::string_view rest_;
};

/// Says whether a text is UTF-8, by decoding every character and looking at its value.
bool is_utf8(std::string_view text)
{
    for (std::size_t i = 0; i < text.size();) {
        const auto first = static_cast<unsigned char>(text[i]);
        const std::size_t length = first < 0x80       ? 1
                                   : first >> 5 == 6  ? 2
                                   : first >> 4 == 14 ? 3
                                   : first >> 3 == 30 ? 4
                                                      : 0;
        if (length == 0 || i + length > text.size()) {
            return false;
        }
        unsigned long value = length == 1 ? first : first & (0x7fu >> length);
        for (std::size_t k = 1; k < length; ++k) {
            const auto next = static_cast<unsigned char>(text[i + k]);
            if (next >> 6 != 2) {
                return false;
            }
            value = value << 6 | (next & 0x3f);
        }
        constexpr unsigned long LEAST[] = {0, 0, 0x80, 0x800, 0x10000};
        if (value < LEAST[length] || value > 0x10ffff || (value >= 0xd800 && value <= 0xdfff)) {
            return false;
        }
        i += length;
    }
    return true;
}

} // namespace

const JsonValue& JsonValue::operator[](const std::string& name) const
{
    static const JsonValue NONE;
    const auto found = members.find(name);
    return found == members.end() ? NONE : found->second;
}

std::optional<JsonValue> read_json(std::string_view text)
{
    return is_utf8(text) ? Reader(text).read_document() : std::nullopt;
}

} // namespace app
