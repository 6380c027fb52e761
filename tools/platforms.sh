#!/bin/sh
# The same bytes everywhere (`make test-platforms`): builds the programs for other platforms, runs them with --quick,
# and compares every table with paper/quick.sha256.
#   platforms.sh [PLATFORM...]                      all of them without
#   PROGRAMS='sec31_dps_limit secA_integrators'     only these programs
# Several things are changed at once, because equal bytes acquit all of them. Each platform needs the Debian packages
# that stand beside it, and ends with a word where they are missing.
#   gcc      g++ -O3, vectors as wide as the processor allows, every program on all cores
#   narrow   g++ -O2, vectors of 128 bits, eight programs at once, one thread each
#   clang    clang++ -O2, vectors of 128 bits, one thread                          (clang 16 or later)
#   trixie   Debian 13 in a bare root: its compiler and its libraries              (debootstrap, root)
#   arm64    ARM64: cross-compiled, under emulation; `long double` is another type (g++-aarch64-linux-gnu
#            and qemu-user-static); also runs the unit tests and, on the tables of build/data, the statements
# shellcheck disable=SC2012,SC2015,SC2317
set -eu
unset CDPATH
cd "$(dirname "$0")/.."
root=$PWD place=$PWD/build/platforms
jobs=$(nproc)
programs=${PROGRAMS:-$(cd src && ls sec*.cpp | sed 's/\.cpp$//')}
bad=0

say() { echo "  platform $1"; }
lacks() { say "$name: left out, $1"; }

# build FOLDER TARGETS CMAKE-ARGUMENT...
build() {
  folder=$1 targets=$2
  shift 2
  # shellcheck disable=SC2086
  { cmake -S "$root" -B "$folder" "$@" && cmake --build "$folder" --parallel "$jobs" --target $targets; } \
    > "$place/$name.log" 2>&1 || { tail -n 20 "$place/$name.log"; say "$name: cannot be built"; bad=1; return 1; }
}

# run BIN AT-ONCE THREADS COMMAND...: every program, into $place/$name.quick
run() {
  bin=$1 at_once=$2 threads=$3
  shift 3
  rm -rf "$place/$name.quick"
  mkdir -p "$place/$name.quick"
  # shellcheck disable=SC2016
  echo "$programs" | tr ' ' '\n' | xargs -P "$at_once" -I '{}' sh -c '
    bin=$1 out=$2 threads=$3 program=$4; shift 4; mkdir -p "$out/$program"; start=$(date +%s)
    "$@" "$bin/$program" --quick --out "$out/$program" ${threads:+--threads "$threads"} > "$out/$program.log" 2>&1 ||
      echo "  platform $program ends with exit code $? after $(($(date +%s) - start)) s: $(tail -n 1 "$out/$program.log")"' \
    run "$bin" "$place/$name.quick" "$threads" '{}' "$@"
}

compare() {
  say "$name: $1"
  against=
  [ "$name" = gcc ] || [ ! -d "$place/gcc.quick" ] || against="--against $place/gcc.quick"
  status=0
  # shellcheck disable=SC2086
  PYTHONPATH=tools python3 -m lineage hashes --run quick --data "$place/$name.quick" $against || status=$?
  [ "$status" = 0 ] || [ "$name" = arm64 ] || bad=1
}

gcc() {
  build "$place/gcc" programs -DCMAKE_CXX_COMPILER=g++ || return 0
  run "$place/gcc/bin" 1 "" env
  compare "$(g++ --version | head -n 1), -O3, $(grep -o -w -m 1 avx512f /proc/cpuinfo || grep -o -w -m 1 avx2 /proc/cpuinfo || echo baseline)"
}
o2="-DCMAKE_BUILD_TYPE=Plain -DCMAKE_CXX_FLAGS_PLAIN=-O2"
narrow() {
  # shellcheck disable=SC2086
  build "$place/narrow" programs -DCMAKE_CXX_COMPILER=g++ $o2 -DLATTICE_SCALAR=ON || return 0
  run "$place/narrow/bin" 8 1 env
  compare "g++ -O2, vectors of 128 bits, eight programs at once"
}
clang() {
  command -v clang++ > /dev/null || { lacks "clang++ is missing"; return 0; }
  [ "$(echo __clang_major__ | clang++ -E -P -)" -ge 16 ] || { lacks "$(clang++ --version | head -n 1) is older than 16"; return 0; }
  # shellcheck disable=SC2086
  build "$place/clang" programs -DCMAKE_CXX_COMPILER=clang++ $o2 || return 0
  run "$place/clang/bin" 1 1 env
  compare "$(clang++ --version | head -n 1), -O2, one thread"
}

