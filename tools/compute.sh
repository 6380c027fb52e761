#!/bin/sh
# Runs a program for its results, notes what it cost, and makes a second make in the same checkout wait:
#   compute.sh PROGRAM RESULTS COST AT-ONCE COMMAND...
# One of several programs that run AT-ONCE costs its share of the time.
set -eu
program=$1 results=$2 cost=$3 at_once=$4
shift 4
mkdir -p "${results%/*}" "${cost%/*}"
# shellcheck source=tools/shared.sh
. "${0%/*}/shared.sh"
hold "${cost%/*}/.${cost##*/}.lock"
# Another make was here first.
if [ -f "$results" ] && ! newer "$program" "$results"; then exit 0; fi
echo "  compute  ${program##*/}"
start=$(now)
"$@"
echo "$start $(now) $at_once" | awk '{ printf "%.1f\n", ($2 > $1 ? ($2 - $1) / $3 : 0) }' > "$cost"
catch_up "$results" "$program"
