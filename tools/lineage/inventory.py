"""What there is: every command with its options, the modules of the library, and the packages that all was made with.

A program describes itself by `--describe`, src/modules.ecsv says what a module is about, and dpkg knows the versions. The
book makes pages of them."""

import shutil
import subprocess
from pathlib import Path

from . import ecsv
from .claims import programs_of
from .volumes import volumes

# Packages that the README takes for granted, in the words of apt-packages.txt
GRANTED = "build"
GRANTED_PACKAGES = ("g++", "cmake", "make", "git")


def description(program):
    """What a program says of itself: a row for each command, without an option, and rows of its options below it."""
    try:
        run = subprocess.run([str(program), "--describe"], capture_output=True, text=True, check=True, timeout=60)
    except (OSError, subprocess.SubprocessError) as error:
        raise ecsv.Fault(f"{program}: cannot describe itself ({error}); make programs") from None
    return ecsv.parse(run.stdout, program, ("command", "option", "meaning", "takes", "lowest", "highest", "words", "default")).rows


def commands(root, folder):
    """The same of all programs; nothing of one that is not built."""
    for name in (program for folder in volumes(root) for program in programs_of(folder)):
        program = (Path(folder) / name).resolve()
        yield from ({"program": name, **row} for row in description(program)) if program.exists() else ()


def allowed(row):
    """What an option takes, in words; nothing for a flag."""
    if "number" in row["takes"]:
        return "[{}, {}] {}".format(*(repr(row[end]).removesuffix(".0") for end in ("lowest", "highest")), row["unit"]).strip()
    return row["words"]


def explained(row):
    """The meaning of an option, with its default."""
    return row["meaning"] + f" (default: {row['default']})" * bool(row["default"])


def wells(program):
    """The wells that a program offers, in the order of the library's list, each with the names of its parameters."""
    rows = description(program)
    well = next(row for row in rows if row["option"] == "well")
    own = [row for row in rows if (row["command"], row["chosen_by"]) == (well["command"], "well")]
    return {name: [row["option"] for row in own if name in row["choices"].split(", ")] for name in well["words"].split(", ")}


def modules(root):
    """What each module is about, by its folder."""
    return {folder: row["idea"] for folder, row in ecsv.read(Path(root) / "src/modules.ecsv", ("folder", "idea")).by("folder").items()}


def packages(root):
    """The packages of apt-packages.txt and those that it takes for granted, with the versions installed here."""
    wanted, section = [(name, GRANTED) for name in GRANTED_PACKAGES], "figures and tests"
    for line in ecsv.text_of(Path(root) / "tools/apt-packages.txt").split():
        if line.startswith("["):
            section = line.strip("[]")
        else:
            wanted.append((line, section))
    versions = {}
    if shutil.which("dpkg-query"):
        run = subprocess.run(["dpkg-query", "-W", "-f", "${Package}\t${db:Status-Status}\t${Version}\n", *(n for n, _ in wanted)],
                             capture_output=True, text=True, check=False)
        found = (line.split("\t") for line in run.stdout.splitlines())
        versions = {name: version for name, status, version in found if status == "installed"}
    return [{"package": name, "version": versions.get(name, ""), "section": section} for name, section in wanted]

