"""Would the tests notice? Puts errors into a copy of the sources, one at a time: those of mutants.tsv, or random ones.

`make mutants` takes the errors that were chosen by hand. A row names the tests that should notice; an error is killed if
one of them fails (or no longer compiles, or does not end) and survives otherwise. A row whose right text is not in its
module exactly once is a mistake in the table and ends the run. Arguments select rows by their module or description.

`make mutants RANDOM=200 SEED=1` draws errors from the code of src/lattice and of the sections: an operator, a comparison, a
sign, an index, a constant, min for max, sin for cos, and for or; not from prose, texts and messages. A tolerance, which is
written with an exponent, is not drawn: ten times more of it is no error. Each error meets the tests that read the file, the
cheapest first, until all have passed or forty objects were compiled for it, and then the quick runs of the four cheapest
programs that read it, whose tables are compared byte by byte. It is *killed* by a test, *seen by bytes only*, or *alive*; what
equivalent.tsv lists with a reason changes nothing that anybody could see. What does not compile is no error, and another one
is drawn.

Both work on what `make` has built: of a binary only the objects that read the changed file are compiled again, as they
were. Of tests that call programs or read tables, the cases that do neither are run.
"""

import collections
import concurrent.futures
import functools
import json
import os
import pathlib
import random
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build"
ALONE = "~[published]~[cli]"  # what needs no program and no table
PROGRAMS_ONLY = {"command_line", "models_by_name", "nonexistence", "fingerprint", "published", "findings", "main"}
MEMORY = 6 << 30  # bytes that one process may take
OBJECTS, PROGRAMS = 40, 4  # compiled for the tests of a random error; programs that it meets if it passes them


# What is built

class Unit:
    """An object file: how it was compiled, and what it reads."""

    def __init__(self, entry):
        self.command, self.folder = entry["command"], pathlib.Path(entry["directory"])
        self.path = self.folder / re.search(r" -o (\S+)", self.command)[1]
        self.common = re.search(r"-include (\S+/cmake_pch\.hxx)", self.command)  # headers that are read once
        self.seconds = 20 if "/Unity/" in str(self.path) else 2  # about what it takes to compile

    @functools.cached_property
    def files(self):
        lists = [self.path.with_name(self.path.name + ".d")] + ([pathlib.Path(self.common[1] + ".gch.d")] if self.common else [])
        return {word for one in lists for word in one.read_text(encoding="utf8").split() if word.startswith(str(ROOT / "src"))}

    def reads(self, file):
        return str(ROOT / "src" / file) in self.files

    def compile(self, place, file, renewed):
        """Compiles the copy below `place` as the original was; whether that works. `renewed` gets the object, and what is
        read once for many if that has changed too."""
        target = renewed[self] = place / f"{len(renewed)}.o"
        command = self.command.replace(f" -o {re.search(' -o ([^ ]+)', self.command)[1]}", f" -o {target}")
        if self.common and str(ROOT / "src" / file) in pathlib.Path(self.common[1] + ".gch.d").read_text(encoding="utf8"):
            command = command.replace(self.common[1], str(self.compile_common(place, renewed)))
        command = command.replace(f"{ROOT}/src", f"{place}/src")
        return subprocess.run(command, shell=True, cwd=self.folder, capture_output=True).returncode == 0

    def compile_common(self, place, renewed):
        """The headers that are read once, compiled once for each error."""
        header = self.common[1]
        if header not in renewed:
            renewed[header] = place / f"common{len(renewed)}.hpp"
            text = pathlib.Path(header).read_text(encoding="utf8").replace(f"{ROOT}/src", f"{place}/src")
            renewed[header].write_text(text, encoding="utf8")
            entry = next(one for one in json.loads((BUILD / "compile_commands.json").read_text(encoding="utf8"))
                         if one["file"] == header + ".cxx")
            command = re.sub(r" -o \S+", f" -o {renewed[header]}.gch", entry["command"]).replace(f"{ROOT}/src", f"{place}/src")
            pathlib.Path(f"{renewed[header]}.gch").unlink(missing_ok=True)
            subprocess.run(command.replace(f"-include {header} ", f"-include {renewed[header]} "), shell=True,
                           cwd=self.folder, capture_output=True)
        return renewed[header]


@functools.cache
def all_units():
    entries = json.loads((BUILD / "compile_commands.json").read_text(encoding="utf8"))
    return {unit.path: unit for unit in map(Unit, entries) if unit.path.exists()}


