#include "base/json_writer.h"

#include "parsed_json.h"

#include <gtest/gtest.h>
#include <random>

namespace base {
namespace {

TEST(JsonWriterTest, CommasStandBetweenValuesAndNowhereElse)
{
    JsonWriter json;
    json.begin_object().key("a").begin_array().number(std::int64_t{1}).number(std::int64_t{-2}).end_array();
    json.key("b").begin_object().end_object().key("c").null().key("d").boolean(true).key("e").decimal(-5, 2);
    json.key("f")
        .begin_array()
        .begin_array()
        .end_array()
        .begin_object()
        .end_object()
        .end_array()
        .end_object();
    EXPECT_EQ(json.take(), R"({"a":[1,-2],"b":{},"c":null,"d":true,"e":-0.05,"f":[[],{}]})");
    EXPECT_EQ(json.string("x").take(), "\"x\"");
}

TEST(JsonWriterTest, LargeCountsAreWrittenInFull)
{
    JsonWriter json;
    EXPECT_EQ(json.number(std::uint64_t{18446744073709551615u}).take(), "18446744073709551615");
}

TEST(JsonWriterTest, SpecialCharactersAreEscaped)
{
    JsonWriter json;
    EXPECT_EQ(json.string("a\"b\\c\nd\te\x01").take(), R"("a\"b\\c\nd\te\u0001")");
    EXPECT_EQ(json.string(std::string_view("\0", 1)).take(), R"("\u0000")");
    EXPECT_EQ(json.string("\xe2\x86\x90 \xc3\xa9 \xf0\x9f\x98\x80").take(),
              "\"\xe2\x86\x90 \xc3\xa9 \xf0\x9f\x98\x80\"");
}

TEST(JsonWriterTest, BytesThatAreNotUtf8AreReplacedOneByOne)
{
    JsonWriter json;
    EXPECT_EQ(json.string("a\xff\x62").take(), R"("a\ufffdb")");
    EXPECT_EQ(json.string("\xc3").take(), R"("\ufffd")");
    EXPECT_EQ(json.string("\xc0\xaf").take(), R"("\ufffd\ufffd")");           // longer than needed
    EXPECT_EQ(json.string("\xed\xa0\x80").take(), R"("\ufffd\ufffd\ufffd")"); // a surrogate
    EXPECT_EQ(json.string("\xf4\x90\x80\x80").take(), R"("\ufffd\ufffd\ufffd\ufffd")");
}

TEST(JsonWriterTest, AnyBytesGiveJsonThatReadsBack)
{
    std::mt19937 random(1);
    for (int i = 0; i < 20000; ++i) {
        std::string bytes;
        for (unsigned n = random() % 8; n > 0; --n) {
            bytes.push_back(static_cast<char>(random()));
        }
        const nlohmann::json read = parsed_json(JsonWriter().string(bytes).take());
        ASSERT_TRUE(read.is_string());
    }
    const nlohmann::json read = parsed_json(JsonWriter().string("a\"b\\c\n\x1f\xc3\xa9").take());
    EXPECT_EQ(read, "a\"b\\c\n\x1f\xc3\xa9");
}

TEST(ParsedJsonTest, RefusesWhatIsNotJson)
{
    for (std::string_view text : {"", "{", "[1,]", "{\"a\":1,}", "{a:1}", "01", "1.", ".5", "\"\n\"", "nul",
                                  "1 2", "{\"a\":1,\"a\":2}", "\"\xff\"", "[1 2]", "-"}) {
        EXPECT_TRUE(parsed_json(text).is_discarded()) << text;
    }
}

} // namespace
} // namespace base
