#include "app/commands/keys.h"

namespace app {

namespace {

struct KeyName
{
    Key key;
    std::string_view code;
    std::string_view label;
};

constexpr KeyName KEY_NAMES[] = {
    {Key::a, "KeyA", "A"},
    {Key::b, "KeyB", "B"},
    {Key::c, "KeyC", "C"},
    {Key::d, "KeyD", "D"},
    {Key::e, "KeyE", "E"},
    {Key::f, "KeyF", "F"},
    {Key::g, "KeyG", "G"},
    {Key::h, "KeyH", "H"},
    {Key::i, "KeyI", "I"},
    {Key::j, "KeyJ", "J"},
    {Key::k, "KeyK", "K"},
    {Key::l, "KeyL", "L"},
    {Key::m, "KeyM", "M"},
    {Key::n, "KeyN", "N"},
    {Key::o, "KeyO", "O"},
    {Key::p, "KeyP", "P"},
    {Key::q, "KeyQ", "Q"},
    {Key::r, "KeyR", "R"},
    {Key::s, "KeyS", "S"},
    {Key::t, "KeyT", "T"},
    {Key::u, "KeyU", "U"},
    {Key::v, "KeyV", "V"},
    {Key::w, "KeyW", "W"},
    {Key::x, "KeyX", "X"},
    {Key::y, "KeyY", "Y"},
    {Key::z, "KeyZ", "Z"},
    {Key::digit_1, "Digit1", "1"},
    {Key::digit_2, "Digit2", "2"},
    {Key::digit_3, "Digit3", "3"},
    {Key::digit_4, "Digit4", "4"},
    {Key::digit_5, "Digit5", "5"},
    {Key::digit_6, "Digit6", "6"},
    {Key::digit_7, "Digit7", "7"},
    {Key::digit_8, "Digit8", "8"},
    {Key::digit_9, "Digit9", "9"},
    {Key::digit_0, "Digit0", "0"},
    {Key::enter, "Enter", "Enter"},
    {Key::escape, "Escape", "Esc"},
    {Key::backspace, "Backspace", "Backspace"},
    {Key::tab, "Tab", "Tab"},
    {Key::space, "Space", "Space"},
    {Key::minus, "Minus", "-"},
    {Key::equal, "Equal", "="},
    {Key::comma, "Comma", ","},
    {Key::period, "Period", "."},
    {Key::home, "Home", "Home"},
    {Key::page_up, "PageUp", "Page Up"},
    {Key::delete_forward, "Delete", "Delete"},
    {Key::end, "End", "End"},
    {Key::page_down, "PageDown", "Page Down"},
    {Key::right, "ArrowRight", "→"},
    {Key::left, "ArrowLeft", "←"},
    {Key::down, "ArrowDown", "↓"},
    {Key::up, "ArrowUp", "↑"},
    {Key::keypad_minus, "NumpadSubtract", "Keypad -"},
    {Key::keypad_plus, "NumpadAdd", "Keypad +"},
};

template <class Matches> KeyName find_key(Matches matches)
{
    for (const KeyName& name : KEY_NAMES) {
        if (matches(name)) {
            return name;
        }
    }
    return {Key::none, "", ""};
}

} // namespace

std::string_view key_code(Key key)
{
    return find_key([key](const KeyName& name) { return name.key == key; }).code;
}

std::string_view key_label(Key key)
{
    return find_key([key](const KeyName& name) { return name.key == key; }).label;
}

Key key_from_number(int number)
{
    return find_key([number](const KeyName& name) { return static_cast<int>(name.key) == number; }).key;
}

} // namespace app
