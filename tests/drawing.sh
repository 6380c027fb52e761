#!/bin/sh
# A drawing gets its name only if it is whole, and a table that was changed after the run, or that is of a quick one, is
# drawn by nobody. A python that lacks a module says which.
# Argument: the repository.
set -eu
root=$(cd "$1" && pwd -P)
scratch=$(mktemp -d)
mounted=
trap '[ -z "$mounted" ] || umount "$scratch/small"; rm -rf "$scratch"' EXIT
fail() { echo "$1"; cat "$scratch/said"; exit 1; }
for p in python3 /usr/bin/python3; do
  "$p" -c 'import matplotlib' 2>/dev/null && PYTHON=$p && break
done
export PYTHON MATPLOTLIBRC="$root/figures" MPLBACKEND=Agg
draw() { sh "$root/tools/draw.sh" "$@" > "$scratch/said" 2>&1; }
cd "$scratch"

# Two drawings, by either tool, large enough to be cut.
cat > curve.gp <<'GP'
set terminal svg
set output out
plot for [k=1:20] sin(k*x)
GP
cat > curve.py <<'PY'
import sys
import matplotlib.pyplot as plt
plt.plot([x * x % 97 for x in range(9000)])
plt.savefig(sys.argv[2], format="svg")
PY
mkdir small
for script in curve.gp curve.py; do
  draw good.svg data "$script" || fail "$script is not drawn"
  draw good.pdf good.svg || fail "no PDF"
  draw good.png good.svg || fail "no PNG"
  [ ! -e good.svg.part ] || fail "a temporary file stays"
  printf 'error\n' > broken.gp
  rm good.svg
  draw good.svg data broken.gp && fail "a script that fails is not noticed"
  [ ! -e good.svg ] || fail "a failed drawing has a name"
done

# A picture that was cut is refused even if the tool is content: stubs that write too little and succeed.
mkdir stubs
printf '#!/bin/sh\necho "<svg>"\n' > stubs/gnuplot
cat > stubs/rsvg-convert <<'STUB'
#!/bin/sh
while [ $# -gt 1 ]; do shift; done
echo cut > "$1"
STUB
chmod +x stubs/*
echo '<svg></svg>' > whole.svg
for out in cut.svg cut.pdf cut.png; do
  case $out in *.svg) PATH="$scratch/stubs:$PATH" draw $out data curve.gp ;; *) PATH="$scratch/stubs:$PATH" draw $out whole.svg ;; esac &&
    fail "$out is cut and not noticed"
  grep -q 'cut short' said || fail "$out: the reason is not said"
  ! ls $out* >/dev/null 2>&1 || fail "$out stays"
done

# A disk that is really full, where we may mount one.
if mount -t tmpfs -o size=20k tmpfs small 2>/dev/null; then
  mounted=yes
  for script in curve.gp curve.py; do
    draw small/full.svg data "$script" && fail "$script: a full disk is not noticed"
    ! ls small/full.svg* >/dev/null 2>&1 || fail "$script: a cut drawing stays"
  done
else
  echo "no disk can be mounted here: a full one is tested by stubs only"
fi

# Tables are what the program wrote.
tables() { sh "$root/tools/tables.sh" data > said 2>&1; }
mkdir -p data/prog
printf '# who\nx,y\n1,2\n3,4\n' > data/prog/speeds.ecsv
printf '# who\nid\n' > data/prog/results.ecsv
for t in speeds results; do
  printf '%s  %s\n' "$(grep -v '^#' data/prog/$t.ecsv | sha256sum | cut -c -64)" $t.ecsv
done > data/prog/SHA256SUMS
tables || fail "whole tables are refused"
sed -i 's/who/whoever/' data/prog/speeds.ecsv
tables || fail "a header does not count"
cp data/prog/speeds.ecsv kept
sed -i 's/1,2/1,4/' data/prog/speeds.ecsv
tables && fail "a doubled value is not noticed"
grep -q 'data/prog/speeds.ecsv: not what prog wrote' said || fail "the changed table is not named"
sed '/3,4/d' kept > data/prog/speeds.ecsv
tables && fail "a deleted row is not noticed"

# Nor does a script draw them, however it is called.
cat > speeds.py <<'PY'
import sys
sys.path.insert(0, sys.argv.pop())
import draw
data, out = draw.arguments()
figure, axes = draw.plt.subplots()
axes.plot(draw.read(f"{data}/prog/speeds.ecsv")["y"])
draw.save(figure, out)
PY
by_hand() { PYTHONDONTWRITEBYTECODE=1 "$PYTHON" speeds.py "$1" speeds.svg "$root/figures" > said 2>&1; }
refused() { by_hand "$1" && fail "$2 is drawn"; [ "$(cat said)" = "$3" ] || fail "$2 is not named in one line"; }
refused data "a changed table" "data/prog/speeds.ecsv: not what prog wrote; remove it to have it computed again"
FROM="speeds.py data/prog/speeds.ecsv" draw good.svg data curve.gp && fail "a changed table is drawn by gnuplot"
[ ! -e good.svg ] || fail "a drawing of a changed table has a name"
grep -q 'speeds.ecsv: not what prog wrote' said || fail "a changed table is not named"
cp kept data/prog/speeds.ecsv

# Tables of a quick run are drawn where they belong.
mkdir -p other build/quick
cp -r data other/data
sed -i "1i # - {parameters: 'quick = yes'}" other/data/prog/*.ecsv
mv other/data build/quick/data
cp -r build/quick/data other/data
quick="other/data/prog/results.ecsv: of a quick run; remove other/data/prog to have it computed again"
sh "$root/tools/tables.sh" other/data > said 2>&1 && fail "tables of a quick run are taken"
[ "$(cat said)" = "$quick" ] || fail "a quick run is not named in one line"
FROM="other/data/prog/results.ecsv" draw good.svg other/data curve.gp && fail "a quick run is drawn by gnuplot"
[ "$(cat said)" = "$quick" ] || fail "gnuplot: a quick run is not named in one line"
refused other/data "a quick run" "other/data/prog/speeds.ecsv: of a quick run; remove other/data/prog to have it computed again"
sh "$root/tools/tables.sh" build/quick/data > said 2>&1 || fail "a quick run is refused in its own folder"
by_hand build/quick/data || fail "a quick run is not drawn from its own folder"
FROM="build/quick/data/prog/speeds.ecsv" draw good.svg build/quick/data curve.gp || fail "gnuplot does not draw a quick run"

# A table that is gone is computed again.
rm data/prog/speeds.ecsv
tables || fail "a missing table is an error"
[ ! -e data/prog/results.ecsv ] || fail "a missing table is not computed again"

# A python without numpy and matplotlib: a script says which module it lacks, and how to get it.
mkdir bare
echo 'import sys; sys.modules.update(numpy=None, matplotlib=None)' > bare/sitecustomize.py
for script in "$root"/figures/draw.py "$root"/figures/fig08*.py "$root"/figures/x04*.py "$root/python/notebooks.py"; do
  PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=bare "$PYTHON" "$script" > said 2>&1 && fail "$script draws without matplotlib"
  grep -qx '[a-z]*: .* has no module matplotlib (Debian: python3-matplotlib; PYTHON=.*)' said || fail "$script does not say what is missing"
  [ "$(wc -l < said)" = 1 ] || fail "$script says it in more than one line"
done
for script in "$root"/figures/[!d]*.py; do
  awk '/^import (draw|spectra)$/ { first = 1 } /^(import|from) (matplotlib|numpy)/ && !first { exit 1 }' "$script" ||
    { echo "$script" > said; fail "a script does not import draw first"; }
done
