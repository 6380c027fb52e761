#!/bin/sh
# Builds and runs the tests of files or folders of tests/ and beyond/tests/:  test.sh BUILD JOBS floquet sec33
# `code` is all of volume one but what compares with a record: statements, values, bytes, and numbers that prose quotes.
set -eu
build=$1 jobs=$2 names=
shift 2
if [ "$*" = code ]; then
  sh "${0%/*}/build.sh" "$build" "$jobs" all
  exec ctest --test-dir "$build" -j "$jobs" -LE beyond -E '^(statements|record|programs/(data|exercises|make))$' --output-on-failure --timeout 900
fi
for name; do
  names=$names${names:+|}$name
  grep -qE "(^|/)${name}[/ ]" "$build/tests.txt" ||
    { echo "T: '$name' is not a test (allowed: files and folders of tests/ and beyond/tests/, such as floquet or orbits)" >&2; exit 2; }
done
# shellcheck disable=SC2046
sh "${0%/*}/build.sh" "$build" "$jobs" $(grep -E "(^|/)($names)[/ ]" "$build/tests.txt" | cut -d ' ' -f 2 | sort -u)
exec ctest --test-dir "$build" -j "$jobs" -R "(^|/)($names)(/|\$)" --no-tests=error --output-on-failure --timeout 900
