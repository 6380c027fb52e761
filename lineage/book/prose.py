"""Prose to HTML: one run of pandoc over all blocks, one run of KaTeX over all formulas."""

import html
import json
import re
import shutil
import subprocess
import unicodedata
from pathlib import Path

from ..ecsv import Fault

ASSETS = Path(__file__).resolve().parents[2] / "book"

READER = "markdown-auto_identifiers-citations-raw_tex-raw_html-native_divs-native_spans+lists_without_preceding_blankline"
MARK = "borderOfBlock{}"


def prepared(text):
    """A figure stands in a paragraph of its own, whatever the lines around it."""
    return re.sub(r"(!\[[^\]]*\]\(fig:[^)]*\))", r"\n\n\1\n\n", text)


def to_html(texts):
    """The HTML of each text, by pandoc in one run."""
    if not texts:
        return []
    if not shutil.which("pandoc"):
        raise Fault("pandoc is missing")
    joined = "\n\n".join(MARK.format(i) + "\n\n" + prepared(t) for i, t in enumerate(texts)) + "\n"
    run = subprocess.run(
        ["pandoc", "--from", READER, "--to", "html5", "--mathjax", "--wrap=none", "--columns=100000",
         "--fail-if-warnings"],
        input=joined, capture_output=True, text=True, encoding="utf-8", check=False)
    if run.returncode:
        raise Fault("pandoc: " + run.stderr.strip())
    pieces = re.split(r"<p>borderOfBlock(\d+)</p>\n?", run.stdout)
    if [int(n) for n in pieces[1::2]] != list(range(len(texts))):
        raise Fault("pandoc has swallowed the border of a block: some Markdown is not closed")
    return [p.strip() for p in pieces[2::2]]


def from_tex(caption):
    """A caption of paper/captions.tex as Markdown: words, formulas, dashes and spaces that do not break."""
    pieces = caption.split("$")
    odd = re.search(r"[\\{}&#_^*`<>|\[\]]", "".join(pieces[::2]))
    if odd or len(pieces) % 2 == 0:
        raise Fault(f"paper/captions.tex: {repr(odd[0]) if odd else 'an open formula'} in '{caption[:60]}...'")
    pieces[::2] = [words.replace("~", "\u00a0").replace("--", "–") for words in pieces[::2]]
    return "$".join(pieces)


MATH = re.compile(r'<span class="math (inline|display)">(.*?)</span>', re.S)


def formulas(page):
    """The formulas in a piece of HTML: pairs (TeX, displayed)."""
    return [(html.unescape(tex), kind == "display") for kind, tex in MATH.findall(page)]


def unwrapped(tex):
    """pandoc hands a formula over with its delimiters."""
    return re.sub(r"^(\\\(|\\\[|\$\$?)(.*?)(\\\)|\\\]|\$\$?)$", r"\2", tex.strip(), flags=re.S)


def typeset(found):
    """HTML of formulas by (TeX, displayed); a formula that KaTeX refuses is an error."""
    todo = sorted(set(found))
    if not todo:
        return {}
    run = subprocess.run(
        [node(), str(ASSETS / "typeset.js")], input=json.dumps([[unwrapped(t), d] for t, d in todo]),
        capture_output=True, text=True, encoding="utf-8", check=False)
    if run.returncode:
        raise Fault("KaTeX: " + run.stderr.strip())
    return dict(zip(todo, json.loads(run.stdout)))


def node():
    for name in ("node", "nodejs"):
        if shutil.which(name):
            return name
    raise Fault("node is missing (Debian: nodejs)")


def with_formulas(page, done):
    """The page with each formula replaced by what `typeset` made of it. No line begins with the comma
    behind a short one."""
    page = re.sub(r'<span class="math inline">[^<]{1,34}</span>[.,;:!?)’”]+',
                  lambda m: f'<span class="nobreak">{m[0]}</span>', page)
    return MATH.sub(lambda m: done[html.unescape(m.group(2)), m.group(1) == "display"], page)


VOID = {"img", "br", "hr", "input", "col", "meta", "link", "wbr"}


