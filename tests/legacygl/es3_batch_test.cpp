// How draws are gathered into one: which slots their transforms get, and what is drawn in one call. No ES
// context.

#include "legacygl/backend/es3_batch.h"
#include "legacygl/backend/es3_stream.h"

#include <gtest/gtest.h>

#include <array>

namespace {

using namespace legacygl;

/// A transform of two vec4s that is told by a number.
struct Transform
{
    explicit Transform(int n) : values{glm::vec4(static_cast<float>(n)), glm::vec4(-1)}, number(n) {}
    UniformValues uniforms() const { return {values, static_cast<std::uint64_t>(number)}; }
    std::array<glm::vec4, 2> values;
    int number;
};

constexpr DrawRun TRIANGLE{PrimitiveClass::triangles, false, 0, 3};
constexpr DrawRun LINE{PrimitiveClass::lines, false, 0, 2};
constexpr DrawRun INDEXED{PrimitiveClass::triangles, true, 0, 6};

TEST(Es3Batch, ATransformGetsTheNextSlotUnlessItIsTheLastOne)
{
    Es3Batch batch;
    batch.begin(3);
    for (const int number : {7, 7, 8, 9, 9}) {
        EXPECT_TRUE(batch.put(Transform(number).uniforms()));
    }
    EXPECT_EQ(batch.slot(), 2);
    EXPECT_FALSE(batch.put(Transform(10).uniforms())) << "there are three slots";
    const UniformValues all = batch.transforms();
    ASSERT_EQ(all.values.size(), 6u);
    EXPECT_EQ(all.values[2], glm::vec4(8));
    EXPECT_EQ(all.values[5], glm::vec4(-1));
}

TEST(Es3Batch, ASlotAskedForIsCountedModuloTheSlotsAndTakenOnce)
{
    Es3Batch batch;
    batch.begin(4);
    EXPECT_TRUE(batch.put(Transform(7).uniforms(), 6));
    EXPECT_EQ(batch.slot(), 2);
    EXPECT_TRUE(batch.put(Transform(7).uniforms(), 2)) << "with the same transform";
    EXPECT_FALSE(batch.put(Transform(8).uniforms(), 10));
    EXPECT_TRUE(batch.put(Transform(8).uniforms(), 11));
    EXPECT_EQ(batch.transforms().values.size(), 8u) << "slots 0 to 3";
    EXPECT_EQ(batch.transforms().values[6], glm::vec4(8));
}

TEST(Es3Batch, OnlySlotZeroAloneHasARevision)
{
    Es3Batch batch;
    batch.begin(4);
    batch.put(Transform(7).uniforms());
    EXPECT_EQ(batch.transforms().revision, 7u);
    batch.put(Transform(8).uniforms());
    EXPECT_EQ(batch.transforms().revision, 0u);
    batch.begin(4);
    batch.put(Transform(9).uniforms(), 1);
    EXPECT_EQ(batch.transforms().revision, 0u);
}

TEST(Es3Batch, RunsThatGoOnWhereTheLastOneEndedAreOneCall)
{
    Es3Batch batch;
    batch.begin(1);
    batch.add({&TRIANGLE, 1}, 0, 0);
    batch.add({&TRIANGLE, 1}, 3, 0);
    ASSERT_EQ(batch.runs().size(), 1u);
    EXPECT_EQ(batch.runs()[0].count, 6u);
    batch.add({&TRIANGLE, 1}, 30, 0);
    batch.add({&LINE, 1}, 33, 0);
    batch.add({&INDEXED, 1}, 35, 12);
    batch.add({&INDEXED, 1}, 39, 18);
    ASSERT_EQ(batch.runs().size(), 4u);
    EXPECT_EQ(batch.runs()[1].first, 30u);
    EXPECT_EQ(batch.runs()[3].first, 12u);
    EXPECT_EQ(batch.runs()[3].count, 12u);
    batch.begin(1);
    EXPECT_TRUE(batch.empty());
}

TEST(Es3Stream, VerticesNameTheSlotThatTheirDrawHas)
{
    VertexFormat format;
    format.components[0] = 2;
    const std::array<float, 6> triangle{0, 0, 1, 0, 0, 1};
    const std::array<std::uint32_t, 3> indices{0, 1, 2};
    Es3Stream stream;
    stream.begin(format);
    stream.add(triangle, indices, 0);
    EXPECT_TRUE(stream.slots().empty()) << "all have slot 0";
    stream.add(triangle, {}, 0);
    stream.add(triangle, indices, 1);
    EXPECT_EQ(stream.first_vertex(), 9u);
    EXPECT_EQ(stream.first_index(), 6u);
    EXPECT_EQ(stream.indices()[3], 6u) << "indices are of the stream";
    const std::span<const float> slots = stream.slots();
    ASSERT_EQ(slots.size(), 9u);
    EXPECT_EQ(slots[5], 0);
    EXPECT_EQ(slots[6], 1);
}

} // namespace
