# Small faults, two for each task of the lab, that the task's check has to find. Each is one replacement in one
# file; the checks know nothing of them.
#
#   tanklab_mutant(ID FILE FAULT OLD NEW)
#
# ID: the task and a letter. FILE: relative to src/. OLD has to stand in it exactly once.
#
# With -DTANKLAB_MUTANT=ID the programs, the page too, are built with that fault in them; TANKLAB_MUTANTS builds a
# test for each (tests/mutants/CMakeLists.txt).

# Writes the faulty copy of a file where the file of that name would be, below `folder`; sets `result` to it.
function(tanklab_write_mutant folder file old new result)
  set(source ${PROJECT_SOURCE_DIR}/src/${file})
  set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
  file(READ ${source} text)
  string(FIND "${text}" "${old}" first)
  string(FIND "${text}" "${old}" last REVERSE)
  if(first EQUAL -1 OR NOT first EQUAL last)
    message(FATAL_ERROR "The mutant of src/${file} replaces a text that does not stand there exactly once: ${old}")
  endif()
  string(REPLACE "${old}" "${new}" text "${text}")
  set(copy ${folder}/${file})
  if(EXISTS ${copy})
    file(READ ${copy} before)
  endif()
  if(NOT "${before}" STREQUAL "${text}")
    file(WRITE ${copy} "${text}")
  endif()
  set(${result} ${copy} PARENT_SCOPE)
endfunction()

