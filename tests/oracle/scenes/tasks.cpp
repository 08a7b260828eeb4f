// What the program draws for every task and figure of the lab, for every preset of the particle system, and
// for states that no task has: a line through everything, a shot in flight, all of it as edges.

#include "app/links/tasks.h"
#include "particles/presets.h"
#include "scenes/program.h"

#include <algorithm>

namespace {

struct Named
{
    const char* name;
    const char* link;
};

constexpr Named OTHERS[] = {
    {"line_through_all", "task=2.5&probe=line&spheres=all&handle=line_b"},
    {"ray_low", "task=2.5&probe=ray&detail=low&axis=main_gun"},
    {"point_inside_triangles", "probe=point&point_x=0&point_y=1.1&point_z=0&triangles=on&distance=8"},
    {"shot", "task=2.6&tick=20"},
    {"sparks_late", "task=2.6&tick=52"},
    {"edges_of_both", "task=3.1&wireframe=on"},
};

[[maybe_unused]] const bool registered = [] {
    for (const app::Task& task : app::tasks()) {
        std::string id(task.id);
        std::replace(id.begin(), id.end(), '.', '_');
        const std::string kind(app::link_key(task.kind));
        oracle::add_link(kind + "_" + id, kind + "=" + std::string(task.id));
    }
    for (const particles::Preset& preset : particles::presets()) {
        oracle::add_link("particles_" + std::string(preset.id),
                         "distance=22&look_x=6&look_y=3&event=open&tick=150&particles=" +
                             std::string(preset.id));
    }
    for (const Named& other : OTHERS) {
        oracle::add_link(std::string("program_") + other.name, other.link);
    }
    return true;
}();

} // namespace
