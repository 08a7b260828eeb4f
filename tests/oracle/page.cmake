# The scenes as one page, in ${CMAKE_CURRENT_BINARY_DIR}/page; tests/page/oracle.test.mjs opens it.
set(site ${CMAKE_CURRENT_BINARY_DIR}/page)
add_executable(oracle_page page_main.cpp drawing.cpp scene.cpp ${scene_sources} ${PROJECT_SOURCE_DIR}/src/platform/files/asset_files.cpp)
target_include_directories(oracle_page PRIVATE . ${PROJECT_SOURCE_DIR}/src)
target_link_libraries(oracle_page PRIVATE legacygl scene)
file(GLOB_RECURSE asset_files CONFIGURE_DEPENDS ${assets}/*)
include(WebModule)
tanklab_web_module(oracle_page UTF8ToString HEAPU8)
target_link_options(oracle_page PRIVATE ${tanklab_webgl2} -sEXPORT_ES6 --no-entry --preload-file "${assets}@/assets")
set_target_properties(oracle_page PROPERTIES
  OUTPUT_NAME oracle
  RUNTIME_OUTPUT_DIRECTORY ${site}
  LINK_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/page.html;${asset_files}")
add_custom_command(TARGET oracle_page POST_BUILD
  COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_CURRENT_SOURCE_DIR}/page.html ${site}/index.html)
