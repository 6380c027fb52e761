#!/bin/sh
# Everything in one archive, for those who will not run anything: dist.sh BUILD, into BUILD/dist.
# The sources are those of the last commit, and build/ has tables, figures, verdicts, the book, the paper and the theorem
# where `make` puts them, so that the README's paths hold; SHA256SUMS is over every file. Equal contents give equal bytes:
# names in order, nobody's files, all of the time of the last commit.
set -eu
unset CDPATH
build=$1 products=
refuse() { echo "dist: $1" >&2; exit 1; }
unset GIT_DIR GIT_WORK_TREE
[ -n "$(sh "${0%/*}/revision.sh")" ] || refuse "not a checkout of the repository (allowed: a clone with its history)"
{ [ -d "$build/data" ] && [ -d "$build/figures" ]; } || refuse "$build/data and $build/figures are missing: compute them first (make figures)"
[ -z "$(git status --porcelain --untracked-files=no)" ] || echo "dist       : uncommitted changes are not included"

name=breathers-$(sed -n 's/^ *"version": *"\([0-9.]*\)".*/\1/p' codemeta.json) out=$build/dist
epoch=$(git log -1 --format=%ct)
part=$out/.part
rm -rf "$part"
mkdir -p "$part/$name/build/report"
trap 'rm -rf "$part"' EXIT
git archive HEAD | tar -C "$part/$name" -xf -

# What there is of the products; hidden files are of runs that were cut off.
take() {
  if [ -e "$build/$1" ]; then
    cp -r "$build/$1" "$part/$name/build/$1"
    products="$products ${1##*/}"
  else
    echo "dist       : without $2, which does not exist ($3)"
  fi
}
take data "the tables" "make figures"
take figures "the figures" "make figures"
take report/claims.ecsv "published against reproduced" "make figures"
take book "the book" "make book"
take paper.pdf "the paper" "make paper"
take theorem.pdf "the theorem" "make paper"
find "$part/$name/build" -name '.*' -exec rm -rf {} +

(cd "$part/$name" && find . -type f | LC_ALL=C sort | sed 's|^\./||' | tr '\n' '\0' | xargs -0 sha256sum) > "$part/sums"
mv "$part/sums" "$part/$name/SHA256SUMS"
tar -C "$part" --sort=name --mtime="@$epoch" --owner=0 --group=0 --numeric-owner --mode=u=rwX,go=rX \
  --format=ustar -cf "$part/all.tar" "$name"
gzip -n -9 "$part/all.tar"
mv "$part/all.tar.gz" "$out/$name.tar.gz"
(cd "$out" && sha256sum "$name.tar.gz" > "$name.tar.gz.sha256")
echo "dist       : $out/$name.tar.gz ($(du -h "$out/$name.tar.gz" | cut -f 1)): sources$(echo "$products" | sed 's/ /, /g')"
