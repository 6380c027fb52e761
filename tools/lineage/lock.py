"""The reference values, paper/converged.ecsv: what we found, with its error.

It has the answer to every statement that is a number, and the cells that prose, paper or book quote. A fresh value has to agree with the locked one within the sum of the two errors.

The programs give the same bits on every machine, but another compiler or mathematical library may round a
logarithm differently, so that a relative difference of 1e-12 is always allowed."""

import re
from pathlib import Path

from . import ecsv
from .chapters import read_commands
from .cells import cited, home_of, read_cells
from .claims import programs_of, quoted_in, read_answers, read_every, read_second
from .values import Finding, distance
from .volumes import joined, volumes

COLUMNS = [
    ecsv.Column("program", "string", "program that computes it"),
    ecsv.Column("what", "string", "cell of a table; answer to a statement; failures: how many of them fail"),
    ecsv.Column("id", "string", "address of the cell, or statement"),
    ecsv.Column("value", "float64", "converged value"),
    ecsv.Column("error", "float64", "absolute error; 0 for an exact value"),
    ecsv.Column("unit", "string", "unit of value and error"),
]


def lock_of(root):
    return Path(root) / "paper/converged.ecsv"


def read_lock(root):
    """The locked values by (program, what, id)."""
    rows = ecsv.read(lock_of(root), [c.name for c in COLUMNS]).by(("program", "what", "id"))
    return {key: Finding(**row) for key, row in rows.items()}


def lock_text(findings):
    rows = [{c.name: getattr(findings[key], c.name) for c in COLUMNS} for key in sorted(findings)]
    return ecsv.to_text(ecsv.Table(COLUMNS, rows, {
        "title": "What we found: a fresh value agrees within the sum of the errors"}))


# What is quoted


def sources(root):
    return sorted(p for p in (Path(root) / "src").rglob("*") if p.suffix in (".cpp", ".hpp", ".ipp"))


def uncommented(tex):
    """TeX without its comments."""
    return re.sub(r"(?<!\\)%.*", "", tex)


def quoted(root):
    """The names of all numbers that prose, paper, book, the lists of claims and findings or the second route quote, in both
    volumes."""
    all = volumes(root)
    out = set().union(*map(quoted_in, joined(read_every, all).values()), *(joined(read, all) for read in (read_second, read_commands)))
    for folder in all:
        for path in sources(folder) + sorted((folder / "book").glob("*.md")):
            out.update(cited(ecsv.text_of(path), home_of(path)))
        for path in sorted((folder / "paper").glob("*.tex")):
            out.update(re.findall(r"\\(?:num|both|cell\{[^}]*\})\{([^}#]+)\}", uncommented(ecsv.text_of(path))))
    return out


def is_kept(finding, names):
    return finding.what != "cell" or finding.name in names


# Locked and fresh


def renewed(locked, fresh, programs, kept):
    """The new lock: the fresh values that `kept` accepts. A program that has not been run keeps its rows, a program that no
    longer exists loses them."""
    run = {program for program, *_ in fresh}
    stands = {key: f for key, f in locked.items() if key[0] in programs and key[0] not in run}
    return {key: f for key, f in (fresh | stands).items() if kept(f)}


def changes(locked, now, kept):
    """A line for each difference, to be signed by whoever renews the lock."""
    for key, was in locked.items():
        place = f"{was.program} {was.id}" if was.what == "cell" else f"{was.id} ({was.what})"
        if key not in now:
            yield f"  gone     {place}: was {was.shown}" if kept(was) else f"  dropped  {place}: nothing quotes it"
            continue
        f, size = now[key], max(abs(was.value), abs(now[key].value))
        apart = distance(was, f)
        if apart > 1 or abs(was.value - f.value) > 1e-12 * size:
            yield (f"  moved    {place}: {was.value:.17g} -> {f.value:.17g}, {apart:.3g} of the sum of the errors"
                   + ("  <- outside" if apart > 1 else ""))
    for key in now:
        if key not in locked:
            f = now[key]
            yield f"  new      {f.program} {f.id}: {f.shown}" if f.what == "cell" else f"  new      {f.id} ({f.what}): {f.shown}"


def fresh_values(root, data, names):
    """What the programs that have run wrote: answers, and the cells of these names."""
    ecsv.check_all_written(data)
    return read_cells(data, programs_of(root), names) | read_answers(root, Path(data).parent / "report")


def renew(root, data):
    """Writes the reference values and says what moved."""
    programs, names = programs_of(root), quoted(root)
    locked = read_lock(root) if lock_of(root).exists() else {}
    fresh = fresh_values(root, data, names)

    def kept(finding):
        return is_kept(finding, names)

    now = renewed(locked, fresh, programs, kept)
    said = list(changes(locked, now, kept))
    ecsv.write_whole(lock_of(root), lock_text(now))
    print(*said, f"values     : {len(now)} ({len(fresh)} computed), {len(said)} changes, in {lock_of(root)}", sep="\n")


def check(root, data):
    """Says which locked values are gone, or farther than the sum of the errors, and returns how many."""
    locked = read_lock(root)
    fresh = fresh_values(root, data, quoted(root))
    moved = [line for line in changes(locked, {key: f for key, f in fresh.items() if key in locked}, lambda f: True)
             if "moved" not in line or "outside" in line]
    print(*moved, f"values     : {len(locked) - len(moved)} of {len(locked)} within the sum of the errors", sep="\n")
    return len(moved)
