#!/bin/sh
# The Makefile with its tools replaced by stubs: paths with spaces, copied checkouts, runs that are
# killed, LAUNCH, THREADS, QUICK, DEPS and PYTHON. Takes seconds because nothing is compiled.
set -eu
root=$(cd "$1" && pwd -P)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
here="$scratch/a b/it's here"
mkdir -p "$here/src" "$scratch/bin"
cp -r "$root/Makefile" "$root/tools" "$root/figures" "$root/apt-packages.txt" "$here"
for chapter in "$root"/src/sec*.cpp; do : > "$here/src/${chapter##*/}"; done
export STUB_LOG="$scratch/log"

stub() { cat > "$scratch/bin/$1"; chmod +x "$scratch/bin/$1"; }
# `cmake -S . -B build` leaves a cache, `cmake --build build` makes programs that note how they were
# called, of the folder for which the cache was made.
stub cmake <<'STUB'
#!/bin/sh
set -eu
case $1 in
-S) echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" > "$4/CMakeCache.txt" ;;
--build)
  home=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$2/CMakeCache.txt")
  mkdir -p "$2/bin"
  for name in $(cd src && ls | sed -n 's/\.cpp$//p'); do
    [ -x "$2/bin/$name" ] || cp "$STUB_PROGRAM" "$2/bin/$name"
    echo "$home" > "$2/bin/.home"
  done ;;
esac
STUB
stub program <<'STUB'
#!/bin/sh
out=
[ "$1" = --out ] && out=$2
echo "${0##*/} $*" >> "$STUB_LOG"
[ -z "$out" ] && exit 0
rm -f "$out/results.ecsv"
sleep "${STUB_SLEEP:-0}"
echo done > "$out/results.ecsv"
STUB
stub srun <<'STUB'
#!/bin/sh
echo "launched" >> "$STUB_LOG"
shift
exec "$@"
STUB
export STUB_PROGRAM="$scratch/bin/program"
PATH="$scratch/bin:$PATH"
unset MAKEFLAGS MAKELEVEL MFLAGS SLURM_CPUS_PER_TASK
fail() { echo "$1"; cat "$STUB_LOG"; exit 1; }
run() { : > "$STUB_LOG"; make DEPS=skip "$@" > "$scratch/out" 2>&1 || { cat "$scratch/out"; fail "make $*"; }; }
cd "$here"
chapters=$(find src -name 'sec*.cpp' | wc -l)

run all-data
[ "$(grep -c -- '--out build/data/' "$STUB_LOG")" = "$chapters" ] || fail "not every program ran"
run all-data
[ -s "$STUB_LOG" ] && fail "a second make ran something again"

# Threads: all granted cores, a share with -j, what is asked for, and none where srun decides.
run all-data B=one CORES=6
grep -q -- '--threads 6' "$STUB_LOG" || fail "a single run does not get all cores"
run all-data B=two CORES=6 -j3
grep -q -- '--threads 2' "$STUB_LOG" || fail "three at a time do not share the cores"
run all-data B=three CORES=6 -j
grep -q -- '--threads 1' "$STUB_LOG" || fail "make -j oversubscribes"
run all-data B=four THREADS=5 -j2
grep -q -- '--threads 5' "$STUB_LOG" || fail "THREADS= is ignored"
run all-data B=five LAUNCH='srun -n1'
grep -q launched "$STUB_LOG" || fail "LAUNCH= is ignored"
grep -q -- '--threads' "$STUB_LOG" && fail "srun is told how many threads to use"
SLURM_CPUS_PER_TASK=1 run all-data B=six
grep -q -- '--threads 1' "$STUB_LOG" || fail "the grant of Slurm is ignored"
run all-data QUICK=1
[ "$(grep -c -- '--out build/quick/data/.* --quick' "$STUB_LOG")" = "$chapters" ] || fail "QUICK=1"

# A run that is killed leaves no answer, and the next make goes on where it was.
rm build/data/*/results.ecsv
STUB_SLEEP=1 timeout -s INT 2.5 make DEPS=skip all-data > "$scratch/out" 2>&1 && fail "not killed"
before=$(find build/data -name results.ecsv | wc -l)
[ "$before" -lt "$chapters" ] || fail "killed too late"
run all-data
[ "$(grep -c -- --out "$STUB_LOG")" = $((chapters - before)) ] || fail "the next make did not go on"

# A copy is built for itself, and so is a checkout that was moved.
cp -r "$here" "$scratch/copy"
cd "$scratch/copy"
run all-data
grep -q 'everything is built again' "$scratch/out" || fail "the copy does not say what it does"
[ "$(cat build/bin/.home)" = "$PWD" ] || fail "the copy builds the original"
[ "$(grep -c -- --out "$STUB_LOG")" = "$chapters" ] || fail "the copy keeps the original's tables"
mv "$scratch/copy" "$scratch/moved"
cd "$scratch/moved"
run all-data
[ "$(cat build/bin/.home)" = "$PWD" ] || fail "the moved checkout builds the original"

# The python that can draw is found, and PYTHON= is taken as one word.
cd "$here"
script=$(cd figures && ls x01_*.py)
echo 'import sys; open(sys.argv[2], "w").write("drawn")' > "figures/$script"
printf '#!/bin/sh\nexit 1\n' | stub python3
stub rsvg-convert <<'STUB'
#!/bin/sh
while [ $# -gt 1 ]; do shift; done
echo image > "$1"
STUB
if /usr/bin/python3 -c 'import matplotlib' 2>/dev/null; then
  run x01
  [ "$(cat build/figures/"${script%.py}".svg)" = drawn ] || fail "no figure"
fi
rm -f build/figures/x01*
cp /usr/bin/python3 "$scratch/a b/python3" 2>/dev/null || exit 0
run x01 PYTHON="$scratch/a b/python3"
[ -f "build/figures/${script%.py}.pdf" ] || fail "PYTHON= with a space"
