#!/bin/sh
# Makes one drawing, $1, under a temporary name of its own, and gives it its own name only if it is whole:
#   draw.sh OUT.svg DATA SCRIPT      a script of figures/ draws from the tables below DATA
#   draw.sh OUT.pdf|OUT.png IN.svg   the same picture in another form
#   draw.sh                          only asks whether there is what draws, before hours are spent on computing
# FROM lists the files from which make wants it made; tables among them must be what their programs wrote.
# Tools end with success also where they could not write, but every form has an end that a cut file lacks.
set -eu
if [ $# = 0 ]; then
  missing=
  lacks() { missing="$missing, $1 (Debian: $2)"; }
  command -v gnuplot >/dev/null 2>&1 || lacks "gnuplot 5.4" gnuplot-nox
  command -v rsvg-convert >/dev/null 2>&1 || lacks "rsvg-convert 2.54" librsvg2-bin
  "${PYTHON:-python3}" -c 'import importlib.util as u; u.find_spec("matplotlib").name' 2>/dev/null ||
    lacks "python3 with matplotlib 3.6" python3-matplotlib
  [ -n "$missing" ] || exit 0
  echo "missing: ${missing#, } (allowed: these versions or newer ones; make install-deps installs them, PYTHON=... names another python3)" >&2
  exit 1
fi
out=$1 part=$1.$$.part
refuse() {
  rm -f "$part"
  echo "$out: $1" >&2
  exit 1
}

if [ $# = 3 ]; then
  # shellcheck disable=SC2086
  [ -z "${FROM:-}" ] || PYTHONPATH="${0%/*}${PYTHONPATH:+:$PYTHONPATH}" "${PYTHON:-python3}" -m lineage tables $FROM || exit 1
  case $3 in
  *.gp) gnuplot --default-settings -e "data='$2'; out='/dev/stdout'" "$3" > "$part" || refuse "gnuplot failed" ;;
  *) PYTHONPATH="${0%/*}/../figures${PYTHONPATH:+:$PYTHONPATH}" "$PYTHON" "$3" "$2" "$part" || refuse "the drawing failed" ;;
  esac
else
  case $out in
  *.pdf) rsvg-convert --format pdf "$2" --output "$part" || refuse "rsvg-convert failed" ;;
  *) rsvg-convert --zoom 2.5 "$2" --output "$part" || refuse "rsvg-convert failed" ;;
  esac
fi

case $out in
*.svg) end='</svg>' ;;
*.pdf) end='%%EOF' ;;
*) end='IEND' ;;
esac
tail -c 64 "$part" | grep -aq -- "$end" || refuse "the drawing is cut short (is the disk full?)"
mv "$part" "$out"