trixie() {
  [ "$(id -u)" = 0 ] && command -v debootstrap > /dev/null || { lacks "needs root and debootstrap"; return 0; }
  there="$place/trixie"
  [ -f "$there/made" ] || { rm -rf "$there"; debootstrap --variant=minbase \
    --include=g++,cmake,make,libgsl-dev,libeigen3-dev,libboost-dev,libmd-dev,catch2 trixie "$there" \
    > "$place/debootstrap.log" 2>&1 && touch "$there/made"; } || { lacks "debootstrap fails"; return 0; }
  mkdir -p "$there/tree"
  git ls-files -z | tar --null -T - -c | tar -x -C "$there/tree"
  chroot "$there" sh -c "cd /tree && cmake -S . -B build && cmake --build build --parallel $jobs --target programs" \
    > "$place/trixie.log" 2>&1 || { tail -n 20 "$place/trixie.log"; say "trixie: cannot be built"; bad=1; return 0; }
  # The programs find their libraries there, and the tables come out here.
  run "$there/tree/build/bin" 1 2 env LD_LIBRARY_PATH="$there/usr/lib/x86_64-linux-gnu" \
    "$there/lib64/ld-linux-x86-64.so.2"
  compare "Debian $(cat "$there/etc/debian_version"), $(chroot "$there" g++ --version | head -n 1)"
}

# The libraries for ARM64 are unpacked beside the build; the machine's own packages stay as they are.
arm64_libraries() {
  [ ! -f "$place/arm64/libmd.a" ] || return 0
  lists="$place/arm64/apt"
  mkdir -p "$lists/lists/partial" "$lists/cache/archives/partial" "$place/arm64/include"
  : > "$lists/status"
  (cd "$lists" && for verb in update "download libgsl-dev libmd-dev"; do
    # shellcheck disable=SC2086
    apt-get -qq -o APT::Architecture=arm64 -o APT::Architectures::=arm64 -o Dir::State::Lists="$lists/lists" \
      -o Dir::Cache="$lists/cache" -o Dir::State::status="$lists/status" -o APT::Sandbox::User= $verb || exit 1
  done && for deb in lib*-dev_*.deb; do dpkg -x "$deb" root || exit 1; done) > "$place/arm64-libraries.log" 2>&1 || return 1
  for there in boost catch2; do ln -sfn "/usr/include/$there" "$place/arm64/include/$there"; done
  ln -sfn ../apt/root/usr/include/gsl "$place/arm64/include/gsl"
  cp "$lists"/root/usr/lib/aarch64-linux-gnu/lib*.a "$lists"/root/usr/include/sha2*.h "$place/arm64/"
}
arm64() {
  command -v aarch64-linux-gnu-g++ > /dev/null && command -v qemu-aarch64-static > /dev/null ||
    { lacks "g++-aarch64-linux-gnu or qemu-user-static is missing"; return 0; }
  mkdir -p "$place/arm64"
  arm64_libraries || { lacks "its libraries cannot be fetched ($place/arm64-libraries.log)"; return 0; }
  here="$place/arm64"
  build "$here/build" "programs tests" -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64 \
    -DCMAKE_CXX_COMPILER=aarch64-linux-gnu-g++ -DCMAKE_EXE_LINKER_FLAGS=-static \
    -DGSL_INCLUDE_DIR="$here/include" -DGSL_LIBRARY="$here/libgsl.a" -DGSL_CBLAS_LIBRARY="$here/libgslcblas.a" \
    -DBoost_NO_BOOST_CMAKE=ON -DBoost_INCLUDE_DIR="$here/include" -DCATCH_INCLUDE="$here/include" \
    -DMD_INCLUDE="$here" -DMD_LIBRARY="$here/libmd.a" || return 0
  for it in "$here/build/bin/"tests_lattice_* "$here/build/bin/"tests_sec*; do
    qemu-aarch64-static "$it" "[unit]" || bad=1
  done > "$place/arm64-unit.log" 2>&1
  say "arm64: unit tests: $(grep -c '^All tests passed' "$place/arm64-unit.log") executables pass, $(grep -c '^test cases:' "$place/arm64-unit.log") fail"
  # The statements reads the tables of this machine's full run
  if [ -d "$root/build/data" ]; then
    ln -sfn "$root/build/data" "$here/build/data"
    qemu-aarch64-static "$here/build/bin/tests_statements" > "$place/arm64-statements.log" 2>&1 || bad=1
    say "arm64: statements: $(tail -n 2 "$place/arm64-statements.log" | head -n 1)"
  fi
  run "$here/build/bin" "$jobs" 1 qemu-aarch64-static
  compare "ARM64 under $(qemu-aarch64-static --version | head -n 1)"
}

mkdir -p "$place"
[ $# -gt 0 ] || set -- gcc narrow clang trixie arm64
for name; do
  case $name in
  gcc|narrow|clang|trixie|arm64) "$name" ;;
  *) echo "platforms.sh: '$name' is unknown (allowed: gcc, narrow, clang, trixie, arm64)" >&2; exit 2 ;;
  esac
done
exit $bad
