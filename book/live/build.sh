#!/bin/sh
# Compiles the live pages from the library's headers: build.sh FOLDER makes FOLDER/*.wasm. Where
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
# Whether the module is newer than everything that its compiler has read.
is_new() {
  [ -e "$out/$1.wasm" ] && [ -e "$out/$1.d" ] || return 1
  # shellcheck disable=SC2046
  changed=$(find "$0" $(sed 's/^[^:]*://; s/\\$//' "$out/$1.d") -newer "$out/$1.wasm") || return 1
  [ -z "$changed" ]
}

build() {
  wasm=$out/$1.wasm
  is_new "$1" && return
  clang++-14 --target=wasm32-wasi -std=c++20 -O2 -fexceptions -fno-rtti -ffp-contract=off \
    -fno-math-errno -msimd128 -I"$root/src" -I/usr/include/eigen3 -MMD -c "$here/$1.cpp" \
    -o "$out/$1.o"
  # The linker is called by itself: the driver may run an optimiser that breaks vector instructions.
  wasm-ld-14 --stack-first -z stack-size=262144 --no-entry --strip-all --gc-sections \
    --export=__wasm_call_ctors -L/usr/lib/wasm32-wasi "$out/$1.o" -lc++ -lc++abi -lc "$runtime" \
    -o "$wasm.part"
  mv "$wasm.part" "$wasm"
}

build breather &
one=$!
build strike
build defect
wait $one
