#include "app/tasks.h"

namespace app {

namespace {

constexpr Task TASKS[] = {
    {.kind = TaskKind::task,
     .id = "1.1",
     .title = "Assemble the tank",
     .text =
         "Five meshes make eighteen parts, and the parts hang in a tree: the body carries the turret and the "
         "wheels, the turret carries both guns. Turn the tank and everything turns; turn the turret and the "
         "guns go "
         "along, the wheels do not.",
     .commands = {"turn_left", "turn_right", "turret_left", "turret_right"},
     .link = "turret=40&gun=6&secondary_gun=-30&orbit=-25&tilt=22&distance=12&look_x=1&look_y=1.2&look_z=0.5",
     .source = "src/scene/draw_tank.cpp"},
    {.kind = TaskKind::task,
     .id = "1.2",
     .title = "Rotate turret, guns and wheels",
     .text = "Two keys for each part turn it one way and the other, about its own axis and pivot. The guns "
             "stop at "
             "their limits; the turret and the wheels go all the way round.",
     .commands = {"turret_left", "turret_right", "gun_up", "gun_down", "secondary_gun_left",
                  "secondary_gun_right", "wheels_forward", "wheels_backward"},
     .link = "orbit=62&tilt=12",
     .source = "src/app/commands.cpp"},
    {.kind = TaskKind::task,
     .id = "1.3",
     .title = "A display list for every part",
     .text = "Every mesh is compiled into a display list of its own once; a frame only pushes, moves, turns, "
             "calls "
             "the part's list and pops. The wheel's list is called fourteen times.",
     .commands = {"wheels_forward", "wheels_backward"},
     .link = "orbit=90&tilt=6&look_y=0.9&look_z=0",
     .source = "src/scene/tank_lists.cpp"},
    {.kind = TaskKind::task,
     .id = "1.4",
     .title = "Draw an OBJ mesh yourself",
     .text = "draw_obj walks the faces of a mesh; each corner has three indices of its own, for position, "
             "normal and "
             "texture coordinate. Come close and look at the edges and the paint.",
     .commands = {"orbit_left", "orbit_right", "zoom_in", "zoom_out"},
     .link = "orbit=30&tilt=24&distance=7.5&look_y=1.4&look_z=1",
     .source = "src/scene/draw_obj.cpp"},
};

} // namespace

std::span<const Task> tasks()
{
    return TASKS;
}

std::optional<std::size_t> find_task(TaskKind kind, std::string_view id)
{
    const std::span<const Task> all = tasks();
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].kind == kind && all[i].id == id) {
            return i;
        }
    }
    return std::nullopt;
}

} // namespace app
