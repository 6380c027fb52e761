#!/bin/sh
# Builds targets, says once that it compiles, how long that takes and where the log is, and on a terminal how far it is:
#   build.sh BUILD JOBS TARGET...
set -eu
build=$1 jobs=$2
shift 2
log=$build/build.log
# shellcheck source=tools/shared.sh
. "${0%/*}/shared.sh"
hold "$build/.lock"
# Minutes of processor time if nothing is there yet: for everything, or for the library and one program.
case $* in
all) what=tests work=12 ;;
programs) what=programs work=12 ;;
*) what=$* work=4 ;;
esac
announce() {
  minutes=$(((work + jobs - 1) / jobs))
  printf '  build    %s on %s core%s: about %s minute%s the first time (%s)\n' "$what" \
    "$jobs" "$([ "$jobs" = 1 ] || echo s)" "$minutes" "$([ "$minutes" = 1 ] || echo s)" "$log"
}
: > "$log"
exec 4>&1
status=$({ { cmake --build "$build" --parallel "$jobs" --target "$@" 2>&1 || echo failed >&3; } |
  while IFS= read -r line; do
    printf '%s\n' "$line" >> "$log"
    case $line in
    '['*' Building '*)
      [ -n "${said-}" ] || announce >&4
      said=yes
      [ ! -t 2 ] || printf '\r\033[K  build    %s %s' "${line%%]*}]" "${line##*/}" >&2
      ;;
    esac
  done; } 3>&1)
[ ! -t 2 ] || printf '\r\033[K' >&2
[ -z "$status" ] || { cat "$log"; exit 1; }
