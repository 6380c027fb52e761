"""Would the tests notice? Puts the errors of mutants.tsv into a copy of the library, one at a time.

The library and the tests are compiled once, and for each error what depends on the file in which it is.
Then the tests that its row names are run. An error is killed if one of them
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


def library_files(source, room="*"):
    found = (source / "lattice").glob(f"{room}/*.[ch]pp")
    return sorted(path for path in found if path.parent.name != "report")


def read_table(selection):
    table, mistakes = [], []
    for number, line in enumerate((ROOT / "tools/mutants.tsv").read_text(encoding="utf8").splitlines(), 1):
        if not line or line.startswith("#"):
            continue
        room, right, wrong, tests, what = line.split("\t")
        counts = {path: path.read_text(encoding="utf8").count(right) for path in library_files(ROOT / "src", room)}
        if sum(counts.values()) != 1:
            mistakes.append(f"mutants.tsv:{number}: '{right}' occurs {sum(counts.values())} times in {room}")
        elif not selection or any(word in room or word in what for word in selection):
            file = next(path for path, count in counts.items() if count).relative_to(ROOT / "src")
            table.append((file, right, wrong, tests.split(), what))
    if mistakes:
        raise SystemExit("\n".join(mistakes))
    return table


class Build:
    """The library and the tests as objects in `folder`, and what each of them was compiled from."""

    def __init__(self, folder, tests):
        self.folder = folder
        self.units = {f"{path.parent.name}-{path.stem}": path.relative_to(ROOT)
                      for path in library_files(ROOT / "src") if path.suffix == ".cpp"}
        self.library = sorted(self.units)
        self.units |= {f"test-{test}": pathlib.Path("tests") / f"{test}.cpp" for test in ["main", *tests]}

    def compile(self, unit, root, folder):
        """The object of a unit from the sources below `root`, or nothing where they do not compile."""
        done = subprocess.run([*COMPILE, "-MMD", f"-I{root / 'src'}", "-c", str(root / self.units[unit]), "-o",
                               str(folder / f"{unit}.o")], capture_output=True)
        return folder / f"{unit}.o" if done.returncode == 0 else None

    def all(self, pool):
        for unit, made in zip(self.units, pool.map(lambda u: self.compile(u, ROOT, self.folder), self.units)):
            if not made:
                raise SystemExit(f"{self.units[unit]} does not compile without any error: nothing can be said")

    def depends(self, unit, file):
        return f"/src/{file}" in (self.folder / f"{unit}.d").read_text(encoding="utf8")

    def verdict(self, test, root, folder, file=None):
        """How `test` fails with the sources below `root`, which differ in `file`; nothing if it passes."""
        objects = []
        for unit in [*self.library, "test-main", f"test-{test}"]:
            changed = file is not None and self.depends(unit, file)
            objects.append(self.compile(unit, root, folder) if changed else self.folder / f"{unit}.o")
        if None in objects:
            return "no longer compiles"
        binary = folder / test
        linked = subprocess.run([COMPILE[0], *map(str, objects), *LINK, "-o", str(binary)], capture_output=True)
        if linked.returncode:
            return "no longer links"
        try:
            run = subprocess.run([str(binary)], capture_output=True, timeout=LIMIT)
        except subprocess.TimeoutExpired:
            return "does not end"
        return None if run.returncode == 0 else "fails"


def judge(mutant, build, scratch, places):
    file, right, wrong, tests, _ = mutant
    place = places.setdefault(threading.get_ident(), pathlib.Path(tempfile.mkdtemp(dir=scratch)))
    if not (place / "src").exists():
        shutil.copytree(ROOT / "src/lattice", place / "src/lattice")
        shutil.copytree(ROOT / "tests", place / "tests")
    path = place / "src" / file
    original = path.read_text(encoding="utf8")
    path.write_text(original.replace(right, wrong), encoding="utf8")
    try:
        for test in tests:
            how = build.verdict(test, place, place, file)
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
        tests = sorted({test for mutant in table for test in mutant[3]})
        build = Build(scratch, tests)
        with concurrent.futures.ThreadPoolExecutor(workers) as pool:
            build.all(pool)
            for test, how in zip(tests, pool.map(lambda test: build.verdict(test, ROOT, scratch), tests)):
                if how:
                    raise SystemExit(f"{test} {how} without any error: nothing can be said")
            places = {}
            verdicts = pool.map(lambda mutant: judge(mutant, build, scratch, places), table)
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
