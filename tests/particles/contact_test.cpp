#include "particles/contact.h"

#include "particles/random.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <vector>

namespace particles {
namespace {

constexpr double GRAVITY = 9.81;
constexpr double EXACT = 1e-12;

double fall_time(double height)
{
    return std::sqrt(2.0 * height / GRAVITY);
}

std::optional<double> contact(double distance, double speed, double acceleration, double k, double limit)
{
    return time_of_contact(distance, speed, acceleration, k, flight(k, limit));
}

TEST(TimeOfContact, OfAFallIsTheRootOfTheParabola)
{
    EXPECT_NEAR(contact(2.0, 0.0, -GRAVITY, 0.0, 5.0).value(), fall_time(2.0), EXACT);
    EXPECT_NEAR(contact(2.0, 3.0, -GRAVITY, 0.0, 5.0).value(),
                (3.0 + std::sqrt(9.0 + 4.0 * GRAVITY)) / GRAVITY, EXACT);
    EXPECT_NEAR(contact(2.0, -3.0, -GRAVITY, 0.0, 5.0).value(),
                (-3.0 + std::sqrt(9.0 + 4.0 * GRAVITY)) / GRAVITY, EXACT);
    EXPECT_NEAR(contact(2.0, -4.0, 0.0, 0.0, 5.0).value(), 0.5, EXACT);
}

TEST(TimeOfContact, IsNothingBeforeOrWithoutContact)
{
    EXPECT_FALSE(contact(2.0, 0.0, -GRAVITY, 0.0, fall_time(2.0) - 1e-9));
    EXPECT_TRUE(contact(2.0, 0.0, -GRAVITY, 0.0, fall_time(2.0) + 1e-9));
    EXPECT_FALSE(contact(2.0, 1.0, 0.0, 0.0, 60.0));
    EXPECT_FALSE(contact(2.0, 0.0, 0.0, 0.3, 60.0));
    EXPECT_FALSE(contact(2.0, 1.0, GRAVITY, 0.3, 60.0));
    EXPECT_FALSE(contact(2.0, -1.0, 0.0, 1.0, 60.0)) << "air stops it after one metre";
}

TEST(TimeOfContact, LeavingThePlaneIsNone)
{
    EXPECT_NEAR(contact(0.0, 3.0, -GRAVITY, 0.0, 5.0).value(), 6.0 / GRAVITY, EXACT);
    EXPECT_FALSE(contact(0.0, 3.0, -GRAVITY, 0.0, 0.5));
    EXPECT_FALSE(contact(0.0, 3.0, 0.0, 0.0, 60.0));
}

TEST(TimeOfContact, IsFoundWhereItTurnsRoundBehindThePlane)
{
    EXPECT_NEAR(contact(0.1, -2.0, 10.0, 0.0, 5.0).value(), (2.0 - std::sqrt(2.0)) / 10.0, EXACT);
    EXPECT_FALSE(contact(0.21, -2.0, 10.0, 0.0, 5.0)) << "turns round before";
    EXPECT_TRUE(contact(0.1, -2.0, 10.0, 0.7, 5.0));
    EXPECT_FALSE(contact(0.21, -2.0, 10.0, 0.7, 5.0));
}

TEST(TimeOfContact, InAirIsWhereTheHeightVanishesForTheFirstTime)
{
    Random random(1, 0);
    int contacts = 0;
    for (int i = 0; i < 20'000; ++i) {
        const double distance = random.uniform() * 3.0;
        const double speed = random.uniform() * 20.0 - 10.0;
        const double acceleration = random.uniform() * 40.0 - 20.0;
        const double k = random.uniform() * 5.0;
        const double limit = random.uniform() * 2.0;
        const auto height = [=](double t) {
            const Flight f = flight(k, t);
            return distance + speed * f.reach + acceleration * f.fall;
        };
        const auto time = contact(distance, speed, acceleration, k, limit);
        double lowest = distance;
        for (double t = 0.0; t <= time.value_or(limit); t += limit / 64.0) {
            lowest = std::min(lowest, height(t));
        }
        EXPECT_GE(lowest, -1e-12);
        if (time) {
            ++contacts;
            EXPECT_NEAR(height(*time), 0.0, 1e-11);
            EXPECT_TRUE(*time >= 0.0 && *time <= limit);
        }
    }
    EXPECT_GT(contacts, 4'000);
    EXPECT_LT(contacts, 16'000);
}

const Forces earth{{0.0, -GRAVITY, 0.0}, 0.0};

Wall floor_with(double restitution, double friction = 0.0)
{
    return {.normal = {0.0, 1.0, 0.0}, .offset = 0.0, .restitution = restitution, .friction = friction};
}

Fate fly(Motion& motion, const Forces& forces, const std::vector<Wall>& walls, double seconds)
{
    return fly_among_walls(motion, forces, walls, flight(forces.air_resistance, seconds));
}

TEST(FlyAmongWalls, BouncesAtTheTimeOfContact)
{
    Motion ball{{1.0, 2.0, 3.0}, {4.0, 0.0, 0.0}};
    const double after = 0.3;
    EXPECT_EQ(fly(ball, earth, {floor_with(0.5)}, fall_time(2.0) + after), Fate::moves);
    const double speed = 0.5 * std::sqrt(2.0 * GRAVITY * 2.0);
    EXPECT_NEAR(ball.position.x, 1.0 + 4.0 * (fall_time(2.0) + after), EXACT);
    EXPECT_NEAR(ball.position.y, speed * after - GRAVITY * after * after / 2.0, EXACT);
    EXPECT_NEAR(ball.velocity.x, 4.0, EXACT);
    EXPECT_NEAR(ball.velocity.y, speed - GRAVITY * after, EXACT);
}

TEST(FlyAmongWalls, BouncesAsOftenAsThereIsTime)
{
    Motion ball{{0.0, 1.0, 0.0}, {0.0, 0.0, 0.0}};
    // Seven bounces without loss, and up again.
    fly(ball, earth, {floor_with(1.0)}, 14.0 * fall_time(1.0));
    EXPECT_NEAR(ball.position.y, 1.0, 1e-9);
    EXPECT_NEAR(ball.velocity.y, 0.0, 1e-9);
}

TEST(FlyAmongWalls, ABounceTakesCoulombsFrictionFromTheSpeedAlong)
{
    Motion fast{{0.0, 0.0, 0.0}, {5.0, -2.0, 0.0}};
    fly(fast, {}, {floor_with(0.5, 0.3)}, 0.0);
    EXPECT_NEAR(fast.velocity.x, 5.0 - 0.3 * 1.5 * 2.0, EXACT);
    EXPECT_NEAR(fast.velocity.y, 1.0, EXACT);
    Motion slow{{0.0, 0.0, 0.0}, {0.5, -2.0, 0.5}};
    fly(slow, {}, {floor_with(0.5, 0.3)}, 0.0);
    EXPECT_EQ(slow.velocity.x, 0.0);
    EXPECT_EQ(slow.velocity.z, 0.0);
    EXPECT_NEAR(slow.velocity.y, 1.0, EXACT);
}

TEST(FlyAmongWalls, ComesToRestAfterBouncing)
{
    Motion ball{{0.0, 1.0, 0.0}, {0.0, 0.0, 0.0}};
    fly(ball, earth, {floor_with(0.3)}, 5.0);
    EXPECT_EQ(ball.position.y, 0.0);
    EXPECT_EQ(ball.velocity.y, 0.0);
}

TEST(FlyAmongWalls, SlidesToAStopAgainstFriction)
{
    const double stop_time = 3.0 / (0.5 * GRAVITY);
    Motion half_way{{0.0, 0.0, 0.0}, {3.0, 0.0, 0.0}};
    fly(half_way, earth, {floor_with(0.5, 0.5)}, stop_time / 2.0);
    EXPECT_NEAR(half_way.velocity.x, 1.5, EXACT);
    EXPECT_NEAR(half_way.position.x, 0.75 * 9.0 / (2.0 * 0.5 * GRAVITY), EXACT);
    Motion to_the_end{{0.0, 0.0, 0.0}, {3.0, 0.0, 0.0}};
    fly(to_the_end, earth, {floor_with(0.5, 0.5)}, 10.0);
    EXPECT_NEAR(to_the_end.position.x, 9.0 / (2.0 * 0.5 * GRAVITY), EXACT);
    EXPECT_EQ(to_the_end.velocity, glm::dvec3(0.0));
}

TEST(FlyAmongWalls, OnASlopeFrictionHoldsOrSlowsIt)
{
    const double angle = 0.5;
    Wall slope{.normal = {std::sin(angle), std::cos(angle), 0.0}, .offset = 0.0, .restitution = 0.5};
    slope.friction = std::tan(angle) * 1.01;
    Motion held{{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
    fly(held, earth, {slope}, 2.0);
    EXPECT_EQ(held.position, glm::dvec3(0.0));
    slope.friction = std::tan(angle) * 0.5;
    Motion slides{{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
    fly(slides, earth, {slope}, 2.0);
    const double acceleration = GRAVITY * (std::sin(angle) - slope.friction * std::cos(angle));
    EXPECT_NEAR(glm::length(slides.velocity), acceleration * 2.0, 1e-9);
    EXPECT_NEAR(glm::length(slides.position), acceleration * 2.0, 1e-9);
}

TEST(FlyAmongWalls, SlidesIntoAWallAndBouncesOffIt)
{
    const Wall right{.normal = {-1.0, 0.0, 0.0}, .offset = -2.0, .restitution = 0.5};
    Motion ball{{0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}};
    fly(ball, earth, {floor_with(0.5), right}, 1.0);
    EXPECT_NEAR(ball.position.x, 2.0 - 0.5 * 2.0, EXACT);
    EXPECT_NEAR(ball.position.y, 0.0, EXACT);
    EXPECT_NEAR(ball.velocity.x, -2.0, EXACT);
}

TEST(FlyAmongWalls, WindLiftsWhatRests)
{
    Motion leaf{{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
    const Forces updraught{{0.0, 2.0, 0.0}, 1.0};
    fly(leaf, updraught, {floor_with(0.5, 1.0)}, 1.0);
    EXPECT_NEAR(leaf.position.y, 2.0 * flight(1.0, 1.0).fall, EXACT);
}

TEST(FlyAmongWalls, SticksWhereItTouches)
{
    Wall wall = floor_with(0.5);
    wall.response = ContactResponse::stick;
    Motion drop{{0.0, 2.0, 0.0}, {3.0, 0.0, 0.0}};
    EXPECT_EQ(fly(drop, earth, {wall}, fall_time(2.0) * 0.9), Fate::moves);
    EXPECT_EQ(fly(drop, earth, {wall}, 1.0), Fate::sticks);
    EXPECT_NEAR(drop.position.x, 3.0 * fall_time(2.0), EXACT);
    EXPECT_NEAR(drop.position.y, 0.0, EXACT);
    EXPECT_EQ(drop.velocity, glm::dvec3(0.0));
}

TEST(FlyAmongWalls, IsRecycledAtAContactOnly)
{
    Wall wall = floor_with(0.5);
    wall.response = ContactResponse::recycle;
    Motion drop{{0.0, 0.0, 0.0}, {0.0, 3.0, 0.0}};
    EXPECT_EQ(fly(drop, earth, {wall}, 5.9 / GRAVITY), Fate::moves) << "begins on the plane, leaving it";
    EXPECT_EQ(fly(drop, earth, {wall}, 0.2 / GRAVITY), Fate::is_recycled);
}

TEST(FlyAmongWalls, WhatIsBehindAWallIsPutOnIt)
{
    Motion sunk{{1.0, -3.0, 2.0}, {0.0, 0.0, 0.0}};
    fly(sunk, earth, {floor_with(0.5)}, 0.1);
    EXPECT_EQ(sunk.position, glm::dvec3(1.0, 0.0, 2.0));
}

TEST(FlyAmongWalls, WalksOutOfNoWedge)
{
    const double s = std::sqrt(0.5);
    const Wall left{.normal = {s * 0.2, 1.0, 0.0}, .restitution = 0.9};
    Wall steep{.normal = glm::normalize(glm::dvec3{-1.0, 0.1, 0.0}), .restitution = 0.9};
    Random random(2, 0);
    for (int i = 0; i < 2'000; ++i) {
        Motion ball{{-random.uniform(), 1.0, 0.0}, random.in_ball() * 20.0};
        fly(ball, earth, {left, steep}, random.uniform() * 3.0);
        EXPECT_TRUE(std::isfinite(ball.position.x + ball.position.y));
        EXPECT_GE(glm::dot(steep.normal, ball.position), -1e-9);
    }
}

std::vector<Wall> random_box(Random& random)
{
    std::vector<Wall> walls;
    for (int i = 0; i < 6; ++i) {
        glm::dvec3 normal = random.in_ball();
        normal[i / 2] = i % 2 == 0 ? 1.5 : -1.5;
        const double restitution = random.uniform();
        const double friction = random.uniform() < 0.5 ? 0.0 : random.uniform();
        walls.push_back({glm::normalize(normal), -1.0 - random.uniform(), restitution, friction});
    }
    return walls;
}

TEST(FlyAmongWalls, NothingIsBehindAWallAfterwards)
{
    Random random(3, 0);
    for (int i = 0; i < 3'000; ++i) {
        const std::vector<Wall> walls = random_box(random);
        const Forces forces{random.in_ball() * 30.0, random.uniform() < 0.5 ? 0.0 : random.uniform() * 3.0};
        Motion ball{random.in_ball() * 0.5, random.in_ball() * 30.0};
        for (int step = 0; step < 5; ++step) {
            fly(ball, forces, walls, random.uniform() * (step == 4 ? 60.0 : 0.1));
            for (const Wall& wall : walls) {
                // A corner of slanted walls is left in several pushes, of which the last may push it back.
                EXPECT_GE(glm::dot(wall.normal, ball.position) - wall.offset, -1e-6) << i;
            }
            EXPECT_TRUE(std::isfinite(glm::dot(ball.velocity, ball.velocity)));
        }
    }
}

TEST(FlyAmongWalls, EnergyNeverGrows)
{
    Random random(4, 0);
    for (int i = 0; i < 2'000; ++i) {
        const std::vector<Wall> walls = random_box(random);
        const Forces forces{{0.0, -GRAVITY, 0.0}, i % 2 == 0 ? 0.0 : 0.5};
        Motion ball{random.in_ball() * 0.5, random.in_ball() * 10.0};
        const auto energy = [&] {
            return glm::dot(ball.velocity, ball.velocity) / 2.0 + GRAVITY * ball.position.y;
        };
        double before = energy();
        for (int step = 0; step < 50; ++step) {
            fly(ball, forces, walls, random.uniform() * 0.1);
            // What rests on a slope is lifted by up to a millionth of a metre when put back on it.
            EXPECT_LE(energy(), before + 2e-5) << i << " " << step;
            before = energy();
        }
    }
}

TEST(FlyAmongWalls, ManyShortFlightsAreOneLongFlight)
{
    Random random(5, 0);
    for (int i = 0; i < 1'000; ++i) {
        // Friction goes with the direction at the beginning of a slide, so nothing pushes sideways then.
        const bool has_friction = i % 3 == 0;
        const std::vector<Wall> walls{floor_with(0.6, has_friction ? 0.2 : 0.0)};
        const Forces forces{{has_friction ? 0.0 : random.uniform(), -GRAVITY, 0.0}, i % 2 == 0 ? 0.0 : 0.8};
        const Motion begin{{0.0, random.uniform() * 2.0, 0.0}, random.in_ball() * 5.0};
        Motion at_once = begin;
        Motion in_parts = begin;
        fly(at_once, forces, walls, 3.0);
        for (int part = 0; part < 180; ++part) {
            fly(in_parts, forces, walls, 1.0 / 60.0);
        }
        // A wall is touched from a millionth of a metre on, which the end of a part may fall into.
        EXPECT_NEAR(glm::length(at_once.position - in_parts.position), 0.0, 5e-6) << i;
        EXPECT_NEAR(glm::length(at_once.velocity - in_parts.velocity), 0.0, 5e-6) << i;
    }
}

TEST(WallOf, BringsTheNormalToLengthOne)
{
    const Wall wall = wall_of({.normal = {0.0f, 0.0f, -4.0f},
                               .point = {1.0f, 2.0f, 3.0f},
                               .response = ContactResponse::stick,
                               .restitution = 0.25f,
                               .friction = 0.5f});
    EXPECT_EQ(wall.normal, glm::dvec3(0.0, 0.0, -1.0));
    EXPECT_EQ(wall.offset, -3.0);
    EXPECT_EQ(wall.response, ContactResponse::stick);
    EXPECT_EQ(wall.restitution, 0.25);
    EXPECT_EQ(wall.friction, 0.5);
}

} // namespace
} // namespace particles
