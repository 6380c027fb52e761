"""Code as HTML: colours by Pygments, line numbers, and links from the names that the library defines."""

import re
from functools import cache

from pygments import lex
from pygments.lexers import CppLexer, GnuplotLexer, PythonLexer
from pygments.token import Comment, Keyword, Name, Number, String
from markupsafe import escape

LEXERS = {"cpp": CppLexer, "python": PythonLexer, "gnuplot": GnuplotLexer}
SHORT = [(Comment.Preproc, "d"), (Comment.PreprocFile, "s"), (Comment, "c"), (String, "s"), (Number, "n"), (Keyword, "k")]


@cache
def kind_of(token):
    return next((short for kind, short in SHORT if token in kind), "")


def words(code, language):
    """The tokens of Pygments; neighbours of one kind are one, and names stand alone."""
    out = []
    for token, text in lex(code, LEXERS[language](stripnl=False)):
        kind = "name" if token in Name and re.fullmatch(r"\w+", text) else kind_of(token)
        if out and kind == out[-1][0] != "name":
            out[-1][1] += text
        else:
            out.append([kind, text])
    if not code.endswith("\n"):
        out[-1][1] = out[-1][1].removesuffix("\n")  # which the lexer needs behind a remark
    return out


def span(kind, text):
    """A coloured piece; a piece over several lines is coloured line by line."""
    if not kind:
        return str(escape(text))
    return "\n".join(f'<span class="{kind}">{escape(t)}</span>' if t.strip() else t for t in text.split("\n"))


def coloured(code, language="cpp", link=None, include=None):
    """HTML of `code`. `link(name)` may give the address of a name's definition, and `include(path)` that of a
    header."""
    out, at = [], 0
    for kind, text in words(code, language):
        before, at = code[max(0, at - 9):at], at + len(text)
        target = None
        if kind == "name" and link:
            member = before.endswith((".", "->")) or (before.endswith("::") and not before.endswith("lattice::"))
            target = None if member else link(text)
        elif kind == "s" and include and text.startswith('"'):
            target = include(text.strip('"'))
        if target:
            out.append(f'<a class="{"id" if kind == "name" else "s"}" href="{target}">{escape(text)}</a>')
        else:
            out.append(span("" if kind == "name" else kind, text))
    return "".join(out)


def numbered(code, first, language="cpp", link=None, include=None):
    """A block of code whose lines carry the numbers of the file, as text that is not copied and as
    anchors L<number>."""
    lines = coloured(code, language, link, include).split("\n")
    body = "".join(f'<span class="l" id="L{first + i}" data-n="{first + i}">{line}\n</span>'
                   for i, line in enumerate(lines))
    return f'<pre class="code" tabindex="0"><code>{body}</code></pre>'
