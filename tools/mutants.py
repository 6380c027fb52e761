"""Would the tests notice? Puts the errors of mutants.tsv into a copy of the sources, one at a time.

`make mutants`: a row names the tests that should notice; an error is killed if one of them fails (or no longer compiles, or
does not end) and survives otherwise. A row whose right text is not in its module, of either volume, exactly once is a mistake
in the table and ends the run. Arguments select rows by their module or description.

It works on what `make` has built: of a test only the objects that read the changed file are compiled again, as they were. Of
tests that call programs or read tables, the cases that do neither are run.
"""

import concurrent.futures
import functools
import json
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
VOLUMES = [ROOT, ROOT / "beyond"]
BUILD = ROOT / "build"
ALONE = "~[published]~[cli]"  # what needs no program and no table
MEMORY = 6 << 30  # bytes that one process may take


# What is built

def copied(text, place):
    """The text with the sources of both volumes below `place`."""
    for volume in VOLUMES:
        text = text.replace(f"{volume}/src", f"{place / volume.relative_to(ROOT)}/src")
    return text


class Unit:
    """An object file: how it was compiled, and what it reads."""

    def __init__(self, entry):
        self.command, self.folder = entry["command"], pathlib.Path(entry["directory"])
        self.path = self.folder / re.search(r" -o (\S+)", self.command)[1]
        self.common = re.search(r"-include (\S+/cmake_pch\.hxx)", self.command)  # headers that are read once

    @functools.cached_property
    def files(self):
        lists = [self.path.with_name(self.path.name + ".d")] + ([pathlib.Path(self.common[1] + ".gch.d")] if self.common else [])
        words = {word for one in lists for word in one.read_text(encoding="utf8").split()}
        return {os.path.normpath(self.folder / word) for word in words}  # ccache may write them relative to the folder

    def reads(self, file):
        return str(ROOT / file) in self.files

    def compile(self, place, file, renewed):
        """Compiles the copy below `place` as the original was; whether that works. `renewed` gets the object, and what is
        read once for many if that has changed too."""
        target = renewed[self] = place / f"{len(renewed)}.o"
        command = self.command.replace(f" -o {re.search(' -o ([^ ]+)', self.command)[1]}", f" -o {target}")
        if self.common and str(ROOT / file) in pathlib.Path(self.common[1] + ".gch.d").read_text(encoding="utf8"):
            command = command.replace(self.common[1], str(self.compile_common(place, renewed)))
        return subprocess.run(copied(command, place), shell=True, cwd=self.folder, capture_output=True).returncode == 0

    def compile_common(self, place, renewed):
        """The headers that are read once, compiled once for each error."""
        header = self.common[1]
        if header not in renewed:
            renewed[header] = place / f"common{len(renewed)}.hpp"
            renewed[header].write_text(copied(pathlib.Path(header).read_text(encoding="utf8"), place), encoding="utf8")
            entry = next(one for one in json.loads((BUILD / "compile_commands.json").read_text(encoding="utf8"))
                         if one["file"] == header + ".cxx")
            command = copied(re.sub(r" -o \S+", f" -o {renewed[header]}.gch", entry["command"]), place)
            pathlib.Path(f"{renewed[header]}.gch").unlink(missing_ok=True)
            subprocess.run(command.replace(f"-include {header} ", f"-include {renewed[header]} "), shell=True,
                           cwd=self.folder, capture_output=True)
        return renewed[header]


@functools.cache
def all_units():
    entries = json.loads((BUILD / "compile_commands.json").read_text(encoding="utf8"))
    return {unit.path: unit for unit in map(Unit, entries) if unit.path.exists()}


