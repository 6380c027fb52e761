#!/bin/sh
# The README's commands on a machine that has nothing else: a bare root made by debootstrap, with the compiler,
# cmake, make and git that the README asks for, a clone of HEAD in a folder with a space in its name, and an
# empty environment.
#   fresh.sh [SUITE]            both commands, then make book and make paper; SUITE is the machine's own release
#   fresh.sh --two [SUITE]      both commands only
# FRESH_ENV='CXXFLAGS=-Werror' adds to the empty environment; KEEP=1 leaves the root where it is. Ends with 77
# where such a root cannot be made.
set -eu
cd "$(dirname "$0")/.."
two=
[ "${1:-}" = --two ] && two=yes && shift
# shellcheck disable=SC1091
suite=${1:-$(. /etc/os-release && echo "${VERSION_CODENAME:-}")}
place=$PWD/build/fresh
base=$place/$suite.tar root=$place/$suite logs=$place/log-$suite
cannot() { echo "  fresh    no bare root here: $1" >&2; exit 77; }
case $suite in ''|*[!a-z]*) cannot "'$suite' is no name of a release" ;; esac

[ "$(id -u)" = 0 ] || cannot "that takes root"
unshare --mount true 2>/dev/null || cannot "nothing may be mounted"
command -v debootstrap >/dev/null 2>&1 || {
  command -v apt-get >/dev/null 2>&1 || cannot "neither debootstrap nor apt"
  { apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends debootstrap; } \
    >/dev/null 2>&1 || cannot "debootstrap cannot be installed"
}
mkdir -p "$logs"
forget() { rm -rf "$root"; }

# The bare root is fetched once and unpacked afresh each time.
if [ ! -f "$base" ]; then
  echo "  fresh    $suite: debootstrap"
  forget
  debootstrap --variant=minbase --include=g++,cmake,make,git,ca-certificates "$suite" "$root" \
    > "$logs/debootstrap" 2>&1 || { tail -n 3 "$logs/debootstrap" >&2; cannot "debootstrap $suite failed"; }
  tar -C "$root" -cf "$base.part" . && mv "$base.part" "$base"
else
  forget
  mkdir -p "$root" && tar -C "$root" -xf "$base"
fi
[ -n "${KEEP:-}" ] || trap forget EXIT
cp /etc/resolv.conf /etc/hosts "$root/etc/" 2>/dev/null || true
apt-config dump 2>/dev/null | grep '^Acquire::.*Proxy ' > "$root/etc/apt/apt.conf.d/proxy" || true
git clone -q --no-hardlinks . "$root/home/a checkout" || exit 1
[ -z "$(git status --porcelain --untracked-files=no)" ] || echo "  fresh    what is not committed is not in it"

# What the reader is told to type, as the README tells it.
commands=$(sed -n '/^## Two commands/,/^## /s/^\(make [a-z]*\).*/\1/p' README.md)
[ "$(echo "$commands" | wc -l)" = 2 ] || { echo "README.md: the section 'Two commands' does not have two" >&2; exit 1; }
[ -n "$two" ] || commands="$commands
make book
make paper"

inside() {
  # shellcheck disable=SC2016,SC2086
  unshare --mount --pid --fork --kill-child sh -c '
    root=$1; shift
    mount -t proc proc "$root/proc" && mkdir -p "$root/dev/shm" && mount -t tmpfs tmpfs "$root/dev/shm" &&
    { mkdir -p "$root/dev/pts" && mount -t devpts -o newinstance,ptmxmode=0666 devpts "$root/dev/pts" &&
      rm -f "$root/dev/ptmx" && ln -s pts/ptmx "$root/dev/ptmx" || true; } &&
    exec chroot "$root" env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
      '"${FRESH_ENV:-}"' sh -c "cd \"/home/a checkout\" && $*"' sh "$root" "$1" < /dev/null
}
bad=0
echo "$commands" > "$logs/commands"
while read -r command; do
  log="$logs/$(echo "$command" | tr ' ' -)"
  start=$(date +%s)
  [ ! -t 1 ] || printf '  fresh    %s: %s ...\r' "$suite" "$command"
  if inside "$command" > "$log" 2>&1; then said=passes lines=6; else said=FAILS lines=80 bad=1; fi
  echo "  fresh    $suite: $command $said after $(($(date +%s) - start)) s"
  tail -n $lines "$log" | sed 's/^/           | /'
  [ $bad = 0 ] || break
done < "$logs/commands"
exit $bad
