"""Plain texts of tables as a page shows them: numbers, units, Greek letters, long names."""

import re

from markupsafe import Markup, escape

from ..values import with_digits, without_zeros

GREEK = {"pi": "π", "eps": "ε", "omega": "ω", "tau": "τ", "mu": "μ", "lambda": "λ", "beta": "β", "gamma": "γ",
         "delta": "δ", "Phi": "Φ", "Gamma": "Γ"}
SIGNS = {">=": "≥", "<=": "≤", "+-": "±", "->": "→", " - ": " − "}
WORDED = re.compile(
    r"\b(?P<base>[A-Za-z]+)_(?P<below>\([^)]*\)|[A-Za-z0-9]+)(?![\w.])|\^(?P<above>\([^)]*\)|-?[0-9/]+|[A-Za-z0-9]+)"
    r"|\b(?P<greek>" + "|".join(GREEK) + r")\b|(?P<root>\bsqrt(?=\())|(?P<sign>>=|<=|\+-|->| - )"
    r"|(?<![\w)])(?P<minus>-)(?=[A-Za-z(])")


def number(text):
    """`1.6e-11` as a reader wants it; other texts as they are."""
    text = re.sub(r"(?<![\w.])-(?=\d)", "−", str(escape(text)))
    return Markup(re.sub(
        r"(?<![\w.])(\d[\d.]*)e(-?)(\d+)\b",
        lambda m: f"{'' if m[1] == '1' else m[1] + '·'}10<sup>{'−' if m[2] else ''}{m[3]}</sup>", text))


def short(x, digits=2):
    """A number of few digits."""
    return number(without_zeros(with_digits(x, digits)))


def spelled(text):
    """What the list of claims writes for every reader, `E_PN for omega_b = 1.1`, as a page shows it."""
    def piece(m):
        if m["base"]:
            return f'{GREEK.get(m["base"], m["base"])}<sub>{spelled(m["below"].strip("()"))}</sub>'
        if m["above"]:
            return f'<sup>{spelled(m["above"].strip("()")).replace("-", "−")}</sup>'
        return GREEK[m["greek"]] if m["greek"] else "√" if m["root"] else "−" if m["minus"] else SIGNS[m["sign"]]

    out, done = "", 0
    for m in WORDED.finditer(text):
        out += str(number(text[done:m.start()])) + piece(m)
        done = m.end()
    return Markup(out + str(number(text[done:])))


def unit(text):
    """A unit of a table, with a space before it."""
    return f" {'µm' if text == 'um' else text}" if text and text != "claim" else ""


def broken(name):
    """A long name that may be broken behind a point, a slash or an underscore."""
    return Markup(re.sub(r"([_./])(?=\w)(?!ecsv)", r"\1<wbr>", str(escape(name))))


def agreement(tolerance):
    """A tolerance of paper/published.ecsv in words."""
    kind, _, size = tolerance.partition(" ")
    return {"rel": "to a relative " + number(size), "abs": "to " + number(size)}.get(kind, tolerance)


def value(finding):
    """A value with its error and unit."""
    if finding.unit == "claim":
        return finding.shown
    shown, error, size = number(finding.shown), number(finding.shown_error), unit(finding.unit)
    if finding.kind == "residue":
        return shown + size + " (made of rounding: only its size counts)"
    return shown + size + ", exact" if finding.error == 0 else shown + " ± " + error + size


def spoken(figure):
    """How a reader calls a figure."""
    return f"Figure {figure}" if figure.startswith("x") else f"Figure {int(figure)}"


def short_figure(figure):
    return figure if figure.startswith("x") else str(int(figure))
