# Installs the library to a fresh folder, builds examples/ against it and runs what was built.
include(${CMAKE_CURRENT_LIST_DIR}/../../tools/files_in.cmake)
set(place ${BUILD}/install-test)
if(place MATCHES "[][*?]")  # which the build may have, and a prefix may not
  string(MD5 place ${BUILD})
  set(place $ENV{TMPDIR}/lattice-${place})
endif()
file(REMOVE_RECURSE ${place})
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE code OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGV}\n${text}")
  endif()
  set(text "${text}" PARENT_SCOPE)
endfunction()
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${place}/prefix)
run(${CMAKE_COMMAND} -S ${EXAMPLES} -B ${place}/build -D CMAKE_PREFIX_PATH=${place}/prefix -D
    CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_FLAGS=-O0)
run(${CMAKE_COMMAND} --build ${place}/build)

# What each program says: the digits that do not depend on rounding
set(says
    "strike" "^boundary share 0\\.242[0-9]+\n$"
    "independent" "^difference [0-9.]+e-(0[7-9]|1[0-9])\n$"
    "breather" "^amplitude 0\\.01074[0-9]+, energy 0\\.000153599, residual [0-9.]+e-1[2-9] after [0-9] steps\n$"
    "multipliers" "^multipliers \\(1,-0\\.0003094[0-9]+\\) and \\(1,0\\.0003094[0-9]+\\), error [0-9.]+e-[01][0-9]\n$"
    "barrier" "^at equal frequency 1\\.62[0-9]+e-11, at equal area -2\\.3[0-9]+e-13\n$"
    "own_well" "^energy drift [0-9.]+e-(0[89]|1[0-9])\n$"
    "own_contact" "^energy drift [0-9.]+e-(0[89]|1[0-9])\n$"
    "own_start" "^the light bead is at 0\\.037553[0-9]* \\+- [0-9.]+e-(09|1[0-9])\n$"
    "limit" "^speed 0\\.3748[0-9]+ sites per unit of slow time, norm drift [0-9.]+e-1[0-9]\n$"
    "array" "^force 2\\.864[0-9]+ N, velocity 0\\.493[0-9]+ m/s, arrival 39\\.41[0-9]+ ms\n$"
    "sweep" "^0\\.230[0-9]+\n0\\.188[0-9]+\n0\\.171[0-9]+\n(0\\.[0-9]+\n)+$"
    "quadruple" "^energy 0\\.461486038076935627[0-9]+, residual [0-9.]+e-2[6-9]\n$")
list(LENGTH says expected_count)
while(says)
  list(POP_FRONT says name expected)
  run(${place}/build/${name})
  if(NOT text MATCHES "${expected}")
    message(FATAL_ERROR "${name} says: ${text}")
  endif()
endwhile()
# A copy of the chapter of one's own computes, draws and judges; where its statement is turned round it stops
file(COPY ${EXAMPLES}/chapter DESTINATION ${place})
run(${CMAKE_COMMAND} -S ${place}/chapter -B ${place}/chapter/build -D CMAKE_PREFIX_PATH=${place}/prefix -D
    CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_FLAGS=-O0)
run(${CMAKE_COMMAND} --build ${place}/chapter/build)
file(READ ${place}/chapter/build/own_chain.svg drawn)
if(NOT text MATCHES "slower_and_weaker holds: [^\n]*mu = 0\\.99[^\n]*0\\.2276[0-9]+ " OR NOT drawn MATCHES "</svg>")
  message(FATAL_ERROR "the chapter says: ${text}")
endif()
file(READ ${place}/chapter/statements.cpp source)
string(REPLACE "increases(speeds, \"mu\", \"speed\")" "less(speeds.at(\"mu\", 1)[\"speed\"], speeds.at(\"mu\", 0.94)[\"speed\"])"
       turned "${source}")
file(WRITE ${place}/chapter/statements.cpp "${turned}")
execute_process(COMMAND ${CMAKE_COMMAND} --build ${place}/chapter/build RESULT_VARIABLE code OUTPUT_VARIABLE text ERROR_QUIET)
if(code EQUAL 0 OR NOT text MATCHES "slower_and_weaker FAILS: ")
  message(FATAL_ERROR "with the statement turned round the chapter says: ${text}")
endif()
# Another project takes the core into a shared library on a machine without GSL and Boost, from the installed library as
# from a subfolder, which adds the library alone.
file(WRITE ${place}/outer/outer.cpp "#include \"lattice/impact/impact.hpp\"\nusing namespace lattice;\n"
     "double moved() {\n  auto state = struck(9, 1);\n  evolve(EventCorrected{0.05}, Chain{9}, state, 1);\n  return state.y[0];\n}\n")
