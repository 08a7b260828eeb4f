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
