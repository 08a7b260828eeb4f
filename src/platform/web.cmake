# scripts/cmake/WebPage.cmake makes the page of this target, with its link flags.
add_executable(tanklab web/web_bridge.cpp web/web_canvas.cpp web/web_page.cpp)
target_link_libraries(tanklab PRIVATE platform_program checks app scene legacygl)
