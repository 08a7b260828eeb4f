#include "app/simulation/hit_report.h"

#include "base/measures.h"
#include "tank/part.h"

namespace app {

namespace {

using collision::SphereTest;

std::string_view probe_name(Probe probe)
{
    switch (probe) {
    case Probe::none:
        return "none";
    case Probe::point:
        return "point";
    case Probe::segment:
        return "segment";
    case Probe::ray:
        return "ray";
    case Probe::line:
        return "line";
    }
    return {};
}

std::string query_text(const HitReport& report, const glm::dvec3& second)
{
    const collision::Query& query = report.query;
    std::string text;
    switch (report.probe) {
    case Probe::none:
        return text;
    case Probe::point:
        text = "Point " + base::in_metres(query.origin);
        if (query.radius > 0.0) {
            text += " with radius " + base::in_metres(query.radius) + " m";
        }
        return text;
    case Probe::segment:
        text = "Segment from ";
        break;
    case Probe::ray:
        text = "Ray from ";
        break;
    case Probe::line:
        text = "Line through ";
        break;
    }
    text += base::in_metres(query.origin);
    if (query.origin == second) {
        return text + ", whose ends are the same: a point";
    }
    return text +
           (report.probe == Probe::segment ? " to "
            : report.probe == Probe::ray   ? " through "
                                           : " and ") +
           base::in_metres(second);
}

/// Returns the line's second place: of a ray and a line not in the query, which has their direction.
glm::dvec3 second_place(const collision::Query& query)
{
    return query.shape == collision::Shape::segment ? query.end : query.origin + query.direction;
}

std::string sphere_text(const SphereTest& test, bool is_point)
{
    std::string text = "centre " + base::in_metres(test.sphere.centre) + ", radius " +
                       base::in_metres(test.sphere.radius) + " m, distance " +
                       base::in_metres(test.distance) + " m, ";
    text += test.is_inside ? "depth " + base::in_metres(test.depth)
                           : "outside by " + base::in_metres(-test.depth);
    text += " m";
    if (!is_point) {
        text += ", closest point " + base::in_metres(test.closest_point) + " at parameter " +
                base::in_metres(test.parameter);
    }
    return text;
}

void write_point(base::JsonWriter& json, std::string_view key, const glm::dvec3& point)
{
    json.key(key).begin_array();
    for (int axis = 0; axis < 3; ++axis) {
        json.decimal(base::to_millimetres(point[axis]), 3);
    }
    json.end_array();
}

void write_sphere(base::JsonWriter& json, std::string_view name, const SphereTest& test)
{
    json.begin_object().key("part").string(name);
    write_point(json, "centre", test.sphere.centre);
    json.key("radius").decimal(base::to_millimetres(test.sphere.radius), 3);
    json.key("distance").decimal(base::to_millimetres(test.distance), 3);
    json.key("depth").decimal(base::to_millimetres(test.depth), 3);
    json.key("inside").boolean(test.is_inside);
    write_point(json, "closest_point", test.closest_point);
    json.key("parameter").decimal(base::to_millimetres(test.parameter), 3);
    json.end_object();
}

} // namespace

std::optional<collision::Query> probe_query(const State& state)
{
    const Projectile& projectile = state.projectile;
    switch (projectile.probe) {
    case Probe::none:
        return std::nullopt;
    case Probe::point:
        return collision::Query::point(projectile.point, projectile.radius);
    case Probe::segment:
        return collision::Query::segment(projectile.a, projectile.b);
    case Probe::ray:
        return collision::Query::ray(projectile.a, projectile.b - projectile.a);
    case Probe::line:
        return collision::Query::line(projectile.a, projectile.b - projectile.a);
    }
    return std::nullopt;
}

HitReport hit_report(const State& state, const collision::SphereHierarchy& spheres)
{
    const std::optional<collision::Query> query = probe_query(state);
    if (!query) {
        return {};
    }
    return {state.projectile.probe, *query, spheres.explain(*query), {}};
}

void test_triangles(HitReport& report, const TankTriangles& triangles, const tank::PartMatrices& matrices)
{
    if (report.probe != Probe::point) {
        return;
    }
    report.explanation.hits.for_each([&](std::size_t index) {
        const auto part = static_cast<tank::Part>(index);
        if (const auto test = triangles.test(report.query.origin, part, matrices.mesh(part))) {
            report.triangles.push_back(*test);
        }
    });
}

std::vector<std::string> report_lines(const HitReport& report)
{
    std::vector<std::string> lines;
    if (report.probe == Probe::none) {
        return lines;
    }
    std::string first = query_text(report, second_place(report.query));
    const collision::Explanation& explanation = report.explanation;
    if (explanation.refusal != collision::Refusal::none) {
        lines.push_back(first + " is not tested: " + std::string(refusal_text(explanation.refusal)) + ".");
        return lines;
    }
    const bool is_point = report.probe == Probe::point;
    const bool is_inside = explanation.root.is_inside;
    lines.push_back(first + (is_inside ? " is inside" : " is outside") +
                    " the whole tank: " + sphere_text(explanation.root, is_point) +
                    (is_inside ? ". So its parts are tested." : ". No part is tested."));
    explanation.hits.for_each([&](std::size_t part) {
        lines.push_back("It penetrates " + std::string(tank::part_name(static_cast<tank::Part>(part))) +
                        ": " + sphere_text(explanation.parts[part], is_point) + ".");
    });
    if (is_inside && explanation.hits.is_empty()) {
        lines.push_back("It penetrates none of the " + std::to_string(explanation.parts.size()) + " parts.");
    }
    for (const TriangleTest& test : report.triangles) {
        lines.push_back("Against its triangles it is " +
                        std::string(test.is_inside ? "inside " : "outside ") +
                        std::string(tank::part_name(test.part)) + ", " + base::in_metres(test.distance) +
                        " m from the surface" + (test.is_inside ? "." : ": rejected."));
    }
    return lines;
}

void write_report(base::JsonWriter& json, const HitReport& report)
{
    if (report.probe == Probe::none) {
        json.null();
        return;
    }
    const collision::Explanation& explanation = report.explanation;
    json.begin_object().key("probe").string(probe_name(report.probe));
    write_point(json, "from", report.query.origin);
    if (report.probe != Probe::point) {
        write_point(json, "to", second_place(report.query));
    }
    json.key("radius").decimal(base::to_millimetres(report.query.radius), 3);
    json.key("refusal");
    if (explanation.refusal == collision::Refusal::none) {
        json.null();
    } else {
        json.string(refusal_text(explanation.refusal));
    }
    json.key("root");
    if (explanation.refusal == collision::Refusal::none) {
        write_sphere(json, "tank", explanation.root);
    } else {
        json.null();
    }
    json.key("parts_tested").number(static_cast<std::uint64_t>(explanation.parts.size()));
    json.key("tested").begin_array();
    for (std::size_t part = 0; part < explanation.parts.size(); ++part) {
        json.begin_object().key("part").string(tank::part_name(static_cast<tank::Part>(part)));
        json.key("depth").decimal(base::to_millimetres(explanation.parts[part].depth), 3).end_object();
    }
    json.end_array();
    json.key("parts").begin_array();
    explanation.hits.for_each([&](std::size_t part) {
        write_sphere(json, tank::part_name(static_cast<tank::Part>(part)), explanation.parts[part]);
    });
    json.end_array();
    json.key("triangles").begin_array();
    for (const TriangleTest& test : report.triangles) {
        json.begin_object().key("part").string(tank::part_name(test.part));
        json.key("inside").boolean(test.is_inside);
        json.key("distance").decimal(base::to_millimetres(test.distance), 3);
        write_point(json, "nearest", test.point);
        json.end_object();
    }
    json.end_array().end_object();
}

} // namespace app
