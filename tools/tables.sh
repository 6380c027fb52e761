#!/bin/sh
# Are the tables below the folder $1 still those that the programs wrote? Every program leaves a SHA256SUMS
# beside its tables, of their rows without the `#` lines. A table that is gone is computed again: its
# program's results.ecsv is removed. One that was changed by hand stops everything that reads it.
set -eu
bad=0
for sums in "$1"/*/SHA256SUMS; do
  [ -f "$sums" ] || continue
  folder=${sums%/*}
  [ -f "$folder/results.ecsv" ] || continue
  while read -r sum name; do
    if [ ! -f "$folder/$name" ]; then
      echo "  missing  $folder/$name: its program runs again"
      rm -f "$folder/results.ecsv"
    elif [ "$(grep -v '^#' "$folder/$name" | sha256sum)" != "$sum  -" ]; then
      echo "$folder/$name: not what ${folder##*/} wrote; remove it to have it computed again" >&2
      bad=1
    fi
  done < "$sums"
done
exit $bad
