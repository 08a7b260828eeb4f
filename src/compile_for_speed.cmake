# Compiles source files of this folder for speed: what runs for each vertex, particle, test or number of a file.
#
# The page is built for size, and emcc's -Oz also forbids inlining, which -O3 alone does not allow again: a step of
# the particles took four times as long, a test of spheres ten times. Copying memory in one instruction and computing
# with four floats at once is in every browser that has WebGL 2, in Safari since 16.4.
function(compile_for_speed)
  if(EMSCRIPTEN)
    set(options -O3 -finline-functions -mbulk-memory -msimd128)
  else()
    set(options $<$<NOT:$<CONFIG:Debug>>:-O3>)
  endif()
  set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS "${options}")
endfunction()
