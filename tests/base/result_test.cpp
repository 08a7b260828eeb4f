#include "base/result.h"

#include <gtest/gtest.h>
#include <memory>

namespace {

using base::ReadError;
using base::Result;

TEST(Result, HoldsAValue)
{
    const Result<int> result = 7;
    ASSERT_TRUE(result);
    EXPECT_EQ(result.value(), 7);
}

TEST(Result, HoldsAnErrorInsteadOfAValue)
{
    const Result<int> result = ReadError{"tankbody.obj", 17, "a face needs more"};
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().line, 17);
}

TEST(Result, GivesUpAValueThatCannotBeCopied)
{
    Result<std::unique_ptr<int>> result = std::make_unique<int>(3);
    const std::unique_ptr<int> moved = std::move(result).value();
    EXPECT_EQ(*moved, 3);
}

TEST(ReadError, NamesFileLineAndCause)
{
    EXPECT_EQ((ReadError{"tankbody.obj", 17, "a face needs three vertices"}).message(),
              "tankbody.obj:17: a face needs three vertices");
}

TEST(ReadError, LeavesOutTheLineOfTheWholeFile)
{
    EXPECT_EQ((ReadError{"texture.tga", 0, "the file is empty"}).message(), "texture.tga: the file is empty");
}

} // namespace
