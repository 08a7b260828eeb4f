#include "particles/particle_system.h"
#include "particles/presets.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <new>

namespace {

int allocations = 0;

void* counted(std::size_t size)
{
    ++allocations;
    void* const memory = std::malloc(size > 0 ? size : 1);
    if (memory == nullptr) {
        std::abort();
    }
    return memory;
}

} // namespace

// For the whole test program.
void* operator new(std::size_t size)
{
    return counted(size);
}

void* operator new[](std::size_t size)
{
    return counted(size);
}

void operator delete(void* memory) noexcept
{
    std::free(memory);
}

void operator delete[](void* memory) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
    std::free(memory);
}

void operator delete[](void* memory, std::size_t) noexcept
{
    std::free(memory);
}

namespace particles {
namespace {

TEST(Allocation, IsCounted)
{
    const int before = allocations;
    ParticleSystem system;
    ASSERT_EQ(system.configure(preset(PresetName::sparks).settings), "");
    EXPECT_GT(allocations, before);
}

TEST(Allocation, OfPlacesHappensOnlyWhenTheirNumberChanges)
{
    for (const Preset& row : presets()) {
        ParticleSystem system;
        ASSERT_EQ(system.configure(row.settings), "");
        ParticleSettings other = row.settings;
        other.life = 0.3;
        const int before = allocations;
        for (int i = 0; i < 200; ++i) {
            if (i % 5 == 0) {
                EXPECT_TRUE(system.burst(70, {0.0F, 1.0F, 0.0F}, {0.0F, 2.0F, 0.0F}));
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
        EXPECT_EQ(allocations, before) << row.id;
        ++other.maximum_particles;
        EXPECT_TRUE(system.configure(other).empty());
        EXPECT_GT(allocations, before) << row.id;
    }
}

} // namespace
} // namespace particles
