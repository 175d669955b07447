# CHOLMOD and UMFPACK in place of Eigen's direct solvers. Both are GPL in part, and so is the program then.
find_path(SUITESPARSE_INCLUDE_DIR umfpack.h PATH_SUFFIXES suitesparse REQUIRED)
find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
find_library(UMFPACK_LIBRARY umfpack REQUIRED)
target_include_directories(parmesan_fem SYSTEM PRIVATE ${SUITESPARSE_INCLUDE_DIR})
target_compile_definitions(parmesan_fem PRIVATE PARMESAN_SUITESPARSE)
target_link_libraries(parmesan_fem PUBLIC ${CHOLMOD_LIBRARY} ${UMFPACK_LIBRARY})
