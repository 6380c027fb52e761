#!/usr/bin/env python3
"""Random command lines: whatever is asked, a program answers as it promises.

    fuzz.py BIN [COUNT [SEED]]

The options are those that `--describe` declares, with their ranges. Half of the values are drawn from them, sizes and times
from their small ends, so that a run is short; the others are what people mistype, and what nobody does. Asked is of
every answer: exit code 0, 1 or 2 and no signal, within thirty seconds (times LATTICE_SLACK); a complaint is one line and
comes without a table; a table can be read, and holds a nan only where a description or a reason says so; nothing is left
behind but the file that was asked for. Line number k of a seed is always the same."""

import concurrent.futures
import math
import os
import random
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
sys.dont_write_bytecode = True
from lineage import ecsv, inventory  # noqa: E402

BAD = ["0", "-1", "1", "2", "1.1", "nan", "inf", "-inf", "1e400", "1e-400", "-0", "", " ", "x", "1/0", "0x10", "031",
       "99999999999999999999", "--", "-", "site", "bond", "quartic", "hertz", "\t", "é", "a,b", "2/8", "nowhere/x/y", "/", "'",
       "$(ls)", "0.5", "-1/6", "a\nb", "1" * 400, "0." + "0" * 400 + "1", "\udcff", "+-1", "1_0"]
SECONDS = 30 * float(os.environ.get("LATTICE_SLACK", "1"))
# What decides how long a run takes, and how many times its least value is still short; tolerances at their large end.
SIZES = {"sites": 2, "columns": 1.5, "rows": 1.5, "time": 1.5, "tau": 5, "patience": 2, "longest": 3, "k": 4, "near": 3,
         "reach": 2}
LOOSE = {"tolerance": 1e-2}
LONG = {"sec34_boomeron_map map",  # a point of a map is a run
        "sec33_floquet exchange", "sec33_mobility threshold",     # Newton and multipliers, or a run, many times
        "sec5_enclosures dps", "sec5_enclosures breather"}
FREE = {"output", "out", "folder"}


def declared(folder):
    """What `--describe` declares, by programs and commands ('' is the full run): the rows of the options."""
    known = {}
    for row in inventory.commands(ROOT, folder):
        options = known.setdefault(row["program"], {}).setdefault(row["command"], {})
        if row["option"] not in ("", "help", "version", "describe"):
            options[row["option"]] = row
    return known


def good_value(chance, row):
    """A value that is declared as allowed, and cheap."""
    name, takes, least, most = (row[what] for what in ("option", "takes", "lowest", "highest"))
    if takes == "text":
        return f"{chance.randint(1, 3)}/100000" if name == "part" else "x"
    if takes == "name":
        return chance.choice(row["words"].split(", "))
    if name in SIZES:
        most = min(most, max(least, 1) * SIZES[name])
    least = max(least, LOOSE.get(name, least))
    if chance.random() < 0.15:
        x = chance.choice([least, most])
    elif least > 0 and most / least > 50:
        x = least * (most / least) ** chance.random()
    else:
        x = least + (most - least) * chance.random()
    return repr(math.floor(x) if takes == "whole number" else min(max(x, least), most))


class Line:
    """One command line, and what is expected of the answer."""

    def __init__(self, number, seed, known):
        chance = random.Random(f"{seed} {number}")
        pairs = sorted((program, name) for program in known for name in known[program])
        self.program, name = chance.choice([(program, name) for program, name in pairs if name or chance.random() < 0.1])
        options = known[self.program][name]
        self.words, self.output = [name] if name else [], None
        share = chance.choice([0, 0, 0, 0.3, 1])  # of bad values in this line
        asked = {option for option in options if chance.random() < 0.4} | {o for o in options if o in SIZES or o in LOOSE}
        for option in sorted(sorted(asked - FREE), key=lambda _: chance.random()):  # sets have another order in every run
            self.add(chance, option, options[option], chance.random() < share)
        if chance.random() < 0.1:
            self.words += chance.choice([["--bogus"], ["--bogus=1"], ["-q"], ["word"], ["--s"], ["--", "x"], ["=", "--="]])
        if not name:  # only a line that cannot be good: a full run takes what it takes
            self.words += chance.choice([["--bogus"], ["--threads", "0"], ["--quick=1"], ["--threads", "nan"], ["run!"]])
        elif chance.random() < 0.3:
            self.output = "asked for.ecsv"
            self.words += ["--output", self.output]

    def add(self, chance, option, row, bad):
        flag = row["takes"] == "flag"
        value = chance.choice(BAD) if bad else "" if flag else good_value(chance, row)
        if flag and not bad:
            self.words += ["--" + option]
        else:
            self.words += [f"--{option}={value}"] if chance.random() < 0.2 else ["--" + option, value][:1 + (chance.random() < 0.95)]