class Binary:
    """A test, one source with main: what it consists of, and how it behaves unchanged."""

    def __init__(self, name, link_file, own, arguments):
        self.name, self.arguments, self.folder = name, arguments, link_file.parents[2]
        compiler, self.libraries = re.match(r"(\S+).*? -o \S+(.*)", link_file.read_text(encoding="utf8").strip()).groups()
        self.compiler, self.units = compiler, [all_units()[path] for path in own]
        self.seconds, self.lock = None, threading.Lock()

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

    def run(self, binary, limit):
        """What is wrong with it; nothing if it succeeds."""
        try:
            done = subprocess.run([str(binary), *self.arguments], stdin=subprocess.DEVNULL, capture_output=True, timeout=limit)
        except subprocess.TimeoutExpired:
            return "does not end"
        return "fails" if done.returncode else None

    def unchanged(self, scratch):
        """Runs it as it is, once: it must succeed."""
        with self.lock:
            if self.seconds is None:
                self.run_unchanged(scratch)

    def run_unchanged(self, scratch):
        begin = time.monotonic()
        subprocess.run(f"{self.link({})} -o {scratch}/unchanged", shell=True, cwd=self.folder, check=True, capture_output=True)
        if self.run(scratch / "unchanged", 600):
            raise SystemExit(f"{self.name} fails without any error: nothing can be said")
        self.seconds = time.monotonic() - begin

    def verdict(self, file, place, renewed):
        """How it behaves with the changed copy below `place`: nothing if it succeeds. `renewed` holds what was compiled."""
        self.unchanged(place)
        for unit in self.changed(file):
            if unit not in renewed and not unit.compile(place, file, renewed):
                return "no longer compiles"
        link = subprocess.run(f"{self.link(renewed)} -o {place}/changed", shell=True, cwd=self.folder, capture_output=True)
        return "no longer links" if link.returncode else self.run(place / "changed", 10 + 5 * self.seconds)


def source_of(name):
    """The test of that name, in the first volume that has one."""
    return next((path for volume in VOLUMES if (path := volume / f"tests/{name}.cpp").exists()), None)


@functools.cache
def test_of(name):
    path = source_of(name)
    place = path.parent.relative_to(ROOT)
    folder = BUILD / place / "CMakeFiles" / ("tests.dir" if place == pathlib.Path("tests") else "tests_beyond.dir")
    main, = folder.rglob("main.cpp.o")
    with_data = re.search('DATA_DIR|BIN_DIR|"run.hpp"', path.read_text(encoding="utf8"))
    return Binary(name, folder / "link.txt", [main, folder / f"{name}.cpp.o"], [ALONE] if with_data else [])


class Places:
    """A copy of the sources for each worker."""

    def __init__(self, scratch):
        self.scratch, self.of = scratch, {}

    def with_error(self, error, judge):
        """What `judge` says of the place while the error is in it."""
        file, begin, right, wrong = error
        place = self.of.setdefault(threading.get_ident(), pathlib.Path(tempfile.mkdtemp(dir=self.scratch)))
        for volume in VOLUMES:
            copy = place / volume.relative_to(ROOT) / "src"
            if not copy.exists():
                shutil.copytree(volume / "src", copy)
        path = place / file
        text = path.read_text(encoding="utf8")
        path.write_text(text[:begin] + wrong + text[begin + len(right):], encoding="utf8")
        try:
            return judge(place)
        finally:
            path.write_text(text, encoding="utf8")


# The table

def files(module):
    """The sources of a module of the library, of `report`, or the code of a section in either volume."""
    folders = [volume / "src" / module for volume in VOLUMES] if module == "report" or module.startswith("sec") \
        else [ROOT / "src/lattice" / module]
    return sorted(path for folder in folders if folder.exists() for path in folder.iterdir() if path.suffix in (".hpp", ".cpp"))


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
        elif missing := [test for test in tests.split() if not source_of(test)]:
            mistakes.append(f"mutants.tsv:{number}: there is no test {missing[0]}")
        elif not selection or any(word in module or word in what for word in selection):
            path, text = next((path, text) for path, text in texts.items() if right in text)
            table.append(((path.relative_to(ROOT), text.index(right), right, wrong), tests.split(), what))
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


def main():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    workers = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(workers) as pool:
        places = Places(pathlib.Path(folder))
        table = read_table(sys.argv[1:])
        tests = sorted({test for _, names, _ in table for test in names})
        list(pool.map(lambda test: test_of(test).unchanged(pathlib.Path(tempfile.mkdtemp(dir=places.scratch))), tests))
        return judge_table(pool, places, table)


if __name__ == "__main__":
    sys.exit(main())
