#!/bin/sh
# shellcheck disable=SC2016  # stubs are texts
# The Makefile and tools/ in a small checkout with stubs for what compiles, computes and draws: what runs again and what
# does not, two makes at once, runs that are killed, copied checkouts, drawings that are cut, and tables that are not what
# their program wrote. Argument: the repository.
set -eu
root=$(cd "$1" && pwd -P)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
here="$scratch/a b/[Re] it's here"
for volume in . beyond; do mkdir -p "$here/$volume/src" "$here/$volume/paper" "$here/$volume/figures"; done
mkdir "$scratch/bin"
cd "$here"
cp -r "$root/Makefile" "$root/tools" .
cp "$root"/figures/draw.py "$root"/figures/matplotlibrc "$root"/figures/style.gp figures
# Three programs with a figure each, and a second volume with one.
names=id,label,section,program,script,data,caption,details
printf '%s\n' $names '01,one,1,sec1_short,fig01_short.gp,short,"One.","(a) So, or so."' '02,two,1,sec2_long,fig02_long.gp,long,"Two.","(a) So, or so."' \
  'x01,"",3,sec3_own,x01_own.py,own,"Three.","(a) So, or so."' > figures/figures.ecsv
printf '%s\n' $names 'x02,"",5,sec5_far,x02_far.py,far,"Four.","(a) So, or so."' > beyond/figures/figures.ecsv
printf 'program,seconds\nsec1_short,1\nsec2_long,9.5\nsec3_own,12\n' > paper/costs.ecsv
printf 'program,seconds\nsec5_far,2\n' > beyond/paper/costs.ecsv
touch src/sec1_short.cpp src/sec2_long.cpp src/sec3_own.cpp beyond/src/sec5_far.cpp
for script in fig01_short fig02_long; do printf 'print "<svg></svg>"\n' > figures/$script.gp; done
echo 'import draw, sys; open(sys.argv[2], "w").write("drawn</svg>")' | tee figures/x01_own.py > beyond/figures/x02_far.py
export STUB_LOG="$scratch/log" STUB_PROGRAM="$scratch/bin/program"

