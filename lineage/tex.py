"""Numbers in the paper. It says `\\num{pn.omega11}` and `\\err{pn.omega11}` for a locked value and its error,
`\\pub{pn.omega11}` for what the article prints, `\\fig{07}` for a figure with the first sentence of its caption,
`\\tally{figures}` for what can be counted and `\\meta{version}` for what codemeta.json says. This file writes the
definitions of all these and the table of claims, and names every reference that has nothing behind it.

A file of the paper that begins with `% chapter: <program>` is read only where that chapter exists."""

import re
from pathlib import Path

from . import ecsv, metadata
from .claims import VERDICTS, programs_of, read_claims, verdict
from .lock import name_of, read_lock, uncommented
from .refresh import read_figures

HEAD = "% Written by `python3 -m lineage macros`; do not edit.\n"
GREEK = {"pi", "eps", "omega", "tau", "mu", "phi", "lambda", "beta", "Phi", "Gamma", "delta"}
WORDED = re.compile(
    r"(?P<base>-?[A-Za-z]+)_(?P<below>\([^)]*\)|[A-Za-z0-9]+)"
    r"|\^(?P<above>\([^)]*\)|-[0-9/]+|[A-Za-z0-9]+)"
    r"|(?P<number>-?\d+(?:\.\d+)?e-?\d+|-\d+(?:\.\d+)?)"
    r"|\b(?P<greek>pi|eps|omega|tau|mu|lambda|beta|Phi|Gamma|delta)\b"
    r"|\bsqrt\((?P<root>[^()]*)\)"
    r"|(?P<relation>>=|<=|\+-|->)|(?P<minus>(?:= | )-)(?= |i\b)")


def value(shown):
    """`1.62e-11` and `-3` as TeX sets them, `0.000162` as the former; words such as `holds` stay."""
    found = re.fullmatch(r"(-?)([0-9.]+)(?:e(-?[0-9]+))?", shown)
    if not found:
        return shown
    sign, mantissa, exponent = found.groups()
    small = re.fullmatch(r"0\.(000+)([1-9])([0-9]*)", mantissa)
    if not exponent and small:
        exponent = str(-1 - len(small[1]))
        mantissa = small[2] + ("." if small[3] else "") + small[3]
    return rf"\ensuremath{{{sign}{mantissa}" + (rf"\times10^{{{exponent}}}" if exponent else "") + "}"


def name(word):
    """A name such as `omega` or `-E` in mathematics."""
    if word[0] == "-":
        return "-" + name(word[1:])
    if word in GREEK:
        return r"\epsilon" if word == "eps" else "\\" + word
    return word if len(word) == 1 else rf"\mathrm{{{word}}}"


def escaped(text):
    return re.sub(r"[\^~]", r"\\\g<0>{}", re.sub(r"[%&#_$]", r"\\\g<0>", text))


def unit(text):
    return r"$\mu$m" if text == "um" else escaped(text)


def worded(plain):
    """The list of claims is written for every reader, `E_PN for omega_b = 1.1`: subscripts, powers, Greek names,
    numbers with a sign or an exponent and inequalities become mathematics, the rest stays text."""
    def piece(m):
        if m["base"]:
            below = m["below"].strip("()")
            return f"${name(m['base'])}_{{{name(below) if len(below) > 1 and below.isalpha() else below}}}$"
        if m["above"]:
            return f"$^{{{m['above'].strip('()')}}}$"
        if m["number"]:
            return value(m["number"])
        if m["greek"]:
            return f"${name(m['greek'])}$"
        if m["root"]:
            return rf"$\sqrt{{{name(m['root']) if m['root'].isalpha() else m['root']}}}$"
        return m["minus"][:-1] + "$-$" if m["minus"] else {">=": r"$\ge$", "<=": r"$\le$", "+-": r"$\pm$", "->": r"$\to$"}[m[0]]

    out, done = "", 0
    for m in WORDED.finditer(plain):
        out += escaped(plain[done:m.start()]) + piece(m)
        done = m.end()
    return out + escaped(plain[done:])


