#!/bin/sh
# Runs a program for its tables and notes what it cost, unless they are its own already:
#   compute.sh PROGRAM SHA256SUMS COST AT-ONCE COMMAND...
# Whose they are is told by the checksum of the program in run.ecsv beside them: one that was built again to the same
# bytes computes nothing. One of several programs that run AT-ONCE costs its share of the time.
set -eu
program=$1 results=$2 cost=$3 at_once=$4 maker=${2%/*}/run.ecsv
shift 4
mkdir -p "${results%/*}" "${cost%/*}"
# shellcheck source=tools/shared.sh
. "${0%/*}/shared.sh"
# A second make in the same checkout waits, and finds them made.
hold "${cost%/*}/.${cost##*/}.lock"
sum=$(sha256sum < "$program")
if [ -f "$results" ] && grep -qxF "program,${sum%% *}" "$maker" 2>/dev/null; then exit 0; fi
echo "  compute  ${program##*/}"
start=$(date +%s.%N)
"$@"
echo "$start $(date +%s.%N) $at_once" | awk '{ printf "%.1f\n", ($2 - $1) / $3 }' > "$cost"
