#include "allocation_count/allocation_count.h"
#include "particles/particle_system.h"
#include "particles/presets.h"

#include <gtest/gtest.h>

namespace particles {
namespace {

TEST(Allocation, IsCounted)
{
    const std::size_t before = allocation_count();
    ParticleSystem system;
    ASSERT_EQ(system.configure(preset(PresetName::sparks).settings), "");
    EXPECT_GT(allocation_count(), before);
}

TEST(Allocation, OfPlacesHappensOnlyWhenTheirNumberChanges)
{
    for (const Preset& row : presets()) {
        ParticleSystem system;
        ASSERT_EQ(system.configure(row.settings), "");
        ParticleSettings other = row.settings;
        other.life = 0.3;
        const std::size_t before = allocation_count();
        for (int i = 0; i < 200; ++i) {
            if (i % 5 == 0) {
                EXPECT_TRUE(system.burst(70, {0.0f, 1.0f, 0.0f}, {0.0f, 2.0f, 0.0f}));
            }
            EXPECT_TRUE(system.step(1.0 / 60.0));
            EXPECT_EQ(system.view().count(), system.live());
            hash(system);
        }
        EXPECT_TRUE(system.configure(other).empty());
        system.set_releasing(true);
        system.step(1.0);
        system.restart(9);
        system.step(1.0);
        EXPECT_EQ(allocation_count(), before) << row.id;
        ++other.maximum_particles;
        EXPECT_TRUE(system.configure(other).empty());
        EXPECT_GT(allocation_count(), before) << row.id;
    }
}

} // namespace
} // namespace particles
