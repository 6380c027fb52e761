"""What there is: every command with its options, and the packages that all was made with.

Nothing of it is written by hand: a program describes itself in its `--help`, and dpkg knows the versions. The book makes
pages of them."""

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
    for line in ecsv.text_of(Path(root) / "tools/apt-packages.txt").split():
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

