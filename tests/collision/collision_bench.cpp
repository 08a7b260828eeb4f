// Measures hit_test on something like the tank: 18 spheres, half of the queries inside the root and a quarter
// hitting a part. Prints nanoseconds a query as JSON; the best of many rounds, as the least disturbed one.
#include "collision/smallest_sphere.h"
#include "collision/sphere_hierarchy.h"
#include "tests/collision/random_geometry.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <utility>
#include <vector>

namespace {

using namespace collision;

/// Spheres like those of our tank's parts, in metres: hull, turret, two guns, seven wheels a side.
SphereHierarchy tank_spheres()
{
    std::vector<BoundingSphere> spheres{
        {{0, 1.1, 0}, 3.7}, {{0, 2.0, 0.1}, 1.9}, {{0, 2.0, 3.4}, 2.3}, {{-0.5, 2.5, 0.3}, 0.6}};
    for (const double side : {1.38, -1.38}) {
        for (int wheel = 0; wheel < 7; ++wheel) {
            spheres.push_back({{side, 0.44, 2.4 - 0.8 * wheel}, 0.5});
        }
    }
    return SphereHierarchy(spheres);
}

enum class Wanted
{
    outside,
    root_only,
    hit,
};

/// Makes queries until the wanted mix of 2 : 1 : 1 is there, in random order.
template <class Make> std::vector<Query> mixed_queries(Random& random, const SphereHierarchy& tank, Make make)
{
    constexpr std::size_t COUNT = 4096;
    std::vector<Query> queries;
    const auto collect = [&](Wanted wanted, std::size_t count) {
        while (count > 0) {
            const Query query = make();
            const HitResult result = tank.hit_test(query);
            const Wanted got = !result.is_root_entered   ? Wanted::outside
                               : result.parts.is_empty() ? Wanted::root_only
                                                         : Wanted::hit;
            if (got == wanted) {
                queries.push_back(query);
                --count;
            }
        }
    };
    collect(Wanted::outside, COUNT / 2);
    collect(Wanted::root_only, COUNT / 4);
    collect(Wanted::hit, COUNT / 4);
    for (std::size_t i = COUNT; i-- > 1;) {
        std::swap(queries[i], queries[random.index(i + 1)]);
    }
    return queries;
}

double nanoseconds_a_query(const SphereHierarchy& tank, const std::vector<Query>& queries, std::uint64_t& sum)
{
    using Clock = std::chrono::steady_clock;
    double best = 1e300;
    for (int round = 0; round < 200; ++round) {
        const Clock::time_point begin = Clock::now();
        for (int again = 0; again < 4; ++again) {
            for (const Query& query : queries) {
                sum += tank.hit_test(query).parts.bits();
            }
        }
        const std::chrono::duration<double, std::nano> time = Clock::now() - begin;
        best = std::min(best, time.count() / static_cast<double>(4 * queries.size()));
    }
    return best;
}

} // namespace

int main()
{
    Random random(1);
    const SphereHierarchy tank = tank_spheres();
    const glm::dvec3 middle = tank.root().centre;
    const double size = tank.root().radius;
    const std::vector<Query> points =
        mixed_queries(random, tank, [&] { return Query::point(middle + random.in_box(1.5 * size)); });
    const std::vector<Query> segments = mixed_queries(random, tank, [&] {
        const glm::dvec3 from = middle + random.in_box(2.0 * size);
        return Query::segment(from, from + random.in_box(size));
    });
    std::uint64_t sum = 0;
    const double point_ns = nanoseconds_a_query(tank, points, sum);
    const double segment_ns = nanoseconds_a_query(tank, segments, sum);
    // The sum is the same everywhere, and printing it keeps the work from being left out.
    std::printf("{\"hit_test_point_ns\":%.2f,\"hit_test_segment_ns\":%.2f,\"checksum\":\"%016llx\"}\n",
                point_ns, segment_ns, static_cast<unsigned long long>(sum));
    return 0;
}
