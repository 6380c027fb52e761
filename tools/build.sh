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
minutes=$(first_build "$build" "$jobs" "$@")
case $# in 1) what=$1 ;; *) what="$# programs" ;; esac
: > "$log"
exec 4>&1
start=$(date +%s)
# `progress " 25%] Building ..."`
progress() {
  share=${1%%%*} left=
  [ -z "$minutes" ] || [ "$share" -lt 10 ] || left=", about $((($(date +%s) - start) * (100 - share) / share / 60 + 1)) min more"
  printf '\r\033[K  build    %d %%%s' "$share" "$left"
}
status=$({ { cmake --build "$build" --parallel "$jobs" --target "$@" 2>&1 || echo failed >&3; } |
  while IFS= read -r line; do
    printf '%s\n' "$line" >> "$log"
    case $line in
    '['*' Building '*)
      [ -n "${said-}" ] || echo "  build    $what on $jobs core$([ "$jobs" = 1 ] || echo s)${minutes:+, about $minutes min} ($log)" >&4
      said=yes
      [ ! -t 2 ] || progress "${line#[}" >&2
      ;;
    esac
  done; } 3>&1)
[ ! -t 2 ] || printf '\r\033[K' >&2
[ -z "$status" ] || { cat "$log"; exit 1; }
