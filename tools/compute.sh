#!/bin/sh
# Runs a program for its results, notes what it cost, and makes a second make in the same checkout wait:
#   compute.sh PROGRAM RESULTS COST COMMAND...
set -eu
program=$1 results=$2 cost=$3
shift 3
mkdir -p "${results%/*}" "${cost%/*}"
if command -v flock >/dev/null 2>&1; then
  exec 9> "${cost%/*}/.${cost##*/}.lock"
  flock 9
  # Another make was here first.
  [ -n "$(find "$results" -newer "$program" 2>/dev/null)" ] && exit 0
fi
echo "  compute  ${program##*/}"
start=$(date +%s.%N)
"$@"
echo "$start $(date +%s.%N)" | awk '{ printf "%.1f\n", $2 - $1 }' > "$cost"
