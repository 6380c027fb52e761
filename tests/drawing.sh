#!/bin/sh
# A drawing gets its name only if it is whole, and a table that was changed after the run is drawn by nobody.
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
rm data/prog/speeds.ecsv
tables || fail "a missing table is an error"
[ ! -e data/prog/results.ecsv ] || fail "a missing table is not computed again"
