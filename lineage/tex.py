"""Numbers in the paper. It says `\\num{pn.omega11}` and `\\err{pn.omega11}` for a locked value and its error,
`\\pub{pn.omega11}` for what the article prints and `\\claimed{pn.omega11}` for what that is, `\\fig{07}` for a figure
with the first sentence of its caption, `\\finding{pull}` for the sentence of a finding, `\\tally{figures}` for what can
be counted and `\\meta{version}` for what codemeta.json says. This file writes the definitions of all these and the
table of claims. It names every reference that has nothing behind it, every figure that the paper forgets, and every
claim that does not survive and is not among those for which the paper has a cause.

A file of the paper that begins with `% chapter: <program>` is read only where that chapter exists."""

import re
from pathlib import Path

from . import ecsv, metadata
from .claims import VERDICTS, Judge, name_of, programs_of, read_claims
from .findings import NUMBERS, read_findings
from .lock import read_lock, uncommented
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


def sentence(row, nums):
    """The sentence of a finding, with its kind of evidence, in TeX."""
    pieces = row["sentence"].split("$")
    for i in range(0, len(pieces), 2):
        words = re.split(r"\[[^\]]*\]\(num:([^)]+)\)", pieces[i])
        words[::2] = [re.sub(r"`([^`]*)`", r"\\texttt{\1}", escaped(w).replace("–", "--")) for w in words[::2]]
        words[1::2] = [nums[name] for name in words[1::2]]
        pieces[i] = "".join(words)
    return "$".join(pieces) + rf" [\emph{{{row['kind']}}}]"


def paper_texts(claims, lock, figures, meta, findings):
    """What the paper may refer to, in TeX by (kind of reference, id); of a figure the name of its file."""
    counts = {"figures": len(figures), "claims": len(claims)}
    counts.update({v: sum(c["status"] == v for c in claims.values()) for v in VERDICTS if v != "unresolved"})
    out = {("pub", id): worded(c["printed"]) for id, c in claims.items()}
    out.update({("claimed", id): worded(c["quantity"]) for id, c in claims.items()})
    for f in lock.values():
        out["num", name_of(f, claims)] = value(f.shown)
        out["err", name_of(f, claims)] = value(f.shown_error)
    nums = {name: text for (kind, name), text in out.items() if kind == "num"}
    for id, row in findings.items():
        if lost := [name for name in NUMBERS.findall(row["sentence"]) if name not in nums]:
            raise row.fault(f"{id}: nothing is locked under '{lost[0]}' (a new one: make lock)")
        out["finding", id] = sentence(row, nums)
    out.update({("fig", id): Path(f["script"]).stem for id, f in figures.items()})
    out.update({("tally", what): str(n) for what, n in counts.items()})
    code, text = metadata.licences(meta)
    said = {"version": meta["version"], "keywords": ", ".join(meta["keywords"]), "code": code, "text": text}
    said["edition"] = ", ".join(["Version " + meta["version"], *([day] if (day := meta.get("datePublished")) else [])])
    out.update({("meta", what): escaped(words).replace("–", "--") for what, words in said.items()})
    return out


def dangling(paper, texts):
    """References that would stay empty, each once. A comment refers to nothing, and `#1` is a parameter."""
    found = re.finditer(r"\\(num|err|pub|claimed|fig|tally|meta|finding)\{([^}#]*)\}", uncommented(paper))
    return sorted({m[0] for m in found if (m[1], m[2]) not in texts})


PLACED = re.compile(r"\\(?:wide|twins|pair|own|ownpair)(?:\[[^]]*\])?((?:\{x?\d\d\})+)")
CITED = re.compile(r"\bFigs?\.[~\s](x?\d\d(?:(?:--|,\s|\sand\s|,\sand\s)x?\d\d)*)")
CAUSED = re.compile(r"\\gone\{([^}#]*)\}")


