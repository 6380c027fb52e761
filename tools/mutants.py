"""Would the tests notice? Puts the errors of mutants.tsv into a copy of the library, one at a time.

For each error only the tests that its row names are compiled and run; of those that call programs or read their
tables, the cases that do neither. An error is killed if one of them fails (or no longer compiles, or takes more than
two minutes) and survives otherwise; the unchanged library must pass first. What an error does not touch is compiled
once. A row whose right text is not in its room exactly once is a mistake in the table and ends the run before anything
is built. Words given as arguments select rows by their room or by their description.
"""

import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import threading

ROOT = pathlib.Path(__file__).resolve().parent.parent
COMPILE = [os.environ.get("CXX", "g++"), "-std=c++20", "-O1", "-w", "-ffp-contract=off", "-fno-math-errno",
           "-DLATTICE_WIDE=", "-DEIGEN_NO_CPUID", "-I/usr/include/eigen3", *(f'-D{name}="{value}"' for name, value in {
               "SOURCE_DIR": ROOT, "DATA_DIR": ROOT / "build/data", "BIN_DIR": ROOT / "build/bin", "LATTICE_VERSION": "0",
               "LATTICE_BUILD": "mutants -O1", "LATTICE_LIBRARIES": "those of the machine"}.items())]
LINK = ["-lgsl", "-lgslcblas", "-lpthread"]
ALONE = "~[published]~[cli]"  # what needs no program and no table
LIMIT = 120  # seconds for one test


def files(room):
    """The sources of a room of the library, of `report`, or of a section's shelf."""
    folder = ROOT / "src" / room if room == "report" or room.startswith("sec") else ROOT / "src/lattice" / room
    return sorted(path for path in folder.iterdir() if path.suffix in (".hpp", ".cpp"))


def read_table(selection):
    table, mistakes = [], []
    for number, line in enumerate((ROOT / "tools/mutants.tsv").read_text(encoding="utf8").splitlines(), 1):
        if not line or line.startswith("#"):
            continue
        room, right, wrong, tests, what = line.split("\t")
        counts = {path: path.read_text(encoding="utf8").count(right) for path in files(room)}
        if sum(counts.values()) != 1:
            mistakes.append(f"mutants.tsv:{number}: '{right}' occurs {sum(counts.values())} times in {room}")
        elif missing := [test for test in tests.split() if not (ROOT / f"tests/{test}.cpp").exists()]:
            mistakes.append(f"mutants.tsv:{number}: there is no tests/{missing[0]}.cpp")
        elif not selection or any(word in room or word in what for word in selection):
            file = next(path for path, count in counts.items() if count)
            table.append((file.relative_to(ROOT / "src"), right, wrong, tests.split(), what))
    if mistakes:
        raise SystemExit("\n".join(mistakes))
    return table


def quadruple():
    """The sources that are compiled once more in quadruple precision, and how: as CMakeLists.txt does it."""
    listed = re.search(r"set\(QUADRUPLE ([^)]*)\)", (ROOT / "CMakeLists.txt").read_text(encoding="utf8"))
    return {f"lattice/{name}.cpp" for name in listed[1].split()}, ["-include", "lattice/quadruple/extended.hpp", "-DLATTICE_QUADRUPLE"]


def take_float128():
    """Quadruple precision is faster where the compiler brings it along."""
    probe = '#include <boost/multiprecision/float128.hpp>\nint main() { return sqrt(boost::multiprecision::float128(2)) > 2; }'
    if subprocess.run([*COMPILE, "-x", "c++", "-", "-o", os.devnull, "-lquadmath"], input=probe, text=True,
                      capture_output=True).returncode == 0:
        COMPILE.append("-DLATTICE_FLOAT128")
        LINK.append("-lquadmath")


def build(code, target, flags=()):
    """Compiles `code` below the folder of the library's copy that it reads; whether that works."""
    source = next(parent for parent in code.parents if (parent / "lattice").is_dir())
    return subprocess.run([*COMPILE, *flags, f"-I{source}", "-MMD", "-c", str(code), "-o", str(target)],
                          capture_output=True).returncode == 0


def reads(listing, file):
    """Whether an object's list of dependencies names the file."""
    return any(word.endswith("/src/" + str(file)) for word in listing.read_text(encoding="utf8").split())


