# What `cmake --install` leaves behind: the program, and parmesan::mesher, ::fem, ::adapt for find_package(parmesan).
include(CMakePackageConfigHelpers)

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/parmesan)
install(TARGETS parmesan_mesher parmesan_fem parmesan_adapt EXPORT parmesan)
foreach(module IN ITEMS mesher fem adapt)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${module} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/parmesan
          FILES_MATCHING PATTERN "*.h")
endforeach()
install(EXPORT parmesan NAMESPACE parmesan:: FILE parmesan-targets.cmake DESTINATION ${config_dir})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/parmesan-config.cmake.in
                              ${PROJECT_BINARY_DIR}/parmesan-config.cmake INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/parmesan-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/parmesan-config.cmake ${PROJECT_BINARY_DIR}/parmesan-config-version.cmake
        DESTINATION ${config_dir})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
