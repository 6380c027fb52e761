#!/bin/sh
# Installs the Debian packages listed in the file $1 that are missing. DEPS=skip forbids it.
set -eu
list=$1
[ "${DEPS:-}" = skip ] && exit 0
if ! command -v apt-get >/dev/null 2>&1; then
  echo "This machine has no apt. Install what these Debian packages contain, then say DEPS=skip:" >&2
  sed 's/^/  /' "$list" >&2
  exit 1
fi
missing=
while read -r package; do
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing="$missing $package"
done < "$list"
[ -n "$missing" ] || exit 0
echo "Installing missing packages:$missing"
if [ "$(id -u)" = 0 ]; then as_root=; elif command -v sudo >/dev/null 2>&1; then as_root=sudo; else
  echo "Neither root nor sudo: ask someone to install them, then say DEPS=skip." >&2
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
