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
-S)
  mkdir "$4/configuring" || { echo "two at once configure $4"; exit 1; }
  sleep 0.1
  rmdir "$4/configuring"
  echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" > "$4/CMakeCache.txt" ;;
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
# The tables of its figures, their checksums, and last the results.
cd "$out"
for table in $(awk -F, -v me="${0##*/}" '$4 == me { print $7 }' "$STUB_FIGURES"); do
  printf '# header\nx\n1\n' > "$table.ecsv"
done
echo done > results.ecsv.new
for table in *.ecsv results.ecsv.new; do
  [ ! -f "$table" ] || printf '%s  %s\n' "$(grep -v '^#' "$table" | sha256sum | cut -c -64)" "${table%.new}"
done > SHA256SUMS
mv results.ecsv.new results.ecsv
STUB
stub srun <<'STUB'
#!/bin/sh
echo "launched" >> "$STUB_LOG"
shift
exec "$@"
STUB
export STUB_PROGRAM="$scratch/bin/program" STUB_FIGURES="$here/figures/figures.ecsv"
PATH="$scratch/bin:$PATH"
unset PYTHON MAKEFLAGS MAKELEVEL MFLAGS SLURM_CPUS_PER_TASK QUICK LAUNCH THREADS DEPS CXXFLAGS
fail() { echo "$1"; cat "$STUB_LOG"; [ ! -f "$scratch/out" ] || cat "$scratch/out"; exit 1; }
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
rm -r build/quick
run all-data QUICK=0 B=seven
[ -d seven/data ] || fail "QUICK=0 is quick"