class Binary:
    """A test, one source with main, or a program: what it consists of, and how it behaves unchanged."""

    def __init__(self, name, link_file, own, arguments):
        self.name, self.arguments, self.folder = name, arguments, link_file.parents[2]
        compiler, self.libraries = re.match(r"(\S+).*? -o \S+(.*)", link_file.read_text(encoding="utf8").strip()).groups()
        self.compiler, self.units = compiler, [all_units()[path] for path in own]
        self.seconds, self.output, self.lock = 0.0, None, threading.Lock()

    @functools.cached_property
    def parts(self):
        """Its own objects, and the members of libraries that the linker takes."""
        with tempfile.TemporaryDirectory() as scratch:
            trace = subprocess.run(f"{self.link({})} -Wl,--trace,--trace -o {scratch}/linked", shell=True, cwd=self.folder,
                                   capture_output=True, text=True).stdout
        taken = {(library, member) for library, member in re.findall(r"lib(\w+)\.a\)?\(?([\w.-]+\.o)", trace)}
        members = [unit for path, unit in all_units().items()
                   if any(part.endswith(".dir") and (part[:-4], path.name) in taken for part in path.parts)]
        return self.units + members

    def link(self, renewed):
        """The command; archives have what the objects named lack."""
        others = [target for unit, target in renewed.items() if unit not in self.units and unit in self.parts]
        return " ".join(map(str, [self.compiler, *(renewed.get(unit, unit.path) for unit in self.units), *others, self.libraries]))

    def changed(self, file):
        return [unit for unit in self.parts if unit.reads(file)]

    def run(self, binary, scratch, limit):
        """Whether it succeeds, and the lines of its tables."""
        out = scratch / "out"
        shutil.rmtree(out, ignore_errors=True)
        try:
            done = subprocess.run([str(binary), *(str(out) if word == "OUT" else word for word in self.arguments)],
                                  stdin=subprocess.DEVNULL, capture_output=True, timeout=limit)
        except subprocess.TimeoutExpired:
            return False, "does not end"
        tables = {path.name: [line for line in path.read_text(encoding="utf8").splitlines() if line[:1] != "#"]
                  for path in sorted(out.glob("*.ecsv"))} if out.exists() else {}
        return done.returncode == 0, tables

    def unchanged(self, scratch):
        """Runs it as it is, once: it must succeed."""
        with self.lock:
            if self.output is None:
                self.run_unchanged(scratch)

    def run_unchanged(self, scratch):
        begin = time.monotonic()
        subprocess.run(f"{self.link({})} -o {scratch}/unchanged", shell=True, cwd=self.folder, check=True, capture_output=True)
        good, self.output = self.run(scratch / "unchanged", scratch, 600)
        self.seconds = time.monotonic() - begin
        if not good:
            raise SystemExit(f"{self.name} fails without any error: nothing can be said")

    def verdict(self, file, place, renewed):
        """How it behaves with the changed copy below `place`: nothing if as before. `renewed` holds what was compiled."""
        self.unchanged(place)
        for unit in self.changed(file):
            if unit not in renewed and not unit.compile(place, file, renewed):
                return "no longer compiles"
        link = subprocess.run(f"{self.link(renewed)} -o {place}/changed", shell=True, cwd=self.folder, capture_output=True)
        if link.returncode:
            return "no longer links"
        good, output = self.run(place / "changed", place, 10 + 5 * self.seconds)
        return ("does not end" if output == "does not end" else "fails") if not good else "differs" if output != self.output else None


@functools.cache
def test_of(name):
    folder = BUILD / "tests/CMakeFiles/tests.dir"
    text = (ROOT / f"tests/{name}.cpp").read_text(encoding="utf8")
    with_data = re.search('DATA_DIR|BIN_DIR|"run.hpp"', text)
    return Binary(name, folder / "link.txt", [folder / "main.cpp.o", folder / f"{name}.cpp.o"], [ALONE] if with_data else [])


def tests_again():
    """Those that are compiled several at once (tests/CMakeLists.txt)."""
    folder = BUILD / "tests/CMakeFiles"
    return [Binary(f"{unit.name[:7]}", folder / "tests.dir/link.txt", [folder / "tests.dir/main.cpp.o", unit], [])
            for unit in sorted(all_units()) if "Unity" in unit.parts]


@functools.cache
def program_of(name):
    folder = BUILD / f"CMakeFiles/{name}.dir"
    return Binary(name, folder / "link.txt", [folder / f"src/{name}.cpp.o"], ["--quick", "--out", "OUT"])


