#include "app/links/tasks.h"

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
     .source = "src/scene/tank/draw_tank.cpp"},
    {.kind = TaskKind::task,
     .id = "1.2",
     .title = "Rotate turret, guns and wheels",
     .text = "Two keys for each part turn it one way and the other, about its own axis and pivot. The guns "
             "stop at "
             "their limits; the turret and the wheels go all the way round.",
     .commands = {"turret_left", "turret_right", "gun_up", "gun_down", "secondary_gun_left",
                  "secondary_gun_right", "secondary_gun_up", "secondary_gun_down", "wheels_forward",
                  "wheels_backward"},
     .link = "orbit=62&tilt=12&axis=moving",
     .source = "src/app/commands/commands.cpp"},
    {.kind = TaskKind::task,
     .id = "1.3",
     .title = "A display list for every part",
     .text = "Every mesh is compiled into a display list of its own once; a frame only pushes, moves, turns, "
             "calls "
             "the part's list and pops. The wheel's list is called fourteen times.",
     .commands = {"wheels_forward", "wheels_backward"},
     .link = "orbit=90&tilt=6&look_y=0.9&look_z=0",
     .source = "src/scene/tank/tank_lists.cpp"},
    {.kind = TaskKind::task,
     .id = "1.4",
     .title = "Draw an OBJ mesh yourself",
     .text = "draw_obj walks the faces of a mesh; each corner has three indices of its own, for position, "
             "normal and "
             "texture coordinate. Come close and look at the edges and the paint.",
     .commands = {"orbit_left", "orbit_right", "zoom_in", "zoom_out"},
     .link = "orbit=30&tilt=24&distance=7.5&look_y=1.4&look_z=1",
     .source = "src/scene/tank/draw_obj.cpp"},
    {.kind = TaskKind::task,
     .id = "2.1",
     .title = "A bounding sphere from a mesh",
     .text =
         "The centre is the average of all vertices, the radius the largest distance from there to one of "
         "them. The smallest sphere around the same vertices is a little tighter; compare the two.",
     .commands = {"next_fit", "next_parts", "orbit_left", "orbit_right"},
     .link = "tilt=10&distance=15&look_y=1&look_z=0&spheres=parts&parts=body",
     .source = "src/collision/bounding_sphere.cpp"},
    {.kind = TaskKind::task,
     .id = "2.2",
     .title = "A sphere for every part and one for the whole tank",
     .text = "Eighteen spheres, one around each part, and one around all of these. Turn the turret or drive "
             "the wheels round: every sphere goes with its part.",
     .commands = {"turret_left", "turret_right", "gun_up", "gun_down", "turn_left", "turn_right",
                  "next_spheres"},
     .link = "distance=17.5&look_y=1.3&look_z=0.8&spheres=all",
     .source = "src/app/simulation/tank_spheres.cpp"},
    {.kind = TaskKind::task,
     .id = "2.3",
     .title = "Test a point",
     .text = "The point is tested against the sphere of the whole tank first, and only if inside against "
             "those of the parts. Every sphere it penetrates is printed, with centre, radius, distance and "
             "depth.",
     .commands = {"projectile_left", "projectile_right", "projectile_up", "projectile_down",
                  "projectile_away", "projectile_nearer", "print_report"},
     .link = "distance=17&look_z=0.8&probe=point&point_x=1&point_y=2.6&point_z=1.5",
     .source = "src/app/simulation/hit_report.cpp"},
    {.kind = TaskKind::task,
     .id = "2.4",
     .title = "Show the point and what it penetrates",
     .text = "Move the point by keys or by dragging it, along all three axes. The spheres it is inside of "
             "appear, transparent, each level in its own colour.",
     .commands = {"projectile_left", "projectile_right", "projectile_up", "projectile_down",
                  "projectile_away", "projectile_nearer", "next_spheres"},
     .link = "distance=17&look_z=0.8&probe=point&point_x=1.6&point_y=0.6&point_z=2.2",
     .source = "src/app/simulation/simulation_frame.cpp"},
    {.kind = TaskKind::task,
     .id = "2.5",
     .title = "Test a line",
     .text = "For every sphere the point of the line closest to its centre is found and tested; those points "
             "are marked. Move either end, and try the ray and the line without ends.",
     .commands = {"next_handle", "next_probe", "projectile_left", "projectile_right", "projectile_up",
                  "projectile_down", "projectile_away", "projectile_nearer"},
     .link = "distance=17.5&look_z=0.8&probe=segment&handle=line_a",
     .source = "src/collision/closest_point.h"},
    {.kind = TaskKind::task,
     .id = "2.6",
     .title = "Sparks where the projectile hits",
     .text =
         "Fire the projectile along its line: where it touches the sphere of a part there is one burst of "
         "sparks, and a weak shower while it stays inside. They fall, bounce on the ground and go out.",
     .commands = {"fire", "fire_at_aim", "next_handle", "projectile_left", "projectile_right",
                  "projectile_up", "projectile_down", "next_particles"},
     .link = "distance=14&look_z=0.8&line_ax=10&line_ay=2.4&line_az=2&line_bx=0&line_by=2.4&line_bz=1"
             "&speed=5&event=fire&tick=82",
     .source = "src/app/simulation/sparks.cpp"},
    {.kind = TaskKind::task,
     .id = "3.1",
     .title = "Assemble the low-detail tank",
     .text =
         "On the right the low model: the same tree and joints, a tenth of the triangles, no light and no "
         "texture: glColor3ub gives each corner the mean of the paint there, in the sun. Turn something: "
         "both do the same.",
     .commands = {"turret_left", "turret_right", "gun_up", "gun_down", "turn_left", "turn_right",
                  "next_detail"},
     .link = "heading=-16&orbit=0&tilt=20&distance=14.5&look_x=1.9&look_y=1.2&look_z=0&detail=both",
     .source = "src/scene/tank/draw_tank.cpp"},
    {.kind = TaskKind::task,
     .id = "3.2",
     .title = "Find the distance at which no difference shows",
     .text = "The low tank alone, seen by the handout's camera along -Z. Move it away, change between the "
             "models, and where you see no change any more note the distance: it is the threshold d.",
     .commands = {"zoom_out", "zoom_in", "next_detail", "note_threshold"},
     .link = "heading=-30&orbit=0&tilt=0&distance=30&look_z=0&detail=low",
     .source = "src/lod/threshold_search.cpp"},
    {.kind = TaskKind::task,
     .id = "3.3",
     .title = "Switch the level at the threshold",
     .text =
         "Beyond the threshold distance the low model is drawn, inside it the high one. Go further and come "
         "back: each crossing switches once, a little trembling about d does not. Here d is so near that "
         "the eye sees the switch; the d of task 3.2, which the program begins with, is where it does not.",
     .commands = {"zoom_out", "zoom_in", "next_detail", "note_threshold"},
     .link = "heading=-30&orbit=0&tilt=0&distance=20&look_z=0&threshold=21",
     .source = "src/lod/level_selector.cpp"},
    {.kind = TaskKind::figure,
     .id = "1",
     .title = "The tank as wireframe",
     .text =
         "The edges of the high model's faces, in four viewports: from the front, from the left, from above, "
         "and in perspective. Go round it, or turn something: all four show it.",
     .commands = {"orbit_left", "orbit_right", "tilt_up", "turret_left", "gun_up", "toggle_wireframe",
                  "next_view"},
     .link = "view=four&ground=off&wireframe=on",
     .source = "src/scene/scene_renderer.cpp"},
    {.kind = TaskKind::figure,
     .id = "2",
     .title = "The hierarchy of parts",
     .text = "The tree: the body carries the turret and fourteen wheels, the turret carries both guns. Turn "
             "one: the tree and its axis show what moves, and what comes along.",
     .commands = {"turn_left", "turret_left", "gun_up", "secondary_gun_left", "secondary_gun_up",
                  "wheels_forward", "next_axis"},
     .link = "turret=50&gun=10&secondary_gun=-40&orbit=30&tilt=35&distance=13&axis=moving",
     .source = "src/tank/layout.cpp"},
    {.kind = TaskKind::figure,
     .id = "3",
     .title = "The body alone",
     .text = "Only the first part of the tree is drawn. Draw the others one by one.",
     .commands = {"next_parts"},
     .link = "parts=body",
     .source = "src/scene/tank/draw_tank.cpp"},
    {.kind = TaskKind::figure,
     .id = "4",
     .title = "Side view, and the axis of the secondary gun",
     .text = "The secondary gun turns about (0, 1, 0) through a pivot of its own on the turret's roof, not "
             "about the origin of its mesh.",
     .commands = {"secondary_gun_left", "secondary_gun_right", "next_axis"},
     .link = "orbit=90&tilt=0&look_y=1.8&look_z=0.5&axis=secondary_gun",
     .source = "src/tank/layout.cpp"},
    {.kind = TaskKind::figure,
     .id = "5a",
     .title = "The sphere of the whole tank",
     .text = "The first level of the hierarchy: one sphere around everything.",
     .commands = {"next_spheres", "turret_left"},
     .link = "distance=17&look_z=0.8&spheres=whole",
     .source = "src/collision/sphere_hierarchy.cpp"},
    {.kind = TaskKind::figure,
     .id = "5b",
     .title = "A point outside the tank's sphere",
     .text = "It is further from the centre than the radius, so nothing else needs to be tested.",
     .commands = {"projectile_down", "projectile_left", "print_report"},
     .link = "distance=18&look_z=0.8&probe=point&point_x=5.2&point_y=3.6&point_z=-2.4&spheres=whole",
     .source = "src/collision/sphere_hierarchy.cpp"},
    {.kind = TaskKind::figure,
     .id = "5c",
     .title = "A point inside the tank's sphere",
     .text = "It is inside, so the parts are tested, too; it is in none of them.",
     .commands = {"projectile_down", "projectile_left", "print_report"},
     .link = "distance=17&look_z=0.8&probe=point&point_x=3&point_y=4&point_z=3&spheres=whole",
     .source = "src/collision/sphere_hierarchy.cpp"},
    {.kind = TaskKind::figure,
     .id = "5d",
     .title = "A point inside the tank's sphere and those of parts",
     .text = "It is inside the first level and penetrates spheres of the second one.",
     .commands = {"projectile_up", "projectile_right", "print_report"},
     .link = "distance=17&look_z=0.8&probe=point&point_x=1&point_y=2.6&point_z=1.5&spheres=whole",
     .source = "src/collision/sphere_hierarchy.cpp"},
    {.kind = TaskKind::figure,
     .id = "6",
     .title = "A sphere for each part",
     .text = "The second level of the hierarchy: eighteen spheres, which follow the joints.",
     .commands = {"turret_left", "gun_up", "next_spheres"},
     .link = "distance=16&look_z=0.8&spheres=parts",
     .source = "src/app/simulation/tank_spheres.cpp"},
    {.kind = TaskKind::figure,
     .id = "7a",
     .title = "A point inside the main sphere",
     .text = "The test of the first level: the point is inside the sphere of the whole tank.",
     .commands = {"next_figure", "print_report"},
     .link = "distance=17&look_z=0.8&probe=point&point_x=0.9&point_y=3.4&point_z=1&spheres=whole",
     .source = "src/collision/sphere_hierarchy.cpp"},
    {.kind = TaskKind::figure,
     .id = "7b",
     .title = "The point is processed at the second level",
     .text = "Because it was inside the main sphere, the same point is tested against the sphere of every "
             "part.",
     .commands = {"next_figure", "print_report"},
     .link = "distance=17&look_z=0.8&probe=point&point_x=0.9&point_y=3.4&point_z=1&spheres=all",
     .source = "src/collision/sphere_hierarchy.cpp"},
    {.kind = TaskKind::figure,
     .id = "7c",
     .title = "The point is inside the turret's sphere",
     .text = "Of the second level the turret's sphere, and the body's, contain the point: it may have hit "
             "them.",
     .commands = {"next_figure", "print_report"},
     .link = "distance=17&look_z=0.8&probe=point&point_x=0.9&point_y=3.4&point_z=1",
     .source = "src/collision/sphere_hierarchy.cpp"},
    {.kind = TaskKind::figure,
     .id = "7d",
     .title = "The point is rejected against the triangles",
     .text = "Against the triangles of the parts whose spheres contain it the same point is outside: it has "
             "hit nothing. The nearest triangles are marked.",
     .commands = {"toggle_triangles", "projectile_down", "print_report"},
     .link = "distance=9&look_y=2.4&look_z=0.6&probe=point&point_x=0.9&point_y=3.4&point_z=1&triangles=on",
     .source = "src/app/simulation/tank_triangles.cpp"},
    {.kind = TaskKind::figure,
     .id = "8",
     .title = "The high and the low body",
     .text = "Side by side: the body of the high model, and that of the low one on the right.",
     .commands = {"orbit_left", "orbit_right", "next_parts"},
     .link = "orbit=0&tilt=24&distance=12.5&look_x=2.75&look_y=0.8&look_z=0&detail=both&parts=body",
     .source = "src/scene/tank/draw_tank.cpp"},
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
