# How the project's own targets are compiled, and how a module becomes a target.

# The files below the root that match the patterns, looked up again at each build.
function(parmesan_sources variable)
  list(TRANSFORM ARGN PREPEND ${PROJECT_SOURCE_DIR}/)
  file(GLOB_RECURSE found CONFIGURE_DEPENDS ${ARGN})
  set(${variable} ${found} PARENT_SCOPE)
endfunction()

# Warnings, sanitizers, and no contraction to fused multiply-add: it changes the mesh between builds.
function(parmesan_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
  target_compile_definitions(${target} PRIVATE PARMESAN_VERSION="${PROJECT_VERSION}")
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # false alarms on string + string, GCC bug 105651
    target_compile_options(${target} PRIVATE -Wno-restrict -Wno-stringop-overflow -Wno-array-bounds)
  endif()
  if(CMAKE_UNITY_BUILD)
    target_compile_options(${target} PRIVATE -Wno-shadow)  # by names of the file before
  endif()
  if(NOT OpenMP_CXX_FOUND)
    target_compile_options(${target} PRIVATE -Wno-unknown-pragmas)
  endif()
  if(PARMESAN_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(PARMESAN_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=address,undefined -fno-sanitize-recover=all
                                             -fno-omit-frame-pointer)
    target_compile_definitions(${target} PRIVATE PARMESAN_SANITIZE _GLIBCXX_ASSERTIONS)
    target_link_options(${target} PRIVATE -fsanitize=address,undefined)
  endif()
endfunction()

# parmesan_module(NAME LIBRARY...): the folder NAME as the static library parmesan::NAME.
function(parmesan_module name)
  parmesan_sources(sources ${name}/*.cpp)
  add_library(parmesan_${name} STATIC ${sources})
  parmesan_compile_options(parmesan_${name})
  add_library(parmesan::${name} ALIAS parmesan_${name})
  set_target_properties(parmesan_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(parmesan_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                                                     $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/parmesan>)
  target_link_libraries(parmesan_${name} PUBLIC ${ARGN})
endfunction()
