#!/bin/sh
# Builds targets and says on a terminal what is compiled and how far it is:
#   build.sh BUILD JOBS TARGET...
set -eu
build=$1 jobs=$2
shift 2
log=$build/build.log
# shellcheck source=tools/shared.sh
. "${0%/*}/shared.sh"
hold "$build/.lock"
if [ -t 2 ]; then
  : > "$log"
  status=$({ { cmake --build "$build" --parallel "$jobs" --target "$@" 2>&1 || echo failed >&3; } |
    while IFS= read -r line; do
      printf '%s\n' "$line" >> "$log"
      case $line in
      '['*' Building '*) printf '\r\033[K  build    %s %s' "${line%%]*}]" "${line##*/}" >&2 ;;
      esac
    done; } 3>&1)
  printf '\r\033[K' >&2
else
  status=
  cmake --build "$build" --parallel "$jobs" --target "$@" > "$log" 2>&1 || status=failed
fi
[ -z "$status" ] || { cat "$log"; exit 1; }