class Places:
    """A copy of the sources for each worker."""

    def __init__(self, scratch):
        self.scratch, self.of = scratch, {}

    def with_error(self, error, judge):
        """What `judge` says of the place while the error is in it."""
        file, begin, right, wrong = error
        place = self.of.setdefault(threading.get_ident(), pathlib.Path(tempfile.mkdtemp(dir=self.scratch)))
        if not (place / "src").exists():
            shutil.copytree(ROOT / "src", place / "src")
        path = place / "src" / file
        text = path.read_text(encoding="utf8")
        path.write_text(text[:begin] + wrong + text[begin + len(right):], encoding="utf8")
        try:
            return judge(place)
        finally:
            path.write_text(text, encoding="utf8")


# Errors chosen by hand

def files(module):
    """The sources of a module of the library, of `report`, or the code of a section."""
    folder = ROOT / "src" / module if module == "report" or module.startswith("sec") else ROOT / "src/lattice" / module
    return sorted(path for path in folder.iterdir() if path.suffix in (".hpp", ".cpp"))


def read_table(selection):
    table, mistakes = [], []
    for number, line in enumerate((ROOT / "tools/mutants.tsv").read_text(encoding="utf8").splitlines(), 1):
        if not line or line.startswith("#"):
            continue
        module, right, wrong, tests, what = line.split("\t")
        texts = {path: path.read_text(encoding="utf8") for path in files(module)}
        count = sum(text.count(right) for text in texts.values())
        if count != 1:
            mistakes.append(f"mutants.tsv:{number}: '{right}' occurs {count} times in {module}")
        elif missing := [test for test in tests.split() if not (ROOT / f"tests/{test}.cpp").exists()]:
            mistakes.append(f"mutants.tsv:{number}: there is no tests/{missing[0]}.cpp")
        elif not selection or any(word in module or word in what for word in selection):
            path, text = next((path, text) for path, text in texts.items() if right in text)
            table.append(((path.relative_to(ROOT / "src"), text.index(right), right, wrong), tests.split(), what))
    if mistakes:
        raise SystemExit("\n".join(mistakes))
    return table


def judge_table(pool, places, table):
    def judge(row):
        error, tests, _ = row

        def with_tests(place):
            renewed = {}
            return next((f"{test} {how}" for test in tests if (how := test_of(test).verdict(error[0], place, renewed))), None)
        return places.with_error(error, with_tests)

    survivors = 0
    for ((file, _, _, wrong), tests, what), how in zip(table, pool.map(judge, table)):
        survivors += how is None
        print(f"killed    {what} ({how})" if how else f"SURVIVES  {what}: {file} with '{wrong}' passes {' and '.join(tests)}; "
              "write the test that it asks for", flush=True)
    print(f"{len(table) - survivors} of {len(table)} errors killed")
    return survivors > 0


# Errors drawn at random

SKIPPED = re.compile(r"^\s*(#|defined\(|template|using |static_assert|throw |requires )|Failure|operator|[Pp]rogress|invalid_argument")
SWAPS = {" + ": " - ", " - ": " + ", " * ": " / ", " / ": " * ", " < ": " <= ", " <= ": " < ", " > ": " >= ", " >= ": " > ",
         " == ": " != ", " != ": " == ", " && ": " || ", " || ": " && ", " += ": " -= ", " -= ": " += ", " *= ": " /= ",
         " /= ": " *= ", "min(": "max(", "max(": "min(", "sin(": "cos(", "cos(": "sin("}
PATTERNS = [(re.compile("|".join(r"(?<!\w)" + re.escape(key) if key[0] != " " else re.escape(key) for key in SWAPS)),
             lambda found: SWAPS[found[0]]),
            (re.compile(r"(?:(?<=[(\[{])|(?<=[,=?:] )|(?<=return ))-(?=[A-Za-z(\d])"), lambda found: ""),  # a sign
            (re.compile(r"(?<=[( ])!(?=[\w(])"), lambda found: ""),
            (re.compile(r"\[(?!this)[a-z_]\w*\](?!\()"), lambda found: found[0][:-1] + " + 1]"),  # an index
            (re.compile(r"(?<![\w.])(?<!e-)\d+(?![\w.'>])"), lambda found: str(int(found[0]) + 1)),
            (re.compile(r"(?<![\w.])\d*\.\d+(?![\w.'])"), lambda found: repr(2 * float(found[0]) or 1.0))]


def code_of(text):
    """The text with comments and strings blanked."""
    blank = lambda found: re.sub(r"[^\n]", " ", found[0])  # noqa: E731
    return re.sub(r'/\*.*?\*/|//[^\n]*|"(?:\\.|[^"\\\n])*"', blank, text, flags=re.S)


