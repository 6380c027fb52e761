#!/bin/sh
# The examples of DATA.md, as they stand there: each prints the largest speed of figure 19 in the linear well, and all
# must agree. A tool that is not installed is passed over with a line. Arguments: the repository, the build folder.
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

# What all must give, read here in a way of its own: the columns by their places.
ought=$(awk -F, '!/^#/ && $1 + 0 == 0 && $1 != "s" && $3 > most { most = $3 } END { printf "%.17g", most }' "build/$table")
block awk 1 > a.awk
agree awk awk -f a.awk "build/$table"
for label in gnuplot pandas astropy octave julia; do
  case $label in
  gnuplot) there gnuplot --version && { block gnuplot 1 > a.gp; agree gnuplot gnuplot --default-settings a.gp; } ;;
  pandas | astropy)
    for python in python3 /usr/bin/python3 none; do "$python" -c "import $label" 2> /dev/null && break; done
    there "$python" -c "import $label" && {
      block python "$([ $label = pandas ] && echo 1 || echo 2)" > a.py
      agree $label "$python" -W ignore a.py
    } ;;
  octave) there octave-cli --version && { block octave 1 > a.m; agree octave octave-cli --norc --quiet a.m; } ;;
  julia) there julia --version && { block julia 1 > a.jl; agree julia julia a.jl; } ;;
  esac || [ $? = 1 ]
done
[ "$tried" -ge 2 ] || { echo "only $tried example was tried"; exit 1; }
echo "$tried examples agree: $ought"
