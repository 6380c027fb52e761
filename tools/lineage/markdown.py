"""Values and words for the book: Markdown, with HTML for what it has no form. tex.py does the same for the report."""

import math
import re
from html import escape

from . import tex

WORDS = re.compile(rf"(\$[^$]*\$|`[^`]*`|\[[^\]]*\]\([^)]*\)|\b(?!(?:{'|'.join(sorted(tex.GREEK))})_)[A-Za-z]\w{{2,}}_\w+)")


def plain(text):
    """A text that Markdown leaves as it is."""
    return re.sub(r"([\\`*_{}\[\]<>$|#~])", r"\\\1", str(text))


def spelled(text):
    """What a list writes for every reader, `E_PN for omega_b = 1.1`, with formulas. Formulas, code and links stay, and so
    do names such as sec33_floquet."""
    pieces = WORDS.split(text)
    for i in range(0, len(pieces), 2):
        said = re.sub(r"\\ensuremath\{((?:[^{}]|\{[^{}]*\})*)\}", r"$\1$", tex.worded(pieces[i])).replace("$$", "")
        pieces[i] = re.sub(r"([|<>*\[\]])", r"\\\1", said.replace(r"\^{}", "^").replace(r"\~{}", r"\~"))
    pieces[1::2] = [piece if piece[0] in "$`[" else plain(piece) for piece in pieces[1::2]]
    return "".join(pieces).replace("$$", "$ $")


def number(text):
    """`1.6e-11` as a reader wants it, in HTML."""
    text = re.sub(r"(?<![\w.])-(?=\d)", "−", escape(text))
    return re.sub(r"(?<![\w.])(\d[\d.]*)e([-+]?)0*(\d+)\b",
                  lambda m: f"{'' if m[1] == '1' else m[1] + '·'}10<sup>{'−' if m[2] == '-' else ''}{m[3]}</sup>", text)


def unit(text):
    """With a space before it."""
    return f" {'µm' if text == 'um' else text}" if text else ""


def with_error(found):
    """A value with its error and unit, as text."""
    if not math.isfinite(found.value):
        return found.shown
    return found.shown + (f"{unit(found.unit)}, exact" if found.error == 0 else f" ± {found.shown_error}{unit(found.unit)}")


def table(heads, rows, kind="rows"):
    """A table whose cells stand under each other on a narrow screen; nothing without rows."""
    lines = ["| " + " | ".join(re.sub(r"\s+", " ", cell) for cell in row) + " |" for row in rows]
    head = ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)]
    return "\n".join(["", f":::{{container}} {kind}", *head, *lines, ":::", ""]) if lines else ""


def listing(code, language, first=0):
    """Code, with the numbers of its lines from `first` on, if there is one."""
    begin = f":lineno-start: {first}\n" if first else ""
    return f"\n``````{{code-block}} {language}\n{begin}\n{code}\n``````\n"


def place(id):
    """What a link to this id leads to."""
    return f'<a id="{escape(id)}"></a>'


def name(text):
    """A long name, which may be broken behind a point, an underscore or a slash."""
    return "<code>" + re.sub(r"([._/])(?=[A-Za-z])", r"\1<wbr>", text) + "</code>"


def link(address, text):
    return f'<a href="{escape(address)}">{text}</a>'


def data(path):
    """A link to a table."""
    return f'<a href="data/{path}" download>{path}</a>'


def verdict(said):
    return f'<span class="verdict {said.split(",")[0].split()[0]}">{said}</span>'
