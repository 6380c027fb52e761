# Whether the Python module can be built, and with which interpreter: the first one that has numpy and its own
# headers, and none where the compiler is that of another machine or code has a fixed address. Sets LATTICE_HAS_PYTHON and, where that is on,
# the targets of pybind11.
set(LATTICE_HAS_PYTHON OFF)
if(NOT LATTICE_PYTHON OR NOT anywhere OR CMAKE_CROSSCOMPILING)
  return()
endif()
if(NOT Python_EXECUTABLE)
  foreach(candidate python3 /usr/bin/python3)
    execute_process(
      COMMAND ${candidate} -c
              "import numpy, os, sys, sysconfig
os.stat(os.path.join(sysconfig.get_path('include'), 'Python.h'))
print(sys.executable, end='')"
      RESULT_VARIABLE code OUTPUT_VARIABLE found ERROR_QUIET)
    if(code STREQUAL 0)
      set(Python_EXECUTABLE ${found})
      break()
    endif()
  endforeach()
endif()
if(Python_EXECUTABLE)
  find_package(Python QUIET COMPONENTS Interpreter Development.Module)
  find_package(pybind11 QUIET CONFIG)
  if(Python_FOUND AND pybind11_FOUND)
    set(LATTICE_HAS_PYTHON ON)
  endif()
endif()
