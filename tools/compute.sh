#!/bin/sh
# Runs a program for its results, notes what it cost, and makes a second make in the same checkout wait:
#   compute.sh PROGRAM RESULTS COST COMMAND...
set -eu
program=$1 results=$2 cost=$3
shift 3
mkdir -p "${results%/*}" "${cost%/*}"
# shellcheck source=tools/shared.sh
. "${0%/*}/shared.sh"
hold "${cost%/*}/.${cost##*/}.lock"
# Another make was here first.
if [ -f "$results" ] && ! newer "$program" "$results"; then exit 0; fi
echo "  compute  ${program##*/}"
start=$(now)
"$@"
echo "$start $(now)" | awk '{ printf "%.1f\n", ($2 > $1 ? $2 - $1 : 0) }' > "$cost"
catch_up "$results" "$program"
