# Toolchain file of the page: the emcc on the PATH, and nothing of the system's but what build/deps/web holds.
#
# emcmake is not used: it hands Node a flag that newer ones refuse.
get_filename_component(tanklab_root "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)
set(tanklab_web_dependencies "${tanklab_root}/build/deps/web")
if(NOT EXISTS "${tanklab_web_dependencies}/key")
  message(FATAL_ERROR "What the page is built with is not there yet: run scripts/setup web")
endif()

find_program(TANKLAB_EMCC emcc REQUIRED)
find_program(TANKLAB_NODE NAMES node nodejs REQUIRED)
set(CMAKE_CROSSCOMPILING_EMULATOR "${TANKLAB_NODE}" CACHE FILEPATH "Runs what is compiled")

# Debian's emcc links with its own acorn from -O2 on; a Node.js that is not Debian's does not look there.
if(EXISTS /usr/share/nodejs/acorn)
  set(ENV{NODE_PATH} "$ENV{NODE_PATH}:/usr/share/nodejs")
  foreach(language C CXX)
    set(CMAKE_${language}_LINKER_LAUNCHER "${CMAKE_COMMAND};-E;env;NODE_PATH=/usr/share/nodejs"
      CACHE STRING "Lets emcc find acorn")
  endforeach()
endif()

set(CMAKE_CXX_FLAGS_INIT "-fno-exceptions")
foreach(language C CXX)
  set(CMAKE_${language}_STANDARD_INCLUDE_DIRECTORIES "${tanklab_web_dependencies}/include")
endforeach()
set(CMAKE_FIND_ROOT_PATH "${tanklab_web_dependencies}")
set(SDL2_DIR "${tanklab_web_dependencies}/lib" CACHE PATH "SDL2 for the web")
set(glm_DIR "${tanklab_web_dependencies}/lib" CACHE PATH "GLM for the web")

get_filename_component(tanklab_emcc "${TANKLAB_EMCC}" REALPATH)
get_filename_component(EMSCRIPTEN_ROOT_PATH "${tanklab_emcc}" DIRECTORY)
include("${EMSCRIPTEN_ROOT_PATH}/cmake/Modules/Platform/Emscripten.cmake")
