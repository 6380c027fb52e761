#!/bin/sh
# Are the tables below the folder $1 still those that the programs wrote? Every program leaves a SHA256SUMS
# beside its tables. A table that is gone is computed again: its program's results.ecsv is removed. One that
# was changed by hand, or one of a quick run among those of full ones, stops everything that reads it.
set -eu
# shellcheck source=tools/shared.sh
. "${0%/*}/shared.sh"
bad=0
for sums in "$1"/*/SHA256SUMS; do
  [ -f "$sums" ] || continue
  folder=${sums%/*}
  [ -f "$folder/results.ecsv" ] || continue
  of_full_run "$folder/results.ecsv" || bad=1
  while read -r _ name; do
    if [ ! -f "$folder/$name" ]; then
      echo "  missing  $folder/$name: its program runs again"
      rm -f "$folder/results.ecsv"
    else
      as_written "$folder/$name" || bad=1
    fi
  done < "$sums"
done
exit $bad
