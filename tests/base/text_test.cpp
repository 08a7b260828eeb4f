#include "base/text.h"

#include <gtest/gtest.h>
#include <vector>

namespace base {
namespace {

TEST(TextTest, LongTextsAreQuotedInPartBetweenCharacters)
{
    EXPECT_EQ(in_quotes("abc"), "\"abc\"");
    EXPECT_EQ(in_quotes(std::string(40, 'a')), '"' + std::string(40, 'a') + '"');
    EXPECT_EQ(in_quotes(std::string(41, 'a')), '"' + std::string(40, 'a') + "...\"");
    EXPECT_EQ(in_quotes(std::string(39, 'a') + "\xc3\xa9\xc3\xa9"), '"' + std::string(39, 'a') + "...\"");
}

TEST(TextTest, QuotingBytesThatAreNoCharactersEnds)
{
    EXPECT_EQ(in_quotes(std::string(100, '\x80')), "\"...\"");
}

TEST(TextTest, QuotingLetsNoControlCharacterThrough)
{
    EXPECT_EQ(in_quotes(std::string_view("a\0\x1b[2J\n\x7f", 8)), "\"a??[2J??\"");
    EXPECT_EQ(in_quotes(std::string(50, '\n')), '"' + std::string(40, '?') + "...\"");
    EXPECT_EQ(in_quotes("gr\xc3\xb6\xc3\x9f"
                        "er"),
              "\"gr\xc3\xb6\xc3\x9f"
              "er\"");
}

TEST(TextTest, ListsReadLikeSentences)
{
    const std::vector<std::string_view> three = {"a", "b", "c"};
    EXPECT_EQ(listed({}), "");
    EXPECT_EQ(listed(std::span(three).first(1)), "a");
    EXPECT_EQ(listed(std::span(three).first(2)), "a and b");
    EXPECT_EQ(listed(three), "a, b and c");
    EXPECT_EQ(listed(three, "or"), "a, b or c");
}

TEST(TextTest, LowerCaseTouchesOnlyAscii)
{
    EXPECT_EQ(lower_case("TankBODY_\xc3\x89.Obj"), "tankbody_\xc3\x89.obj");
}

} // namespace
} // namespace base
