"""The bytes of all tables, paper/hashes.ecsv: SHA-256 over the lines of a table without those that begin with `#`, and
without the column `made_by`, the name of a function.

Equal sources give equal bytes on every machine with this kind of processor, whatever compiler, release of Debian,
number of threads or width of the vectors. The record has them for the full run, which the tests compare, and for the
quick one, which takes two minutes and serves to compare platforms (tools/platforms.sh). What is known to depend on
the platform is left out of its table's hash: a column, or the rows that begin with a name, that stands in the column
`left_out`, by hand, with the reason beside it."""

import csv
import hashlib
import platform
from dataclasses import dataclass
from pathlib import Path

from . import ecsv
from .claims import programs_of, runs_of

RUNS = ("full", "quick")
OTHER_PROCESSOR = 77  # what ctest calls skipped
COLUMNS = [
    ecsv.Column("program", "string", "program that writes the table"),
    ecsv.Column("table", "string", "name of the table"),
    ecsv.Column("full", "string", "SHA-256 of the full run's table without its lines with #"),
    ecsv.Column("quick", "string", "the same for the run with --quick"),
    ecsv.Column("left_out", "string", "columns, or first cells of rows, that depend on the platform, by hand"),
    ecsv.Column("reason", "string", "why they do"),
]


@dataclass
class Entry:
    full: str = ""
    quick: str = ""
    left_out: str = ""
    reason: str = ""


def record_of(root):
    return Path(root) / "paper/hashes.ecsv"


def read_record(root):
    """The entries by (program, table), and with what they were computed."""
    table, out = ecsv.read(record_of(root), [c.name for c in COLUMNS]), {}
    for key, row in table.by(("program", "table")).items():
        if bool(row["left_out"]) != bool(row["reason"]):
            raise row.fault("a row needs a reason if it is left out, and only then")
        out[key] = Entry(*(row[c.name] for c in COLUMNS[2:]))
    return out, table.meta


def rows_of(path, left_out=""):
    """The lines that count, without the rows and the cells that are left out."""
    lines = ecsv.rows_of(ecsv.text_of(path))
    if not lines or not left_out and "made_by" not in lines[0].split(","):
        return lines
    names, (header, *rows) = ["made_by", *left_out.split()], csv.reader(lines)
    kept = [i for i, column in enumerate(header) if column not in names]
    rows = [header] + [cells for cells in rows if cells[0] not in names]
    return [",".join(ecsv.cell_text(cells[i]) for i in kept) for cells in rows]


def hash_of(path, left_out=""):
    return hashlib.sha256("".join(line + "\n" for line in rows_of(path, left_out)).encode()).hexdigest()


def maker_of(path):
    """The compiler and the libraries that its header names."""
    meta = ecsv.header_of(ecsv.text_of(path))[1]
    return ", ".join(meta.get(key, "unknown") for key in ("build", "libraries"))


def tables_in(data, programs):
    """The files of the runs that are complete, by (program, table)."""
    return {(p, path.stem): path for p, facts in runs_of(data, programs) for path in sorted(facts.parent.glob("*.ecsv"))}


def first_difference(path, other, left_out=""):
    """Where two tables part, and how far."""
    one, two = rows_of(path, left_out), rows_of(other, left_out)
    if not one or not two or one[0] != two[0]:
        return "other columns"
    if len(one) != len(two):
        return f"{len(one) - 1} rows instead of {len(two) - 1}"
    apart = [i for i in range(len(one)) if one[i] != two[i]]
    tables, out = [ecsv.read(p) for p in (path, other)], left_out.split()
    for row, twin in zip(*(table.rows for table in tables)):
        for name, a in row.items():
            if str(a) != str(b := twin[name]) and name not in out and str(next(iter(row.values()))) not in out:
                return f"row {row.number}, {name}: {a!r} instead of {b!r} ({len(apart)} of {len(one) - 1} rows differ)"
    return "other spelling"


