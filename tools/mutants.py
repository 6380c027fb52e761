"""Would the tests notice? Puts the errors of mutants.tsv into a copy of the library, one at a time.

For each error only the tests that its row names are compiled and run. An error is killed if one of them
fails (or no longer compiles, or takes more than two minutes) and survives otherwise; the unchanged
library must pass first. A row whose right text is not in its room exactly once is a mistake in the
table and ends the run before anything is built. Words given as arguments select rows by their room or
by their description.
"""

import concurrent.futures
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading

ROOT = pathlib.Path(__file__).resolve().parent.parent
COMPILE = [os.environ.get("CXX", "g++"), "-std=c++20", "-O1", "-w", "-ffp-contract=off", "-fno-math-errno",
           "-DLATTICE_WIDE=", "-I/usr/include/eigen3"]
LINK = ["-lgsl", "-lgslcblas", "-lpthread"]
LIMIT = 120  # seconds for one test


def headers(source, room):
    return sorted((source / "lattice" / room).rglob("*.hpp"))


def read_table(selection):
    table, mistakes = [], []
    for number, line in enumerate((ROOT / "tools/mutants.tsv").read_text(encoding="utf8").splitlines(), 1):
        if not line or line.startswith("#"):
            continue
        room, right, wrong, tests, what = line.split("\t")
        counts = {path: path.read_text(encoding="utf8").count(right) for path in headers(ROOT / "src", room)}
        if sum(counts.values()) != 1:
            mistakes.append(f"mutants.tsv:{number}: '{right}' occurs {sum(counts.values())} times in {room}")
        elif not selection or any(word in room or word in what for word in selection):
            file = next(path for path, count in counts.items() if count).relative_to(ROOT / "src")
            table.append((file, right, wrong, tests.split(), what))
    if mistakes:
        raise SystemExit("\n".join(mistakes))
    return table


def passes(source, test, work, main):
    """Whether `test` succeeds with the headers below `source`; otherwise how it does not."""
    binary = work / test
    compiled = subprocess.run([*COMPILE, f"-I{source}", str(ROOT / "tests" / f"{test}.cpp"), str(main), *LINK,
                               "-o", str(binary)], capture_output=True)
    if compiled.returncode:
        return "no longer compiles"
    try:
        run = subprocess.run([str(binary)], capture_output=True, timeout=LIMIT)
    except subprocess.TimeoutExpired:
        return "does not end"
    return None if run.returncode == 0 else "fails"


def judge(mutant, scratch, main, places):
    file, right, wrong, tests, _ = mutant
    place = places.setdefault(threading.get_ident(), pathlib.Path(tempfile.mkdtemp(dir=scratch)))
    source = place / "src"
    if not source.exists():
        shutil.copytree(ROOT / "src/lattice", source / "lattice")
    path = source / file
    original = path.read_text(encoding="utf8")
    path.write_text(original.replace(right, wrong), encoding="utf8")
    try:
        for test in tests:
            how = passes(source, test, place, main)
            if how:
                return f"{test} {how}"
    finally:
        path.write_text(original, encoding="utf8")
    return None


def main():
    table = read_table(sys.argv[1:])
    workers = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    survivors = 0
    with tempfile.TemporaryDirectory() as folder:
        scratch = pathlib.Path(folder)
        binary = scratch / "main.o"
        subprocess.run([*COMPILE, "-c", str(ROOT / "tests/main.cpp"), "-o", str(binary)], check=True)
        with concurrent.futures.ThreadPoolExecutor(workers) as pool:
            tests = sorted({test for mutant in table for test in mutant[3]})
            unchanged = pool.map(lambda test: passes(ROOT / "src", test, scratch, binary), tests)
            for test, how in zip(tests, unchanged):
                if how:
                    raise SystemExit(f"{test} {how} without any error: nothing can be said")
            places = {}
            verdicts = pool.map(lambda mutant: judge(mutant, scratch, binary, places), table)
            for (file, _, wrong, tests, what), how in zip(table, verdicts):
                survivors += how is None
                verdict = f"killed    {what} ({how})" if how else (
                    f"SURVIVES  {what}: {file} with '{wrong}' passes {' and '.join(tests)}; "
                    "write the test that it asks for")
                print(verdict, flush=True)
    print(f"{len(table) - survivors} of {len(table)} errors killed")
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main())
