#!/bin/sh
# Builds targets, says once that it compiles and where the log is, and on a terminal how far it is:
#   build.sh BUILD JOBS TARGET...
set -eu
unset CLICOLOR_FORCE  # coloured lines would not be known again
build=$1 jobs=$2
shift 2
log=$build/build.log
# shellcheck source=tools/shared.sh
. "${0%/*}/shared.sh"
hold "$build/.lock"
# How long it takes can be said where nothing is compiled yet: minutes of processor time, for all, some or one program.
minutes=
if [ -z "$(find "$build" -name '*.o' 2>/dev/null | head -n 1)" ]; then
  case $* in programs | all) work=10 ;; *' '*) work=7 ;; *) work=2 ;; esac
  minutes=", about $(((work + jobs - 1) / jobs)) min"
fi
case $# in 1) what=$1 ;; *) what="$# programs" ;; esac
: > "$log"
exec 4>&1
status=$({ { cmake --build "$build" --parallel "$jobs" --target "$@" 2>&1 || echo failed >&3; } |
  while IFS= read -r line; do
    printf '%s\n' "$line" >> "$log"
    case $line in
    '['*' Building '*)
      [ -n "${said-}" ] || echo "  build    $what on $jobs core$([ "$jobs" = 1 ] || echo s)$minutes ($log)" >&4
      said=yes
      [ ! -t 2 ] || printf '\r\033[K  build    %s %s' "${line%%]*}]" "${line##*/}" >&2
      ;;
    esac
  done; } 3>&1)
[ ! -t 2 ] || printf '\r\033[K' >&2
[ -z "$status" ] || { cat "$log"; exit 1; }
