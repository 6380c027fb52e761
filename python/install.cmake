# Installs the Python module, FOLDER, to where PYTHON looks for modules below the prefix: to the folder that it searches
# there, or else to that of the same name, which PYTHONPATH may name. If only the libraries were built there is none.
include(${CMAKE_CURRENT_LIST_DIR}/../tools/files_in.cmake)
files_in(compiled ${FOLDER} _lattice.*)
if(NOT compiled)
  message(STATUS "The Python module is not installed, because it is not built (cmake --build BUILD --target python_module)")
  return()
endif()
execute_process(
  COMMAND ${PYTHON} -c
          "import os, re, site, sys, sysconfig
prefix = os.path.abspath(sys.argv[1]).rstrip('/')
searched = [path for path in site.getsitepackages() if re.match(re.escape(prefix) + '/lib/python[^/]*/[^/]*$', path)]
usual = 'lib/python%d.%d/' % sys.version_info[:2] + os.path.basename(sysconfig.get_path('platlib'))
print((searched + [prefix + '/' + usual])[0], end='')"
          ${CMAKE_INSTALL_PREFIX}
  OUTPUT_VARIABLE packages COMMAND_ERROR_IS_FATAL ANY)
files_in(parts ${FOLDER} *.*)
file(INSTALL ${parts} DESTINATION ${packages}/lattice)
