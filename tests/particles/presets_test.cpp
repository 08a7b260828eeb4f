#include "particles/particle_system.h"
#include "particles/presets.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace particles {
namespace {

TEST(Presets, AreSixOfLab2AndTwoForHits)
{
    std::set<std::string_view> ids;
    ASSERT_EQ(presets().size(), 8u);
    for (std::size_t i = 0; i < presets().size(); ++i) {
        const Preset& row = presets()[i];
        EXPECT_EQ(static_cast<std::size_t>(row.name), i);
        EXPECT_EQ(&preset(row.name), &row);
        EXPECT_FALSE(row.title.empty());
        ids.insert(row.id);
    }
    EXPECT_EQ(ids.size(), presets().size());
}

TEST(Presets, AreValid)
{
    for (const Preset& row : presets()) {
        EXPECT_EQ(validate(row.settings), "") << row.id;
        EXPECT_EQ(row.burst_count > 0, !row.settings.releases) << row.id;
    }
}

TEST(Presets, ShowParticlesForAMinuteAndNeverRunOutOfPlaces)
{
    for (const Preset& row : presets()) {
        ParticleSystem system;
        ASSERT_EQ(system.configure(row.settings), "");
        std::size_t most = 0;
        for (int TICK = 0; TICK < 3600; ++TICK) {
            if (row.burst_count > 0 && TICK % 30 == 0) {
                ASSERT_TRUE(system.burst(row.burst_count, row.settings.position, row.settings.velocity));
            }
            system.step(1.0 / 60.0);
            most = std::max(most, system.live());
        }
        EXPECT_GT(most, 10u) << row.id;
        EXPECT_EQ(system.counts().refused, 0u) << row.id;
    }
}

TEST(Presets, SparksAreAsTheLabSays)
{
    const Preset& sparks = preset(PresetName::sparks);
    EXPECT_EQ(sparks.burst_count, 100);
    EXPECT_EQ(sparks.settings.release_count, 100);
    EXPECT_EQ(sparks.settings.release_interval, 0.05);
    EXPECT_EQ(sparks.settings.life, 0.5);
    EXPECT_EQ(sparks.settings.velocity_variance, 10.0);
    EXPECT_EQ(sparks.settings.texture, TextureKind::streak);
    EXPECT_EQ(sparks.settings.blending, Blending::additive);
}

TEST(Presets, ABurstOfSparksIsAllOutAfterATwentiethOfASecondAndOverAfterHalfASecondMore)
{
    ParticleSystem system;
    ASSERT_EQ(system.configure(preset(PresetName::sparks).settings), "");
    EXPECT_FALSE(system.is_active());
    ASSERT_TRUE(system.burst(100, {0.0f, 2.0f, 0.0f}, {0.0f, 0.0f, 0.0f}));
    EXPECT_TRUE(system.is_active());
    system.step(0.05);
    EXPECT_EQ(system.counts().released, 100u);
    EXPECT_GT(system.live(), 90u);
    system.step(0.5);
    EXPECT_EQ(system.live(), 0u);
    EXPECT_FALSE(system.is_active());
}

TEST(Presets, SixBurstsOfSparksAtOnceFindTheirPlaces)
{
    ParticleSystem system;
    ASSERT_EQ(system.configure(preset(PresetName::sparks).settings), "");
    for (int i = 0; i < 6; ++i) {
        ASSERT_TRUE(system.burst(100, {0.0f, 2.0f, 0.0f}, {0.0f, 0.0f, 0.0f}));
    }
    system.step(0.05);
    EXPECT_EQ(system.counts().refused, 0u);
}

} // namespace
} // namespace particles
