#!/bin/sh
# The first line of `make figures` says what it will do, and in about how long:
#   plan.sh BUILD FOLDER JOBS COSTS FIGURE... -- PROGRAM...
# The costs are those of two cores (paper/costs.ecsv); a figure takes one of them a second.
set -eu
# shellcheck source=tools/shared.sh
. "${0%/*}/shared.sh"
build=$1 folder=$2 cores=$3 costs=$4 draw=0 compute=0 seconds=0
shift 4
compile=$(first_build "$build" "$cores" programs)
while [ "$1" != -- ]; do [ -f "$1" ] || draw=$((draw + 1)); shift; done
shift
for program; do
  [ ! -f "$folder/data/$program/SHA256SUMS" ] || continue
  compute=$((compute + 1))
  cost=$(sed -n "s/^$program,\([0-9]*\).*/\1/p" "$costs")
  seconds=$((seconds + ${cost:-1} + 1))
done
minutes=$((${compile:-0} + (2 * seconds + draw) / cores / 60 + 1))
echo "figures    : ${compile:+compile all, }compute $compute programs, draw $draw figures: about $minutes min on" \
  "$cores cores, more where programs changed"
