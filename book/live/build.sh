#!/bin/sh
# Compiles the live pages and what they need of the library: build.sh FOLDER makes FOLDER/*.wasm. Where
# the compiler for the browser is missing it says so, and the book is woven without live pages.
set -eu
out=$1
here=$(dirname "$0")
root=$here/../..
browser="clang++ --target=wasm32-wasi"
runtime=$($browser --rtlib=compiler-rt -print-libgcc-file-name 2>/dev/null) || true
if [ ! -e "$runtime" ] || ! command -v wasm-ld >/dev/null || [ ! -e /usr/lib/wasm32-wasi/libc++.a ]; then
  echo "live pages : left out, clang for the browser is not installed (apt-packages.txt, [live])"
  rm -f "$out"/*.wasm
  exit 0
fi
mkdir -p "$out"
pages="breather strike defect"
[ ! -e "$root/beyond/book/live/drive.cpp" ] || pages="$pages drive"
# A source of either volume, from the folder of the checkout.
of() { ls "$root/$1" 2>/dev/null || ls "$root/beyond/$1" 2>/dev/null; }
# Whether the object $1 is newer than everything that its compiler has read.
is_new() {
  [ -e "$1.o" ] && [ -e "$1.d" ] || return 1
  # shellcheck disable=SC2046
  changed=$(find "$0" $(sed 's/^[^:]*://; s/\\$//' "$1.d") -newer "$1.o" 2>/dev/null) || return 1
  [ -z "$changed" ]
}

# Compiles $1 into the object $2, without its ending. Clang 19 crashes while it threads jumps, so
# that pass is left out.
compile() {
  is_new "$2" && return
  $browser -std=c++20 -O2 -mllvm -jump-threading-threshold=0 -fexceptions -fno-rtti -ffp-contract=off \
    -fno-math-errno -msimd128 -I"$here" -I"$root/src" -I"$root/beyond/src" -I/usr/include/eigen3 -MMD -c "$1" -o "$2.part.o" -MF "$2.d"
  mv "$2.part.o" "$2.o"
}

# The sources of the library that stand beside the headers which the objects have read.
needed() {
  sed 's/^[^:]*://; s/\\$//' "$@" | tr ' ' '\n' | sed -n 's|^.*/src/\(.*\)\.hpp$|\1|p' | sort -u |
    while read -r part; do
      if of "src/$part.cpp" > /dev/null; then echo "$part"; fi
    done
}

# The pages first, then what they need, then what that needs, until nothing is added.
running=
for page in $pages; do
  compile "$(of "book/live/$page.cpp")" "$out/$page" &
  running="$running $!"
done
for process in $running; do wait "$process"; done
parts=
lists=$(for page in $pages; do echo "$out/$page.d"; done)
while
  # shellcheck disable=SC2086
  more=$(needed $lists)
  [ "$more" != "$parts" ]
do
  running=
  for part in $more; do
    object=$out/$(echo "$part" | tr / -)
    compile "$(of "src/$part.cpp")" "$object" &
    running="$running $!"
    case $lists in *"$object.d"*) ;; *) lists="$lists $object.d" ;; esac
  done
  for process in $running; do wait "$process"; done
  parts=$more
done

# The linker is called by itself: the driver may run an optimiser that breaks vector instructions.
objects=$(for part in $parts; do echo "$out/$(echo "$part" | tr / -).o"; done)
for page in $pages; do
  # shellcheck disable=SC2086
  wasm-ld --stack-first -z stack-size=262144 --no-entry --strip-all --gc-sections \
    --export=__wasm_call_ctors -L/usr/lib/wasm32-wasi "$out/$page.o" $objects -lc++ -lc++abi -lc \
    "$runtime" -o "$out/$page.wasm.part"
  mv "$out/$page.wasm.part" "$out/$page.wasm"
done
