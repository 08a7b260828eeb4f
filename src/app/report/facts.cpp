#include "app/report/facts.h"

#include "app/links/tasks.h"
#include "app/state/flight.h"
#include "base/measures.h"
#include "lod/threshold.h"

namespace app {

namespace {

std::string metres(double value)
{
    return base::in_metres(value) + " m";
}

/// Returns the number of triangles of the drawn parts of one model.
std::size_t triangles(const Simulation& simulation, lod::Level level)
{
    const assets::Assets& assets = simulation.assets();
    std::size_t count = 0;
    for (tank::Part part : tank::ALL_PARTS) {
        if (is_shown(simulation.state().show.parts, part)) {
            count += assets.meshes(level)[tank::index_of(assets.layout[part].mesh)].faces.size();
        }
    }
    return count;
}

/// Returns a part with what hangs on it: "turret (main_gun, secondary_gun)".
std::string tree(const tank::Layout& layout, tank::Part part)
{
    std::string text(tank::part_name(part));
    bool has_children = false;
    tank::for_each_child(layout, part, [&](tank::Part child) {
        text += has_children ? ", " : " (";
        has_children = true;
        text += tree(layout, child);
    });
    return has_children ? text + ")" : text;
}

std::string named(collision::PartSet parts)
{
    std::string text;
    parts.for_each([&](std::size_t part) {
        text += text.empty() ? "" : ", ";
        text += tank::part_name(static_cast<tank::Part>(part));
    });
    return text.empty() ? "none" : text;
}

void add_assembly(std::vector<Fact>& facts, const Simulation& simulation)
{
    facts.push_back({"Tree", tree(simulation.assets().layout, tank::Part::body)});
    facts.push_back({"Parts", std::to_string(tank::PART_COUNT)});
    facts.push_back({"Triangles", std::to_string(triangles(simulation, lod::Level::high))});
}

void add_mesh_spheres(std::vector<Fact>& facts, const Simulation& simulation)
{
    for (std::size_t mesh = 0; mesh < tank::MESH_KIND_COUNT; ++mesh) {
        const auto kind = static_cast<tank::MeshKind>(mesh);
        const collision::BoundingSphere& average = simulation.spheres().of_mesh(kind, SphereFit::average);
        const collision::BoundingSphere& smallest = simulation.spheres().of_mesh(kind, SphereFit::smallest);
        facts.push_back({tank::mesh_title(kind),
                         std::to_string(simulation.assets().high[mesh].positions.size()) +
                             " vertices, average " + base::in_metres(average.centre) + ", radius " +
                             metres(average.radius) + "; smallest sphere " + metres(smallest.radius)});
    }
}

void add_hierarchy(std::vector<Fact>& facts, const Simulation& simulation)
{
    const collision::SphereHierarchy& spheres = simulation.spheres().hierarchy();
    facts.push_back({"Sphere around all parts' spheres", metres(spheres.root().radius)});
    facts.push_back({"Sphere of all vertices at rest", metres(spheres.whole().radius)});
    facts.push_back({"Part spheres recomputed", std::to_string(spheres.refit_counts().parts)});
    facts.push_back({"Root spheres recomputed", std::to_string(spheres.refit_counts().roots)});
}

void add_hits(std::vector<Fact>& facts, const Simulation& simulation)
{
    const HitReport& report = simulation.report();
    if (report.probe == Probe::none) {
        return;
    }
    const collision::Explanation& explanation = report.explanation;
    facts.push_back({"Whole tank", explanation.root.is_inside
                                       ? "inside by " + metres(explanation.root.depth)
                                       : "outside by " + metres(-explanation.root.depth)});
    facts.push_back({"Parts tested", std::to_string(explanation.parts.size())});
    facts.push_back({"Penetrated", named(explanation.hits)});
    for (const TriangleTest& test : report.triangles) {
        facts.push_back({"Triangles", std::string(tank::part_name(test.part)) +
                                          (test.is_inside ? ": inside, " : ": outside, ") +
                                          metres(test.distance) + " from the surface"});
    }
}

void add_sparks(std::vector<Fact>& facts, const Simulation& simulation)
{
    const State& state = simulation.state();
    facts.push_back({"Projectile", (state.shot.flies ? "in flight at " : "at rest at ") +
                                       base::in_metres(projectile_position(state))});
    facts.push_back({"Touched", std::to_string(simulation.touches()) + " spheres of parts"});
    facts.push_back({"Inside", named(simulation.inside())});
    std::size_t live = 0;
    for (const particles::ParticleSystem* system : simulation.sparks().systems()) {
        live += system->live();
    }
    facts.push_back({"Sparks alight", std::to_string(live)});
}

void add_levels(std::vector<Fact>& facts, const Simulation& simulation)
{
    const State& state = simulation.state();
    const lod::SwitchBand band = lod::band_by_fraction(state.show.threshold);
    facts.push_back({"Distance", metres(state.camera.distance)});
    facts.push_back({"Threshold d", metres(state.show.threshold)});
    facts.push_back({"Becomes low beyond", metres(band.outer)});
    facts.push_back({"Becomes high within", metres(band.inner)});
    facts.push_back({"Level by distance", std::string(lod::level_name(simulation.level()))});
    facts.push_back({"Switched", std::to_string(simulation.level_switches()) + " times"});
    facts.push_back({"Triangles, high", std::to_string(triangles(simulation, lod::Level::high))});
    facts.push_back({"Triangles, low", std::to_string(triangles(simulation, lod::Level::low))});
}

bool is_one_of(std::string_view id, std::initializer_list<std::string_view> ids)
{
    for (std::string_view one : ids) {
        if (id == one) {
            return true;
        }
    }
    return false;
}

void add_of_figure(std::vector<Fact>& facts, const Simulation& simulation, std::string_view id)
{
    if (is_one_of(id, {"5a", "6"})) {
        add_hierarchy(facts, simulation);
    } else if (id[0] == '5' || id[0] == '7') {
        add_hits(facts, simulation);
    } else if (id == "8") {
        add_levels(facts, simulation);
    } else {
        add_assembly(facts, simulation);
    }
}

void add_of_task(std::vector<Fact>& facts, const Simulation& simulation, std::string_view id)
{
    if (id[0] == '1') {
        add_assembly(facts, simulation);
    } else if (id[0] == '3') {
        add_levels(facts, simulation);
    } else if (id == "2.1") {
        add_mesh_spheres(facts, simulation);
    } else if (id == "2.2") {
        add_hierarchy(facts, simulation);
    } else if (id == "2.6") {
        add_sparks(facts, simulation);
    } else {
        add_hits(facts, simulation);
    }
}

} // namespace

std::vector<Fact> facts(const Simulation& simulation)
{
    std::vector<Fact> facts;
    if (!simulation.state().task) {
        const lod::Level level = simulation.shown_level();
        facts.push_back({"Level", std::string(lod::level_name(level))});
        facts.push_back({"Triangles", std::to_string(triangles(simulation, level))});
        add_hits(facts, simulation);
    } else if (const Task& task = tasks()[*simulation.state().task]; task.kind == TaskKind::figure) {
        add_of_figure(facts, simulation, task.id);
    } else {
        add_of_task(facts, simulation, task.id);
    }
    if (simulation.assets().scale != 1.0) {
        facts.push_back({"Tank", "your own, scaled by " + base::factor_text(simulation.assets().scale)});
    }
    return facts;
}

std::size_t triangles_drawn(const Simulation& simulation)
{
    const bool is_low_besides = simulation.state().show.detail == Detail::both;
    return triangles(simulation, simulation.shown_level()) +
           (is_low_besides ? triangles(simulation, lod::Level::low) : 0);
}

} // namespace app
