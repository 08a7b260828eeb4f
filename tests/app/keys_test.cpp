#include "app/commands/keys.h"

#include <gtest/gtest.h>
#include <set>
#include <string_view>

namespace app {
namespace {

TEST(KeysTest, NumbersAreThoseOfUsbHid)
{
    // USB HID Usage Tables 1.12, section 10, keyboard page.
    EXPECT_EQ(static_cast<int>(Key::a), 0x04);
    EXPECT_EQ(static_cast<int>(Key::z), 0x1d);
    EXPECT_EQ(static_cast<int>(Key::digit_1), 0x1e);
    EXPECT_EQ(static_cast<int>(Key::digit_0), 0x27);
    EXPECT_EQ(static_cast<int>(Key::enter), 0x28);
    EXPECT_EQ(static_cast<int>(Key::backspace), 0x2a);
    EXPECT_EQ(static_cast<int>(Key::space), 0x2c);
    EXPECT_EQ(static_cast<int>(Key::minus), 0x2d);
    EXPECT_EQ(static_cast<int>(Key::equal), 0x2e);
    EXPECT_EQ(static_cast<int>(Key::home), 0x4a);
    EXPECT_EQ(static_cast<int>(Key::page_up), 0x4b);
    EXPECT_EQ(static_cast<int>(Key::delete_forward), 0x4c);
    EXPECT_EQ(static_cast<int>(Key::page_down), 0x4e);
    EXPECT_EQ(static_cast<int>(Key::right), 0x4f);
    EXPECT_EQ(static_cast<int>(Key::left), 0x50);
    EXPECT_EQ(static_cast<int>(Key::down), 0x51);
    EXPECT_EQ(static_cast<int>(Key::up), 0x52);
    EXPECT_EQ(static_cast<int>(Key::keypad_minus), 0x56);
    EXPECT_EQ(static_cast<int>(Key::keypad_plus), 0x57);
}

TEST(KeysTest, EveryNumberWithAKeyHasANameOfItsOwn)
{
    std::set<std::string_view> codes;
    for (int number = 1; number < 300; ++number) {
        const Key key = key_from_number(number);
        if (key == Key::none) {
            continue;
        }
        EXPECT_EQ(static_cast<int>(key), number);
        EXPECT_FALSE(key_label(key).empty());
        EXPECT_TRUE(codes.insert(key_code(key)).second) << key_code(key);
    }
    EXPECT_EQ(codes.size(), 26u + 10 + 7 + 2 + 9 + 2);
}

TEST(KeysTest, NamesAreTheBrowsers)
{
    EXPECT_EQ(key_code(Key::q), "KeyQ");
    EXPECT_EQ(key_code(Key::digit_0), "Digit0");
    EXPECT_EQ(key_code(Key::up), "ArrowUp");
    EXPECT_EQ(key_code(Key::keypad_plus), "NumpadAdd");
    EXPECT_EQ(key_from_number(0), Key::none);
    EXPECT_EQ(key_from_number(-5), Key::none);
    EXPECT_EQ(key_code(Key::none), "");
}

} // namespace
} // namespace app
