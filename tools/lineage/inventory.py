"""What there is: every table with its columns, every command with its options, and the packages they were made with.

Nothing of it is written by hand. A table describes itself in its header, a program in its `--help`, and dpkg knows
the versions. The verb writes three tables, and the book makes pages of them."""

import re
import shutil
import subprocess
from pathlib import Path

from . import ecsv
from .claims import programs_of
from .volumes import volumes

# Packages that the README takes for granted, in the words of apt-packages.txt
GRANTED = "build"
GRANTED_PACKAGES = ("g++", "cmake", "make", "git")

COLUMNS = {
    "tables": [("program", "that writes the table"), ("table", "name of the table"), ("column", "name of the column"),
               ("unit", "unit of the column; empty if it has none"), ("kind", "float64, int64 or string"),
               ("description", "what the column means")],
    "commands": [("program", "name of the program"), ("command", "name of the command; empty for the program alone"),
                 ("option", "with two dashes; empty in the row that says what the command does"),
                 ("allowed", "values that the option takes; empty if it takes none"),
                 ("description", "what the command does or the option means, with the default")],
    "packages": [("package", "name in Debian"), ("version", "installed here; empty if it is not"),
                 ("section", "of apt-packages.txt, what the package is needed for")]}


def tables(root, data):
    """A row for each column of each table, in the order of programs, tables and columns."""
    for program in (program for folder in volumes(root) for program in programs_of(folder)):
        for path in sorted((Path(data) / program).glob("[!.]*.ecsv")):
            for c in ecsv.header_of(ecsv.text_of(path))[0]:
                yield {"program": program, "table": path.stem, "column": c.name, "unit": c.unit, "kind": c.kind,
                       "description": c.description}


def entries(help_text, heading):
    """The lines of help below a heading: (name, what is allowed, meaning)."""
    block = re.search(rf"^{heading}.*?:\n((?: .*\n)*)", help_text, re.M)
    for line in re.sub(r"\n {20,}(?=\S)", " ", block[1]).splitlines() if block else ():
        name, meaning = re.split(r" {2,}", line.strip(), maxsplit=1)
        name, _, allowed = name.partition(" ")
        yield name, allowed, meaning


def help_of(program, *command):
    try:
        run = subprocess.run([str(program), *command, "--help"], capture_output=True, text=True, check=True, timeout=60)
    except (OSError, subprocess.SubprocessError) as error:
        raise ecsv.Fault(f"{program}: cannot print its help ({error})") from None
    return run.stdout


def rows_of(program, command, text):
    title, _, rest = text.partition("\n")
    yield {"program": program, "command": command, "option": "", "allowed": "", "description": title}
    for name, allowed, meaning in entries(rest, "Options"):
        yield {"program": program, "command": command, "option": name, "allowed": allowed, "description": meaning}


def commands(root, folder):
    """What the programs say of themselves; nothing for one that is not built."""
    for name in (program for folder in volumes(root) for program in programs_of(folder)):
        program = (Path(folder) / name).resolve()
        if program.exists():
            text = help_of(program)
            yield from rows_of(name, "", text)
            for command, _, _ in entries(text, "Commands"):
                yield from rows_of(name, command, help_of(program, command))


def packages(root):
    """The packages of apt-packages.txt and those that it takes for granted, with the versions installed here."""
    wanted, section = [(name, GRANTED) for name in GRANTED_PACKAGES], "figures and tests"
    for line in ecsv.text_of(Path(root) / "apt-packages.txt").split():
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


def write(root, data, folder, out):
    """The verb: tables.ecsv, commands.ecsv and packages.ecsv."""
    ecsv.check_all_written(data)
    for name, rows in [("tables", tables(root, data)), ("commands", commands(root, folder)), ("packages", packages(root))]:
        columns = [ecsv.Column(column, "string", text) for column, text in COLUMNS[name]]
        ecsv.write_whole(Path(out) / f"{name}.ecsv",
                         ecsv.to_text(ecsv.Table(columns, list(rows), {"program": "lineage inventory"})))
