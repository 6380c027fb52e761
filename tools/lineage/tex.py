"""Numbers in the three documents of the report: paper, supplement and theorem. They say `\\num{pn.omega11}` and
`\\err{pn.omega11}` for a locked value and its error, `\\both{pn.omega11}` for the two in one, as in 1.62(3)e-11,
`\\about{pn.omega11}` for the value to three digits, `\\pub{pn.omega11}` for what the article prints,
`\\claimed{pn.omega11}` for what that is and `\\verdict{pn.omega11}` for what became of it, `\\fig{07}` for a figure with
the first sentence of its caption and a link to its chapter, `\\finding{pull}` for the sentence of a finding,
`\\tally{figures}` for what can be counted and `\\meta{version}` for what codemeta.json says. This file writes the
definitions of all these, the table of claims, and the proof, which is told once, in its chapter. It names every
reference that has nothing behind it, every figure that is in none of the documents or in two, and every claim that does
not survive and is not among those for which the paper has a cause.

A file of the report that begins with `% chapter: <program>` is read only where that chapter exists."""

import math
import re
from pathlib import Path

from . import ecsv, metadata
from .chapters import chapter_of
from .claims import NUMBERS, by_name, is_number, meanings, programs_of, read_claims, read_findings, read_verdicts, said
from .lock import read_lock, uncommented
from .refresh import read_figures
from .values import with_digits
from .volumes import joined, volumes

