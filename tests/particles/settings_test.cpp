#include "particles/settings.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace particles {
namespace {

using Change = std::function<void(ParticleSettings&)>;

constexpr float NOT_A_NUMBER = std::numeric_limits<float>::quiet_NaN();
constexpr float INFINITE = std::numeric_limits<float>::infinity();

std::string verdict(const Change& change)
{
    ParticleSettings settings;
    settings.plane_count = 1;
    change(settings);
    return validate(settings);
}

TEST(Validate, AcceptsTheDefaults)
{
    EXPECT_EQ(validate({}), "");
}

struct Limits
{
    const char* sentence;
    std::vector<Change> good;
    std::vector<Change> bad;
};

/// The limits of a number that is set by set(settings, value).
template <class Set>
Limits number(const char* sentence, Set set, std::vector<double> good, std::vector<double> bad)
{
    Limits limits{sentence, {}, {}};
    bad.insert(bad.end(), {static_cast<double>(NOT_A_NUMBER), static_cast<double>(INFINITE),
                           -static_cast<double>(INFINITE)});
    for (const double value : good) {
        limits.good.push_back([=](ParticleSettings& s) { set(s, value); });
    }
    for (const double value : bad) {
        limits.bad.push_back([=](ParticleSettings& s) { set(s, value); });
    }
    return limits;
}

template <class Set> Limits whole(const char* sentence, Set set, std::vector<int> good, std::vector<int> bad)
{
    Limits limits{sentence, {}, {}};
    for (const int value : good) {
        limits.good.push_back([=](ParticleSettings& s) { set(s, value); });
    }
    for (const int value : bad) {
        limits.bad.push_back([=](ParticleSettings& s) { set(s, value); });
    }
    return limits;
}

/// The same for a vector, along each of its axes.
template <class Set>
Limits vector(const char* sentence, Set set, std::vector<double> good, std::vector<double> bad)
{
    Limits limits{sentence, {}, {}};
    for (int axis = 0; axis < 3; ++axis) {
        const Limits along = number(
            sentence, [=](ParticleSettings& s, double value) { set(s)[axis] = static_cast<float>(value); },
            good, bad);
        limits.good.insert(limits.good.end(), along.good.begin(), along.good.end());
        limits.bad.insert(limits.bad.end(), along.bad.begin(), along.bad.end());
    }
    return limits;
}

float to_float(double value)
{
    return static_cast<float>(value);
}

std::vector<Limits> all_limits()
{
    using S = ParticleSettings;
    return {
        whole("The maximum of particles must be from 0 to 1000000.",
              [](S& s, int v) { s.maximum_particles = v; }, {0, 1, 1'000'000}, {-1, 1'000'001}),
        whole("The number to release must be from 0 to 1000000.",
              [](S& s, int v) {
                  s.release_count = v;
                  s.release_interval = 1.0;
              },
              {0, 1'000'000}, {-1, 1'000'001}),
        number("The release interval must be from 0.001 to 60 seconds.",
               [](S& s, double v) { s.release_interval = v; }, {0.001, 60.0}, {0.0, -1.0, 0.0009, 60.1}),
        whole("The number to release must be at most 1000000 a second, so smaller or at longer intervals.",
              [](S& s, int v) { s.release_count = v; }, {50'000}, {50'001}),
        number("The life cycle must be from 0 to 60 seconds.", [](S& s, double v) { s.life = v; },
               {0.0, 60.0}, {-0.1, 60.1}),
        number("The variance of the life cycle must be from 0 to 1.",
               [](S& s, double v) { s.life_variance = v; }, {0.0, 1.0}, {-0.1, 1.1}),
        number("The size must be from 0 to 100 metres, at the start and at the end.",
               [](S& s, double v) { s.size.start = to_float(v); }, {0.0, 100.0}, {-0.1, 101.0}),
        number("The size must be from 0 to 100 metres, at the start and at the end.",
               [](S& s, double v) { s.size.end = to_float(v); }, {0.0, 100.0}, {-0.1, 101.0}),
        number("The colour must be from 0 to 1 in red, green, blue and alpha, at the start, in the middle "
               "and at "
               "the end.",
               [](S& s, double v) { s.colour.start.r = to_float(v); }, {0.0, 1.0}, {-0.1, 1.1}),
        number("The colour must be from 0 to 1 in red, green, blue and alpha, at the start, in the middle "
               "and at "
               "the end.",
               [](S& s, double v) { s.colour.middle.b = to_float(v); }, {0.0, 1.0}, {-0.1, 1.1}),
        number("The colour must be from 0 to 1 in red, green, blue and alpha, at the start, in the middle "
               "and at "
               "the end.",
               [](S& s, double v) { s.colour.end.a = to_float(v); }, {0.0, 1.0}, {-0.1, 1.1}),
        number("The middle of the colour must be from 0 to 1 of the life cycle.",
               [](S& s, double v) { s.colour.middle_at = to_float(v); }, {0.0, 1.0}, {-0.1, 1.1}),
        number("The time of a streak must be from 0 to 10 seconds.",
               [](S& s, double v) { s.streak_time = v; }, {0.0, 10.0}, {-0.1, 11.0}),
        vector("The position must be from -10000 to 10000 metres along each axis.",
               [](S& s) -> glm::vec3& { return s.position; }, {-10'000.0, 10'000.0}, {-10'001.0, 10'001.0}),
        vector("The variance of the position must be from 0 to 10000 metres along each axis.",
               [](S& s) -> glm::vec3& { return s.position_variance; }, {0.0, 10'000.0}, {-0.1, 10'001.0}),
        vector("The velocity must be from -1000 to 1000 m/s along each axis.",
               [](S& s) -> glm::vec3& { return s.velocity; }, {-1000.0, 1000.0}, {-1001.0, 1001.0}),
        number("The variance of the velocity must be from 0 to 1000 m/s.",
               [](S& s, double v) { s.velocity_variance = v; }, {0.0, 1000.0}, {-0.1, 1001.0}),
        vector("The gravity must be from -1000 to 1000 m/s^2 along each axis.",
               [](S& s) -> glm::vec3& { return s.gravity; }, {-1000.0, 1000.0}, {-1001.0, 1001.0}),
        vector("The wind must be from -1000 to 1000 m/s along each axis.",
               [](S& s) -> glm::vec3& { return s.wind; }, {-1000.0, 1000.0}, {-1001.0, 1001.0}),
        number("The air resistance must be from 0 to 1000 per second.",
               [](S& s, double v) { s.air_resistance = v; }, {0.0, 1000.0}, {-0.1, 1001.0}),
        whole("The number of collision planes must be from 0 to 6.", [](S& s, int v) { s.plane_count = v; },
              {0, 6}, {-1, 7}),
        vector("The normal of a collision plane must be between 0.001 and 1000 long.",
               [](S& s) -> glm::vec3& { return s.planes[0].normal; }, {-1000.0, 1000.0}, {1001.0}),
        {"The normal of a collision plane must be between 0.001 and 1000 long.",
         {[](S& s) { s.planes[0].normal = {0.0f, 0.0f, -0.0011f}; }},
         {[](S& s) { s.planes[0].normal = {0.0f, 0.0f, 0.0f}; },
          [](S& s) { s.planes[0].normal = {1e-30F, 0.0f, 0.0f}; }}},
        vector("The point of a collision plane must be from -10000 to 10000 metres along each axis.",
               [](S& s) -> glm::vec3& { return s.planes[0].point; }, {-10'000.0, 10'000.0}, {-10'001.0}),
        number("The restitution of a collision plane must be from 0 to 1.",
               [](S& s, double v) { s.planes[0].restitution = to_float(v); }, {0.0, 1.0}, {-0.1, 1.01}),
        number("The friction of a collision plane must be from 0 to 10.",
               [](S& s, double v) { s.planes[0].friction = to_float(v); }, {0.0, 10.0}, {-0.1, 10.1}),
    };
}

TEST(Validate, AcceptsWhatIsWithinTheLimits)
{
    for (const Limits& limits : all_limits()) {
        for (const Change& change : limits.good) {
            EXPECT_EQ(verdict(change), "") << limits.sentence;
        }
    }
}

TEST(Validate, SaysInASentenceWhichSettingIsNotAndWhatItMustBe)
{
    for (const Limits& limits : all_limits()) {
        for (const Change& change : limits.bad) {
            EXPECT_EQ(verdict(change), limits.sentence);
        }
    }
}

TEST(Validate, LooksAtEveryPlaneInUseAndAtNoOther)
{
    ParticleSettings settings;
    settings.planes[5].restitution = 2.0f;
    settings.plane_count = 5;
    EXPECT_EQ(validate(settings), "");
    settings.plane_count = 6;
    EXPECT_EQ(validate(settings), "The restitution of a collision plane must be from 0 to 1.");
}

TEST(IsValidSource, RefusesWhatIsTooFarTooFastOrNotANumber)
{
    EXPECT_TRUE(is_valid_source({1.0f, 10'000.0f, 0.0f}, {0.0f, 0.0f, -1000.0f}));
    EXPECT_FALSE(is_valid_source({1.0f, 10'001.0f, 0.0f}, {0.0f, 0.0f, 0.0f}));
    EXPECT_FALSE(is_valid_source({0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -1001.0f}));
    EXPECT_FALSE(is_valid_source({0.0f, NOT_A_NUMBER, 0.0f}, {0.0f, 0.0f, 0.0f}));
    EXPECT_FALSE(is_valid_source({0.0f, 0.0f, 0.0f}, {INFINITE, 0.0f, 0.0f}));
}

TEST(Moved, TakesThePlanesAlong)
{
    ParticleSettings settings;
    settings.plane_count = 2;
    settings.position = {1.0f, 2.0f, 3.0f};
    settings.planes[1].point = {0.0f, 5.0f, 0.0f};
    const ParticleSettings there = moved(settings, {10.0f, 20.0f, 30.0f});
    EXPECT_EQ(there.position, (glm::vec3{11.0f, 22.0f, 33.0f}));
    EXPECT_EQ(there.planes[0].point, (glm::vec3{10.0f, 20.0f, 30.0f}));
    EXPECT_EQ(there.planes[1].point, (glm::vec3{10.0f, 25.0f, 30.0f}));
    EXPECT_EQ(there.velocity, settings.velocity);
}

} // namespace
} // namespace particles
