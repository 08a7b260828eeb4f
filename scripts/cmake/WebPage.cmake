# How the executable `tanklab` becomes a page. The root CMakeLists.txt calls it for the target that
# src/platform makes; nothing there needs to know.
#
# Out comes an ES module, tanklab.js, with one default export: an async function that takes
#   canvas       the canvas; its id has to be "canvas"
#   wasmBinary   the bytes of tanklab.wasm (the page fetches them itself, to show the progress)
#   print, printErr, onAbort, noInitialRun   as Emscripten describes them
# and gives the module with what is listed below, and _name for each EMSCRIPTEN_KEEPALIVE function.
#
# The program runs its frames by emscripten_request_animation_frame_loop: emscripten_set_main_loop does the
# same and brings 5 KB of gzipped script along.

include(WebModule)
set(tanklab_runtime_methods ccall UTF8ToString stringToUTF8 lengthBytesUTF8 callMain HEAPU8)
set(tanklab_exported_functions _main _malloc _free)

# Applies the link flags of the page to a target. The optimisation is that of the build type.
function(tanklab_link_for_web target)
  tanklab_web_module(${target} ${tanklab_runtime_methods})
  list(JOIN tanklab_exported_functions "," functions)
  target_link_options(${target} PRIVATE ${tanklab_webgl2}
    -sEXPORT_ES6 -sEXPORT_NAME=createTanklab
    -sFILESYSTEM=0                      # files come through tanklab_add_file
    -sMALLOC=emmalloc                   # 3 KB smaller; a steady frame allocates nothing
    -sGL_TRACK_ERRORS=0                 # legacygl keeps the errors that glGetError tells
    -sHTML5_SUPPORT_DEFERRING_USER_SENSITIVE_REQUESTS=0 # the page asks for full screen itself
    -sTEXTDECODER=2                     # every browser with WebGL 2 has one
    -sINCOMING_MODULE_JS_API=canvas,wasmBinary,print,printErr,onAbort,noInitialRun
    -sEXPORTED_FUNCTIONS=${functions})
endfunction()

# Makes the page of the target: the target `page`, built by default, assembles build/web.
function(tanklab_web_page target)
  tanklab_link_for_web(${target})
  set_target_properties(${target} PROPERTIES
    OUTPUT_NAME tanklab
    RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/wasm")
  set(site "${PROJECT_SOURCE_DIR}/build/web" CACHE PATH "Where the static site goes")
  set(program "${CMAKE_BINARY_DIR}/wasm/tanklab.js")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/web/*" "${PROJECT_SOURCE_DIR}/assets/*")
  add_custom_command(
    OUTPUT "${CMAKE_BINARY_DIR}/page.stamp"
    COMMAND "${TANKLAB_NODE}" "${PROJECT_SOURCE_DIR}/scripts/assemble-page.mjs"
      --web "${PROJECT_SOURCE_DIR}/web" --assets "${PROJECT_SOURCE_DIR}/assets" --program "${program}" --out "${site}"
    COMMAND "${CMAKE_COMMAND}" -E touch "${CMAKE_BINARY_DIR}/page.stamp"
    DEPENDS ${target} "${PROJECT_SOURCE_DIR}/scripts/assemble-page.mjs" ${sources}
    COMMENT "Assembling the page in ${site}"
    VERBATIM)
  add_custom_target(page ALL DEPENDS "${CMAKE_BINARY_DIR}/page.stamp")

  # The same program with the names of its imports left whole, as -sASSERTIONS leaves them: a test reads
  # them. A GL name there is one that legacygl forgot and Emscripten's own quietly took.
  get_target_property(sources ${target} SOURCES)
  get_target_property(folder ${target} SOURCE_DIR)
  get_target_property(libraries ${target} LINK_LIBRARIES)
  list(TRANSFORM sources PREPEND "${folder}/" REGEX "^[^/$]")
  add_executable(tanklab_named_imports ${sources})
  if(libraries)
    target_link_libraries(tanklab_named_imports PRIVATE ${libraries})
  endif()
  target_include_directories(tanklab_named_imports PRIVATE $<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>)
  target_compile_definitions(tanklab_named_imports PRIVATE $<TARGET_PROPERTY:${target},COMPILE_DEFINITIONS>)
  tanklab_link_for_web(tanklab_named_imports)
  target_link_options(tanklab_named_imports PRIVATE $<TARGET_PROPERTY:${target},LINK_OPTIONS> -sASSERTIONS)
  set_target_properties(tanklab_named_imports PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/wasm")
endfunction()