foreach(way "find_package(lattice REQUIRED)" "add_subdirectory(\"${EXAMPLES}/..\" lattice)")
  file(WRITE ${place}/outer/CMakeLists.txt "cmake_minimum_required(VERSION 3.20)\nproject(outer LANGUAGES CXX)\n"
       "set(CMAKE_DISABLE_FIND_PACKAGE_GSL ON)\nset(CMAKE_DISABLE_FIND_PACKAGE_Boost ON)\n${way}\n"
       "add_library(outer SHARED outer.cpp)\ntarget_link_libraries(outer PRIVATE lattice::core)\n"
       "target_link_options(outer PRIVATE -Wl,-z,defs)\n"
       "if(TARGET programs OR TARGET tests)\n  message(FATAL_ERROR \"more than the library is added\")\nendif()\n")
  file(REMOVE_RECURSE ${place}/outer/build)
  run(${CMAKE_COMMAND} -S ${place}/outer -B ${place}/outer/build -D CMAKE_PREFIX_PATH=${place}/prefix -D
      CMAKE_CXX_COMPILER=${COMPILER})
  if(way MATCHES "^find")
    run(${CMAKE_COMMAND} --build ${place}/outer/build --target outer)
  endif()
endforeach()
# A machine that lacks two libraries is told of both at once
execute_process(COMMAND ${CMAKE_COMMAND} -S ${EXAMPLES}/.. -B ${place}/lacking -D CMAKE_DISABLE_FIND_PACKAGE_GSL=ON -D
                        CMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON -D CMAKE_CXX_COMPILER=${COMPILER}
                RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE text)
string(REGEX REPLACE "[ \n]+" " " text "${text}")
if(code EQUAL 0 OR NOT text MATCHES "LIBRARIES: missing GSL 2.7 .Debian: libgsl-dev., Eigen 3.4 .Debian: libeigen3-dev. .allowed")
  message(FATAL_ERROR "where GSL and Eigen are missing CMake says: ${text}")
endif()

# Whoever compiles against the installed headers cannot change values by accident, nor where errors would be zero
foreach(option -ffast-math -Ofast -mlong-double-64)
  file(WRITE ${place}/fast.cpp "#include \"lattice/numerics/estimate.hpp\"\nint main() {}\n")
  execute_process(COMMAND ${COMPILER} -std=c++20 ${option} -I ${place}/prefix/include -fsyntax-only ${place}/fast.cpp
                  RESULT_VARIABLE code ERROR_VARIABLE text)
  if(code EQUAL 0 OR NOT text MATCHES "lattice needs (IEEE arithmetic: compile without -ffast-math|a long double with more digits)")
    message(FATAL_ERROR "with ${option} the compiler of the reader says: ${text}")
  endif()
endforeach()
run(${COMPILER} -std=c++20 -O3 -I ${place}/prefix/include -fsyntax-only ${place}/fast.cpp)

# The Python module is installed with the rest, and says where it is imported what it lacks
function(python_says folder code expected)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env PYTHONPATH=${folder} PYTHONDONTWRITEBYTECODE=1 ${PYTHON} -c "${code}"
                  OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT text MATCHES "${expected}")
    message(FATAL_ERROR "the Python module says: ${text}")
  endif()
endfunction()
if(PYTHON)
  files_in(packages ${place}/prefix/lib python*/*-packages)
  python_says("${packages}" "print(__import__('lattice').Chain(3))" "^Chain of 3 beads: wells harmonic")
  python_says("${packages}" "import sys\nsys.modules['numpy'] = None\nimport lattice"
              "\nImportError: lattice needs numpy, [^\n]*python3-numpy[^\n]*\n$")
  file(COPY ${BUILD}/python/lattice/__init__.py DESTINATION ${place}/bare/lattice)
  python_says("${place}/bare" "import lattice" "\nImportError: lattice: the compiled part is missing[^\n]*\n$")
endif()

# None is left out
files_in(programs ${EXAMPLES} *.cpp)
list(LENGTH programs count)
math(EXPR expected_count "${expected_count} / 2")
if(NOT count EQUAL expected_count)
  message(FATAL_ERROR "examples/ holds ${count} programs, of which this test runs ${expected_count}")
endif()
file(REMOVE_RECURSE ${place})
