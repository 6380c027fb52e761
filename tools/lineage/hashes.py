"""The bytes of all tables: paper/full.sha256 of the full run and paper/quick.sha256 of the quick one, which the test `record`
compares. Both are lists for coreutils,

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


def told(root, data, run):
    """Prints the tables of a run that differ from the record, and returns how many do."""
    record, found = ecsv.sums_of(record_of(root, run)), found_in(root, data, run)
    if not found:
        raise ecsv.Fault(f"{data}: no program has finished here")
    begun = [name for name in record if (Path(data) / name).parent.is_dir()]
    differ = [name for name in sorted({*begun, *found}) if record.get(name) != found.get(name)]
    for name in differ:
        word = ("not recorded" if name not in record else "recorded and not there" if name not in found
                else "not the bytes that are recorded")
        print(f"  differs  {Path(data) / name}: {word}")
    print(f"bytes      : {sum(name not in differ for name in found)} of {len(found)} tables of the {run} run are as recorded")
    return len(differ)


def made_here(data, name):
    return f"{platform.machine()}, {ecsv.maker_of((Path(data) / name).parent)}"


def is_here(root, data):
    """Whether the record was made on this kind of processor; else it says so."""
    made = ecsv.text_of(record_of(root, "full")).partition("\n")[0].removeprefix("# ")
    if made.partition(",")[0] == platform.machine():
        return True
    here = made_here(data, min(found_in(root, data, "full")))
    print(f"             here     {here}")
    print(f"             recorded {made}")
    print("             a different kind of processor may give different bytes (MAINTAINING.md)")
    return False


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
