# The target `delaunay_speed` (tools/bench): our triangulations beside CGAL's, where CGAL is found.
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
find_package(CGAL 5.5 QUIET)
add_executable(delaunay_speed EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/tools/bench/delaunay_speed.cpp
                                               ${PROJECT_SOURCE_DIR}/tools/bench/point_sets.cpp)
target_link_libraries(delaunay_speed PRIVATE parmesan_mesher)
if(CGAL_FOUND)
  target_sources(delaunay_speed PRIVATE ${PROJECT_SOURCE_DIR}/tools/bench/cgal_delaunay.cpp)
  target_link_libraries(delaunay_speed PRIVATE CGAL::CGAL)
else()
  target_sources(delaunay_speed PRIVATE ${PROJECT_SOURCE_DIR}/tools/bench/cgal_absent.cpp)
endif()
parmesan_compile_options(delaunay_speed)

# The target `fem_speed`: assembly and solvers by size.
add_executable(fem_speed EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/tools/bench/fem_speed.cpp)
target_link_libraries(fem_speed PRIVATE parmesan_fem)
parmesan_compile_options(fem_speed)

# The target `recovery_methods`: methods of Hessian recovery side by side.
add_executable(recovery_methods EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/tools/bench/recovery_methods.cpp)
target_link_libraries(recovery_methods PRIVATE parmesan_adapt)
target_compile_definitions(recovery_methods PRIVATE PARMESAN_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
parmesan_compile_options(recovery_methods)
