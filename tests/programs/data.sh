#!/bin/sh
# The examples of DATA.md, as they stand there: each prints the largest speed of figure 19 in the linear well, and all
# must agree; numpy's must read every table, and the command must print what the figure shows. Then the scan of
# examples/. A tool that is not installed is passed over with a line. Arguments: the repository, the build folder.
set -eu
root=$(cd "$1" && pwd -P)
build=$(cd "$2" && pwd -P)
table=data/sec34_impact/velocity_sweep.ecsv
[ -f "$build/$table" ] || { echo "no $table (make figures)"; exit 1; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
ln -s "$build" build

# The k-th block of code in the language $1, k = $2.
block() { awk -v open="\`\`\`$1" -v k="$2" '/^```/ { if (on) exit; if ($0 == open && ++n == k) { on = 1; next } } on' "$root/DATA.md"; }

tried=0
agree() {
  name=$1
  shift
  if ! said=$("$@" 2> err); then cat err; echo "$name: the example of DATA.md fails"; exit 1; fi
  echo "$said" | awk -v name="$name" -v ought="$ought" '
    { d = $1 - ought; if (d < 0) d = -d; if (NF != 1 || !(d <= 1e-14 * ought)) { print name ": " $0 " instead of " ought; exit 1 } }
    END { exit NR != 1 }' || { echo "$name: $said instead of $ought"; exit 1; }
  tried=$((tried + 1))
}
there() { "$@" > /dev/null 2>&1 || { echo "skipped: $label is not installed"; return 1; }; }

# Any table is read whole, with as many rows and columns as it has.
every_table() {
  for path in build/data/*/*.ecsv; do
    sed -e "s|build/data/sec34_impact/velocity_sweep.ecsv|$path|" -e '/^print/d' a.py
    echo "assert table.size == len(rows) - 1 and len(table.dtype) == len(rows[0].split(chr(9))), '$path'"
  done > every.py
  "$1" -W error every.py || { echo "numpy: the example of DATA.md does not read every table"; exit 1; }
}

# What all must give, read here in a way of its own: the columns by their places.
ought=$(awk -F, '!/^#/ && $1 + 0 == 0 && $1 != "s" && $3 > most { most = $3 } END { printf "%.17g", most }' "build/$table")
block awk 1 > a.awk
agree awk awk -f a.awk "build/$table"
for label in gnuplot numpy pandas astropy octave julia; do
  case $label in
  gnuplot) there gnuplot --version && { block gnuplot 1 > a.gp; agree gnuplot gnuplot --default-settings a.gp; } ;;
  numpy | pandas | astropy)
    for python in python3 /usr/bin/python3 none; do "$python" -c "import $label" 2> /dev/null && break; done
    there "$python" -c "import $label" && {
      case $label in numpy) k=1 ;; pandas) k=2 ;; *) k=3 ;; esac
      block python $k > a.py
      agree $label "$python" -W ignore a.py
      [ $label != numpy ] || every_table "$python"
    } ;;
  octave) there octave-cli --version && { block octave 1 > a.m; agree octave octave-cli --norc --quiet a.m; } ;;
  julia) there julia --version && { block julia 1 > a.jl; agree julia julia a.jl; } ;;
  esac || [ $? = 1 ]
done
# The command prints what figure 19 shows at its velocity, bit by bit.
block sh 1 > a.sh
velocity=$(sed 's/.*--velocity \([^ ]*\).*/\1/' a.sh)
sh a.sh | awk -F, '$1 == "speed" { print $2 }' > printed
awk -F, -v v="$velocity" '!/^#/ && $1 == 0 && $2 > v - 1e-9 && $2 < v + 1e-9 { print $3 }' "build/$table" | cmp -s - printed ||
  { echo "at the velocity $velocity the command of DATA.md prints $(cat printed)"; exit 1; }

# A scan of one's own: three points, of which one fails; called again, it goes on where it was cut off.
for python in /usr/bin/python3 python3 none; do
  PYTHONPATH="$build/python" "$python" -c "import lattice" 2> /dev/null && break
done
label="the Python module"
if PYTHONPATH="$build/python" there "$python" -c "import lattice"; then
  printf 'import scan\nscan.scan("scan.csv", [(1.0, 0.0), (0.5, 1.0), (2.5, -0.25)])\n' > a.py
  scan() { PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="$build/python:$root/examples" SLURM_CPUS_PER_TASK=2 "$python" a.py; }
  scan
  awk -F, '$1 < 2.5 && NR > 1 { good += $3 > 0.1 && $4 > 0 && $4 < 1e-4 && NF == 5 && $5 == "" }
    $1 == 2.5 { failed += $3 == "nan" && $5 != "" } END { exit !(good == 2 && failed == 1 && NR == 4) }' scan.csv ||
    { cat scan.csv; echo "examples/scan.py"; exit 1; }
  sort scan.csv > whole
  head -c -20 scan.csv > part
  mv part scan.csv
  scan
  sort scan.csv | cmp -s - whole || { cat scan.csv; echo "examples/scan.py does not go on where it was"; exit 1; }
fi
[ "$tried" -ge 2 ] || { echo "only $tried example was tried"; exit 1; }
echo "$tried examples agree: $ought"
