#!/usr/bin/env python3
"""Random command lines: a program answers with 0, 1 or 2, at once, without a signal and without a leftover.

    fuzz.py BIN [COUNT [SEED]]

The options are those that `--help` shows. Most values are bad; a good one is made cheap to compute by
a limit of time, and a program that is still computing then has refused nothing and is stopped.
"""

import os
import random
import re
import subprocess
import sys
import tempfile

VALUES = ["0", "-1", "1", "2", "1.1", "1e-3", "nan", "inf", "-inf", "1e400", "-0", "", " ", "x", "1/0", "0x10",
          "031", "1e999", "99999999999999999999", "--", "-", "site", "bond", "quartic", "hertz", "\t", "é", "a,b",
          "2/8", "../nowhere/x", "/", "'", '"', "$(ls)", "*", "0.5", "11", "-1/6"]
SECONDS = 10


def said(*command):
    return subprocess.run(command, capture_output=True, text=True, timeout=60, check=False).stdout


def commands(program):
    """The subcommands of a program, each with its options as help names them; '' is the full run."""
    help_text = said(program, "--help")
    names = re.findall(r"^  (\w[\w-]*) {2,}", help_text.partition("\nCommands")[2], re.M)
    return {name: re.findall(r"(--[\w-]+)", said(program, name, "--help")) for name in names}


def line(chance, known):
    """One command line: a subcommand, perhaps mistyped, with some options and values."""
    name = chance.choice(sorted(known))
    words = [name if chance.random() < 0.9 else chance.choice([name[:-1], name + "x", "", "-"])]
    for _ in range(chance.randint(1, 4)):
        option = chance.choice(known[name] + ["--bogus", "-q"])
        if option in ("--output", "--folder", "--out"):
            continue  # where files may go is tested elsewhere
        words.append(option)
        if chance.random() < 0.9:
            words.append(chance.choice(VALUES))
    return words


def main():
    folder, count, seed = sys.argv[1], int((sys.argv + [0, "200"])[2] or 200), int((sys.argv + ["0"] * 3)[3] or 1)
    chance = random.Random(seed)
    programs = sorted(name for name in os.listdir(folder) if name.startswith("sec"))
    known = {name: commands(os.path.join(os.path.abspath(folder), name)) for name in programs}
    known = {name: subs for name, subs in known.items() if subs}
    assert len(known) > 10, "no programs with subcommands"
    codes, bad = {}, 0
    with tempfile.TemporaryDirectory() as scratch:
        for _ in range(count):
            name = chance.choice(sorted(known))
            words = line(chance, known[name])
            try:
                done = subprocess.run([os.path.join(os.path.abspath(folder), name), *words], cwd=scratch,
                                      capture_output=True, timeout=SECONDS, stdin=subprocess.DEVNULL, check=False)
                code, errors = done.returncode, done.stderr.decode("utf8", "replace")
            except subprocess.TimeoutExpired:
                code, errors = "computing", ""
            codes[code] = codes.get(code, 0) + 1
            wrong = code not in (0, 1, 2, "computing") or (code in (1, 2) and errors.count("\n") != 1)
            left = os.listdir(scratch)
            if wrong or left:
                bad += 1
                print(f"{name} {words}: code {code}, left {left}, said {errors!r}")
                for one in left:
                    os.rename(os.path.join(scratch, one), os.path.join(folder, "..", "fuzz-" + str(bad)))
    print(f"{count} random command lines, seed {seed}: {codes}")
    sys.exit(bad > 0 or codes.get(2, 0) < count / 4)


if __name__ == "__main__":
    main()