# Two makes at once, from nothing, and one whose files are from tomorrow.
STUB_SLEEP=0.1 make DEPS=skip all-data B=eight > "$scratch/other" 2>&1 &
STUB_SLEEP=0.1 run all-data B=eight
wait $! || { cat "$scratch/other"; fail "one of two makes at once"; }
[ "$(grep -c -- --out "$STUB_LOG")" = "$chapters" ] || fail "two makes at once compute twice"
cat "$scratch/out" "$scratch/other" | grep -q 'wait  ' || fail "a make that waits does not say so"
touch -d tomorrow src/*.cpp figures/*.gp
run all-data

# Who cannot write is told so, and not what went wrong yesterday.
mkdir closed
echo "error of yesterday" > closed/build.log
if [ "$(id -u)" = 0 ]; then
  chown -R 65534 closed && chmod 555 closed && chmod -R a+rX "$scratch"
  as_other="setpriv --reuid=65534 --regid=65534 --clear-groups"
else
  chmod 555 closed && as_other=
fi
$as_other make DEPS=skip all-data B=closed > "$scratch/out" 2>&1 && fail "a closed folder is built in"
grep -q 'cannot write to' "$scratch/out" || { cat "$scratch/out"; fail "a closed folder is not named"; }
grep -q yesterday "$scratch/out" && fail "an old log is shown as the cause"
chmod 755 closed

# A path that CMake or make cannot use is refused in one line.
mkdir "$scratch/a;b"
cp -r Makefile tools figures src apt-packages.txt "$scratch/a;b"
(cd "$scratch/a;b" && make DEPS=skip all-data > "$scratch/out" 2>&1) && fail "a path with a semicolon is taken"
grep -q "has a character in its name" "$scratch/out" || { cat "$scratch/out"; fail "the path is not named"; }

# Without the tools that draw nothing is computed in vain.
mkdir "$scratch/few"
for tool in sh awk sed grep nproc date mkdir git id dirname cat rm touch make; do
  ln -s "$(command -v $tool)" "$scratch/few/$tool"
done
: > "$STUB_LOG"
PATH="$scratch/few" make DEPS=skip figures B=nine > "$scratch/out" 2>&1 && fail "figures without gnuplot"
grep -q 'missing: gnuplot' "$scratch/out" || { cat "$scratch/out"; fail "gnuplot is not missed"; }
grep -q -- --out "$STUB_LOG" && fail "computed before gnuplot is missed"

# Names of folders are names of targets too.
make -n tests DEPS=skip 2>&1 | grep -q ctest || fail "make tests tests nothing"
make -n examples DEPS=skip 2>&1 | grep -q ctest || fail "make examples does nothing"

# A name that is mistyped is answered in one line.
for wrong in fgi04 figure7 build/data/sec99/facts.ecsv; do
  code=0
  make DEPS=skip $wrong > "$scratch/out" 2>&1 || code=$?
  [ "$code" = 2 ] || { cat "$scratch/out"; fail "make $wrong ends with $code"; }
  [ "$(wc -l < "$scratch/out")" = 1 ] || { cat "$scratch/out"; fail "make $wrong is answered in several lines"; }
  grep -q "'$wrong'.*make help" "$scratch/out" || { cat "$scratch/out"; fail "make $wrong is not answered"; }
done

# On a terminal one sees what is compiled, elsewhere one line says that something is, and none if nothing is.
stub slow <<'STUB'
#!/bin/sh
for k in 1 2; do echo "[ ${k}0%] Building CXX object CMakeFiles/x.dir/src/sec2_nonexistence.cpp.o"; done
STUB
mkdir "$scratch/terminal"
cp "$scratch/bin/slow" "$scratch/terminal/cmake"
if script -qec true /dev/null < /dev/null > /dev/null 2>&1; then
  PATH="$scratch/terminal:$PATH" script -qec "sh tools/build.sh build 1 programs" /dev/null < /dev/null > "$scratch/out" 2>&1
  grep -q '20%.*sec2_nonexistence' "$scratch/out" || fail "compiling shows nothing on a terminal"
else
  echo "no terminal can be made here: what it shows while compiling is not tested"
fi
PATH="$scratch/terminal:$PATH" sh tools/build.sh build 1 programs > "$scratch/out" 2>&1
grep -q 'build    programs on 1 core: about .* minutes .*build/build.log' "$scratch/out" ||
  fail "compiling does not say what it does"
[ "$(wc -l < "$scratch/out")" = 1 ] || fail "compiling talks into a log"
[ "$(wc -l < build/build.log)" = 2 ] || fail "compiling leaves no log"
sh tools/build.sh build 1 programs > "$scratch/out" 2>&1
[ -s "$scratch/out" ] && fail "what is not compiled is announced"

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
printf '#!/bin/sh\nexit 1\n' | stub python3
stub rsvg-convert <<'STUB'
#!/bin/sh
while [ $# -gt 1 ]; do shift; done
printf 'image\n%%%%EOF IEND\n' > "$1"
STUB
echo 'import sys; open(sys.argv[2], "w").write("drawn</svg>")' > "figures/$script"
stub gnuplot <<'STUB'
#!/bin/sh
echo "<svg></svg>"
STUB
if /usr/bin/python3 -c 'import matplotlib' 2>/dev/null; then
  run x01
  [ "$(cat build/figures/"${script%.py}".svg)" = "drawn</svg>" ] || fail "no figure"
  tail -n 1 "$scratch/out" | grep -q "build/figures/${script%.py}.png" || fail "the figure's place is not said"
  # One that the shell exports is only tried: it need not be able to draw.
  rm -f build/figures/x01*
  PYTHON=python3 run x01
  # A table that is not what its program wrote is drawn by nobody; one that is gone is computed again.
  table=build/data/sec34_kink/kink_transition.ecsv
  run x01
  grep -q draw "$scratch/out" && fail "a figure is drawn again without a reason"
  refused() {
    for target in x01 build/figures/"${script%.py}".svg; do
      make DEPS=skip "$target" > "$scratch/out" 2>&1 && fail "$1 is drawn"
      grep -q "$2" "$scratch/out" || { cat "$scratch/out"; fail "$1 is not named"; }
    done
  }
  sed -i "1i # - {parameters: 'quick = yes'}" build/data/sec34_kink/*.ecsv
  refused "a quick run" "build/data/sec34_kink/results.ecsv: of a quick run; remove build/data/sec34_kink to"
  sed -i 1d build/data/sec34_kink/*.ecsv
  sed -i s/1/2/ $table
  refused "a changed table" "$table: not what sec34_kink wrote"
  rm $table
  run x01
  [ "$(grep -c 'sec34_kink --out' "$STUB_LOG")" = 1 ] || fail "a missing table is not computed again"
  grep -q 'draw *x01' "$scratch/out" || fail "a new table is not drawn"
  # What a run took altogether is said by the run, and not by who looks at it hours later.
  mkdir lineage
  : > lineage/__main__.py
  run figures images=
  grep -q '^together   : [0-9]* s' "$scratch/out" || fail "a run does not say how long it took"
  echo 0 > build/report/start
  run summary
  grep -q '^computing  : [0-9]* s in' "$scratch/out" || fail "the summary does not say what the programs took"
  grep -Eq 'together|[0-9]{3} s' "$scratch/out" && fail "the summary counts the hours since the run"
fi
rm -f build/figures/x01*
cp /usr/bin/python3 "$scratch/a b/python3" 2>/dev/null || exit 0
run x01 PYTHON="$scratch/a b/python3"
[ -f "build/figures/${script%.py}.pdf" ] || fail "PYTHON= with a space"
