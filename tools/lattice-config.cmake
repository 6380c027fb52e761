# find_package(lattice) offers lattice::core, which needs Eigen and threads, and lattice::lattice, the whole, for who has GSL
# and Boost.
if(CMAKE_CURRENT_LIST_DIR MATCHES "[][*?]")
  set(lattice_NOT_FOUND_MESSAGE "CMake takes brackets in '${CMAKE_CURRENT_LIST_DIR}' for patterns (allowed: a prefix without)")
  set(lattice_FOUND FALSE)
  return()
endif()
include(CMakeFindDependencyMacro)
find_dependency(Eigen3)
find_dependency(Threads)
find_package(GSL QUIET)
find_package(Boost QUIET)
include(${CMAKE_CURRENT_LIST_DIR}/lattice-targets.cmake)
