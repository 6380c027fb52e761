#!/bin/sh
# clang-tidy, by the rules of .clang-tidy, on the sources that differ from the commit $1 (without it: on all, which takes
# an hour), and on the source beside a header that differs. It configures a folder of its own, in which nothing is built,
# and finds GCC's header of quadruple precision. Version 16 is the first that knows our C++, and the one that continuous
# integration has; TIDY=... names another one.
set -eu
unset CDPATH
cd "$(dirname "$0")/.."
since=${1:-} tidy=${TIDY:-clang-tidy-16}
command -v "$tidy" > /dev/null || { echo "tidy: $tidy is missing" >&2; exit 1; }
if [ -n "$since" ]; then
  git rev-parse -q --verify "$since^{commit}" >/dev/null || { echo "tidy: '$since' is not a commit" >&2; exit 1; }
  changed=$(git diff --name-only --diff-filter=d "$since" -- src beyond/src)
else
  changed=$(git ls-files src beyond/src)
fi
files=$(echo "$changed" | sed -n 's/\.[hc]pp$/.cpp/p' | sort -u | while read -r file; do [ ! -f "$file" ] || echo "$file"; done)
[ -n "$files" ] || { echo "  tidy     no changes in src and beyond/src"; exit 0; }
log=build/tidy/log
mkdir -p build/tidy
cmake -S . -B build/tidy -D LATTICE_TESTS=OFF -D LATTICE_TOGETHER=OFF > "$log" 2>&1 || { cat "$log"; exit 1; }
bad=0 quadruple=$(c++ -print-file-name=include/quadmath.h)
for file in $files; do
  echo "  tidy     $file"
  "$tidy" -p build/tidy --quiet --extra-arg=-Wno-unknown-warning-option --extra-arg="-idirafter${quadruple%/*}" "$file" \
    > "$log" 2>&1 || { cat "$log"; bad=1; }
done
exit $bad