class Library:
    """The unchanged library and tests, in a copy of their own, compiled."""

    def __init__(self, scratch, tests, pool):
        self.source, self.objects = scratch / "src", scratch / "objects"
        for folder in [ROOT / "src/lattice", ROOT / "src/report", ROOT / "src/commands", *(ROOT / "src").glob("sec*/")]:
            shutil.copytree(folder, self.source / folder.name)
        self.objects.mkdir()
        for path in (ROOT / "tests").glob("*.?pp"):
            shutil.copy(path, self.source)
        sources = [path for where in ("lattice/*", "report", "commands", "sec*") for path in self.source.glob(where + "/*.cpp")]
        # Every object with its source and its flags
        self.of = {self.objects / f"{path.parent.name}-{path.stem}.o": (path.relative_to(self.source), ()) for path in sources}
        twice, flags = quadruple()
        self.of.update({unit.with_name("quadruple-" + unit.name): (code, flags)
                        for unit, (code, _) in list(self.of.items()) if str(code) in twice})
        self.tests = {test: self.objects / f"test-{test}.o" for test in ["main", *tests]}
        self.of.update({unit: (pathlib.Path(test + ".cpp"), ()) for test, unit in self.tests.items()})
        built = pool.map(lambda unit: build(self.source / self.of[unit][0], unit, self.of[unit][1]), self.of)
        for (code, _), good in zip(self.of.values(), built):
            if not good:
                raise SystemExit(f"{code} does not compile without any error: nothing can be said")
        self.archive = scratch / "library.a"
        members = [str(unit) for unit in self.of if unit not in self.tests.values()]
        subprocess.run(["ar", "rcs", str(self.archive), *members], check=True)
        self.used = dict(zip(tests, pool.map(lambda test: self.linked(test, scratch), tests)))
        if not any(len(units) > 2 for units in self.used.values()):
            raise SystemExit("the linker does not say what it takes from an archive: nothing can be said")

    def linked(self, test, scratch):
        """The objects that a test consists of."""
        own = [self.tests["main"], self.tests[test]]
        trace = [*self.link(own, scratch / ("linked-" + test)), "-Wl,--trace,--trace"]
        out = subprocess.run(trace, capture_output=True, text=True)
        taken = set(re.findall(r"library\.a\)?\(?([\w-]+\.o)", out.stdout))
        if out.returncode:
            raise SystemExit(f"{test} does not link without any error: nothing can be said")
        return [unit for unit in self.of if unit.name in taken or unit in own]

    def link(self, units, binary):
        """How a test is linked; the archive has what the units lack."""
        return [COMPILE[0], *map(str, units), str(self.archive), *LINK, "-o", str(binary)]

    def passes(self, test, work, renewed, changed=None):
        """Whether `test` succeeds with the file `changed` in the copy below `work`; otherwise how not. What earlier
        tests of the same error have compiled is in `renewed`."""
        for unit in self.used[test]:
            code, flags = self.of[unit]
            if changed and unit not in renewed and reads(unit.with_suffix(".d"), changed):
                renewed[unit] = work / unit.name
                if not build(work / "src" / code, renewed[unit], flags):
                    return "no longer compiles"
        binary = work / test
        units = [renewed.get(unit, unit) for unit in self.used[test]]
        if subprocess.run(self.link(units, binary), capture_output=True).returncode:
            return "no longer links"
        try:
            text = (self.source / f"{test}.cpp").read_text(encoding="utf8")
            with_data = re.search('DATA_DIR|BIN_DIR|"run.hpp"', text)
            run = subprocess.run([str(binary), *([ALONE] if with_data else [])], capture_output=True, timeout=LIMIT)
        except subprocess.TimeoutExpired:
            return "does not end"
        return None if run.returncode == 0 else "fails"


def judge(mutant, scratch, library, places):
    file, right, wrong, tests, _ = mutant
    place = places.setdefault(threading.get_ident(), pathlib.Path(tempfile.mkdtemp(dir=scratch)))
    if not (place / "src").exists():
        shutil.copytree(library.source, place / "src")
    path = place / "src" / file
    original = path.read_text(encoding="utf8")
    path.write_text(original.replace(right, wrong), encoding="utf8")
    renewed = {}
    try:
        for test in tests:
            how = library.passes(test, place, renewed, file)
            if how:
                return f"{test} {how}"
    finally:
        path.write_text(original, encoding="utf8")
    return None


def main():
    table = read_table(sys.argv[1:])
    take_float128()
    workers = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    survivors = 0
    with tempfile.TemporaryDirectory() as folder:
        scratch = pathlib.Path(folder)
        with concurrent.futures.ThreadPoolExecutor(workers) as pool:
            tests = sorted({test for mutant in table for test in mutant[3]})
            library = Library(scratch, tests, pool)
            unchanged = pool.map(lambda test: library.passes(test, scratch, {}), tests)
            for test, how in zip(tests, unchanged):
                if how:
                    raise SystemExit(f"{test} {how} without any error: nothing can be said")
            places = {}
            verdicts = pool.map(lambda mutant: judge(mutant, scratch, library, places), table)
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
