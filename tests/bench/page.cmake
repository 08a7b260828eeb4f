# The page that scripts/bench opens, in ${CMAKE_CURRENT_BINARY_DIR}/page. The emulation fails as an ES module, so
# both programs are plain scripts.
include(WebModule)
set(site ${CMAKE_CURRENT_BINARY_DIR}/page)
function(add_bench_page name export)
  add_executable(${name} ${ARGN})
  target_include_directories(${name} PRIVATE .)
  tanklab_web_module(${name} ccall HEAPU8 HEAPF32)
  target_link_options(${name} PRIVATE -sEXPORT_NAME=${export} --no-entry)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${site})
endfunction()
add_bench_page(opengl_bench createLegacygl page_main.cpp immediate.cpp lists.cpp)
target_link_libraries(opengl_bench PRIVATE legacygl)
target_link_options(opengl_bench PRIVATE ${tanklab_webgl2} -sGL_TRACK_ERRORS=0)

add_bench_page(opengl_bench_emscripten createEmscripten page_main.cpp immediate.cpp)
target_compile_definitions(opengl_bench_emscripten PRIVATE BENCH_EMSCRIPTEN)
target_link_options(opengl_bench_emscripten PRIVATE -sLEGACY_GL_EMULATION)

add_bench_page(reading_bench createReading page/reading_main.cpp)
target_link_libraries(reading_bench PRIVATE scene legacygl)
target_link_options(reading_bench PRIVATE ${tanklab_webgl2} -sGL_TRACK_ERRORS=0)

set(page_files index.html page.js webgl_lists.js reading.html)
list(TRANSFORM page_files PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/page/)
set_target_properties(opengl_bench PROPERTIES LINK_DEPENDS "${page_files}")
add_custom_command(TARGET opengl_bench POST_BUILD
  COMMAND ${CMAKE_COMMAND} -E copy ${page_files} ${site})
