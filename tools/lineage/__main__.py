"""The verbs. What cannot be used is one line: exit code 1 for a file, 2 for the command line."""

import argparse
import signal
import sys
from pathlib import Path

from . import ecsv, lacking


def need(folder):
    if not Path(folder).is_dir():
        raise ecsv.Fault(f"{folder} is missing: compute it first (make figures)")


def show(given):
    from .show import show as show_one
    show_one(given.root, given.data, given.id)


def accept(given):
    """Values and bytes; prose follows by `refresh`."""
    from . import hashes, lock
    need(given.data)
    if not given.check:
        hashes.renew(given.root, given.data)
        return lock.renew(given.root, given.data)
    moved, tables = lock.check(given.root, given.data), hashes.told(given.root, given.data)
    if not moved and not tables:
        return 0
    if not hashes.is_here(given.root, given.data) and not moved:
        return hashes.OTHER_PROCESSOR
    call = "make accept" if Path(given.root).name != "beyond" else "make volume=beyond accept"
    said = [f"{n} {word}{'s' * (n != 1)}" for n, word in ((tables, "table"), (moved, "value"))]
    print(f"{', '.join(said)} changed; if you meant it: {call}")
    return 1


def tables(given):
    for path in () if given.files else ecsv.forget_incomplete(given.data):
        print(f"  missing  {path}: its program will run again")
    files = [name for name in given.files if name.endswith(".ecsv")]
    faults = list(ecsv.faults_of(files) if given.files else ecsv.altered(given.data))
    for fault in faults:
        print(fault, file=sys.stderr)
    return bool(faults)


def refresh(given):
    from .chapters import measured_costs
    from .refresh import renew
    return renew(given.root, measured_costs(given.costs), given.check) > 0 and given.check


def macros(given):
    from .tex import write
    write(given.root, given.out)


class Parser(argparse.ArgumentParser):
    def error(self, message):
        self.exit(2, f"{self.prog}: {message}\n")


def reader():
    parser = Parser(prog="lineage", description="Reads the tables that the programs wrote.")
    parser.add_argument("--root", default=".", help="folder of the repository (default: here)")
    verbs = parser.add_subparsers(dest="verb", required=True, metavar="verb")
    options = {"data": ("build/data", "folder that holds one folder of tables per program"),
               "costs": ("build/report/cost", "folder with the run time of each program in seconds")}

    def verb(run, help, *wanted, out=None):
        sub = verbs.add_parser(run.__name__, help=help, description=help)
        sub.set_defaults(run=run)
        for name in wanted:
            sub.add_argument("--" + name, default=options[name][0], help=f"{options[name][1]} (default: %(default)s)")
        if out:
            sub.add_argument("--out", default=out, help="where to write (default: %(default)s)")
        return sub

    verb(show, "show one number: printed, converged, error, verdict, figure, command", "data").add_argument("id")
    kept = verb(accept, "record values and bytes in paper/converged.ecsv and full.sha256, and print what moved", "data")
    kept.add_argument("--check", action="store_true", help="only report what changed; exit code 1 if anything did, 77 if it is bytes on "
                                                           "another kind of processor")
    verb(tables, "check that tables are those of SHA256SUMS; a program whose table is missing will run again",
         "data").add_argument("files", nargs="*", help="only the tables among these files")
    stale = verb(refresh, "write the reference values into the prose, and renew the tables of the pages", "costs")
    stale.add_argument("--check", action="store_true", help="only report what is stale; exit code 1 if anything is")
    verb(macros, "write the reference values as macros for the paper", out="build/paper")
    return parser


def main(arguments=None):
    given = reader().parse_args(arguments)
    try:
        return int(given.run(given) or 0)
    except ecsv.Fault as fault:
        print(f"lineage {given.verb}: {fault}", file=sys.stderr)
        return fault.code
    except ModuleNotFoundError as error:
        print(f"lineage {given.verb}: {lacking(error)}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # `| head` is no error
    sys.exit(main())
