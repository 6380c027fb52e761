#!/bin/sh
# Runs on a bad day: killed, out of disk or memory, without anybody who reads. With `maps` those of the maps in parts, which
# volume two has. Arguments: the repository, the folder of the programs.
set -eu
root=$(cd "$1" && pwd -P)
bin=$(cd "$2" && pwd -P)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
fail() { echo "$1"; exit 1; }
rows() { grep -v '^#' "$1"; }

if [ "${3:-}" = maps ]; then
  map() { timeout -s "$1" "$2" "$bin/sec34_boomeron_map" map --threads 1 --columns 6 --rows 6 --output "$3.ecsv" --folder "$3"; }
  # One that is ended again and again, cut and changed by hand has the rows of one that is not
  mkdir whole kept
  map TERM 60 whole
  for signal in TERM XCPU KILL; do map "$signal" 0.1 kept && fail "a map is too short to be ended"; done
  part=$(find kept -name '.*.rows-*')
  [ "$(wc -l < "$part")" -gt 1 ] || fail "no row was kept"
  sed '2s/,/,9/' "$part" | head -c -3 > shorter
  mv shorter "$part"
  map TERM 60 kept
  [ "$(rows kept.ecsv)" = "$(rows whole.ecsv)" ] || fail "a map that was ended is not the whole one"
  # The tasks of Slurm's array make it, too
  mkdir build
  ln -s "$bin" build/bin
  for task in 1 3 2; do SIDE=6 PARTS=3 SLURM_ARRAY_TASK_ID=$task sh "$root/beyond/examples/turning_map.sbatch" > /dev/null; done
  [ "$(cat build/turning-6/.*.rows-* | wc -l)" = $((36 + 3)) ] || fail "the tasks do not keep 36 rows"
  mv build/turning-6 parts
  map TERM 60 parts
  [ "$(rows parts.ecsv)" = "$(rows whole.ecsv)" ] || fail "a map in parts is not the whole one"
  exit
fi

# Whole tables or none, and the next run is as if nothing had been
run() { timeout -s "$1" "$2" "$bin/sec32_dps_profiles" --quick --threads 1 --out "$3"; }
run TERM 60 whole
ended=0
for signal in KILL TERM HUP XCPU; do
  for seconds in 0.003 0.006 0.01 0.015 0.02; do
    run "$signal" "$seconds" hurt 2> /dev/null || ended=$((ended + 1))
    [ ! -f hurt/SHA256SUMS ] || (cd hurt && sha256sum --quiet -c ../whole/SHA256SUMS) || fail "a killed run leaves tables that are not whole"
  done
done
[ "$ended" -gt 5 ] || fail "no run was killed in time"
run TERM 60 hurt
diff -r hurt whole || fail "the run after the killed ones is another one"

# On a full disk, here for a limit of size, nothing is left
prlimit --fsize=600 "$bin/sec32_dps_profiles" --quick --out full 2> said && fail "a full disk is not noticed"
grep -q 'cannot write' said || fail "a full disk: $(cat said)"
[ ! -f full/SHA256SUMS ] || fail "a full disk leaves a list"

# Who reads the first line only hears no complaint, and a table needs no channel
band() { "$bin/sec4_precompression_mi" band "$@"; }
band 2> said | head -n 1 > /dev/null
[ ! -s said ] || fail "a closed pipe: $(cat said)"
band --output x.ecsv 2>&- <&- >&- || fail "no table without a channel"

# A long run keeps two states and not its history
prlimit --as=150000000 "$bin/sec34_boomeron" run --time 3000 > /dev/null || fail "a long run takes more than 150 MB"
