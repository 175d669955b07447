# The target `thesis_experiments` (tools/thesis), which tools/thesis/reproduce runs; built with the slow tests, else when
# asked for.
parmesan_sources(thesis_sources tools/thesis/*.cpp)
add_executable(thesis_experiments EXCLUDE_FROM_ALL ${thesis_sources})
if(PARMESAN_BUILD_TESTS AND NOT PARMESAN_TEST_FILTER MATCHES "slow")
  set_target_properties(thesis_experiments PROPERTIES EXCLUDE_FROM_ALL OFF)
endif()
target_link_libraries(thesis_experiments PRIVATE parmesan_fem parmesan_mesher nlohmann_json::nlohmann_json)
target_include_directories(thesis_experiments PRIVATE ${PROJECT_SOURCE_DIR})
parmesan_compile_options(thesis_experiments)
target_precompile_headers(thesis_experiments PRIVATE <nlohmann/json.hpp>)
