#!/bin/sh
# What a caller happens to export decides about no test. Those that call make, python and the drawing tools are
# run once more, with an environment that is against them. Argument: the build folder.
set -eu
cd "$1"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
for tool in python3 gnuplot; do
  printf '#!/bin/sh\nexit 1\n' > "$scratch/$tool"
  chmod +x "$scratch/$tool"
done
unset HOME
umask 077
# The python3 that comes first on this path fails; the stub of gnuplot is for nobody (drawing needs the real one).
rm "$scratch/gnuplot"
export PATH="$scratch:$PATH" PYTHON=python3 MAKEFLAGS=k MAKELEVEL=3 CXX=/none CXXFLAGS=-ffast-math CFLAGS=-x \
  LANG=de_DE.UTF-8 LC_ALL=de_DE.UTF-8 LC_NUMERIC=de_DE.UTF-8 TMPDIR=/none SLURM_CPUS_PER_TASK=1 SLURM_JOB_ID=7 \
  CTEST_PARALLEL_LEVEL=1 CTEST_ARGS=-N DESTDIR=/none QUICK=1 DEPS=ask LAUNCH=false THREADS=0 JOBS=0 TARGETS=none \
  B=/none D=/none MPLBACKEND=TkAgg PYTHONPATH=/none GNUTERM=none SOURCE_DATE_EPOCH=1 LATTICE_REVISION=none
ctest -R '^(make|drawing)$' --output-on-failure < /dev/null
