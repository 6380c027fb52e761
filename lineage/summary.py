"""Published against reproduced: the table, the end of `make figures`, and one number by its name."""

import difflib
import math
import re
from pathlib import Path

from . import ecsv
from .chapters import chapter_of, explained_by, read_commands, read_costs, run_of, shown_cost
from .claims import Judge, name_of, programs_of, read_claims, runs_of
from .findings import agrees, holds, in_plain, margins, names_in, read_findings, read_second, tally as kinds_of
from .literature import read_literature, tally as literature_tally, verdicts
from .lock import read_fresh, read_lock
from .refresh import command_of, read_figures, tally
from .volumes import article, below, joined, volumes

COLUMNS = [ecsv.Column(name, kind, text) for name, kind, text in [
    ("id", "string", "identifier"),
    ("where", "string", "place in the article"),
    ("quantity", "string", "what is claimed"),
    ("published", "string", "value or statement as printed"),
    ("reproduced", "float64", "converged value; 1 or 0 where the unit is claim"),
    ("error", "float64", "error of the reproduced value"),
    ("unit", "string", "unit of the reproduced value; claim for yes or no"),
    ("verdict", "string", "reproduced, holds, within, measured, follows, discrepant, unresolved or open"),
    ("program", "string", "program that answers"),
    ("reading", "string", "which natural reading of what is not printed was taken, and what others give"),
    ("reason", "string", "likely cause of a discrepancy"),
    ("see", "string", "the chapters that answer and explain it, as commands with their seconds on two cores, and the "
                      "command for the number alone")]]


def see(id, claims, costs, alone):
    """How to compute the answer and its explanation again."""
    runs = [f"{run_of(program)} ({shown_cost(costs.get(program, math.nan))} s)" for program in explained_by(id, claims)]
    return "; ".join(runs + ([f"alone: {alone[id][0]}"] if id in alone else []))


def compared(claims, judge, costs, alone):
    """The rows of the table, one for each claim."""
    for id, c in claims.items():
        f = judge.answer(id)
        yield {"id": id, "where": c["where"], "quantity": c["quantity"], "published": c["printed"],
               "reproduced": f.value if f else math.nan, "error": f.error if f else math.nan,
               "unit": f.unit if f and f.unit else c["unit"], "verdict": judge.verdict(id), "program": c["program"],
               "reading": judge.said(c["reading"]), "reason": judge.said(c["reason"]), "see": see(id, claims, costs, alone)}


def complaint(row):
    """What the summary says of a claim that does not agree."""
    if row["verdict"] == "discrepant" and row["unit"] == "claim":
        what = "does not hold by our criterion"
    else:
        what = f"converged {row['reproduced']:.6g} +- {row['error']:.1g} {row['unit']}"
    return f"  {row['verdict']:10} {row['id']:26} printed {row['published']}, {what.strip()}"


def known_numbers(folders, data, claims):
    """All numbers of these volumes by name: fresh where the program has run, locked elsewhere; and the programs that have run."""
    programs = [program for folder in folders for program in programs_of(folder)]
    ran = {program for program, _ in runs_of(data, programs)}
    locked = [f for f in joined(read_lock, folders).values() if f.program not in ran]
    return {name_of(f, claims): f for f in [*locked, *read_fresh(data, programs, claims).values()]}, ran


def summarize(root, data, out):
    """The verb: writes published.ecsv, counts the verdicts and names what does not agree. Judged is who has run."""
    claims, findings = read_claims(root), read_findings(root)
    known, ran = known_numbers(below(root), data, claims)
    asked = claims if Path(root) == article(root) else {}
    judged = {id: c for id, c in asked.items() if c["program"] in ran or not c["program"]}
    if asked:
        rows = list(compared(judged, Judge(claims, known.values()), read_costs(root), read_commands(root)))
        ecsv.write_whole(Path(out) / "published.ecsv", ecsv.to_text(ecsv.Table(COLUMNS, rows, {"program": "lineage summary"})))
        print(f"claims     : {tally([row['verdict'] for row in rows])}")
        for row in rows:
            if row["verdict"] in ("within", "follows", "discrepant", "unresolved"):
                print(complaint(row))
    beside = list(verdicts(read_literature(root), known))
    if beside:
        print(f"literature : {literature_tally(said for _, _, said in beside)}")
    for row, f, said in beside:
        if said not in ("", "reproduced", "holds"):
            print(f"  {said:10} {row['id']:26} printed {row['printed']}, converged {f.value:.6g} +- {f.error:.1g} {f.unit}")
    held = {id: row for id, row in findings.items() if asked_of(row, claims) <= ran}
    if held:
        print(f"findings   : {kinds_of(held)}")
    for id, row in held.items():
        if not holds(row, known):
            print(f"  fails      {id:26} {'; '.join(condition_texts(row, known))}")
    if len(judged) < len(asked) or len(held) < len(findings):
        print(f"not judged : {len(asked) - len(judged)} claims and {len(findings) - len(held)} findings, whose programs "
              "have not run (make figures)")


