#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

/// Returns a whole text as JSON by RFC 8259; a discarded value (is_discarded()) if it is not, has a key twice
/// in an object, or is not UTF-8. nlohmann's parser takes the last of equal keys, so they are looked for
/// here.
inline nlohmann::json parsed_json(std::string_view text)
{
    using Event = nlohmann::json::parse_event_t;
    std::vector<std::set<std::string>> keys;
    bool has_key_twice = false;
    const auto note = [&](int, Event event, nlohmann::json& value) {
        if (event == Event::object_start) {
            keys.emplace_back();
        } else if (event == Event::object_end) {
            keys.pop_back();
        } else if (event == Event::key) {
            has_key_twice |= !keys.back().insert(value.get<std::string>()).second;
        }
        return true;
    };
    nlohmann::json json = nlohmann::json::parse(text, note, false);
    return has_key_twice ? nlohmann::json(nlohmann::json::value_t::discarded) : json;
}