def on_text(page, change):
    """`change(text, tags)` for every text between tags, with the names of the open tags; formulas
    are not text."""
    out, stack = [], []
    for piece in re.split(r"(<!--.*?-->|<[^>]+>)", page):
        if piece.startswith("<!--"):
            out.append(piece)
        elif found := re.match(r"<(/?)(\w+)([^>]*)>", piece):
            closing, tag, rest = found.groups()
            if closing:
                if not stack or stack[-1].split(".")[0] != tag:
                    raise Fault(f"</{tag}> closes nothing: ...{''.join(out)[-200:]}")
                stack.pop()
            elif tag not in VOID and not rest.endswith("/"):
                stack.append(tag + (".math" if 'class="math' in rest else ""))
            out.append(piece)
        elif piece and not any(t.endswith(".math") for t in stack):
            out.append(change(piece, stack))
        else:
            out.append(piece)
    return "".join(out)


GREEK = re.compile(r"\\(alpha|beta|gamma|delta|epsilon|eta|kappa|lambda|mu|nu|omega|phi|psi|sigma|tau|varphi|xi)(?![a-z]) ?")


def greek(match):
    return unicodedata.lookup("GREEK SMALL LETTER " + match[1].removeprefix("var").replace("lambda", "lamda").upper())


SIGNS = {"cdot": "·", "times": "×", "le": "≤", "leq": "≤", "ge": "≥", "geq": "≥", "pm": "±", "to": "→", "infty": "∞",
         "approx": "≈", "ll": "≪", "gg": "≫", "sum": "Σ", "int": "∫", "partial": "∂", "nabla": "∇", "in": "∈", "sqrt": "√",
         "propto": "∝", "sim": "∼", "ne": "≠", "neq": "≠", "dots": "…", "ldots": "…", "cdots": "…", "ell": "ℓ", "mid": "|",
         "Delta": "Δ", "Gamma": "Γ", "Lambda": "Λ", "Omega": "Ω", "Phi": "Φ", "Psi": "Ψ", "Sigma": "Σ", "top": "T"}


NAMES = {"cos", "sin", "ln", "log", "exp", "max", "min", "sup", "cosh", "sinh", "tanh", "sech"}


def said(tex):
    """A formula in letters and signs: `\\frac{1}{2}\\omega_b^2` is 1/2 ω_b^2."""
    tex = re.sub(r"\\(?:left|right|big|Big|bigl|bigr|Bigl|Bigr|displaystyle|limits)(?![a-z])", "", tex)
    tex = re.sub(r"\\[tdc]?frac\s*(\d)\s*(\d)", r"\1/\2", tex)
    for _ in range(3):  # fractions in fractions
        tex = re.sub(r"\\[tdc]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}", r"\1/\2", tex)
    tex = re.sub(r"\\(?:begin|end)\{[^}]*\}|\\tag\{[^}]*\}|\\[,;:!> ]|\\q?quad|&|\\\\|~", " ", tex)
    tex = GREEK.sub(greek, tex)
    tex = re.sub(r"\\([A-Za-z]+)( ?)", lambda m: SIGNS[m[1]] + m[2] if m[1] in SIGNS else m[1] + " " if m[1] in NAMES else "", tex)
    tex = re.sub(r"([_^])\{([^{}]*[^{}\w][^{}]*)\}", r"\1(\2)", tex)
    return re.sub(r"\s+", " ", re.sub(r"[{}]|\\(?=[{}|])", "", tex).replace("\\", "")).strip()


def plain(page):
    """The words of a piece of HTML; a formula is read aloud, as it were."""
    page = MATH.sub(lambda m: html.escape(said(unwrapped(html.unescape(m.group(2))))), page)
    page = re.sub(r"<sup>(.*?)</sup>", r"^\1", page)
    page = re.sub(r"</?(?:a|b|button|code|em|i|small|span|strong|sub|wbr)\b[^>]*>", "", page)
    return re.sub(r"\s+", " ", html.unescape(re.sub(r"<[^>]+>", " ", page))).strip()


def slug(text):
    return re.sub(r"[^a-z0-9]+", "-", text.lower()).strip("-") or "section"
