#!/bin/sh
# The README's commands on a machine that has nothing else: a bare root made by debootstrap, with the compiler,
# cmake, make and git that the README asks for, and a clone of HEAD where others have stumbled: in a folder with brackets
# and a space in its name, inside another repository, with CDPATH and PYTHONSAFEPATH exported and nothing else.
#   fresh.sh [SUITE]            both commands, then make book and make paper; SUITE is the machine's own release
#   fresh.sh --two [SUITE]      both commands, and those of the second volume
# FRESH_ENV='CXXFLAGS=-Werror' adds to the environment; KEEP=1 leaves the root where it is. Ends with 77
# where such a root cannot be made.
set -eu
unset CDPATH
cd "$(dirname "$0")/.."
two=
[ "${1:-}" != --two ] || { two=yes && shift; }
# shellcheck disable=SC1091
suite=${1:-$(. /etc/os-release && echo "${VERSION_CODENAME:-}")}
place=$PWD/build/fresh
base=$place/$suite.tar root=$place/$suite logs=$place/log-$suite
cannot() { echo "  fresh    cannot make a bare root: $1" >&2; exit 77; }
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
[ -z "$(git status --porcelain --untracked-files=no)" ] || echo "  fresh    uncommitted changes are not included"

# A command in a folder of the root. Nothing is in the environment but what others have stumbled over, and FRESH_ENV.
inside() {
  # shellcheck disable=SC2016
  unshare --mount --pid --fork --kill-child sh -c '
    root=$1 folder=$2 command=$3
    mount -t proc proc "$root/proc" && mkdir -p "$root/dev/shm" && mount -t tmpfs tmpfs "$root/dev/shm" &&
    { mkdir -p "$root/dev/pts" && mount -t devpts -o newinstance,ptmxmode=0666 devpts "$root/dev/pts" &&
      rm -f "$root/dev/ptmx" && ln -s pts/ptmx "$root/dev/ptmx" || true; } &&
    exec chroot "$root" env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
      CDPATH=/home PYTHONSAFEPATH=1 '"${FRESH_ENV:-}"' sh -c "cd \"$folder\" && $command"' sh "$root" "$@" < /dev/null
}
step() {
  log="$logs/$(echo "$2" | tr -cs 'A-Za-z0-9\n' - | cut -c 1-40)"
  start=$(date +%s)
  [ ! -t 1 ] || printf '  fresh    %s: %.60s ...\r' "$suite" "$2"
  if inside "$@" > "$log" 2>&1; then said=passes lines=6; else said=FAILS lines=80; fi
  echo "  fresh    $suite: $2 $said after $(($(date +%s) - start)) s"
  tail -n $lines "$log" | sed 's/^/           | /'
  [ $said = passes ]
}

# What the reader is told to type, as the README tells it.
around="$root/home" folder='[Re] a checkout'
git init -q "$around" && git -C "$around" -c user.name=x -c user.email=x@y commit -q --allow-empty -m "another repository"
git clone -q --no-hardlinks . "$around/$folder" || exit 1
# shellcheck disable=SC2016
commands=$(sed -n '/^```sh$/,/^```$/{ s/^\(make [a-z]*\).*/\1/p; /^```$/q; }' README.md)
[ "$(echo "$commands" | wc -l)" = 2 ] || { echo "README.md does not begin with two commands" >&2; exit 1; }
[ ! -d beyond ] || commands="$commands
make beyond
make test-beyond"
[ -n "$two" ] || commands="$commands
make book
make paper"
echo "$commands" > "$logs/commands"
while read -r command; do
  step "/home/$folder" "$command" || exit
done < "$logs/commands"
