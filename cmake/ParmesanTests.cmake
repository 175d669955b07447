# One executable per module, one ctest entry per test file: `tests_mesher -# [#metric.test]`.
find_package(Catch2 2.13 REQUIRED)

# What tests share. Compiling takes longer than running: -O1 for all of them.
parmesan_sources(support_sources tests/support/*.cpp tests/oracle/*.cpp)
list(FILTER support_sources EXCLUDE REGEX "\\.test\\.cpp$")
add_library(tests_support OBJECT ${support_sources})
target_link_libraries(tests_support PUBLIC parmesan_mesher Catch2::Catch2)
target_include_directories(tests_support PUBLIC ${PROJECT_SOURCE_DIR})
target_compile_definitions(tests_support PUBLIC PARMESAN_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
target_compile_options(tests_support PUBLIC -O1)
parmesan_compile_options(tests_support)
# Catch2 itself, which takes a minute to compile with sanitizers.
set_source_files_properties(${PROJECT_SOURCE_DIR}/tests/support/main.cpp PROPERTIES COMPILE_OPTIONS "-O0;-fno-sanitize=all")

# parmesan_tests(NAME LIBRARY): the files tests/NAME/**/*.test.cpp, and the other sources beside them.
function(parmesan_tests name library)
  parmesan_sources(sources tests/${name}/*.cpp)
  list(REMOVE_ITEM sources ${support_sources})
  add_executable(tests_${name} ${sources})
  target_link_libraries(tests_${name} PRIVATE tests_support ${library})
  parmesan_compile_options(tests_${name})
  target_precompile_headers(tests_${name} PRIVATE <catch2/catch.hpp>)
  list(FILTER sources INCLUDE REGEX "\\.test\\.cpp$")
  foreach(source IN LISTS sources)
    get_filename_component(file ${source} NAME_WLE)
    file(RELATIVE_PATH test ${PROJECT_SOURCE_DIR}/tests ${source})
    string(REGEX REPLACE "\\.test\\.cpp$" "" test ${test})
    add_test(NAME ${test} COMMAND tests_${name} -\# "[#${file}]${PARMESAN_TEST_FILTER}")
    set_tests_properties(${test} PROPERTIES TIMEOUT 900)
  endforeach()
endfunction()

parmesan_tests(oracle parmesan_mesher)
parmesan_tests(mesher parmesan_mesher)
parmesan_tests(fem parmesan_fem)
parmesan_tests(adapt parmesan_adapt)
target_include_directories(tests_adapt SYSTEM PRIVATE ${CAIRO_INCLUDE_DIR})  # reads PNG back
parmesan_tests(thesis parmesan_mesher)
target_sources(tests_thesis PRIVATE ${PROJECT_SOURCE_DIR}/tools/thesis/counted_walks.cpp)
parmesan_tests(system parmesan_adapt)
target_compile_definitions(tests_system PRIVATE PARMESAN_PROGRAM="$<TARGET_FILE:parmesan>")
add_dependencies(tests_system parmesan)
set_tests_properties(system/cases adapt/adapt_loop system/run_command PROPERTIES COST 100)  # the longest begin first

# The experiments of the thesis, small, with their laws.
find_package(Python3 COMPONENTS Interpreter)
if(Python3_FOUND AND NOT PARMESAN_TEST_FILTER MATCHES "slow")
  add_test(NAME thesis/reproduce
           COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/tools/thesis/reproduce --quick
                   --program $<TARGET_FILE:thesis_experiments> --out ${PROJECT_BINARY_DIR}/thesis.out)
endif()

# Pages in a browser; skipped, with a line that says so, where Node, playwright-core or Chromium is missing.
find_program(PARMESAN_NODE node)
function(parmesan_browser_test name)
  add_test(NAME browser/${name}
           COMMAND ${PARMESAN_NODE} ${PROJECT_SOURCE_DIR}/tests/browser/${name}.mjs ${ARGN}
                   ${PROJECT_BINARY_DIR}/browser/${name}
           WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
  set_tests_properties(browser/${name} PROPERTIES TIMEOUT 900 SKIP_RETURN_CODE 77)
endfunction()
if(PARMESAN_NODE)
  parmesan_browser_test(report $<TARGET_FILE:parmesan>)
  parmesan_browser_test(triangulator ${PROJECT_SOURCE_DIR}/tools/thesis/triangulator.html)
endif()
