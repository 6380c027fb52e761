#!/bin/sh
# The gallery of the README is current, and one that is not is noticed. Arguments: the repository and
# the folder of the figures.
set -eu
root=$1 figures=$2
for python in python3 /usr/bin/python3; do "$python" -c 'import matplotlib' 2>/dev/null && break; done
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
check() { "$python" "$root/tools/gallery.py" "$figures" "$1" --check; }
fail() { echo "$1"; exit 1; }

check "$root/figures/gallery"

cp "$root"/figures/gallery/*.png "$scratch"
cp "$scratch/fig12_site_quadruplet.png" "$scratch/fig11_bond_quadruplet.png"
check "$scratch" > "$scratch/out" 2>&1 && fail "a picture of another figure is not noticed"
grep -q 'fig11_bond_quadruplet: a patch differs' "$scratch/out" || fail "the wrong figure is not named"
cp "$root/figures/gallery/fig11_bond_quadruplet.png" "$scratch"
: > "$scratch/old.png"
rm "$scratch/x08_full_order.png"
check "$scratch" > "$scratch/out" 2>&1 && fail "a missing picture is not noticed"
grep -q 'x08_full_order: missing' "$scratch/out" || fail "the missing picture is not named"
grep -q 'old.png: no such figure' "$scratch/out" || fail "a superfluous picture is not noticed"
