#!/bin/sh
# Compiles the live pages and the sources of the library: build.sh FOLDER makes FOLDER/*.wasm. Where
# the compiler for the browser is missing it says so, and the book is woven without live pages.
set -eu
out=$1
here=$(dirname "$0")
root=$here/../..
runtime=$(find /usr/lib/llvm-14 -name libclang_rt.builtins-wasm32.a 2>/dev/null | head -n 1)
if ! command -v clang++-14 >/dev/null || ! command -v wasm-ld-14 >/dev/null || [ -z "$runtime" ] ||
  [ ! -e /usr/lib/wasm32-wasi/libc++.a ]; then
  echo "live pages : left out, clang-14 for the browser is not installed (apt-packages.txt, [live])"
  rm -f "$out"/*.wasm
  exit 0
fi
mkdir -p "$out"
compile() {  # compile OBJECT SOURCE: where it is older than anything that its compiler has read
  if [ -e "$1" ] && [ -e "${1%.o}.d" ]; then
    # shellcheck disable=SC2046
    changed=$(find "$0" $(sed 's/^[^:]*://; s/\\$//' "${1%.o}.d") -newer "$1") && [ -z "$changed" ] && return
  fi
  rm -f "$1"
  clang++-14 --target=wasm32-wasi -std=c++20 -O2 -fexceptions -fno-rtti -ffp-contract=off \
    -fno-math-errno -msimd128 -I"$root/src" -I/usr/include/eigen3 -MMD -c "$2" -o "$1.part.o" \
    -MF "${1%.o}.d"
  mv "$1.part.o" "$1"
}

# What the pages call of the library: its sources are those of `lattice::core`.
mkdir -p "$out/library"
sources=
for name in model/chain model/contact model/cantilever model/kick_drift stepping/schemes \
  stepping/integrate stepping/contact_rkn stepping/accuracy landing/tangent landing/crossing \
  landing/landing orbits/symmetry orbits/newton orbits/shooting orbits/continuation \
  orbits/breather orbits/floquet measure/observe measure/impact measure/kick measure/depinning \
  measure/array_impact measure/pulse measure/scattering; do
  sources="$sources $out/library/$(echo $name | tr / -).o"
  echo "$out/library/$(echo $name | tr / -).o $root/src/lattice/$name.cpp"
done > "$out/library/list"
for page in breather strike defect; do echo "$out/$page.o $here/$page.cpp"; done >> "$out/library/list"
running=0
while read -r object source; do
  compile "$object" "$source" &
  running=$((running + 1))
  [ $((running % 4)) -ne 0 ] || wait
done < "$out/library/list"
wait
while read -r object source; do
  [ -e "$object" ] || { echo "live pages : $source was not compiled"; exit 1; }
done < "$out/library/list"

# The linker is called by itself: the driver may run an optimiser that breaks vector instructions.
for page in breather strike defect; do
  # shellcheck disable=SC2086
  wasm-ld-14 --stack-first -z stack-size=262144 --no-entry --strip-all --gc-sections \
    --export=__wasm_call_ctors -L/usr/lib/wasm32-wasi "$out/$page.o" $sources -lc++ -lc++abi -lc \
    "$runtime" -o "$out/$page.wasm.part"
  mv "$out/$page.wasm.part" "$out/$page.wasm"
done
