"""Syntax colours and line numbers for C++, gnuplot and Python; names that the library defines are links."""

import html
import re

CPP_KEYWORDS = """alignas auto bool break case catch char class concept const constexpr continue decltype
default delete do double else enum explicit extern false float for friend if inline int long mutable
namespace new noexcept nullptr operator private protected public requires return short signed sizeof static
static_assert static_cast struct switch template this throw true try typename union unsigned using virtual
void volatile while std""".split()
PYTHON_KEYWORDS = """False None True and as assert break class continue def del elif else except finally for
from global if import in is lambda nonlocal not or pass raise return try while with yield""".split()
GNUPLOT_KEYWORDS = """plot replot splot set unset using with title notitle lines points linespoints axes load do
for if else in array show style line at every index columnheaders multiplot margins""".split()

TOKENS = {
    "cpp": (r"(?P<comment>//[^\n]*|/\*.*?\*/)"
            r'|(?P<string>"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)\')'
            r"|(?P<directive>^[ \t]*#[ \t]*\w+)"
            r"|(?P<number>\b(?:0x[0-9a-fA-F']+|\d[\d']*\.?\d*(?:[eE][+-]?\d+)?)[fFlLuUzZ]*\b)"
            r"|(?P<name>[A-Za-z_]\w*)", CPP_KEYWORDS),
    "python": (r"(?P<comment>\#[^\n]*)"
               r"|(?P<string>[rfb]*(?:\"\"\".*?\"\"\"|'''.*?'''|\"(?:[^\"\\\n]|\\.)*\"|'(?:[^'\\\n]|\\.)*'))"
               r"|(?P<number>\b\d[\d_]*\.?\d*(?:[eE][+-]?\d+)?\b)"
               r"|(?P<name>[A-Za-z_]\w*)", PYTHON_KEYWORDS),
    "gnuplot": (r"(?P<comment>\#[^\n]*)"
                r"|(?P<string>\"(?:[^\"\\\n]|\\.)*\"|'[^'\n]*')"
                r"|(?P<number>\b\d+\.?\d*(?:[eE][+-]?\d+)?\b)"
                r"|(?P<name>[A-Za-z_]\w*)", GNUPLOT_KEYWORDS),
}
SHORT = {"comment": "c", "string": "s", "directive": "d", "number": "n", "keyword": "k"}
COMPILED = {name: (re.compile(p, re.M | re.S), frozenset(k)) for name, (p, k) in TOKENS.items()}


def span(kind, text):
    """A coloured piece; a piece over several lines is coloured line by line."""
    return "\n".join(f'<span class="{SHORT[kind]}">{html.escape(t, quote=False)}</span>' if t else ""
                     for t in text.split("\n"))


def coloured(code, language="cpp", link=None, include=None):
    """HTML of `code`. `link(name, qualified)` may give the address of a name's definition, and
    `include(path)` that of a header."""
    pattern, keywords = COMPILED[language]
    out, at = [], 0
    for token in pattern.finditer(code):
        out.append(html.escape(code[at:token.start()], quote=False))
        at, kind, text = token.end(), token.lastgroup, token.group()
        before = code[max(0, token.start() - 9):token.start()]
        if kind == "name":
            if text in keywords:
                out.append(span("keyword", text))
                continue
            member = before.endswith((".", "->")) or (before.endswith("::") and not before.endswith("lattice::"))
            target = link(text) if link and not member else None
            out.append(f'<a class="id" href="{target}">{text}</a>' if target else text)
        elif kind == "string" and include and before.endswith("include ") and include(text[1:-1]):
            out.append(f'<a class="s" href="{include(text[1:-1])}">{html.escape(text, quote=False)}</a>')
        else:
            out.append(span(kind, text))
    out.append(html.escape(code[at:], quote=False))
    return "".join(out)


def numbered(code, first, language="cpp", link=None, include=None):
    """A block of code whose lines carry the numbers of the file, as text that is not copied and as
    anchors L<number>."""
    lines = coloured(code, language, link, include).split("\n")
    body = "".join(f'<span class="l" id="L{first + i}" data-n="{first + i}">{line}\n</span>'
                   for i, line in enumerate(lines))
    return f'<pre class="code" tabindex="0"><code>{body}</code></pre>'
