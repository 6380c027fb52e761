"""What a reader needs to compute a number again: the chapters that answer and explain a claim, the commands of their
programs, and what these cost.

Nobody types which chapter explains a discrepancy: it is one whose cells the reason quotes. The costs are in
paper/costs.ecsv, a row for each program, which `make refresh` renews from what the last run took."""

import math
import re
import textwrap
from pathlib import Path

from . import ecsv
from .claims import QUOTED, programs_of
from .inventory import description
from .values import with_digits
from .volumes import article

COSTS = [ecsv.Column("program", "string", "chapter of src/"),
         ecsv.Column("seconds", "float64", "computing time of its full run on two cores", "s")]


def explained_by(id, claims, known=()):
    """The programs behind a claim: the one that answers it, then those of the cells that its reason quotes, and those
    behind the claims that it names or follows from."""
    claim, programs = claims[id], [claims[id]["program"]]
    named = [name for name in claims if re.search(rf"(?<![\w.]){re.escape(name)}(?!\w)", claim["reason"])]
    for name in QUOTED.findall(claim["reason"]) + [claim["covered_by"].partition("^")[0]] + named:
        if name not in claims and "/" in name:
            programs.append(name.partition("/")[0])
        elif name in claims and name != id and name not in known:
            programs += explained_by(name, claims, (id, *known))
    return [program for program in dict.fromkeys(programs) if program]


def chapter_of(root, program):
    """Its source, from the folder of the article."""
    return f"{'beyond/' if (article(root) / f'beyond/src/{program}.cpp').exists() else ''}src/{program}.cpp"


def run_of(program):
    """The command that computes a whole chapter."""
    return f"build/bin/{program}"


def command_of(figure):
    """How a reader asks for a figure: `make fig07`, `make x03`."""
    return "make " + (figure if figure.startswith("x") else "fig" + figure)


def read_commands(root):
    """Commands that compute one number alone, and what they call it, by its name: book/commands.txt."""
    out = {}
    for line in ecsv.lines_of(Path(root) / "book/commands.txt"):
        id, _, command = line.partition(" ")
        command, _, quantity = command.partition("#")
        out[id] = command.strip(), quantity.strip()
    return out


def head_lines(root, program, figures, costs):
    """What stands at the head of a chapter: its command, what that costs and writes, its figures, its other commands; None
    where the program is not there to say these."""
    if not (there := article(root) / run_of(program)).exists():
        return None
    own = [f"`{row['command']}`, {row['meaning']}" for row in description(there) if row["command"] and not row["option"]]
    tables = sum(name.startswith(program + "/") for name in ecsv.sums_of(Path(root) / "paper/full.sha256"))
    seconds = costs.get(program, math.nan)
    drawn = [command_of(id) for id, row in figures.items() if row["program"] == program]
    said = [f"`{run_of(program)}` computes this chapter in {'less than 1' if seconds < 1 else shown_cost(seconds)} s on two cores "
            f"and writes {tables} tables to `build/data/{program}`."]
    said += [f"Its figures: {', '.join(f'`{command}`' for command in drawn)}."] * bool(drawn)
    said += [f"With your parameters: {'; '.join(own)}."] * bool(own)
    return textwrap.wrap(" ".join(said), 120, break_long_words=False, break_on_hyphens=False)


# What it costs


def read_costs(root):
    """The seconds of every program that has been measured, by its name."""
    table = ecsv.read(Path(root) / "paper/costs.ecsv", [c.name for c in COSTS])
    return {program: row["seconds"] for program, row in table.by("program", "costs").items()}


def measured_costs(folder):
    """The seconds that each program took, from the files that tools/compute.sh leaves."""
    out = {}
    for path in sorted(p for p in Path(folder).glob("*") if not p.name.startswith(".")):  # locks of running programs
        try:
            out[path.name] = float(ecsv.text_of(path).split()[0])
        except (ValueError, IndexError):
            raise ecsv.Fault(f"{path}: not a time in seconds") from None
    return out


def renewed_costs(root, measured):
    """The costs of all programs that exist, nan where nobody has measured one. A time is renewed when it has moved by
    more than a factor of two and by more than half a second, since a refreshed page should not show noise. None is less than
    the tenth of a second that is the least to be measured."""
    known, out = read_costs(root), {}
    for program in programs_of(root):
        was, now = known.get(program, math.nan), measured.get(program, math.nan)
        moved = not math.isnan(now) and not (abs(now - was) < 0.5 or 0.5 < now / was < 2)
        out[program] = max(0.1, float(with_digits(now, 2))) if moved else was
    return out


def costs_text(costs):
    """The text of paper/costs.ecsv."""
    rows = [{"program": program, "seconds": f"{seconds:.6g}"} for program, seconds in costs.items()]
    return ecsv.to_text(ecsv.Table(COSTS, rows, {"title": "What a full run of each program costs, written by make refresh"}))


def shown_cost(seconds):
    return "?" if math.isnan(seconds) else "< 1" if seconds < 1 else str(math.floor(seconds + 0.5))
