#pragma once

#include <cstdint>
#include <string_view>

namespace app {

// clang-format off
/// Names the keys that commands use, by place on the keyboard and not by what is printed there.
/// The numbers are those of USB HID's keyboard page, which SDL's scancodes are too.
enum class Key : std::uint16_t {
    none = 0,
    a = 4, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z,
    digit_1 = 30, digit_2, digit_3, digit_4, digit_5, digit_6, digit_7, digit_8, digit_9, digit_0,
    enter = 40, escape, backspace, tab, space, minus, equal,
    comma = 54, period,
    home = 74, page_up, delete_forward, end, page_down, right, left, down, up,
    keypad_minus = 86, keypad_plus,
};
// clang-format on

/// Returns the browser's name of a key, KeyboardEvent.code, such as "KeyQ"; "" for Key::none.
std::string_view key_code(Key key);

/// Returns what is printed on the key of a US keyboard, such as "Q" or "Page Up"; "" for Key::none.
std::string_view key_label(Key key);

/// Returns the key with that USB HID number (an SDL scancode), or Key::none if no command could use it.
Key key_from_number(int number);

} // namespace app
