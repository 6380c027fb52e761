"""The bytes of all tables: paper/full.sha256, which the test `record` compares, a list for coreutils,

    (cd build/data && sha256sum -c ../../paper/full.sha256)

which begins with a comment that names processor, compiler and libraries. Equal sources give equal bytes on every machine with
this kind of processor, whatever compiler, release of Debian, number of threads or width of the vectors."""

import platform
from pathlib import Path

from . import ecsv
from .claims import programs_of, runs_of

OTHER_PROCESSOR = 77  # what ctest calls skipped


def record_of(root):
    return Path(root) / "paper/full.sha256"


def found_in(root, data):
    """The sums of the tables of the runs that are complete, by their names below `data`."""
    return {f"{program}/{name}": known for program, folder in runs_of(data, programs_of(root))
            for name, known in sorted(ecsv.sums_in(folder).items())}


def told(root, data):
    """Prints the tables that differ from the record, and returns how many do."""
    record, found = ecsv.sums_of(record_of(root)), found_in(root, data)
    if not found:
        raise ecsv.Fault(f"{data}: no program has finished here")
    begun = [name for name in record if (Path(data) / name).parent.is_dir()]
    differ = [name for name in sorted({*begun, *found}) if record.get(name) != found.get(name)]
    for name in differ:
        word = ("not recorded" if name not in record else "recorded and not there" if name not in found
                else "not the bytes that are recorded")
        print(f"  differs  {Path(data) / name}: {word}")
    print(f"bytes      : {sum(name not in differ for name in found)} of {len(found)} tables are as recorded")
    return len(differ)


def made_here(root, data):
    """The processor of this machine, and what the first table was made with."""
    return f"{platform.machine()}, {ecsv.maker_of((Path(data) / min(found_in(root, data))).parent)}"


def is_here(root, data):
    """Whether the record was made on this kind of processor; else it says so."""
    made = ecsv.text_of(record_of(root)).partition("\n")[0].removeprefix("# ")
    if made.partition(",")[0] == platform.machine():
        return True
    print(f"             here     {made_here(root, data)}")
    print(f"             recorded {made}")
    print("             a different kind of processor may give different bytes (book/machines.md)")
    return False


def renew(root, data):
    """Records what is in the folder of the runs, and says what moved."""
    programs = programs_of(root)
    if missing := sorted({*programs} - {program for program, _ in runs_of(data, programs)}):
        raise ecsv.Fault(f"{data}: {', '.join(missing)} did not finish (make accept runs everything)")
    ecsv.check_all_written(data)
    found, record = found_in(root, data), ecsv.sums_of(record_of(root))
    for name in sorted({*record, *found}):
        if record.get(name) != found.get(name):
            print(f"  {'new' if name not in record else 'gone' if name not in found else 'moved':9}{name}")
    lines = [f"# {made_here(root, data)}", *(f"{found[name]}  {name}" for name in sorted(found))]
    ecsv.write_whole(record_of(root), "\n".join(lines) + "\n")
    print(f"bytes      : {len(found)} tables, in {record_of(root)}")