DOCUMENTS = ("paper", "supplement", "theorem")
PROOF = "sec5_kernel_equation"  # the chapter whose prose has the proof: the block that ends with a square
SHORT = {"within its own accuracy": "within", "reproduced, assuming": "assuming"}  # where a column is narrow
HEAD = "% Written by `python3 -m lineage macros`; do not edit.\n"
GREEK = {"pi", "eps", "epsilon", "omega", "tau", "mu", "phi", "lambda", "beta", "Phi", "Gamma", "delta"}
WORDED = re.compile(
    r"(?P<base>-?[A-Za-z]+)_(?P<below>\([^)]*\)|[A-Za-z0-9]+)"
    r"|\^(?P<above>\([^)]*\)|-[0-9/]+|[A-Za-z0-9]+)"
    r"|(?P<number>-?(?:\d+(?:\.\d+)?|\.\d+)e-?\d+|-\d+(?:\.\d+)?)"
    r"|\b(?P<greek>pi|eps|epsilon|omega|tau|mu|lambda|beta|Phi|Gamma|delta)\b"
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
    is exact, made of rounding or no number has no parentheses."""
    shown, error = finding.shown, finding.shown_error
    digits = re.fullmatch(r"-?\d+(?:\.(\d+))?(?:e(-?\d+))?", shown)
    if not digits or finding.value == 0 or error in ("", "exact", "nan", "inf") or finding.kind == "residue":
        return value(shown)
    last = int(digits[2] or 0) - len(digits[1] or "")
    return value(shown, f"({max(1, round(float(error) / 10.0**last))})")


def about(finding):
    """A value to three digits at most, where a reader needs no more of it."""
    return value(finding.shown_in_prose)


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


def paper_texts(claims, numbers, verdicts, figures, meta, findings):
    """What the paper may refer to, in TeX by (kind of reference, id); of a figure the name of its file."""
    counts = {"figures": len(figures), "claims": len(claims)}
    counts.update({word: sum(verdicts[id]["verdict"] == word for id in claims) for word in meanings()})
    out = {("pub", id): worded(c["printed"]) for id, c in claims.items()}
    out.update({("claimed", id): worded(c["quantity"]) for id, c in claims.items()})
    out.update({("verdict", id): SHORT.get(word := verdicts[id]["verdict"], word) for id in claims})
    for name, f in numbers.items():
        out["num", name], out["err", name] = value(f.shown), value(f.shown_error)
        out["both", name], out["about", name] = both(f), about(f)
    out.update({("both", id): "--" for id, c in claims.items() if not c["answer"]})  # conditions decide
    nums = {name: text for (kind, name), text in out.items() if kind == "num"}
    for id, row in findings.items():
        if lost := [name for name in NUMBERS.findall(row["sentence"]) if name not in nums]:
            raise row.fault(f"{id}: there is no reference value '{lost[0]}' (a new one: make lock)")
        out["finding", id] = sentence(row, nums)
    out.update({("fig", id): Path(f["script"]).stem for id, f in figures.items()})
    out.update({("tally", what): str(n) for what, n in counts.items()})
    out.update({("source", id): source(f["chapter"], meta) for id, f in figures.items()})
    out.update({("meta", what): escaped(words).replace("–", "--") for what, words in metadata.said(meta).items()})
    return out


def source(path, meta):
    """A link to a chapter: at the repository's address, or else beside the folder that the document is in."""
    where = f"{meta['codeRepository']}/blob/HEAD" if meta.get("codeRepository") else ".."
    return rf"\href{{{where}/{path}}}{{\nolinkurl{{{path}}}}}"


def dangling(paper, texts):
    """References that would stay empty, each once. A comment refers to nothing, and `#1` is a parameter."""
    found = re.finditer(r"\\(num|err|both|about|pub|claimed|verdict|fig|tally|meta|finding)\{([^}#]*)\}", uncommented(paper))
    return sorted({m[0] for m in found if (m[1], m[2]) not in texts})


PLACED = re.compile(r"\\(?:wide|twins|pair|own)(?:\[[^]]*\])?((?:\{x?\d\d\})+)")
CITED = re.compile(r"\bFigs?\.[~\s](x?\d\d(?:(?:--|,\s|\sand\s|,\sand\s)x?\d\d)*)")
CAUSED = re.compile(r"\\gone\{([^}#]*)\}")


INPUT = re.compile(r"\\input\{([a-z]+)\}")


def files_of(root, programs):
    """The texts of each document, by path: its own and those that it reads, where their chapters exist. What TeX
    reads besides was written here. Fault if a file of the report is read by no document."""
    out, there = {}, {path.stem: path for folder in volumes(root) for path in sorted((folder / "paper").glob("*.tex"))}
    for document in (d for d in DOCUMENTS if d in there):
        texts, ahead = {}, [document]
        while ahead:
            path = there.get(ahead.pop(0))
            if not path or path in texts:
                continue
            text = ecsv.text_of(path)
            if chapter_needed(text) in ("", *programs):
                texts[path] = text
                ahead += INPUT.findall(uncommented(text))
        out[document] = texts
    for path in there.values():
        if chapter_needed(ecsv.text_of(path)) in ("", *programs) and not any(path in texts for texts in out.values()):
            raise ecsv.Fault(f"{path}: it is read by none of {', '.join(d + '.tex' for d in DOCUMENTS)}")
    return out


def omissions(documents, verdicts, figures):
    """What the documents, texts by their names, leave out: figures that none shows or that are shown twice, in one or
    in two of them, figures that are cited without being there, discrepant claims without a cause, and causes of what
    is not discrepant."""
    texts = {name: uncommented(text) for name, text in documents.items()}
    shown = {id: [] for id in figures}
    for name, text in texts.items():
        for id in (id for found in PLACED.findall(text) for id in re.findall(r"x?\d\d", found) if id in shown):
            shown[id].append(name)
    whole = "\n".join(texts.values())
    cited = {id for found in CITED.findall(whole) for id in re.findall(r"x?\d\d", found)}
    caused, lost = CAUSED.findall(whole), [id for id, row in verdicts.items() if row["verdict"] == "discrepant"]
    return ([f"figure {id} of figures/figures.ecsv is not shown" for id in figures if not shown[id]]
            + [f"figure {id} is shown {len(places)} times ({', '.join(places)})" for id, places in shown.items()
               if len(places) > 1]
            + [f"figure {id} is cited but not in figures/figures.ecsv" for id in sorted(cited - set(figures))]
            + [f"the discrepant claim '{id}' has no row \\gone" for id in lost if id not in caused]
            + [f"'{id}' has a row \\gone but is not discrepant" for id in caused if id not in lost])


SEE = re.compile(r"\\see\{(x?\d\d)\}\{((?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*)\}")


def captions(root):
    """What paper/captions.tex of a volume says of each figure after the first sentence, in TeX. Fault for what is no entry."""
    path = Path(root) / "paper/captions.tex"
    if not path.exists():
        return {}
    text, out = uncommented(ecsv.text_of(path)), {}
    for id, said in SEE.findall(text):
        if id in out:
            raise ecsv.Fault(f"{path}: figure {id} has two captions")
        out[id] = " ".join(said.split())
    if left := SEE.sub("", text).strip():
        raise ecsv.Fault(f"{path}: this is not of the form \\see{{number}}{{text}}: {left.splitlines()[0][:60]}")
    return out


def in_markdown(caption):
    """A caption of paper/captions.tex as Markdown: words, formulas, dashes and spaces that do not break."""
    pieces = caption.split("$")
    if (odd := re.search(r"[\\{}&#_^*`<>|\[\]]", "".join(pieces[::2]))) or len(pieces) % 2 == 0:
        raise ecsv.Fault(f"paper/captions.tex: {repr(odd[0]) if odd else 'an open formula'} in '{caption[:60]}...'")
    pieces[::2] = [words.replace("~", "\u00a0").replace("--", "–") for words in pieces[::2]]
    return "$".join(pieces)


def chapter_needed(paper):
    """The program without which this file of the paper is left out; empty if it is always read."""
    return paper.split("\n")[0].removeprefix("% chapter: ") if paper.startswith("% chapter: ") else ""


def macros(texts, figures, programs):
    """The definitions, one to a line: `\\define{num}{pn.omega11}{...}`."""
    out = [f"\\define{{{kind}}}{{{id}}}{{{texts[kind, id]}}}" for kind, id in sorted(texts)]
    out += [f"\\define{{caption}}{{{id}}}{{{escaped(f['caption'])}}}" for id, f in figures.items()]
    return HEAD + "\n".join(out + [f"\\define{{chapter}}{{{program}}}{{}}" for program in programs]) + "\n"


def claim_rows(claims, numbers, verdicts):
    """A row for each claim but the discrepant ones, which the paper has in a table of their own, by the sections of the
    article: what is claimed and printed, what we found with its error in parentheses, and the verdict with what it assumes."""
    out, section = HEAD, None
    for id, c in sorted(claims.items(), key=lambda claim: claim[1]["section"]):
        f, verdict = numbers.get(id), verdicts[id]["verdict"]
        if c["answer"] and not f:
            raise ecsv.Fault(f"there is no reference value for the claim '{id}' (make lock)")
        if verdict == "discrepant":
            continue
        if c["section"] != section:
            section = c["section"]
            out += rf"\claimsof{{{escaped(section)}}}" + "\n"
        printed = worded(c["printed"]) + (f" {unit(c['unit'])}" if c["unit"] and is_number(c["printed"]) else "")
        if verdict == "holds" and not is_number(c["printed"]):
            printed = "--"  # the row is the statement
        # The unit is not said again where it is that of the article
        here = both(f) + (f" {unit(f.unit)}" if f.unit and c["unit"] in ("", f.unit) else "") if f else ""
        words = re.sub(r"\bSection ([a-z]+)", r"Section~\\ref{\1}", worded(said(c["assumption"], numbers)))  # by its label
        noted = rf" \emph{{({words})}}" if words else ""
        cells = [escaped(id), worded(c["quantity"]) + noted, printed, here, SHORT.get(verdict, verdict)]
        out += r"\claim" + "".join(f"{{{cell}}}" for cell in cells) + "\n"
    return out


MARKS = re.compile(r"\*\*(?P<bold>[^*]+)\*\*|\*(?P<emph>[^*]+)\*|`(?P<code>[^`]+)`"
                   r"|\[[^]]*\]\(num:(?P<num>[^)]+)\)|(?P<odd>[*`<|\]])")


def marked(words):
    """Words between formulas: emphasis, code and bound numbers of Markdown in TeX. Fault for any other mark."""
    def piece(m):
        if m["odd"]:
            raise ecsv.Fault(f"the proof has a mark that tools/lineage/tex.py does not know: {m.string[m.start():][:40]}")
        if m["num"]:
            return rf"\num{{{m['num']}}}"
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
    """A block of a chapter's prose in TeX: paragraphs and lists, one level deep; its heading is left to the caller."""
    out = []
    for block in re.split(r"\n\s*\n", prose.strip()):
        if block.startswith("#"):
            continue
        items = re.split(r"^(?:\d+\.|-) +", block, flags=re.M)
        if len(items) > 1 and not items[0]:
            kind = "itemize" if block.startswith("-") else "enumerate"
            out.append("\n".join([rf"\begin{{{kind}}}", *(r"\item " + sentences(i.rstrip()) for i in items[1:]),
                                  rf"\end{{{kind}}}"]))
        else:
            out.append(sentences(block))
    return "\n\n".join(out) + "\n"


def proof(root):
    """The proof in TeX, from the one block of its chapter's prose that ends with a square; empty without the chapter."""
    path = Path(root) / chapter_of(root, PROOF)
    if not path.exists():
        return ""
    ends = "$\\square$"
    found = [b.strip() for b in re.findall(r"/\*\*(.*?)\*/", ecsv.text_of(path), re.S) if b.strip().endswith(ends)]
    if len(found) != 1:
        raise ecsv.Fault(f"{path}: {len(found)} blocks of prose end with {ends} (wanted: one, the proof)")
    return HEAD + in_tex(found[0].removesuffix(ends).rstrip())


def write(root, out):
    """The verb. A reference to nothing is found here, in the paper's own words, before TeX is called."""
    all, claims = volumes(root), read_claims(root)
    lock, figures, findings, verdicts = (joined(read, all) for read in (read_lock, read_figures, read_findings, read_verdicts))
    numbers = by_name(lock, claims)
    programs = [program for folder in all for program in programs_of(folder)]
    figures = {id: row | {"chapter": chapter_of(root, row["program"])} for id, row in figures.items()}
    texts = paper_texts(claims, numbers, verdicts, figures, metadata.read(root), findings)
    said = joined(captions, all)
    documents = files_of(root, programs)
    if missing := [f"{path}: {reference} refers to nothing" for path, text in
                   sorted({p: t for document in documents.values() for p, t in document.items()}.items())
                   for reference in dangling(text, texts)]:
        raise ecsv.Fault("; ".join(missing) + " (a new number: make lock)")
    if "supplement" in documents and (left := omissions({name: "\n".join(files.values()) for name, files in documents.items()}, {id: verdicts[id] for id in claims}, figures)):
        raise ecsv.Fault(f"{Path(root) / 'paper'}: " + "; ".join(left))
    ecsv.write_whole(Path(out) / "numbers.tex", macros(texts, figures, programs))
    ecsv.write_whole(Path(out) / "claims.tex", claim_rows(claims, numbers, verdicts))
    ecsv.write_whole(Path(out) / "captions.tex", HEAD + "".join(f"\\see{{{id}}}{{{text}}}\n" for id, text in said.items()))
    ecsv.write_whole(Path(out) / "proof.tex", proof(root))
