"""Numbers for the two documents in TeX, paper and theorem. They say `\\num{pn.omega11}` for a reference value,
`\\both{pn.omega11}` for the value with its error, as in 1.62(3)e-11, `\\cell{0.065}{sec34_impact/velocity_sweep/s=-0.7/packet}` for a
cell with the digits that are typed (cells.py), `\\pub{pn.omega11}` for the printed value,
`\\claimed{pn.omega11}` for the claim, `\\verdict{pn.omega11}` for its verdict, `\\cause{pn.omega15}` for the likely cause of
a discrepancy, `\\finding{pull}` for the sentence of a finding, `\\tally{claims}` for a count, and `\\meta{version}` and
`\\meta{date}`. This file writes the definitions of all these, and the text of the theorem, which is that of its chapter. It names
every reference to nothing, and every discrepant claim without a row in the paper's table."""

import json
import re
from pathlib import Path

from . import ecsv
from .cells import cited
from .chapters import chapter_of
from .claims import by_name, meanings, read_claims, read_findings, read_verdicts
from .lock import read_lock, uncommented
from .refresh import read_figures
from .sources import blocks_of
from .volumes import joined, volumes

THEOREM = "sec5_kernel_equation"  # the chapter whose prose is that of the theorem, from one heading to before another
FROM, TO = "One equation instead of a lattice", "Waves of both signs"
SHORT = {"within its own accuracy": "within", "reproduced, assuming": "assuming"}  # where a column is narrow
HEAD = "% Written by `python3 -m lineage macros`; do not edit.\n"
GREEK = {"pi", "eps", "epsilon", "omega", "tau", "mu", "gamma", "phi", "lambda", "beta", "Phi", "Gamma", "delta"}
WORDED = re.compile(
    r"(?P<base>-?[A-Za-z]+)_(?P<below>\([^)]*\)|[A-Za-z0-9]+)"
    r"|\^(?P<above>\([^)]*\)|-[0-9/]+|[A-Za-z0-9]+)"
    r"|(?P<number>-?(?:\d+(?:\.\d+)?|\.\d+)e-?\d+|-\d+(?:\.\d+)?)"
    r"|\b(?P<greek>pi|eps|epsilon|omega|tau|mu|gamma|lambda|beta|Phi|Gamma|delta)\b"
    r"|\bsqrt\((?P<root>[^()]*)\)"
    r"|(?P<relation>>=|<=|\+-|->)|(?P<minus>(?:= | )-)(?= |[in]\b)")


def value(shown, uncertain=""):
    """`1.62e-11` and `-3` as TeX sets them, `0.000162` as the former; words such as `holds` stay. What is uncertain
    of the last digit follows the digits."""
    found = re.fullmatch(r"(-?)([0-9.]+)(?:e(-?[0-9]+))?", shown)
    if not found:
        return shown
    sign, mantissa, exponent = found.groups()
    small = re.fullmatch(r"0\.(000+)([1-9])([0-9]*)", mantissa)
    if not exponent and small:
        exponent = str(-1 - len(small[1]))
        mantissa = small[2] + ("." if small[3] else "") + small[3]
    return rf"\ensuremath{{{sign}{mantissa}{uncertain}" + (rf"\times10^{{{exponent}}}" if exponent else "") + "}"


def both(finding):
    """A value with its error in parentheses, in units of the last digit shown: `1.62(3)e-11`. The digits are those of
    values.py; where six of them do not reach the error it is one unit, so that what was rounded off is covered. What
    is exact or no number has no parentheses."""
    shown, error = finding.shown, finding.shown_error
    digits = re.fullmatch(r"-?\d+(?:\.(\d+))?(?:e(-?\d+))?", shown)
    if not digits or finding.value == 0 or error in ("", "exact", "nan", "inf"):
        return value(shown)
    last = int(digits[2] or 0) - len(digits[1] or "")
    return value(shown, f"({max(1, round(float(error) / 10.0**last))})")


def as_shown(text):
    """A number as prose has it, with or without its error."""
    shown, _, error = text.partition(" ± ")
    return value(shown) + rf" $\pm$ {value(error)}" * bool(error)