def asked_of(row, claims):
    """The programs whose numbers decide a finding."""
    return {claims[name]["program"] if name in claims else name.partition(".")[0] for name in names_in(row)}


def condition_texts(row, found):
    """The conditions of a finding with their values and what is left to the limits."""
    for m in margins(row, found):
        yield f"{m.name} = {m.value.shown} {m.side} {m.limit}, margin {m.left:.3g} (error {m.error:.1g})"


# One number


def figures_of(claim, figures):
    """The figures that the claim's place in the article names by their labels."""
    words = set(re.findall(r"\w+", claim["where"]))
    return [id for id, f in figures.items() if f["label"] and f["label"] in words]


def facts_of(name, finding, judge, root):
    """What there is to say of a number: pairs of a word and a text."""
    all, claim = volumes(root), judge.claims.get(name)
    figures, alone = joined(read_figures, all), joined(read_commands, all).get(name)
    if claim:
        printed = claim["printed"] or "a statement"
        yield "claim", f"{claim['quantity']} ({claim['where']})"
        yield "printed", printed + (f" {claim['unit']}" if claim["unit"] else "")
    if finding:
        yield "converged", finding.shown + finding.shown_unit
        if finding.unit != "claim":
            yield "error", finding.shown_error
    if claim:
        yield "verdict", judge.verdict(name)
        for word, key in (("read", "reading"), ("why", "reason")):
            if claim[key]:
                yield word, judge.said(claim[key])
    program = finding.program if finding else claim["program"]
    shown = (figures_of(claim, figures) if claim else []) or [i for i, f in figures.items() if f["program"] == program]
    yield "figure", ", ".join(f"{id} ({command_of(id)})" for id in shown) or "none"
    yield "command", f"{alone[0]} (prints it as {alone[1]})" if alone else run_of(program) if program else "none"
    costs = joined(read_costs, all)
    for one in explained_by(name, judge.claims) if claim else [program]:
        yield "chapter", f"{chapter_of(root, one)} ({run_of(one)}, {shown_cost(costs.get(one, math.nan))} s on two cores)"
    if agrees(name, finding, second := joined(read_second, all)):
        there, method = second[name]
        yield "second", f"{there.shown}{there.shown_unit} (error {there.shown_error}): {method}"


def facts_of_finding(row, found):
    """The same of a finding of ours."""
    numbers = {name: f.shown for name, f in found.items()}
    yield "we found", in_plain(row["sentence"], numbers)
    yield "evidence", row["kind"]
    for word, column in (("range", "range"), ("tried", "tried"), ("second", "second")):
        yield word, in_plain(row[column], numbers)
    for text in condition_texts(row, found):
        yield "condition", text


def show(root, data, name):
    """The verb: a line for each; the fresh value where the program has run, the locked one elsewhere."""
    claims = read_claims(root)
    known, _ = known_numbers(volumes(root), data, claims)
    judge, findings = Judge(claims, known.values()), joined(read_findings, volumes(root))
    names = sorted(known.keys() | claims.keys() | findings.keys())
    if name not in names:
        near = difflib.get_close_matches(name, names, 3) or sorted(n for n in names if n.split(".")[-1] == name)
        raise ecsv.Unknown(f"ID: there is no number '{name}'" + (f" (near it: {', '.join(near)})" if near else
                          " (allowed: a claim such as pn.omega11, a fact such as sec31_dps_limit.tau_0_by_quadrature)"))
    finding = known.get(name)
    print(name)
    said = facts_of_finding(findings[name], known) if name in findings else facts_of(name, finding, judge, root)
    for word, text in said:
        print(f"  {word:9}  {text}")
    if finding:
        print(f"  {'from':9}  {'build/data, computed here' if finding.row else 'paper/converged.ecsv (not computed here yet)'}")
