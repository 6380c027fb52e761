# shellcheck shell=sh
# Sourced by the other scripts.

# `hold FILE` makes a second make in the same checkout wait here until the first has done what it does, to the end
# of the script that calls it. Where there is no flock nobody waits.
hold() {
  command -v flock >/dev/null 2>&1 || return 0
  exec 9> "$1"
  flock -n 9 || { echo "  wait     for another make in this checkout" && flock 9; }
}

# `first_build BUILD JOBS TARGET...`: the minutes that it takes to compile all, one or some programs, where none is yet.
first_build() {
  [ -z "$(find "$1" -name '*.o' 2>/dev/null | head -n 1)" ] || return 0
  jobs=$2
  shift 2
  case $* in programs | all) work=10 ;; *' '*) work=7 ;; *) work=2 ;; esac
  echo $(((work + jobs - 1) / jobs))
}
