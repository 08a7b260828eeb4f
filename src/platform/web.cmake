find_package(SDL2 REQUIRED)
set_target_properties(SDL2::SDL2 PROPERTIES IMPORTED_GLOBAL TRUE) # WebPage.cmake links it, too

# scripts/cmake/WebPage.cmake makes the page of this target, with its link flags.
add_executable(tanklab
  capture_json.cpp
  check_assembly.cpp
  check_display_lists.cpp
  check_draw_obj.cpp
  check_joints.cpp
  check_json.cpp
  checks.cpp
  frame_capture.cpp
  input.cpp
  program.cpp
  web_bridge.cpp
  web_canvas.cpp
  web_page.cpp)
target_link_libraries(tanklab PRIVATE app scene legacygl SDL2::SDL2)
