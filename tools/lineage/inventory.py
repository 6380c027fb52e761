"""What there is: every command with its options, and the modules of the library. A program describes itself by `--describe`,
src/modules.ecsv says what a module is about; the book makes pages of them."""

import subprocess
from pathlib import Path

from . import ecsv
from .claims import programs_of
from .volumes import volumes


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
