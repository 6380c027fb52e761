# find_package(lattice) or find_package(lattice COMPONENTS core). The target lattice::core needs
# Eigen only; lattice::lattice also GSL, Boost and threads, which are looked for unless only `core`
# was asked for.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3)
include(${CMAKE_CURRENT_LIST_DIR}/lattice-core.cmake)
set(lattice_core_FOUND TRUE)
if(NOT lattice_FIND_COMPONENTS OR "lattice" IN_LIST lattice_FIND_COMPONENTS)
  find_dependency(GSL)
  find_dependency(Threads)
  find_dependency(Boost)
  include(${CMAKE_CURRENT_LIST_DIR}/lattice-lattice.cmake)
  set(lattice_lattice_FOUND TRUE)
endif()
