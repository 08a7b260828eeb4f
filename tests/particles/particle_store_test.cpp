#include "particles/particle_store.h"

#include "particles/random.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

namespace particles {
namespace {

/// A particle that can be told from others by any of its quantities.
Particle numbered(int number, float life)
{
    const auto n = static_cast<float>(number);
    return {{n, n + 0.125f, n + 0.25f}, {-n, -n - 0.125f, -n - 0.25f}, 0.0f, life};
}

bool is_whole(const Particle& particle)
{
    const float n = particle.position.x;
    return particle.position == glm::vec3{n, n + 0.125f, n + 0.25f} &&
           particle.velocity == glm::vec3{-n, -n - 0.125f, -n - 0.25f};
}

std::vector<int> numbers(const ParticleStore& store, std::size_t begin, std::size_t end)
{
    std::vector<int> found;
    for (std::size_t i = begin; i < end; ++i) {
        EXPECT_TRUE(is_whole(store.get(i)));
        found.push_back(static_cast<int>(store.get(i).position.x));
    }
    std::sort(found.begin(), found.end());
    return found;
}

TEST(ParticleStore, HasNoPlacesAtFirst)
{
    ParticleStore store;
    EXPECT_TRUE(store.is_full());
    EXPECT_EQ(store.age_all(1.0f), 0u);
    EXPECT_TRUE(store.values(ParticleStore::x).empty());
    store.set_capacity(0);
    EXPECT_TRUE(store == ParticleStore{});
}

TEST(ParticleStore, GivesBackWhatWasPutIn)
{
    ParticleStore store;
    store.set_capacity(3);
    store.append(numbered(7, 2.5f));
    store.append(numbered(8, 3.5f));
    EXPECT_FALSE(store.is_full());
    EXPECT_EQ(store.get(1).life, 3.5f);
    EXPECT_EQ(numbers(store, 0, 2), (std::vector<int>{7, 8}));
    EXPECT_EQ(store.values(ParticleStore::velocity_z)[1], -8.25f);
}

TEST(ParticleStore, KeepsExactlyTheLivingThroughAnythingThatHappensToThem)
{
    for (std::uint64_t run = 0; run < 30; ++run) {
        Random random(1, run);
        const auto places = 1 + static_cast<std::size_t>(random.uniform() * 1000.0);
        ParticleStore store;
        store.set_capacity(places);
        std::vector<int> moving;
        std::vector<int> stuck;
        int next = 0;
        const auto erase = [](std::vector<int>& from, int number) {
            from.erase(std::find(from.begin(), from.end(), number));
        };
        for (int step = 0; step < 3'000; ++step) {
            const double choice = random.uniform();
            const auto place = static_cast<std::size_t>(random.uniform() * static_cast<double>(store.live()));
            if (choice < 0.55 && !store.is_full()) {
                moving.push_back(next);
                store.append(numbered(next++, 1e9F));
            } else if (choice < 0.7 && place >= store.stuck() && place < store.live()) {
                const int number = static_cast<int>(store.get(place).position.x);
                store.stick(place);
                erase(moving, number);
                stuck.push_back(number);
            } else if (choice < 0.95 && place < store.live()) {
                const int number = static_cast<int>(store.get(place).position.x);
                erase(place < store.stuck() ? stuck : moving, number);
                store.remove(place);
            }
            ASSERT_EQ(store.live(), moving.size() + stuck.size());
            ASSERT_EQ(store.stuck(), stuck.size());
        }
        std::sort(stuck.begin(), stuck.end());
        EXPECT_EQ(numbers(store, 0, store.stuck()), stuck);
        EXPECT_EQ(numbers(store, store.stuck(), store.live()), moving);
    }
}

TEST(ParticleStore, TakesOutThoseAndOnlyThoseWhoseLifeIsOver)
{
    for (std::uint64_t run = 0; run < 100; ++run) {
        Random random(2, run);
        const auto places = static_cast<std::size_t>(random.uniform() * 900.0);
        ParticleStore store;
        store.set_capacity(places);
        std::vector<int> survivors;
        for (std::size_t i = 0; i < places; ++i) {
            const double life = 0.25 + static_cast<int>(random.uniform() * 4.0); // 0.25, 1.25, 2.25, 3.25
            store.append(numbered(static_cast<int>(i), static_cast<float>(life)));
            if (random.uniform() < 0.3) {
                store.stick(store.stuck() + (store.live() - store.stuck()) / 2);
            }
            if (life > 2.0) {
                survivors.push_back(static_cast<int>(i));
            }
        }
        EXPECT_EQ(store.age_all(1.0f) + store.age_all(1.0f), places - survivors.size());
        EXPECT_EQ(numbers(store, 0, store.live()), survivors);
        EXPECT_EQ(store.age_all(10.0f), survivors.size());
        EXPECT_EQ(store.live(), 0u);
        EXPECT_EQ(store.stuck(), 0u);
    }
}

TEST(ParticleStore, EndsALifeAtItsAgeExactly)
{
    ParticleStore store;
    store.set_capacity(1);
    store.append(numbered(0, 0.5f));
    EXPECT_EQ(store.age_all(0.25f), 0u);
    EXPECT_EQ(store.age_all(0.25f), 1u);
}

TEST(ParticleStore, KeepsThoseWhoFindAPlaceWhenTheirNumberChanges)
{
    ParticleStore store;
    store.set_capacity(4);
    for (int i = 0; i < 4; ++i) {
        store.append(numbered(i, 9.0f));
    }
    store.stick(0);
    store.stick(1);
    store.stick(2);
    store.set_capacity(10);
    EXPECT_EQ(numbers(store, 0, 4), (std::vector<int>{0, 1, 2, 3}));
    store.set_capacity(2);
    EXPECT_EQ(numbers(store, 0, 2), (std::vector<int>{0, 1}));
    EXPECT_EQ(store.stuck(), 2u);
    EXPECT_TRUE(store.is_full());
}

TEST(ParticleStore, IsEqualWhateverUnusedPlacesHold)
{
    ParticleStore a;
    ParticleStore b;
    a.set_capacity(3);
    b.set_capacity(3);
    a.append(numbered(1, 9.0f));
    b.append(numbered(1, 9.0f));
    a.append(numbered(2, 9.0f));
    EXPECT_FALSE(a == b);
    a.remove(1);
    EXPECT_TRUE(a == b);
    a.stick(0);
    EXPECT_FALSE(a == b);
}

} // namespace
} // namespace particles
