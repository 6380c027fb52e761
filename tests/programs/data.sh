#!/bin/sh
# The examples of README.md and book/data.md, as they stand there: Python's by doctest, readers of tables against one of
# our own, a command against the table of its figure. Then the scan of examples/. A module that is not installed is passed
# over with a line. Arguments: the repository, the build folder, the python for which the module is built, if it is.
set -eu
python=${3:-}
root=$(cd "$1" && pwd -P)
build=$(cd "$2" && pwd -P)
table=data/sec34_impact/velocity_sweep.ecsv
[ -f "$build/$table" ] || { echo "no $table (make figures)"; exit 1; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
ln -s "$build" build
export PYTHONPATH="$build/python" PYTHONDONTWRITEBYTECODE=1

# The k-th block of code in the language $2 of the page $1, k = $3.
block() { awk -v open="\`\`\`$2" -v k="$3" '/^```/ { if (on) exit; if ($0 == open && ++n == k) { on = 1; next } } on' "$root/$1"; }
fail() { echo "$1"; exit 1; }
has() { "$python" -c "import $1" 2> /dev/null || { echo "skipped: $1 is not installed"; return 1; }; }

# The largest speed in the linear well, read here in a way of its own: the columns by their places.
ought=$(awk -F, '!/^#/ && $1 + 0 == 0 && $1 != "s" && $4 > most { most = $4 } END { printf "%.17g", most }' "build/$table")
agree() {
  echo "$2" | awk -v ought="$ought" '{ d = $1 - ought; if (d < 0) d = -d; exit !(d <= 1e-14 * ought) }' || fail "$1: $2 instead of $ought"
}
k=0
for module in pandas astropy; do
  k=$((k + 1))
  block book/data.md python $k > a.py
  if has $module; then agree $module "$("$python" -W ignore a.py)"; fi
done
if has lattice; then
  # What README prints, and its run of one's own with a picture
  sed 's/^```.*//' "$root/README.md" > readme
  "$python" -m doctest readme || fail "an example of README.md"
  block README.md python 2 > a.py
  MPLBACKEND=Agg "$python" a.py > said || fail "the run of one's own in README.md"
  { grep -q '^energy' said && [ -s fig19_pendulum.png ]; } || fail "the run of one's own in README.md: $(cat said)"
fi

# The command prints what figure 19 shows at its velocity, bit by bit.
block book/data.md sh 1 > a.sh
velocity=$(sed 's/.*--velocity \([^ ]*\).*/\1/' a.sh)
sh a.sh | awk -F, '$1 == "speed" { print $2 }' > printed
awk -F, -v v="$velocity" '!/^#/ && $1 == 0 && $2 > v - 1e-9 && $2 < v + 1e-9 { print $4 }' "build/$table" | cmp -s - printed ||
  fail "at the velocity $velocity the command of book/data.md prints $(cat printed)"

# A scan of one's own: three points, of which one fails; called again, it goes on where it was cut off.
if has lattice; then
  printf 'import scan\nscan.scan("scan.csv", [(1.0, 0.0), (0.5, 1.0), (2.5, -0.25)])\n' > a.py
  scan() { PYTHONPATH="$build/python:$root/examples" SLURM_CPUS_PER_TASK=2 "$python" a.py; }
  scan
  awk -F, '$1 < 2.5 && NR > 1 { good += $3 > 0.1 && $4 > 0 && $4 < 1e-4 && NF == 5 && $5 == "" }
    $1 == 2.5 { failed += $3 == "nan" && $5 != "" } END { exit !(good == 2 && failed == 1 && NR == 4) }' scan.csv ||
    fail "examples/scan.py: $(cat scan.csv)"
  sort scan.csv > whole
  head -c -20 scan.csv > part
  mv part scan.csv
  scan
  sort scan.csv | cmp -s - whole || fail "examples/scan.py does not go on where it was: $(cat scan.csv)"
fi
echo "the examples of README.md and book/data.md hold"
