"""The bytes of all tables: paper/full.sha256 of the full run, which the tests compare, and paper/quick.sha256 of the quick one,
which takes two minutes and serves to compare platforms (tools/platforms.sh). Both are lists for coreutils,

    (cd build/data && sha256sum -c ../../paper/full.sha256)

and begin with a comment that names processor, compiler and libraries. Equal sources give equal bytes on every machine with
this kind of processor, whatever compiler, release of Debian, number of threads or width of the vectors."""

import platform
from pathlib import Path

from . import ecsv
from .claims import programs_of, runs_of

RUNS = ("full", "quick")
OTHER_PROCESSOR = 77  # what ctest calls skipped


def record_of(root, run):
    return Path(root) / f"paper/{run}.sha256"


def found_in(root, data, run):
    """The sums of the tables that are there, of the runs that are complete, by their names below `data`."""
    out = {}
    for path in (path for _, folder in runs_of(data, programs_of(root)) for path in ecsv.tables_in(folder)):
        text = ecsv.text_of(path)
        ecsv.check_run(path, text, run == "quick")
        out[f"{path.parent.name}/{path.name}"] = ecsv.sha256(text)
    return out


def first_difference(path, other):
    """Where two tables part, and how far."""
    one, two = ecsv.read(path), ecsv.read(other)
    if (one.columns, one.meta) != (two.columns, two.meta):
        return "another header"
    if len(one.rows) != len(two.rows):
        return f"{len(one.rows)} rows instead of {len(two.rows)}"
    apart = [(row, twin) for row, twin in zip(one.rows, two.rows) if str(row) != str(twin)]
    for row, twin in apart:
        name = next(name for name in row if str(row[name]) != str(twin[name]))
        return f"row {row.number}, {name}: {row[name]!r} instead of {twin[name]!r} ({len(apart)} of {len(one.rows)} rows differ)"
    return "other spelling"


def told(root, data, run, against=None):
    """Prints the tables of a run that differ from the record, and returns how many do. A folder of tables from another
    platform, `against`, tells in which row."""
    record, found = ecsv.sums_of(record_of(root, run)), found_in(root, data, run)
    if not found:
        raise ecsv.Fault(f"{data}: no program has finished here")
    begun = [name for name in record if (Path(data) / name).parent.is_dir()]
    differ = [name for name in sorted({*begun, *found}) if record.get(name) != found.get(name)]
    for name in differ:
        word = ("not recorded" if name not in record else "recorded and not there" if name not in found
                else "not the bytes that are recorded")
        path, twin = Path(data) / name, Path(against or "") / name
        if against and path.exists() and twin.exists():
            word += "; " + first_difference(path, twin)
        print(f"  differs  {path}: {word}")
    print(f"bytes      : {sum(name not in differ for name in found)} of {len(found)} tables of the {run} run are as recorded")
    return len(differ)


def made_here(data, name):
    return f"{platform.machine()}, {ecsv.maker_of((Path(data) / name).parent)}"


def is_here(root, data, run="full"):
    """Whether the record was made on this kind of processor; else it says so."""
    made = ecsv.text_of(record_of(root, run)).partition("\n")[0].removeprefix("# ")
    if made.partition(",")[0] == platform.machine():
        return True
    print(f"             here     {made_here(data, min(found_in(root, data, run)))}")
    print(f"             recorded {made}")
    print("             a different kind of processor may give different bytes (MAINTAINING.md)")
    return False


def compare(root, data, run, against=None):
    """The verb: 0, 1 if a table differs, 77 if it does on another kind of processor."""
    if not told(root, data, run, against):
        return 0
    return 1 if is_here(root, data, run) else OTHER_PROCESSOR


def renew(root, folders):
    """Records what is in the folders of the runs, and says what moved."""
    programs, now = programs_of(root), {}
    for run, data in zip(RUNS, folders):
        if missing := sorted({*programs} - {program for program, _ in runs_of(data, programs)}):
            raise ecsv.Fault(f"{data}: {', '.join(missing)} did not finish (make accept runs everything)")
        ecsv.check_all_written(data)
        now[run] = found_in(root, data, run)
    for run, data in zip(RUNS, folders):
        path, found = record_of(root, run), now[run]
        record = ecsv.sums_of(path)
        for name in sorted({*record, *found}):
            if record.get(name) != found.get(name):
                print(f"  {'new' if name not in record else 'gone' if name not in found else 'moved':9}{name} ({run})")
        lines = [f"# {made_here(data, min(found))}", *(f"{found[name]}  {name}" for name in sorted(found))]
        ecsv.write_whole(path, "\n".join(lines) + "\n")
        print(f"bytes      : {len(found)} tables of the {run} run, in {path}")
