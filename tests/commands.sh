#!/bin/sh
# What commands show to whoever waits, leave behind and need. Argument: the folder of the programs.
set -eu
bin=$(cd "$1" && pwd -P)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
fail() { echo "$1"; cat said; exit 1; }
on_terminal() { script -qec "$*" /dev/null < /dev/null > said 2>&1; }

# On a terminal one sees how far a run, a search and a sweep are.
if script -qec true /dev/null < /dev/null > said 2>&1; then
  on_terminal "'$bin/sec34_impact' run --time 2500" || fail "an impact on a terminal"
  grep -qE 'sec34_impact run [0-9]+ s, step 0\.[0-9]+: [0-9]+ %' said || fail "an impact does not show how far it is"
  on_terminal "'$bin/sec33_floquet' exchange --omega 1.5" || fail "an exchange on a terminal"
  grep -qE 'exchange [0-9]+ s, s (up to 1|down to -1) [0-9]+/20' said || fail "an exchange does not show how far it is"
  on_terminal "'$bin/sec33_mobility' threshold" || fail "a threshold on a terminal"
  grep -qE 'threshold [0-9]+ s, thresholds [0-9]+/2' said || fail "a threshold does not show how far it is"
else
  echo "no terminal can be made here: what commands show on one is not tested"
fi
# Elsewhere nothing but the table.
"$bin/sec34_impact" run --time 2000 2> said > table
[ -s said ] && fail "a run talks into a log"

# A long run keeps two states and not its history.
# shellcheck disable=SC3045
(ulimit -v 150000 && "$bin/sec34_boomeron" run --time 3000 > table 2> said) || fail "a long run takes more than 150 MB"

# The tolerance is what it says: the difference of two steps, and a smaller one costs a smaller step.
difference() { awk -F, '$1 == "step_difference" { print $2 }' "$1"; }
for tolerance in 1e-3 1e-6; do
  "$bin/sec34_boomeron" run --tolerance $tolerance > table 2> said || fail "tolerance $tolerance"
  awk -v d="$(difference table)" -v t=$tolerance 'BEGIN { exit !(d > 0 && d <= t) }' || fail "tolerance $tolerance is not kept"
  mv table "table-$tolerance"
done
awk -v a="$(difference table-1e-3)" -v b="$(difference table-1e-6)" 'BEGIN { exit !(b < a / 10) }' || fail "the step does not follow"

# A map leaves nothing where it was not asked to.
mkdir empty && cd empty
"$bin/sec34_boomeron_map" map --columns 2 --rows 2 --output map.ecsv 2> ../said || fail "a small map"
[ "$(ls -A)" = map.ecsv ] || fail "a map leaves more than its table: $(ls -A)"
