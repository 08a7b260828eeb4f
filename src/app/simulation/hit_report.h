#pragma once

#include "app/simulation/tank_triangles.h"
#include "app/state/state.h"
#include "base/json_writer.h"
#include "collision/query.h"
#include "collision/sphere_hierarchy.h"
#include "tank/part_matrices.h"

#include <optional>
#include <string>
#include <vector>

namespace app {

/// Returns what the state's probe tests; nothing for Probe::none.
std::optional<collision::Query> probe_query(const State& state);

/// Holds how the probe was tested against the spheres of the tank.
struct HitReport
{
    Probe probe = Probe::none;
    collision::Query query = collision::Query::point({0.0, 0.0, 0.0}); ///< not used without a probe
    collision::Explanation explanation;
    std::vector<TriangleTest> triangles; ///< of penetrated parts, when the state tests a point against them
};

/// Tests the state's probe against the spheres and tells all of it.
HitReport hit_report(const State& state, const collision::SphereHierarchy& spheres);

/// Adds how a point inside of parts' spheres comes out against their triangles. Precondition: the report is
/// of the same pose as the matrices.
void test_triangles(HitReport& report, const TankTriangles& triangles, const tank::PartMatrices& matrices);

/// Returns the report as lines for people: first what was tested against the whole tank, then, if inside,
/// every part it is inside of. No lines without a probe. Millimetres are the last digit.
std::vector<std::string> report_lines(const HitReport& report);

/// Writes the report as an object: `probe`, `from` (and `to`), `radius`, `refusal` or null, `root` and
/// `parts`, those that were penetrated. Each sphere has `part` (root: "tank"), `centre`, `radius`,
/// `distance`, `depth`, `inside`, `closest_point`, `parameter`. `tested`: every part that was tested, as
/// {part, depth}. `triangles`: of a point tested against those, as {part, inside, distance, nearest}. Or null
/// without a probe.
void write_report(base::JsonWriter& json, const HitReport& report);

} // namespace app