stub() { cat > "$scratch/bin/$1"; chmod +x "$scratch/bin/$1"; }
# `cmake -S . -B build` leaves a cache, `cmake --build build` copies programs that note how they were called.
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
  mkdir -p "$2/bin"
  cp "$2/CMakeCache.txt" "$2/bin/.home"
  for source in src/*.cpp beyond/src/*.cpp; do
    name=$(basename "$source" .cpp) all=programs
    case $source in beyond/*) all=programs_beyond ;; esac
    case " $* " in *" $name "* | *" $all "*) ;; *) continue ;; esac
    [ "$2/bin/$name" -nt "$source" ] || { cat "$STUB_PROGRAM" "$source" > "$2/bin/.$name"; chmod +x "$2/bin/.$name"; mv "$2/bin/.$name" "$2/bin/$name"; }
  done
  for judge in verdicts verdicts_beyond; do printf '#!/bin/sh\n' > "$2/bin/$judge" && chmod +x "$2/bin/$judge"; done ;;
esac
STUB
stub program <<'STUB'
#!/bin/sh
echo "${0##*/} $*" >> "$STUB_LOG"
there=$(realpath "$0")
cd "$2"
rm -f SHA256SUMS
sleep "${STUB_SLEEP:-0}"
name=${0##*_}
printf '# header\nx\n1\n' > "$name.ecsv"
printf 'what,value\nprogram,%s\n' "$(sha256sum < "$there" | cut -d' ' -f1)" > run.ecsv
sha256sum "$name.ecsv" > SHA256SUMS.new
mv SHA256SUMS.new SHA256SUMS
exit 0
STUB
printf '#!/bin/sh\necho launched >> "$STUB_LOG"\nshift\nexec "$@"\n' | stub srun
printf '#!/bin/sh\necho "${STUB_IMAGE-<svg></svg>}"\n' | stub gnuplot
printf '#!/bin/sh\nwhile [ $# -gt 1 ]; do shift; done\necho "${STUB_IMAGE-image %%%%EOF IEND}" > "$1"\n' | stub rsvg-convert
PATH="$scratch/bin:$PATH"
# The python that draws is looked for once, and not by each make.
for PYTHON in python3 /usr/bin/python3; do "$PYTHON" -c 'import matplotlib' 2>/dev/null && break; done
export PYTHON
fail() { echo "$1"; cat "$STUB_LOG" "$scratch/out" 2>/dev/null; exit 1; }
run() { : > "$STUB_LOG"; make DEPS=skip "$@" > "$scratch/out" 2>&1 || fail "make $*"; }
refused() { : > "$STUB_LOG"; ! make DEPS=skip "$@" > "$scratch/out" 2>&1 || fail "make $* is not refused"; }
said() { grep -q -- "$1" "$scratch/out" || fail "$2"; }
ran() { [ "$(cut -d' ' -f1 "$STUB_LOG" | tr '\n' ' ')" = "$1" ] || fail "$2"; }
called() { grep -q -- "$1" "$STUB_LOG" || fail "$2"; }

# Every program runs once, the dearest first, and again only if its bytes are others.
run all-data
ran "sec3_own sec2_long sec1_short " "not every program ran, or not in the order of their costs"
touch src/sec1_short.cpp
run all-data
ran "" "a program that was built again to the same bytes runs again"
echo '# changed' >> src/sec1_short.cpp
run all-data
ran "sec1_short " "a changed program does not run"

# Threads: all granted cores, a share with -j, what is asked for, and none where srun decides.
threads() { rm -rf build/data; want=$1; shift; run all-data "$@"; called "--threads $want" "threads: $* do not give $want"; }
threads 6 CORES=6
threads 2 CORES=6 -j3
threads 5 THREADS=5 -j2
rm -rf build/data
run all-data LAUNCH='srun -n1'
called launched "LAUNCH= is ignored"
grep -q -- '--threads' "$STUB_LOG" && fail "srun is told how many threads to use"
run all-data QUICK=1
called '--out build/quick/data/.* --quick' "QUICK=1"

# Two makes at once, from nothing.
STUB_SLEEP=0.2 make DEPS=skip all-data B=eight > "$scratch/other" 2>&1 &
STUB_SLEEP=0.2 run all-data B=eight
wait $! || { cat "$scratch/other"; fail "one of two makes at once"; }
[ "$(wc -l < "$STUB_LOG")" = 3 ] || fail "two makes at once compute twice"
cat "$scratch/other" >> "$scratch/out"
said 'wait  ' "a make that waits does not say so"

# A name that is mistyped is answered in one line.
refused build/data/sec99/SHA256SUMS
said "'build/data/sec99/SHA256SUMS'.*make help" "a mistyped name is not answered"
[ "$(wc -l < "$scratch/out")" = 1 ] || fail "a mistyped name is answered in several lines"
make -n tests DEPS=skip 2>&1 | grep -q ctest || fail "make tests tests nothing: there is a folder of that name"

# The tests that are asked for.
printf '#!/bin/sh\necho "$*" >> "$STUB_LOG"\n' | stub ctest
echo 'lattice/orbits/floquet tests_lattice_orbits' > build/tests.txt
run test T=floquet
called '-R .*(floquet)' "T=floquet runs no test"
refused test T=floq
said "'floq' is not a test" "a test that is none is not named"

# A run that is killed leaves no answer, and the next make goes on where it was.
rm -r build/data
STUB_SLEEP=1.5 timeout -s INT 2.6 make DEPS=skip all-data > "$scratch/out" 2>&1 && fail "not killed"
run all-data
ran "sec2_long sec1_short " "the next make did not go on"

# A copy is built for itself, as is a checkout that was moved.
cp -r "$here" "$scratch/copy"
(cd "$scratch/copy" && run all-data && said 'rebuilding everything' "the copy does not say what it does" &&
  grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" build/bin/.home) || fail "the copy builds the original"

# Without the tools that draw nothing is computed in vain.
mkdir "$scratch/few"
ln -sf /usr/bin/* "$(command -v make)" "$scratch/bin/cmake" "$scratch/few"
rm -f "$scratch/few/gnuplot" "$scratch/few/rsvg-convert"
PATH="$scratch/few" refused figures B=nine
said 'missing: gnuplot' "gnuplot is not missed"
ran "" "computed before gnuplot is missed"

# All figures of a volume, in as many words; one figure, and it again.
rm -rf build
run figures
[ "$(find build/figures -name '*.pdf' | wc -l) $(wc -l < "$STUB_LOG")" = "3 3" ] || fail "make figures draws or runs something else than its volume"
head -n 1 "$scratch/out" | grep -q '^figures    : compile all, compute 3 programs, draw 3 figures: about [0-9]* min on' ||
  fail "make figures does not begin with what it will do"
said '^together   : [0-9]* s' "a run does not say how long it took"
said '^computing  : [0-9]* s in 3 programs' "the summary does not say what the programs took"
run beyond
ran "sec5_far " "make beyond does not run the programs of its volume only"
said '^computing  : [0-9]* s in 1 programs' "the summary of volume two does not say what its programs took"
rm build/figures/x02*
run x2
[ -f build/figures/x02_far.pdf ] || fail "a figure of volume two has no command"
mv beyond "$scratch/beyond"
run figures
ran "" "without volume two something runs again"
mv "$scratch/beyond" beyond
rm build/figures/x01*
run x1
[ "$(tail -n 1 "$scratch/out")" = "  figure   build/figures/x01_own.png" ] || fail "the figure's place is not said"
run x01
grep -q draw "$scratch/out" && fail "a figure is drawn again without a reason"

# A table that is not what its program wrote is drawn by nobody; one that is gone is computed again.
own=build/data/sec3_own/own.ecsv
written() { (cd build/data/sec3_own && sha256sum own.ecsv > SHA256SUMS); }
sed -i "1i # - {parameters: 'quick = yes'}" $own
written
refused x01
said "$own: from a quick run; remove build/data/sec3_own to" "a quick table is drawn"
sed -i 1d $own
written
sed -i s/1/2/ $own
refused x01
said "$own: not as SHA256SUMS has it; remove it to" "a changed table is drawn"
rm $own
run x01
ran "sec3_own " "a missing table is not computed again"
said 'draw *x01' "a new table is not drawn"

# A script that fails and a picture that was cut have no name, even if the tool is content.
rm build/figures/*
for image in svg pdf png; do
  STUB_IMAGE='cut' refused build/figures/fig01_short.$image
  said 'cut short' "$image is cut and not noticed"
  [ ! -f build/figures/fig01_short.$image ] || fail "$image stays"
  run build/figures/fig01_short.$image
done
echo 'raise SystemExit(1)' > figures/x01_own.py
refused x01
said 'the drawing failed' "a script that fails is not noticed"
