#!/bin/sh
# Runs a program for its results and notes what it cost, unless they are its own already:
#   compute.sh PROGRAM RESULTS COST AT-ONCE COMMAND...
# Whose they are is told by the checksum of the program in .made_by beside them: one that was built again to the same
# bytes computes nothing. One of several programs that run AT-ONCE costs its share of the time; the processor time,
# which no neighbour shortens, stands beside it.
set -eu
program=$1 results=$2 cost=$3 at_once=$4 maker=${2%/*}/.made_by
shift 4
mkdir -p "${results%/*}" "${cost%/*}"
# shellcheck source=tools/shared.sh
. "${0%/*}/shared.sh"
# A second make in the same checkout waits, and finds them made.
hold "${cost%/*}/.${cost##*/}.lock"
sum=$(sha256sum < "$program")
if [ -f "$results" ] && [ "$sum" = "$(cat "$maker" 2>/dev/null)" ]; then exit 0; fi
echo "  compute  ${program##*/}"
rm -f "$maker"
start=$(now)
"$@"
times > "$maker.times"
echo "$start $(now) $at_once $(tail -n 1 "$maker.times" | tr 'ms' '  ')" |
  awk '{ printf "%.1f %.1f\n", ($2 > $1 ? ($2 - $1) / $3 : 0), 60 * ($4 + $6) + $5 + $7 }' > "$cost"
rm "$maker.times"
echo "$sum" > "$maker"
