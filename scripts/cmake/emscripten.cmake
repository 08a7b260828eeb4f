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

# What emcc needs besides itself, as use_emscripten of scripts/common.sh has it: Debian's acorn from -O2 on, where a
# Node.js that is not Debian's does not look, and a cache that it can write.
if(EXISTS /usr/share/nodejs/acorn)
  set(ENV{NODE_PATH} "$ENV{NODE_PATH}:/usr/share/nodejs")
  set(tanklab_emcc_environment NODE_PATH=/usr/share/nodejs)
endif()
if(DEFINED ENV{EM_CACHE})
  list(APPEND tanklab_emcc_environment "EM_CACHE=$ENV{EM_CACHE}")
endif()
if(tanklab_emcc_environment)
  foreach(language C CXX)
    set(CMAKE_${language}_LINKER_LAUNCHER "${CMAKE_COMMAND};-E;env;${tanklab_emcc_environment}"
      CACHE STRING "Gives emcc what it needs")
    if(DEFINED ENV{EM_CACHE})
      set(CMAKE_${language}_COMPILER_LAUNCHER "${CMAKE_${language}_LINKER_LAUNCHER}"
        CACHE STRING "Gives emcc what it needs")
    endif()
  endforeach()
endif()

set(CMAKE_CXX_FLAGS_INIT "-fno-exceptions")
# What 3.1.6 gives a program unasked; since 3.1.27 it would be 64 KB, which nobody guards. All know the setting's old name.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-sTOTAL_STACK=5MB")
foreach(language C CXX)
  set(CMAKE_${language}_STANDARD_INCLUDE_DIRECTORIES "${tanklab_web_dependencies}/include")
endforeach()
set(CMAKE_FIND_ROOT_PATH "${tanklab_web_dependencies}")
set(SDL2_DIR "${tanklab_web_dependencies}/lib" CACHE PATH "SDL2 for the web")

get_filename_component(tanklab_emcc "${TANKLAB_EMCC}" REALPATH)
get_filename_component(EMSCRIPTEN_ROOT_PATH "${tanklab_emcc}" DIRECTORY)
include("${EMSCRIPTEN_ROOT_PATH}/cmake/Modules/Platform/Emscripten.cmake")