def paper_texts(claims, lock, figures, meta):
    """What the paper may refer to, in TeX by (kind of reference, id); of a figure the name of its file."""
    counts = {"figures": len(figures), "claims": len(claims)}
    counts.update({v: sum(c["status"] == v for c in claims.values()) for v in VERDICTS if v != "unresolved"})
    out = {("pub", id): worded(c["printed"]) for id, c in claims.items()}
    for f in lock.values():
        out["num", name_of(f, claims)] = value(f.shown)
        out["err", name_of(f, claims)] = value(f.shown_error)
    out.update({("fig", id): Path(f["script"]).stem for id, f in figures.items()})
    out.update({("tally", what): str(n) for what, n in counts.items()})
    code, text = metadata.licences(meta)
    said = {"version": meta["version"], "keywords": ", ".join(meta["keywords"]), "code": code, "text": text}
    out.update({("meta", what): escaped(words).replace("–", "--") for what, words in said.items()})
    return out


def dangling(paper, texts):
    """References that would stay empty, each once. A comment refers to nothing, and `#1` is a parameter."""
    found = [m for line in paper.splitlines()
             for m in re.finditer(r"\\(num|err|pub|fig|tally|meta)\{([^}#]*)\}", uncommented(line))]
    return sorted({m[0] for m in found if (m[1], m[2]) not in texts})


def chapter_needed(paper):
    """The program without which this file of the paper is left out; empty if it is always read."""
    return paper.split("\n")[0].removeprefix("% chapter: ") if paper.startswith("% chapter: ") else ""


def macros(texts, figures, programs):
    """The definitions, one to a line: `\\define{num}{pn.omega11}{...}`."""
    out = [f"\\define{{{kind}}}{{{id}}}{{{texts[kind, id]}}}" for kind, id in sorted(texts)]
    out += [f"\\define{{caption}}{{{id}}}{{{escaped(f['caption'])}}}" for id, f in figures.items()]
    return HEAD + "\n".join(out + [f"\\define{{chapter}}{{{program}}}{{}}" for program in programs]) + "\n"


def claim_rows(claims, lock):
    """A row for each claim: what is claimed and printed, what we found with its error, and the verdict. Only a
    claim that is open has no number."""
    out = HEAD
    for id, c in claims.items():
        f = lock.get((c["program"], id))
        if not f and c["status"] != "open":
            raise ecsv.Fault(f"nothing is locked for the claim '{id}' (make lock)")
        said = verdict(c, f)
        here = value(f.shown) + (f" {unit(f.unit)}" if f.shown_unit else "") if f and f.shown != said else ""
        cells = [escaped(id), worded(c["quantity"]), worded(c["printed"]) + (f" {unit(c['unit'])}" if c["unit"] else ""),
                 here, value(f.shown_error) if f else "", said]
        out += r"\claim" + "".join(f"{{{cell}}}" for cell in cells) + "\n"
    return out


def write(root, out):
    """The verb. A reference to nothing is found here, in the paper's own words, before TeX is called."""
    claims, lock, figures, programs = read_claims(root), read_lock(root), read_figures(root), programs_of(root)
    texts, missing = paper_texts(claims, lock, figures, metadata.read(root)), []
    for path in sorted((Path(root) / "paper").glob("*.tex")):
        paper = ecsv.text_of(path)
        if chapter_needed(paper) in ("", *programs):
            missing += [f"{path}: nothing is there for {reference}" for reference in dangling(paper, texts)]
    if missing:
        raise ecsv.Fault("; ".join(missing) + " (a new number: make lock)")
    ecsv.write_whole(Path(out) / "numbers.tex", macros(texts, figures, programs))
    ecsv.write_whole(Path(out) / "claims.tex", claim_rows(claims, lock))