def in_table(table):
    """Where a printed table holds what nobody announced, or does not say what a quantity is."""
    columns, quantities = {column.name: column for column in table.columns}, any(c.name == "meaning" for c in table.columns)
    for row in table.rows:
        if quantities:  # help says: a quantity that does not exist is nan; the column reason says why
            value, error = row["value"], row["error"]
            if not row["meaning"] or math.isnan(value) != bool(row["reason"]) or math.isnan(value) != math.isnan(error):
                yield f"{row['quantity']} is {value} +- {error} with the meaning '{row['meaning']}' and the reason '{row['reason']}'"
        for name, cell in row.items():
            if isinstance(cell, float) and (math.isinf(cell) or math.isnan(cell) and not quantities
                                            and "nan" not in columns[name].description):
                yield f"{name} is {cell} in {dict(row)}"


def complaints(line, code, out, errors, left):
    if code not in (0, 1, 2):
        yield "is computing for too long" if code in (-24, "hangs") else f"ends with {code}"
    elif code:
        if errors.count("\n") != 1 or not errors.startswith(line.program + ": ") or out or left:
            yield f"is refused in {errors.count(chr(10))} lines and leaves {left or out and 'a table' or 'nothing'}"
        if "without a reason" in errors or "has no meaning" in errors:
            yield "forgets what its own table must say"
    else:
        if errors or left != ([line.output] if line.output else []):
            yield f"succeeds, complains of '{errors}' and leaves {left}"
        yield from in_table(ecsv.parse(out)) if out else ()


def tried(line, folder):
    """What is wrong with the answer, and its exit code."""
    def limited():
        resource.setrlimit(resource.RLIMIT_CPU, (math.ceil(SECONDS), math.ceil(SECONDS) + 5))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    with tempfile.TemporaryDirectory() as scratch:
        words = [os.fsencode(word) for word in (os.path.join(folder, line.program), *line.words)]
        try:
            done = subprocess.run(words, cwd=scratch, capture_output=True, preexec_fn=limited, stdin=subprocess.DEVNULL,
                                  timeout=60 * SECONDS, check=False)
            code, out, errors = done.returncode, done.stdout.decode("utf8", "replace"), done.stderr.decode("utf8", "replace")
        except subprocess.TimeoutExpired:
            code, out, errors = "hangs", "", ""
        left = sorted(str(path.relative_to(scratch)) for path in Path(scratch).rglob("*"))
        if code == 0 and line.output in left:
            out = Path(scratch, line.output).read_text(encoding="utf8")
        try:
            wrong = list(complaints(line, code, out, errors, left))
        except ecsv.Fault as fault:
            wrong = [f"prints what cannot be read: {fault}"]
        return code, [f"{what}\n    {errors[-2000:]}" if errors else what for what in wrong]


def main():
    folder = os.path.abspath(sys.argv[1])
    count, seed = [int(word) for word in sys.argv[2:4]] + [100, 1][len(sys.argv[2:4]):]
    known = declared(folder)
    for name in LONG:  # only refused: a single point of these is more than a moment
        program, command = name.split()
        known.get(program, {}).pop(command, None)
    assert len(known) > 10, "no programs"
    codes, bad = {}, 0
    print(f"seed {seed}", flush=True)
    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        lines = [Line(number, seed, known) for number in range(count)]
        for line, (code, wrong) in zip(lines, pool.map(lambda line: tried(line, folder), lines)):
            codes[code] = codes.get(code, 0) + 1
            bad += bool(wrong)
            for what in wrong:
                print(f"{line.program} {line.words}: {what}", flush=True)
    print(f"{count} random command lines, seed {seed}: exit codes {dict(sorted(codes.items(), key=str))}, {bad} answers wrong")
    sys.exit(bad > 0 or codes.get(2, 0) < count / 8 or codes.get(0, 0) < count / 8)


if __name__ == "__main__":
    main()
