#!/bin/sh
# The lineage and a map under a real scheduler (`make test-slurm`): a cluster of two nodes on this machine.
#   1. `make QUICK=1 all-data LAUNCH='srun -n1'` gives the recorded bytes
#   2. beyond/examples/turning_map.sbatch, in parts of an array, gives the bytes of the plain run
#   3. the same while a node fails: its parts are queued and computed again
# Argument: the steps (all without); PROGRAMS='sec34_kink' takes only these for the first. Ends with 77 where no cluster can be started.
set -eu
unset CDPATH
cd "$(dirname "$0")/../../.."
steps=${1:-1 2 3}
PATH=$PATH:/usr/sbin
scratch=$(mktemp -d)
cluster="sh tests/programs/slurm/cluster.sh"
finish() { $cluster stop "$scratch/cluster"; rm -rf "$scratch"; rm -rf "build/turning-$SIDE"; }
export SIDE="${SIDE:-24}"
trap finish EXIT
fail() { echo "  slurm    FAILS: $1" >&2; exit 1; }
say() { echo "  slurm    $1"; }
say_to=$($cluster start "$scratch/cluster") || exit $?
eval "$say_to"
sinfo --version | sed 's/^/  slurm    /'

map() { build/bin/sec34_boomeron_map map --columns "$SIDE" --rows "$SIDE" "$@"; }
same() {
  map --folder "build/turning-$SIDE" --output "$scratch/parts.ecsv"
  grep -v '^#' "$scratch/parts.ecsv" | cmp - "$scratch/plain" || fail "$1"
  say "$1: $(wc -c < "$scratch/plain") bytes, the same as those of the plain run"
}
plain() {
  [ ! -f "$scratch/plain" ] || return 0
  map --output "$scratch/plain.ecsv"
  grep -v '^#' "$scratch/plain.ecsv" > "$scratch/plain"
}

case $steps in *1*)
  # shellcheck disable=SC2086
  make DEPS=skip QUICK=1 D="$scratch/quick" THREADS= LAUNCH='srun -n1' ${PROGRAMS:+chapters="$PROGRAMS"} -j2 all-data \
    > "$scratch/log" 2>&1 || { tail -n 20 "$scratch/log"; fail "make all-data under srun"; }
  say "$(grep -c compute "$scratch/log") programs under srun, two at once:"
  python3 -m lineage hashes --check --run quick --data "$scratch/quick/data" || fail "other bytes under srun" ;;
esac
case $steps in *2*)
  plain
  rm -rf "build/turning-$SIDE"
  PARTS=8 sbatch --wait --quiet --array=1-8 beyond/examples/turning_map.sbatch || fail "a part"
  [ "$(cat "build/turning-$SIDE"/.reversal_map.rows-* | wc -l)" -ge $((SIDE * SIDE)) ] || fail "the parts are not complete"
  same "a map in 8 parts" ;;
esac
case $steps in *3*)
  plain
  rm -rf "build/turning-$SIDE"
  job=$(PARTS=4 sbatch --parsable --array=1-4 beyond/examples/turning_map.sbatch)
  # A node is lost when the first rows are safe, and comes back when the controller has noticed.
  while [ "$(cat "build/turning-$SIDE"/.reversal_map.rows-* 2>/dev/null | wc -l)" -lt 20 ] ||
    [ -z "$(squeue -h -w node1 -t running -o %A)" ]; do sleep 0.2; done
  $cluster lose "$scratch/cluster" 1
  while [ -z "$(sinfo -h -n node1 -t down -o %N)" ]; do sleep 0.5; done
  say "node1 is down with $(cat "build/turning-$SIDE"/.reversal_map.rows-* | grep -vc '^#') of $((SIDE * SIDE)) points known"
  $cluster node "$scratch/cluster" 1
  while [ -n "$(squeue -h -j "$job" 2>/dev/null)" ]; do sleep 0.5; done
  again=$(scontrol -o show job "$job" | grep -c ' Restarts=1 ' || true)
  [ "$again" -ge 1 ] || fail "no part was computed again"
  [ "$(scontrol -o show job "$job" | grep -c JobState=COMPLETED)" = 4 ] || fail "not all parts were completed"
  same "a map of which a node was lost ($again part computed again)" ;;
esac
