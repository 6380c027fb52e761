#!/bin/sh
# Runs a test with an environment of its own: what the caller happens to export (PYTHON, MAKEFLAGS, CXXFLAGS,
# LC_ALL, SLURM_*, CTEST_*, DESTDIR, ...) must not decide whether it passes. Only where programs and libraries are found
# (PATH, CMAKE_PREFIX_PATH) and where temporary files go are taken over.
set -eu
umask 022
exec env -i PATH="$PATH" HOME="${HOME:-/tmp}" TMPDIR="${TMPDIR:-/tmp}" LC_ALL=C.UTF-8 \
  ${CMAKE_PREFIX_PATH:+"CMAKE_PREFIX_PATH=$CMAKE_PREFIX_PATH"} "$@"
