"""The road of a number after the programs: everything that reads what they wrote.

    ecsv      the one reader and writer of tables
    values    a value with its error, and the digits that people see of it
    claims    what is claimed and found, the verdicts, and all numbers by their names
    chapters  which chapters answer and explain a claim, their commands and costs
    lock      paper/converged.ecsv: which values are kept, and how far a fresh one may be
    hashes    paper/full.sha256: the bytes of every table
    refresh   values and tables in prose: src/, README.md, MAINTAINING.md, paper/costs.ecsv
    tex       the same values for the paper
    show      one number, statement or finding
    inventory every command and module
    sources   chapters as prose and code, and the line that names a number
    markdown  values and words for the book, which book/literate.py makes of all this

`python3 -m lineage --help` lists the verbs. All need the standard library only.
"""

import sys


def lacking(error):
    """What a ModuleNotFoundError says to somebody whose python lacks a module."""
    name = error.name.partition(".")[0]
    return (f"{sys.executable} has no module {name} (Debian: python3-{name.lower()}; "
            "PYTHON=... names another python3 to make)")
