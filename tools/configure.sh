#!/bin/sh
# Configures the build folder $1. CMake remembers where the sources were: a folder that was copied or
# moved together with them would go on to build the original ones, so it is then set up afresh.
set -eu
build=$1
here=$(pwd -P)
mkdir -p "$build"
if [ -f "$build/CMakeCache.txt" ]; then
  home=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$build/CMakeCache.txt")
  if [ "$(cd "$home" 2>/dev/null && pwd -P)" != "$here" ]; then
    echo "  build    $build was made in $home: everything is built again for $here"
    rm -rf "$build/CMakeCache.txt" "$build/CMakeFiles" "${build:?}/bin" "$build/configured"
  fi
fi
[ -f "$build/configured" ] && exit 0
cmake -S . -B "$build" > "$build/configure.log" 2>&1 || { cat "$build/configure.log"; exit 1; }
touch "$build/configured"
