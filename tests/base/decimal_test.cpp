#include "base/decimal.h"

#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace base {
namespace {

TEST(DecimalTest, IsWrittenAsShortAsItCanBe)
{
    EXPECT_EQ(write_decimal(0, 2), "0");
    EXPECT_EQ(write_decimal(3000, 2), "30");
    EXPECT_EQ(write_decimal(3050, 2), "30.5");
    EXPECT_EQ(write_decimal(3005, 2), "30.05");
    EXPECT_EQ(write_decimal(5, 2), "0.05");
    EXPECT_EQ(write_decimal(-5, 2), "-0.05");
    EXPECT_EQ(write_decimal(-1, 3), "-0.001");
    EXPECT_EQ(write_decimal(-12000, 3), "-12");
    EXPECT_EQ(write_decimal(100, 0), "100");
    EXPECT_EQ(write_decimal(std::numeric_limits<std::int64_t>::min(), 0), "-9223372036854775808");
}

TEST(DecimalTest, WhatIsWrittenIsReadBack)
{
    std::mt19937_64 random(3);
    for (int i = 0; i < 20000; ++i) {
        const int decimals = static_cast<int>(random() % 4);
        const auto value = static_cast<std::int64_t>(random() % 2000001) - 1000000;
        const Decimal read = read_decimal(write_decimal(value, decimals), decimals);
        ASSERT_EQ(read.error, DecimalError::none);
        ASSERT_EQ(read.value, value);
    }
}

TEST(DecimalTest, FormsThatPeopleWriteAreRead)
{
    const auto value = [](std::string_view text) {
        const Decimal read = read_decimal(text, 2);
        EXPECT_EQ(read.error, DecimalError::none) << text;
        return read.value;
    };
    EXPECT_EQ(value("30"), 3000);
    EXPECT_EQ(value("+30"), 3000);
    EXPECT_EQ(value("-30."), -3000);
    EXPECT_EQ(value(".5"), 50);
    EXPECT_EQ(value("-.5"), -50);
    EXPECT_EQ(value("007.10"), 710);
    EXPECT_EQ(value("-0"), 0);
    EXPECT_EQ(value("0000000000000000000000001"), 100);
    EXPECT_EQ(value("999999999999"), 99999999999900);
}

TEST(DecimalTest, FurtherDecimalsAreRoundedWithHalvesAwayFromZero)
{
    EXPECT_EQ(read_decimal("0.004999999999999999999999999", 2).value, 0);
    EXPECT_EQ(read_decimal("0.005", 2).value, 1);
    EXPECT_EQ(read_decimal("-0.005", 2).value, -1);
    EXPECT_EQ(read_decimal("0.999", 2).value, 100);
    EXPECT_EQ(read_decimal("1.5", 0).value, 2);
}

TEST(DecimalTest, OtherTextsSayWhatTheyAre)
{
    EXPECT_EQ(read_decimal("", 2).error, DecimalError::empty);
    EXPECT_EQ(read_decimal("1,5", 2).error, DecimalError::comma);
    EXPECT_EQ(read_decimal("-1.000,5", 2).error, DecimalError::comma);
    EXPECT_EQ(read_decimal("1e3", 2).error, DecimalError::exponent);
    EXPECT_EQ(read_decimal("-1.5E+3", 2).error, DecimalError::exponent);
    EXPECT_EQ(read_decimal("1000000000000", 2).error, DecimalError::too_large);
    for (std::string_view text : {"-", "+", ".", "-.", "1.2.3", "nan", "inf", "0x10", "1 2", "--1", "e5",
                                  "1e", "1e5x", "٣", "12°", "1_000"}) {
        EXPECT_EQ(read_decimal(text, 2).error, DecimalError::no_number) << text;
        EXPECT_EQ(read_decimal(text, 2).value, 0);
    }
}

} // namespace
} // namespace base