# Calls tanklab_mutant for each. Definitions of that function differ; the list is this one.
macro(tanklab_for_each_mutant)
  tanklab_mutant(1.1a scene/tank/draw_tank.cpp "The turret does not carry the main gun."
    [=[    glPushMatrix();
    glTranslatef(placement.pivot.x]=]
    [=[    glPushMatrix();
    if (part == tank::Part::main_gun) {
        glRotatef(-degrees(joints_[tank::Joint::turret]), 0.0f, 1.0f, 0.0f);
    }
    glTranslatef(placement.pivot.x]=])
  tanklab_mutant(1.1b scene/tank/draw_tank.cpp "The last wheel is not drawn."
    [=[if (parts_.contains(tank::index_of(part))) {]=]
    [=[if (parts_.contains(tank::index_of(part)) && part != tank::Part::wheel_right_7) {]=])
  tanklab_mutant(1.2a scene/tank/draw_tank.cpp "The main gun turns to the side instead of up."
    [=[placement.axis.x, placement.axis.y, placement.axis.z);]=]
    [=[part == tank::Part::main_gun ? 0.0f : placement.axis.x,
              part == tank::Part::main_gun ? 1.0f : placement.axis.y, placement.axis.z);]=])
  tanklab_mutant(1.2b scene/tank/draw_tank.cpp "The wheels turn backwards."
    [=[glRotatef(degrees(joints_[placement.joint]),]=]
    [=[glRotatef((part >= tank::Part::wheel_left_1 ? -1.0f : 1.0f) * degrees(joints_[placement.joint]),]=])
  tanklab_mutant(1.3a scene/tank/tank_lists.cpp "The list of one mesh is empty."
    [=[        draw(objs[i]);]=]
    [=[        if (i != 3) {
            draw(objs[i]);
        }]=])
  tanklab_mutant(1.3b scene/scene_renderer.cpp "The lists are compiled again for every frame."
    [=[    use_tank_material();]=]
    [=[    use_tank_material();
    const_cast<TankLists&>(tank_lists_).load_tank_objs(assets_->high);]=])
  tanklab_mutant(1.4a scene/tank/draw_obj.cpp "Normals are looked up by the position's index."
    [=[obj.normals[corner.normal];]=]
    [=[obj.normals[static_cast<std::size_t>(corner.position) % obj.normals.size()];]=])
  tanklab_mutant(1.4b scene/tank/draw_obj.cpp "The texture is upside down."
    [=[glTexCoord2f(texture_coordinate.x, texture_coordinate.y);]=]
    [=[glTexCoord2f(texture_coordinate.x, 1.0f - texture_coordinate.y);]=])

  tanklab_mutant(2.1a collision/bounding_sphere.cpp "The average is taken over one vertex too many."
    [=[sum / count;]=]
    [=[sum / (count + 1.0);]=])
  tanklab_mutant(2.1b collision/bounding_sphere.cpp "The last vertex's distance is the radius."
    [=[radius = std::max(radius, distance_up(centre, point));]=]
    [=[radius = distance_up(centre, point);]=])
  tanklab_mutant(2.2a collision/sphere_hierarchy.cpp "The wheels' spheres stay where they were."
    [=[if (part_matrices[i] == matrices_[i]) {]=]
    [=[if (part_matrices[i] == matrices_[i] || i >= 4) {]=])
  tanklab_mutant(2.2b collision/sphere_hierarchy.cpp "The sphere around the whole is fitted once."
    [=[if (has_moved) {]=]
    [=[if (has_moved && counts_.roots == 0) {]=])
  tanklab_mutant(2.3a collision/sphere_hierarchy.cpp "The guns are tested only behind the turret."
    [=[if (result.parts.back().is_inside) {]=]
    [=[if (result.parts.back().is_inside && ((i != 2 && i != 3) || result.hits.contains(1))) {]=])
  tanklab_mutant(2.3b collision/sphere_hierarchy.cpp "A squared distance is compared with a radius."
    [=[-1.0 : reach * reach};]=]
    [=[-1.0 : reach};]=])
  tanklab_mutant(2.4a scene/markers/spheres.cpp "Penetrated spheres are opaque."
    [=[(sphere.is_root ? ROOT_OPACITY : PART_OPACITY).*use);]=]
    [=[255);]=])
  tanklab_mutant(2.4b scene/markers/spheres.cpp "Penetrated spheres are drawn with a radius of one metre."
    [=[shapes.draw_sphere(sphere.centre, sphere.radius);]=]
    [=[shapes.draw_sphere(sphere.centre, 1.0);]=])
  tanklab_mutant(2.5a collision/sphere_hierarchy.cpp "A segment has no ends."
    [=[return closest_point_on_segment(centre, a, b);]=]
    [=[return closest_point_on_line(centre, a, b - a);]=])
  tanklab_mutant(2.5b collision/sphere_hierarchy.cpp "A ray goes backwards, too."
    [=[return closest_point_on_ray(centre, origin, direction);]=]
    [=[return closest_point_on_line(centre, origin, direction);]=])
  tanklab_mutant(2.6a particles/particle_system.cpp "What releases once never stops."
    [=[settings_.releases = releases;]=]
    [=[settings_.releases = settings_.releases || releases;]=])
  tanklab_mutant(2.6b particles/particle_system.cpp "Nothing falls."
    [=[return {glm::dvec3{settings_.gravity} +]=]
    [=[return {glm::dvec3{0.0} +]=])

  tanklab_mutant(3.1a scene/tank/draw_tank.cpp "The low tank's joints stay at rest."
    [=[    const Disabled texture(GL_TEXTURE_2D);
    draw_at(]=]
    [=[    const Disabled texture(GL_TEXTURE_2D);
    const tank::JointAngles rest{};
    TankDrawing(lists_, layout_, rest, parts_).draw_at(]=])
  tanklab_mutant(3.1b scene/tank/draw_tank.cpp "The low tank is lit."
    [=[    const Disabled lighting(GL_LIGHTING);
]=]
    "")
  tanklab_mutant(3.2a scene/scene_renderer.cpp "The far plane is where the handout has it."
    [=[                   camera.far_plane);]=]
    [=[                   100.0);]=])
  tanklab_mutant(3.2b scene/tank/draw_low_obj.cpp "The low tank is white."
    [=[glColor3ub(colour.red, colour.green, colour.blue);]=]
    [=[glColor3ub(255, 255, 255);]=])
  tanklab_mutant(3.3a lod/level_selector.cpp "The level has no memory."
    [=[    if (distance > band.outer) {]=]
    [=[    return level_at(distance, 0.5 * (band.inner + band.outer));
    if (distance > band.outer) {]=])
  tanklab_mutant(3.3b lod/level_selector.cpp "What has become low stays so."
    [=[    if (distance < band.inner) {
        return Level::high;
    }]=]
    "")
endmacro()
