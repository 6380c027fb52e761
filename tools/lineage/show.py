"""One number, statement or finding by its name: `make show ID=pn.omega11`."""

import difflib
import math
import re

from . import ecsv
from .cells import read_cells
from .chapters import chapter_of, command_of, explained_by, read_commands, read_costs, run_of, shown_cost
from .claims import (agrees, by_name, code_of, in_plain, programs_of, read_answers, read_claims, read_comparisons, read_findings,
                     read_readings, read_second, read_statements, read_verdicts, runs_of, said)
from .lock import read_lock
from .refresh import read_figures
from .volumes import joined, volumes


def figures_of(claim, figures):
    """The figures that the claim's place in the article names by their labels."""
    words = set(re.findall(r"\w+", claim["where"]))
    return [id for id, f in figures.items() if f["label"] and f["label"] in words]


MOST = 12  # comparisons that are shown
ROLES = {"answer": "answers", "claim": "compares", "control": "controls"}


def with_error(value, error):
    return f"{value:.6g}" + (f" +- {error:.1g}" if error > 4e-16 * abs(value) else "")


def compared(rows):
    """The rows that decide: all of a few, of many those that fail and the closest ones."""
    def left(row):
        return (row["large"] - row["small"]) / (max(abs(row["large"]), abs(row["small"])) or 1)

    for row in sorted(rows, key=lambda row: 0 if row["role"] == "answer" else left(row))[:MOST]:
        sides = with_error(row["small"], row["small_error"])
        if row["role"] != "answer":
            sides += f" < {with_error(row['large'], row['large_error'])}  {row['outcome']}"
        yield ROLES[row["role"]], f"{row['cells']}: {sides}"
    if len(rows) > MOST:
        yield "", f"and {len(rows) - MOST} more (in all {sum(r['outcome'] == 'holds' for r in rows)} hold): build/report"


def judged(id, root, verdict):
    """How a statement was judged: its code, the rows that decide, and what other choices give."""
    all = volumes(root)
    _, path, line = joined(read_statements, all)[id]
    rows = joined(read_comparisons, all).get(id, [])
    for text in [] if rows else verdict["found"].split("; "):
        yield "found", text
    yield "judged", f"{path}:{line}" + (f" ({verdict['state']})" if verdict["state"] != "judged" else "")
    for text in code_of(path, line):
        yield "", text
    yield from compared(rows)
    for row in joined(read_readings, all).get(id, []):
        number = "" if math.isnan(row["value"]) else f"{with_error(row['value'], row['error'])} {row['unit']}"
        yield "reading", f"{row['reading']}: {', '.join(filter(None, [number, row['outcome']]))} ({row['choice']})"


def of_number(name, finding, claims, numbers, verdict, root):
    """What there is to say of a number or a statement: pairs of a word and a text."""
    all, claim = volumes(root), claims.get(name)
    figures, alone = joined(read_figures, all), joined(read_commands, all).get(name)
    if claim:
        yield "claim", f"{claim['quantity']} ({claim['where']})"
        yield "printed", (claim["printed"] or "a statement") + (f" {claim['unit']}" if claim["unit"] else "")
    if finding:
        yield "converged", finding.shown + finding.shown_unit
        yield "error", finding.shown_error
    if claim:
        yield "verdict", verdict["verdict"]
        yield from judged(name, root, verdict)
        for word, key in (("remark", "assumption"), ("why", "reason")):
            if claim[key]:
                yield word, said(claim[key], numbers)
    program = finding.program if finding else claim["program"]
    shown = (figures_of(claim, figures) if claim else []) or [i for i, f in figures.items() if f["program"] == program]
    yield "figure", ", ".join(f"{id} ({command_of(id)})" for id in shown) or "none"
    yield "command", f"{alone[0]} (prints it as {alone[1]})" if alone else run_of(program)
    costs = joined(read_costs, all)
    for one in explained_by(name, claims) if claim else [program]:
        yield "chapter", f"{chapter_of(root, one)} ({run_of(one)}, {shown_cost(costs.get(one, math.nan))} s on two cores)"
    if finding and agrees(name, finding, second := joined(read_second, all)):
        there, method = second[name]
        yield "second", f"{there.shown}{there.shown_unit} (error {there.shown_error}): {method}"


def of_finding(row, numbers, verdict, root):
    """The same of a finding of ours."""
    yield "we found", in_plain(row["sentence"], numbers)
    yield "evidence", row["kind"]
    for word in ("range", "tried", "second"):
        yield word, in_plain(row[word], numbers)
    yield from judged(row["id"], root, verdict)


def show(root, data, name):
    """The verb: a line for each; the fresh value where the program has run, the reference value elsewhere."""
    all, claims = volumes(root), read_claims(root)
    programs = [program for volume in all for program in programs_of(volume)]
    ecsv.check_all_written(data)
    locked = joined(read_lock, all)
    fresh = read_cells(data, programs, {name} | {f.name for f in locked.values()}) | joined(read_answers, all)
    numbers = by_name(locked | fresh)
    findings = joined(read_findings, all)
    names = sorted(numbers.keys() | claims.keys() | findings.keys())
    if name not in names:
        near = difflib.get_close_matches(name, names, 3) or sorted(n for n in names if re.split("[./]", n)[-1] == name)
        raise ecsv.Unknown(f"ID: there is no number '{name}'" + (f" (near it: {', '.join(near)})" if near else
                          " (allowed: a claim such as pn.omega11, a cell such as sec34_impact/velocity_sweep/velocity=0.94/s=-0.7/packet)"))
    finding, verdict = numbers.get(name), joined(read_verdicts, all).get(name)
    print(name)
    told = of_finding(findings[name], numbers, verdict, root) if name in findings else of_number(name, finding, claims, numbers, verdict, root)
    for word, text in told:
        print(f"  {word:9}  {text}".rstrip())
    if finding:
        print(f"  {'from':9}  {'build/data, computed here' if finding.key in fresh else 'paper/converged.ecsv (not computed here yet)'}")
