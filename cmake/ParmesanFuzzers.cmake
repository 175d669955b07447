# tests/fuzz/NAME.cpp becomes fuzz_NAME; the target `fuzzers` builds them all.
add_custom_target(fuzzers)

# Fuzzers follow what the modules do that read files. Of the mesher, whose loops the tests of this build run for minutes,
# only which edges are taken, not what is compared.
target_compile_options(parmesan_mesher PRIVATE -fsanitize=fuzzer-no-link -fno-sanitize-coverage=trace-cmp)
target_compile_options(parmesan_adapt PRIVATE -fsanitize=fuzzer-no-link)

parmesan_sources(fuzz_sources tests/fuzz/*.cpp)
foreach(source IN LISTS fuzz_sources)
  get_filename_component(name ${source} NAME_WE)
  add_executable(fuzz_${name} EXCLUDE_FROM_ALL ${source})
  target_link_options(fuzz_${name} PRIVATE -fsanitize=fuzzer)
  # Only the topmost library the fuzzer includes is built and linked.
  file(STRINGS ${source} includes REGEX "^#include \"")
  if("${includes}" MATCHES "adapt/")
    target_link_libraries(fuzz_${name} PRIVATE parmesan_adapt)
  elseif("${includes}" MATCHES "fem/")
    target_link_libraries(fuzz_${name} PRIVATE parmesan_fem)
  else()
    target_link_libraries(fuzz_${name} PRIVATE parmesan_mesher)
  endif()
  parmesan_compile_options(fuzz_${name})
  add_dependencies(fuzzers fuzz_${name})
endforeach()
