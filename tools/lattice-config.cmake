# find_package(lattice) or find_package(lattice COMPONENTS core). The target lattice::core needs Eigen and threads
# only; lattice::lattice also GSL and Boost, which are looked for unless only `core` was asked for.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3)
find_dependency(Threads)
if(NOT lattice_FIND_COMPONENTS OR "lattice" IN_LIST lattice_FIND_COMPONENTS)
  find_dependency(GSL)
  find_dependency(Boost)
  set(lattice_lattice_FOUND TRUE)
endif()
include(${CMAKE_CURRENT_LIST_DIR}/lattice-targets.cmake)
set(lattice_core_FOUND TRUE)