def omissions(paper, claims, figures):
    """What the paper, all its files together, leaves out: figures that it does not show or that it shows twice,
    figures that it cites without having them, discrepant claims without a cause, and causes of what is not
    discrepant."""
    paper = uncommented(paper)
    shown = [id for found in PLACED.findall(paper) for id in re.findall(r"x?\d\d", found)]
    cited = {id for found in CITED.findall(paper) for id in re.findall(r"x?\d\d", found)}
    caused, lost = CAUSED.findall(paper), [id for id, c in claims.items() if c["status"] == "discrepant"]
    return ([f"figure {id} of figures/figures.ecsv is not shown" for id in figures if id not in shown]
            + [f"figure {id} is shown {shown.count(id)} times" for id in figures if shown.count(id) > 1]
            + [f"figure {id} is cited and not in figures/figures.ecsv" for id in sorted(cited - set(figures))]
            + [f"the discrepant claim '{id}' has no row \\gone" for id in lost if id not in caused]
            + [f"'{id}' has a row \\gone and is not discrepant" for id in caused if id not in lost])


SEE = re.compile(r"\\see\{(x?\d\d)\}\{((?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*)\}")


def captions(root):
    """What paper/captions.tex says of each figure after the first sentence, in TeX. Fault for what is no entry."""
    path = Path(root) / "paper/captions.tex"
    if not path.exists():
        return {}
    text, out = uncommented(ecsv.text_of(path)), {}
    for id, said in SEE.findall(text):
        if id in out:
            raise ecsv.Fault(f"{path}: figure {id} has two captions")
        out[id] = " ".join(said.split())
    if left := SEE.sub("", text).strip():
        raise ecsv.Fault(f"{path}: this is no \\see{{number}}{{text}}: {left.splitlines()[0][:60]}")
    return out


def chapter_needed(paper):
    """The program without which this file of the paper is left out; empty if it is always read."""
    return paper.split("\n")[0].removeprefix("% chapter: ") if paper.startswith("% chapter: ") else ""


def macros(texts, figures, programs):
    """The definitions, one to a line: `\\define{num}{pn.omega11}{...}`."""
    out = [f"\\define{{{kind}}}{{{id}}}{{{texts[kind, id]}}}" for kind, id in sorted(texts)]
    out += [f"\\define{{caption}}{{{id}}}{{{escaped(f['caption'])}}}" for id, f in figures.items()]
    return HEAD + "\n".join(out + [f"\\define{{chapter}}{{{program}}}{{}}" for program in programs]) + "\n"


def claim_rows(claims, lock):
    """A row for each claim but the discrepant ones, which the paper has in a table of their own: what is claimed and
    printed, what we found with its error, and the verdict. Only a claim that is open has no number."""
    out, judge = HEAD, Judge(claims, lock.values())
    for id, c in claims.items():
        f = lock.get((c["program"], id))
        if not f and c["status"] != "open":
            raise ecsv.Fault(f"nothing is locked for the claim '{id}' (make lock)")
        said = judge.verdict(id)
        if c["status"] == "discrepant":
            continue
        here = value(f.shown) + (f" {unit(f.unit)}" if f.shown_unit else "") if f and f.shown != said else ""
        cells = [escaped(id), worded(c["quantity"]), worded(c["printed"]) + (f" {unit(c['unit'])}" if c["unit"] else ""),
                 here, value(f.shown_error) if f else "", said]
        out += r"\claim" + "".join(f"{{{cell}}}" for cell in cells) + "\n"
    return out


def write(root, out):
    """The verb. A reference to nothing is found here, in the paper's own words, before TeX is called."""
    claims, lock, figures, programs = read_claims(root), read_lock(root), read_figures(root), programs_of(root)
    texts, missing, papers = paper_texts(claims, lock, figures, metadata.read(root), read_findings(root)), [], []
    for path in sorted((Path(root) / "paper").glob("*.tex")):
        paper = ecsv.text_of(path)
        if chapter_needed(paper) in ("", *programs):
            missing += [f"{path}: nothing is there for {reference}" for reference in dangling(paper, texts)]
            papers.append(paper)
    if missing:
        raise ecsv.Fault("; ".join(missing) + " (a new number: make lock)")
    captions(root)
    if left := omissions("\n".join(papers), claims, figures):
        raise ecsv.Fault(f"{Path(root) / 'paper'}: " + "; ".join(left))
    ecsv.write_whole(Path(out) / "numbers.tex", macros(texts, figures, programs))
    ecsv.write_whole(Path(out) / "claims.tex", claim_rows(claims, lock))
