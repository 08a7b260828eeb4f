#pragma once

#include "app/links/links.h"
#include "app/state/fields.h"

#include <string>
#include <string_view>

// What must hold of opening a link, whatever bytes it has. Shared by the tests and the fuzz target. Each
// function returns what does not hold; empty: all is well.

namespace app {

inline std::string broken_sentence(const std::string& message)
{
    if (message.size() < 10 || message.size() > 300) {
        return "a message is too short or too long: " + message;
    }
    const unsigned char first = static_cast<unsigned char>(message.front());
    const bool begins_with_key = first >= 'a' && first <= 'z' && message.find("=\"") != message.npos;
    if (first != '"' && !(first >= 'A' && first <= 'Z') && !begins_with_key) {
        return "a message does not begin as a sentence does: " + message;
    }
    if (message.back() != '.') {
        return "a message does not end as a sentence does: " + message;
    }
    for (const char c : message) {
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') {
            return "a message has a control character: " + message;
        }
    }
    return "";
}

inline std::string broken_state(const State& state)
{
    for (const Field& field : fields()) {
        const double value = field.get(state);
        if (!(value >= field.minimum && value <= field.maximum)) {
            return std::string(field.name) + " is beyond its limits";
        }
    }
    const std::string text = link(state);
    if (text.size() > MAX_LINK_BYTES) {
        return "a state has a link that is too long: " + text;
    }
    const State snap = snapped(state);
    if (!(snap == state)) {
        return "a link gives a state that is off the grid: " + text;
    }
    if (link(snap) != text) {
        return "the snapped state has another link: " + text;
    }
    State back;
    if (!open_link(back, text).messages.empty()) {
        return "a state's own link has faults: " + text;
    }
    if (!(back == snap)) {
        return "a state's own link gives another state: " + text;
    }
    return "";
}

inline std::string broken_link(std::string_view fragment)
{
    State state;
    const LinkResult result = open_link(state, fragment);
    if (result.messages.size() > 11) {
        return "there are more messages than people read";
    }
    for (const std::string& message : result.messages) {
        if (std::string broken = broken_sentence(message); !broken.empty()) {
            return broken;
        }
    }
    State again = state;
    if (open_link(again, fragment).messages != result.messages || !(again == state)) {
        return "the same link was read differently the second time";
    }
    return broken_state(state);
}

} // namespace app