def name(word):
    """A name such as `omega` or `-E` in mathematics."""
    if word[0] == "-":
        return "-" + name(word[1:])
    if word in GREEK:
        return r"\epsilon" if word == "eps" else "\\" + word
    return word if len(word) == 1 else rf"\mathrm{{{word}}}"


def escaped(text):
    return re.sub(r"[\^~]", r"\\\g<0>{}", re.sub(r"[%&#_$]", r"\\\g<0>", text))


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


def paper_texts(claims, numbers, verdicts, figures, meta, findings):
    """What the paper may refer to, in TeX by (kind of reference, id); of a figure the name of its file."""
    out = {("pub", id): worded(c["printed"]) for id, c in claims.items()}
    out.update({("claimed", id): worded(c["quantity"]) for id, c in claims.items()})
    out.update({("cause", id): worded(c["cause"]) for id, c in claims.items() if c["cause"]})
    out.update({("verdict", id): SHORT.get(word := verdicts[id]["verdict"], word) for id in claims})
    for name, f in numbers.items():
        out["num", name], out["both", name] = value(f.shown), both(f)
    out.update({("both", id): "--" for id in claims if id not in numbers})  # comparisons decide
    for id, row in findings.items():
        if lost := sorted(cited(row["sentence"]) - set(numbers)):
            raise row.fault(f"{id}: there is no reference value '{lost[0]}' (a new one: make accept)")
        out["finding", id] = sentences(row["sentence"]) + rf" [\emph{{{row['kind']}}}]"
    for id, f in figures.items():
        out["fig", id], out["source", id] = Path(f["script"]).stem, rf"\nolinkurl{{{f['chapter']}}}"
        out["caption", id] = sentences(f"{f['caption']} {f['details']}").replace("Fig. ", "Fig.~")
    counts = {word: sum(verdicts[id]["verdict"] == word for id in claims) for word in meanings()}
    out.update({("tally", what): str(n) for what, n in {"claims": len(claims), **counts}.items()})
    return out | {("meta", "version"): meta["version"], ("meta", "date"): meta["datePublished"]}


CELL = re.compile(r"\\cell\{([^}#]*)\}\{([^}#]*)\}")
FIGURES = re.compile(r"\\(?:wide|twins|own)(?:\[[^]]*\])?((?:\{x?\d\d\})+)"
                     r"|\bFigs?\.[~\s](x?\d\d(?:(?:--|,\s|\sand\s|,\sand\s)x?\d\d)*)")
CAUSED = re.compile(r"\\gone\{([^}#]*)\}")


def dangling(paper, texts):
    """References to nothing, each once. A comment refers to nothing, and `#1` is a parameter."""
    paper = uncommented(paper)
    found = re.finditer(r"\\(num|both|pub|claimed|verdict|cause|tally|meta|finding)\{([^}#]*)\}", paper)
    figures = {id for words in FIGURES.findall(paper) for id in re.findall(r"x?\d\d", "".join(words))}
    return (sorted({m[0] for m in found if (m[1], m[2]) not in texts})
            + [f"figure {id}" for id in sorted(figures) if ("fig", id) not in texts])


def omissions(paper, verdicts):
    """Discrepant claims without a row in the paper's table, and rows of claims that are not discrepant."""
    rows, lost = CAUSED.findall(uncommented(paper)), [id for id, row in verdicts.items() if row["verdict"] == "discrepant"]
    return ([f"the discrepant claim '{id}' has no row \\gone" for id in lost if id not in rows]
            + [f"'{id}' has a row \\gone but is not discrepant" for id in rows if id not in lost])


MARKS = re.compile(r"\*\*(?P<bold>[^*]+)\*\*|\*(?P<emph>[^*]+)\*|`(?P<code>[^`]+)`"
                   r"|\[(?P<shown>[^]]*)\]\((?:cell|statement):[^)]+\)|(?P<odd>[*`<|\]])")


def marked(words):
    """Words between formulas: emphasis, code and bound numbers of Markdown in TeX. Fault for any other mark."""
    def piece(m):
        if m["odd"]:
            raise ecsv.Fault(f"a mark that tools/lineage/tex.py does not know: {m.string[m.start():][:40]}")
        if m["shown"]:
            return as_shown(m["shown"])
        kind = "textbf" if m["bold"] else "emph" if m["emph"] else "texttt"
        return rf"\{kind}{{{escaped(m['bold'] or m['emph'] or m['code'])}}}"

    out, done = "", 0
    for m in MARKS.finditer(words):
        out += escaped(words[done:m.start()]) + piece(m)
        done = m.end()
    return out + escaped(words[done:])