def differences(record, data, programs, run):
    """The tables of a run that differ from the record, each with a word."""
    found = tables_in(data, programs)
    for key, path in found.items():
        entry = record.get(key, Entry())
        wanted = getattr(entry, run)
        if not wanted:
            yield key, path, "not recorded"
        elif hash_of(path, entry.left_out) != wanted:
            yield key, path, "not the bytes that are recorded"
    for key, entry in record.items():
        if getattr(entry, run) and key not in found and (key[0] not in programs or (key[0], "facts") in found):
            yield key, Path(data) / key[0] / f"{key[1]}.ecsv", "recorded and not there"
    for program in programs:
        if (Path(data) / program).is_dir() and (program, "facts") not in found:
            yield (program, "facts"), Path(data) / program / "facts.ecsv", "not there: the program did not finish"


def told(root, data, run, against=None):
    """Prints the tables of a run that differ from the record, and returns them. A folder of tables from another platform,
    `against`, tells in which row."""
    record, programs = read_record(root)[0], programs_of(root)
    found, out = tables_in(data, programs), []
    if not found:
        raise ecsv.Fault(f"{data}: no program has finished here")
    for path in found.values():
        ecsv.check_run(path, ecsv.text_of(path), run == "quick")
    for key, path, word in differences(record, data, programs, run):
        out.append(key)
        twin = Path(against or "") / key[0] / path.name
        if against and path.exists() and twin.exists():
            word += "; " + first_difference(path, twin, record.get(key, Entry()).left_out)
        print(f"  differs  {path}: {word}")
    print(f"bytes      : {len(found) - len([key for key in out if key in found])} of {len(found)} tables of the {run} run are as recorded")
    return out


def is_here(root, data):
    """Whether the record was made on this kind of processor; else it says so."""
    meta, found = read_record(root)[1], tables_in(data, programs_of(root))
    if meta.get("processor") == platform.machine():
        return True
    print(f"             here     {maker_of(next(iter(found.values())))}, {platform.machine()}")
    print(f"             recorded {meta.get('maker', 'unknown')}, {meta.get('processor', 'unknown')}")
    print("             a different kind of processor may give different bytes (CONTRIBUTING.md)")
    return False


def compare(root, data, run, against=None):
    """The verb: 0, 1 if a table differs, 77 if it does on another kind of processor."""
    if not told(root, data, run, against):
        return 0
    return 1 if is_here(root, data) else OTHER_PROCESSOR


def renew(root, folders):
    """Records what is in the folders of the runs, keeps what is written by hand, and says what moved."""
    programs = programs_of(root)
    record = read_record(root)[0] if record_of(root).exists() else {}
    now = {key: Entry(left_out=e.left_out, reason=e.reason) for key, e in record.items() if key[0] in programs}
    maker, counts = None, []
    for run, data in zip(RUNS, folders):
        found = tables_in(data, programs)
        if missing := [p for p in programs if (p, "facts") not in found]:
            raise ecsv.Fault(f"{data}: {', '.join(missing)} did not finish (make accept runs everything)")
        ecsv.check_all_written(data)
        for key, path in found.items():
            ecsv.check_run(path, ecsv.text_of(path), run == "quick")
            entry = now.setdefault(key, Entry())
            setattr(entry, run, hash_of(path, entry.left_out))
            maker = maker or maker_of(path)
        counts.append(f"{len(found)} of the {run} run")
    now = {key: e for key, e in now.items() if e.full or e.quick}
    for key in sorted(record.keys() | now.keys()):
        was, entry = record.get(key), now.get(key)
        moved = [run for run in RUNS if was and entry and getattr(was, run) != getattr(entry, run)]
        if moved or not was or not entry:
            word = "new      " if not was else "gone     " if not entry else "moved    "
            print(f"  {word}{' '.join(key)}" + (f": {' and '.join(moved)}" if moved else ""))
    rows = [dict(zip((c.name for c in COLUMNS), (*key, e.full, e.quick, e.left_out, e.reason))) for key, e in sorted(now.items())]
    ecsv.write_whole(record_of(root), ecsv.to_text(ecsv.Table(COLUMNS, rows, {
        "title": "The bytes of all tables", "maker": maker, "processor": platform.machine()})))
    print(f"bytes      : {' and '.join(counts)}, in {record_of(root)}")
