#include "tank/part.h"

#include <gtest/gtest.h>
#include <set>

namespace tank {
namespace {

TEST(PartTest, NamesAreThoseOfTheDesignInItsOrder)
{
    EXPECT_EQ(part_name(Part::body), "body");
    EXPECT_EQ(part_name(Part::turret), "turret");
    EXPECT_EQ(part_name(Part::main_gun), "main_gun");
    EXPECT_EQ(part_name(Part::secondary_gun), "secondary_gun");
    EXPECT_EQ(part_name(Part::wheel_left_1), "wheel_left_1");
    EXPECT_EQ(part_name(Part::wheel_left_7), "wheel_left_7");
    EXPECT_EQ(part_name(Part::wheel_right_1), "wheel_right_1");
    EXPECT_EQ(part_name(Part::wheel_right_7), "wheel_right_7");
    EXPECT_EQ(index_of(Part::wheel_right_7), PART_COUNT - 1);
}

TEST(PartTest, EveryNameIsItsOwn)
{
    std::set<std::string_view> names;
    for (Part part : ALL_PARTS) {
        names.insert(part_name(part));
    }
    EXPECT_EQ(names.size(), PART_COUNT);
}

} // namespace
} // namespace tank
