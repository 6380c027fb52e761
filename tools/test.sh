#!/bin/sh
# Builds and runs the tests of one file or folder of tests/ or beyond/tests/:  test.sh BUILD JOBS floquet
set -eu
build=$1 jobs=$2 name=$3
found=$(sed -n "\;\(^\|/\)$name\(/.*\)\{0,1\} ;p" "$build/tests.txt")
[ -n "$found" ] || { echo "T: '$name' is no test (allowed: the names of files and folders in tests/ and beyond/tests/)" >&2; exit 2; }
# shellcheck disable=SC2046
sh "${0%/*}/build.sh" "$build" "$jobs" $(echo "$found" | cut -d ' ' -f 2 | sort -u)
exec ctest --test-dir "$build" -j "$jobs" -R "(^|/)$name(/|\$)" --no-tests=error --output-on-failure