def candidates():
    out = []
    for path in sorted([*ROOT.glob("src/lattice/*/*.?pp"), *ROOT.glob("src/sec*/*.?pp")]):
        at = 0
        for line in code_of(path.read_text(encoding="utf8")).splitlines(keepends=True):
            if not SKIPPED.search(line):
                out += [(path.relative_to(ROOT / "src"), at + found.start(), found[0], change(found))
                        for pattern, change in PATTERNS for found in pattern.finditer(line)]
            at += len(line)
    return out


def lines_of(error):
    """The number of the line, and the line with and without the error."""
    file, begin, right, wrong = error
    text = (ROOT / "src" / file).read_text(encoding="utf8")
    head, tail = text.rfind("\n", 0, begin) + 1, text.find("\n", begin)
    return text.count("\n", 0, begin) + 1, text[head:tail].strip(), (text[head:begin] + wrong + text[begin + len(right):tail]).strip()


def judge_drawn(error, places, tests, programs):
    """`killed`, `bytes`, `alive` or `none` (does not compile), and by what."""
    def judge(place):
        renewed = {}
        for kind, binaries in (("killed", tests), ("bytes", programs)):
            concerned = [(sum(unit.seconds for unit in changed) + one.seconds, one.name, one) for one in binaries
                         if (changed := one.changed(error[0]))]
            for _, _, one in sorted(concerned)[:None if kind == "killed" else PROGRAMS]:
                if kind == "killed" and len(renewed) > OBJECTS:
                    break
                how = one.verdict(error[0], place, renewed)
                if how and how.startswith("no longer"):
                    return "none", how
                if how:
                    return kind, f"{one.name} {how}"
        return "alive", ""
    return places.with_error(error, judge)


def judge_random(pool, places, count, seed):
    drawn = candidates()
    random.Random(seed).shuffle(drawn)
    print(f"{count} of {len(drawn)} possible errors, seed {seed}", flush=True)
    listed = {tuple(line.split("\t")[:3]) for line in (ROOT / "tools/equivalent.tsv").read_text(encoding="utf8").splitlines()}
    tests = [test_of(path.stem) for path in sorted(ROOT.glob("tests/*.cpp"))
             if path.stem not in PROGRAMS_ONLY and not path.stem.endswith("_again")] + tests_again()
    programs = [program_of(path.stem) for path in sorted(ROOT.glob("src/sec*.cpp"))]
    list(pool.map(lambda one: one.unchanged(pathlib.Path(tempfile.mkdtemp(dir=places.scratch))), tests))

    def judge(error):
        number, right, wrong = lines_of(error)
        kind, how = ("equivalent", "") if (str(error[0]), right, wrong) in listed else judge_drawn(error, places, tests, programs)
        if kind != "none":
            print(f"{kind:10} src/{error[0]}:{number}  {how}" + (f"\n    {right}\n    {wrong}" if kind in ("bytes", "alive") else ""),
                  flush=True)
        return error[0].parent.name, kind

    counts = collections.defaultdict(collections.Counter)
    while (missing := count - sum(sum(of.values()) for of in counts.values())) and drawn:
        batch, drawn = drawn[:missing], drawn[missing:]
        for module, kind in pool.map(judge, batch):
            if kind != "none":
                counts[module][kind] += 1
    kinds = ["killed", "bytes", "alive", "equivalent"]
    total = collections.Counter()
    print(f"{'module':18}" + "".join(f"{kind:>12}" for kind in kinds))
    for module, of in sorted(counts.items()):
        total += of
        print(f"{module:18}" + "".join(f"{of[kind]:12}" for kind in kinds))
    print(f"{'all':18}" + "".join(f"{total[kind]:12}" for kind in kinds))
    return total["alive"] > 0 or total["bytes"] > 0.1 * count


def main():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    workers = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    given = re.fullmatch(r"random=(\d+) seed=(\d+)", " ".join(sys.argv[1:]))
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(workers) as pool:
        places = Places(pathlib.Path(folder))
        if given:
            return judge_random(pool, places, int(given[1]), int(given[2]))
        table = read_table(sys.argv[1:])
        tests = sorted({test for _, names, _ in table for test in names})
        list(pool.map(lambda test: test_of(test).unchanged(pathlib.Path(tempfile.mkdtemp(dir=places.scratch))), tests))
        return judge_table(pool, places, table)


if __name__ == "__main__":
    sys.exit(main())