def sentences(text):
    """Running Markdown in TeX; what is between dollars stays, and a displayed formula gets brackets. An emphasized
    sentence may hold formulas, so that these are set aside first."""
    formulas = re.findall(r"\$\$.*?\$\$|\$[^$]*\$", text, re.S)
    words = marked(re.sub(r"\$\$.*?\$\$|\$[^$]*\$", "\0", text, flags=re.S))
    for formula in formulas:
        words = words.replace("\0", "\\[" + formula[2:-2] + "\\]" if formula.startswith("$$") else formula, 1)
    return words.replace("–", "--").replace("’", "'")


def in_tex(prose):
    """A block of a chapter's prose in TeX: paragraphs and lists, one level deep."""
    out = []
    for block in re.split(r"\n\s*\n", prose.strip()):
        items = re.split(r"^(?:\d+\.|-) +", block, flags=re.M)
        if len(items) > 1 and not items[0]:
            kind = "itemize" if block.startswith("-") else "enumerate"
            out.append("\n".join([rf"\begin{{{kind}}}", *(r"\item " + sentences(i.rstrip()) for i in items[1:]),
                                  rf"\end{{{kind}}}"]))
        else:
            out.append(sentences(block))
    return "\n\n".join(out) + "\n"


def theorem(root):
    """The theorem and its proof in TeX, a section a heading; empty without the chapter."""
    path = Path(root) / chapter_of(root, THEOREM)
    if not path.exists():
        return ""
    prose = "\n\n".join(text for is_prose, _, text in blocks_of(ecsv.text_of(path), path) if is_prose)
    found = re.findall(rf"^(## {FROM}\n.*?)^## {TO}\n", prose, re.M | re.S)
    if len(found) != 1:
        raise ecsv.Fault(f"{path}: no prose from '## {FROM}' to '## {TO}'")
    title, *parts = re.split(r"^## (.+)$", found[0], flags=re.M)[1:]
    sections = [(title, parts[0]), *zip(parts[1::2], parts[2::2])]
    return HEAD + "\n".join(rf"\section{{{sentences(title)}}}" + "\n" + in_tex(text) for title, text in sections)


def write(root, out):
    """The verb. A reference to nothing is found here, in the words of the documents, before TeX is called."""
    all, claims = volumes(root), read_claims(root)
    lock, figures, findings, verdicts = (joined(read, all) for read in (read_lock, read_figures, read_findings, read_verdicts))
    figures = {id: row | {"chapter": chapter_of(root, row["program"])} for id, row in figures.items()}
    meta = json.loads(ecsv.text_of(all[0] / "codemeta.json"))
    numbers = by_name(lock)
    texts = paper_texts(claims, numbers, verdicts, figures, meta, findings)
    documents = {path: ecsv.text_of(path) for folder in all for path in sorted((folder / "paper").glob("*.tex"))}
    for typed, address in {cell for text in documents.values() for cell in CELL.findall(uncommented(text))}:
        if address not in numbers:
            raise ecsv.Fault(f"paper: \\cell{{{typed}}}{{{address}}} refers to nothing (a new number: make accept)")
        texts["cell", f"{typed}@{address}"] = as_shown(numbers[address].shown_like(typed))
    wrong = [f"{path}: {reference} refers to nothing" for path, text in documents.items() for reference in dangling(text, texts)]
    if wrong:
        raise ecsv.Fault("; ".join(wrong) + " (a new number: make accept)")
    if wrong := omissions("\n".join(documents.values()), {id: verdicts[id] for id in claims}):
        raise ecsv.Fault(f"{all[0] / 'paper'}: " + "; ".join(wrong))
    lines = [f"\\define{{{kind}}}{{{id}}}{{{texts[kind, id]}}}\n" for kind, id in sorted(texts)]
    ecsv.write_whole(Path(out) / "numbers.tex", HEAD + "".join(lines))
    ecsv.write_whole(Path(out) / "theorem_text.tex", theorem(root))
