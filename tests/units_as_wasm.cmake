# The units' tests as WebAssembly: one test a unit, wasm/UNIT, since Node takes longer to start than most tests to run.
# The units are compiled as the page has them; the tests themselves in the way that takes least time.

# From the source, which Debian's libgtest-dev brings; its own CMakeLists.txt insists on exceptions.
find_path(TANKLAB_GTEST_SOURCE src/gtest-all.cc PATHS /usr/src/googletest/googletest NO_DEFAULT_PATH
  NO_CMAKE_FIND_ROOT_PATH REQUIRED)
add_compile_options(-O1 -fno-lto)
# One file, since Node's fetch does not read files; the real file system, for what tests read.
add_link_options(-O1 -sENVIRONMENT=node -sSINGLE_FILE -sNODERAWFS -sEXIT_RUNTIME -sALLOW_MEMORY_GROWTH -sASSERTIONS)

add_library(gtest_main STATIC ${TANKLAB_GTEST_SOURCE}/src/gtest-all.cc ${TANKLAB_GTEST_SOURCE}/src/gtest_main.cc)
target_include_directories(gtest_main SYSTEM PUBLIC ${TANKLAB_GTEST_SOURCE}/include PRIVATE ${TANKLAB_GTEST_SOURCE})
target_compile_definitions(gtest_main PUBLIC GTEST_HAS_PTHREAD=0)
target_compile_options(gtest_main PRIVATE -w)
add_library(GTest::gtest_main ALIAS gtest_main)

function(gtest_discover_tests target)
  string(REGEX REPLACE "_test$" "" unit ${target})
  add_test(NAME wasm/${unit} COMMAND ${target})
endfunction()

foreach(folder allocation_count ${units})
  add_subdirectory(${folder})
endforeach()
set_target_properties(collision_bench particles_bench PROPERTIES EXCLUDE_FROM_ALL ON) # measured by hand
