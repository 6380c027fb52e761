#!/bin/sh
# The lineage and a map under a real scheduler (`make test-slurm`): a cluster of two nodes on this machine.
#   1. `make QUICK=1 all-data LAUNCH='srun -n1'` gives the recorded bytes
#   2. beyond/examples/turning_map.sbatch, in parts of an array, gives the bytes of the plain run
# Argument: the steps (all without); PROGRAMS='sec34_kink' takes only these for the first. Ends with 77 where no cluster can be started.
set -eu
unset CDPATH
cd "$(dirname "$0")/../../.."
steps=${1:-1 2}
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
case $steps in *1*)
  # shellcheck disable=SC2086
  make DEPS=skip QUICK=1 D="$scratch/quick" THREADS= LAUNCH='srun -n1' ${PROGRAMS:+chapters="$PROGRAMS"} -j2 all-data \
    > "$scratch/log" 2>&1 || { tail -n 20 "$scratch/log"; fail "make all-data under srun"; }
  say "$(grep -c compute "$scratch/log") programs under srun, two at once:"
  PYTHONPATH=tools python3 -m lineage hashes --run quick --data "$scratch/quick/data" || fail "other bytes under srun" ;;
esac
case $steps in *2*)
  map --output "$scratch/plain.ecsv"
  rm -rf "build/turning-$SIDE"
  PARTS=8 sbatch --wait --quiet --array=1-8 beyond/examples/turning_map.sbatch || fail "a part"
  [ "$(cat "build/turning-$SIDE"/.reversal_map.rows-* | wc -l)" -ge $((SIDE * SIDE)) ] || fail "the parts are not complete"
  map --folder "build/turning-$SIDE" --output "$scratch/parts.ecsv"
  for it in plain parts; do grep -v '^#' "$scratch/$it.ecsv" > "$scratch/$it"; done
  cmp "$scratch/plain" "$scratch/parts" || fail "a map in 8 parts"
  say "a map in 8 parts: $(wc -l < "$scratch/plain") lines, the same as those of the plain run" ;;
esac
