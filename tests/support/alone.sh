#!/bin/sh
# Runs a test with an environment of its own: what the caller happens to export (PYTHON, MAKEFLAGS, CXXFLAGS,
# LC_ALL, SLURM_*, CTEST_*, DESTDIR, ...) must not decide whether it passes. Only where programs and libraries are found
# (PATH, CMAKE_PREFIX_PATH), where temporary files go and the patience with a slow build (LATTICE_SLACK) are taken over.
set -eu
umask 022
tmp=${TMPDIR:-/tmp}
[ -d "$tmp" ] && [ -w "$tmp" ] || tmp=/tmp
# Tests put programs there, which some systems forbid: the folder of the build is then as good.
if try=$(mktemp "$tmp/try.XXXXXX"); then
  printf '#!/bin/sh\n' > "$try" && chmod +x "$try"
  "$try" 2>/dev/null || { mkdir -p "$PWD/tmp" && tmp=$PWD/tmp; }
  rm -f "$try"
fi
exec env -i PATH="$PATH" HOME="${HOME:-$tmp}" TMPDIR="$tmp" LC_ALL=C.UTF-8 \
  ${CMAKE_PREFIX_PATH:+"CMAKE_PREFIX_PATH=$CMAKE_PREFIX_PATH"} \
  LATTICE_SLACK="${LATTICE_SLACK:-1}" "$@"
