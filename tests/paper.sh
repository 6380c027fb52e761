#!/bin/sh
# The paper refers to nothing that is not there, and one that does is refused: by the writer of its numbers,
# which names the reference, and by TeX. Arguments: the repository and the program `report`.
set -eu
root=$(cd "$1" && pwd -P) report=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "$1"; exit 1; }

"$report" macros --root "$root" --out "$scratch/good" || fail "the paper refers to something that is not there"

mkdir "$scratch/bad"
cp -r "$root/paper" "$root/figures" "$root/src" "$scratch/bad"
printf '%s\n' 'is \num{pn.omega12} of \fig{99}' >> "$scratch/bad/paper/paper.tex"
"$report" macros --root "$scratch/bad" --out "$scratch/none" 2> "$scratch/errors" &&
  fail "a missing number is not noticed"
grep -q 'nothing is there for \\num{pn.omega12}' "$scratch/errors" || fail "the missing number is not named"
grep -q 'nothing is there for \\fig{99}' "$scratch/errors" || fail "the missing figure is not named"
[ ! -e "$scratch/none/numbers.tex" ] || fail "numbers were written in spite of that"

# TeX itself: the paper's own preamble, and one sentence.
if ! command -v latexmk >/dev/null 2>&1; then
  echo "latexmk is missing: whether TeX stops at a missing number is not tested"
  exit 0
fi
run_tex() {
  { sed '/^\\begin{document}/q' "$root/paper/paper.tex"; printf '%s\n' "$2" '\end{document}'; } > "$scratch/$1.tex"
  (cd "$scratch" && TEXINPUTS="$root/paper:$scratch/good:" latexmk -norc -pdf -interaction=nonstopmode -halt-on-error \
    "$1.tex" > "$1.said" 2>&1)
}
run_tex there 'It is \num{pn.omega11}.' || { tail -n 20 "$scratch/there.said"; fail "a number that is there stops TeX"; }
run_tex missing 'It is \num{pn.omega12}.' && fail "TeX does not stop at a missing number"
grep -q 'nothing is there for num pn.omega12' "$scratch/missing.log" || fail "TeX does not name the missing number"
