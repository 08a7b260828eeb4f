find_package(PkgConfig REQUIRED)
pkg_check_modules(EGL REQUIRED IMPORTED_TARGET GLOBAL egl)
pkg_check_modules(OPENGL REQUIRED IMPORTED_TARGET GLOBAL gl glu)

add_library(platform_files STATIC files/asset_files.cpp files/log_printer.cpp files/png_file.cpp program/arguments.cpp)
target_link_libraries(platform_files PUBLIC platform_link app)
target_include_directories(platform_files SYSTEM PRIVATE ${STB_INCLUDE_DIR})

# tanklab-render and tanklab-render-reference: one source, two libraries that define the same gl* symbols.
# The emulated one links no OpenGL of the system, so that a function legacygl lacks is a link error.
function(add_render_program name renderer gl_library)
  add_library(platform_offscreen_${renderer} STATIC
    offscreen/egl_context.cpp offscreen/leak_suppressions.cpp offscreen/offscreen_target_${renderer}.cpp)
  target_include_directories(platform_offscreen_${renderer} PUBLIC ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(platform_offscreen_${renderer} PUBLIC ${gl_library} PkgConfig::EGL)
  add_executable(${name} offscreen/render_main.cpp offscreen/render_options.cpp offscreen/threshold_measurement.cpp)
  target_link_libraries(${name} PRIVATE platform_files scene platform_offscreen_${renderer})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
endfunction()
add_render_program(tanklab-render-reference reference PkgConfig::OPENGL)
add_render_program(tanklab-render emulated legacygl)

add_executable(tanklab desktop/window_main.cpp desktop/window_options.cpp)
target_link_libraries(tanklab PRIVATE platform_program platform_files scene legacygl)
set_target_properties(tanklab PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
