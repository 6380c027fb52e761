#!/bin/sh
# What draws must be there before hours are spent on computing. $1 is the python that has matplotlib.
missing=
for tool in gnuplot rsvg-convert; do command -v "$tool" >/dev/null 2>&1 || missing="$missing $tool"; done
"${1:-python3}" -c 'import matplotlib' 2>/dev/null || missing="$missing python3-with-matplotlib"
[ -z "$missing" ] && exit 0
echo "missing:$missing (make install-deps installs them; PYTHON=... names another python3)" >&2
exit 1
