#!/bin/sh
# Installs the Debian packages listed in the file $1 that are missing. DEPS=skip forbids it. What stands
# below a line [name] is wanted only if that name is among the further arguments.
set -eu
list=$1
shift
[ "${DEPS:-}" = skip ] && exit 0
packages=$(awk -v asked=" $* " '/^\[/ { off = !index(asked, " " substr($0, 2, length($0) - 2) " "); next }
  !off && NF { print $1 }' "$list")
if ! command -v apt-get >/dev/null 2>&1; then
  echo "This machine has no apt. Install the contents of these Debian packages, then use DEPS=skip:" >&2
  echo "$packages" | sed 's/^/  /' >&2
  exit 1
fi
missing=
for package in $packages; do
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing="$missing $package"
done
[ -n "$missing" ] || exit 0
echo "Installing missing packages:$missing"
if [ "$(id -u)" = 0 ]; then as_root=; elif command -v sudo >/dev/null 2>&1; then as_root=sudo; else
  echo "No root access and no sudo: ask an administrator to install them, then use DEPS=skip." >&2
  exit 1
fi
export DEBIAN_FRONTEND=noninteractive
log=$(mktemp)
trap 'rm -f "$log"' EXIT
# shellcheck disable=SC2086
{
  $as_root apt-get update -qq
  $as_root apt-get install -y -qq --no-install-recommends $missing
} > "$log" 2>&1 || { cat "$log"; exit 1; }
