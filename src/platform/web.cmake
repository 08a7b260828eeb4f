# scripts/cmake/WebPage.cmake makes the page of this target, with its link flags.
add_executable(tanklab web_bridge.cpp web_canvas.cpp web_page.cpp)
target_link_libraries(tanklab PRIVATE platform_program platform_checks app scene legacygl)
