#!/bin/sh
# Configures a build folder: configure.sh BUILD [SOURCES [OPTIONS OF CMAKE]]. CMake remembers where the sources were: a
# folder that was copied or moved together with them would go on to build the original ones, so it is then set up afresh.
set -eu
build=$1 sources=${2:-.}
[ $# -lt 2 ] || shift
shift
here=$(pwd -P)
refuse() { echo "$1" >&2; exit 1; }
case $here in
*[\"\;:\#\$\\]*) refuse "the folder '$here' has a character in its name that CMake or make cannot use (allowed: all but \" ; : # \$ \\)" ;;
esac
[ -z "$(printf '%s' "$here" | LC_ALL=C sed 's/[^][]//g; :pair; s/\[\]//; t pair')" ] ||
  refuse "the folder '$here' has an unpaired bracket in its name, which CMake cannot use (allowed: pairs [ ])"
(mkdir -p "$build" && : > "$build/.writable.$$" && rm "$build/.writable.$$") 2>/dev/null ||
  refuse "cannot write to $here/$build (allowed: a writable checkout)"
# shellcheck source=tools/shared.sh
. "${0%/*}/shared.sh"
hold "$build/.lock"
# A log of yesterday must not be shown as today's cause.
rm -f "$build/configure.log" "$build/build.log"
if [ -f "$build/CMakeCache.txt" ]; then
  home=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$build/CMakeCache.txt")
  if [ "$(cd "$home" 2>/dev/null && pwd -P)" != "$(cd "$sources" && pwd -P)" ]; then
    echo "  build    $build was made in $home: rebuilding everything for $here"
    rm -rf "$build/CMakeCache.txt" "$build/CMakeFiles" "${build:?}/bin" "$build/configured"
  fi
fi
[ -f "$build/configured" ] && [ "$(cat "$build/configured")" = "$*" ] && exit 0
cmake -S "$sources" -B "$build" "$@" > "$build/configure.log" 2>&1 || {
  # What our own CMakeLists.txt refuses is one line; anything else is shown whole.
  line=$(awk '/^  [A-Z]+: .*/ { on = 1 } on && NF == 0 { exit } on { sub(/^ +/, ""); printf "%s%s", sep, $0; sep = " " }' \
    "$build/configure.log")
  if [ -n "$line" ]; then echo "$line" >&2; else cat "$build/configure.log"; fi
  exit 1
}
printf '%s' "$*" > "$build/configured"
