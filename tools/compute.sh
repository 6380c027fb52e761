#!/bin/sh
# Runs a program for its results, notes what it cost, and makes a second make in the same checkout wait:
#   compute.sh PROGRAM RESULTS COST COMMAND...
set -eu
program=$1 results=$2 cost=$3
shift 3
mkdir -p "${results%/*}" "${cost%/*}"
. "${0%/*}/lock.sh"
hold "${cost%/*}/.${cost##*/}.lock"
# Another make was here first.
if [ -f "$results" ] && ! [ "$program" -nt "$results" ]; then exit 0; fi
echo "  compute  ${program##*/}"
# The seconds since the machine started run forwards, also where somebody sets its clock.
now() { cut -d' ' -f1 /proc/uptime 2>/dev/null || date +%s.%N; }
start=$(now)
"$@"
echo "$start $(now)" | awk '{ printf "%.1f\n", ($2 > $1 ? $2 - $1 : 0) }' > "$cost"
# What is older than its program is computed again: after a clock was set back, for ever.
if [ "$program" -nt "$results" ]; then touch -r "$program" "$results"; fi
