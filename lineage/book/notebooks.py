"""The notebooks of the Python module as pages: their text is woven like that of a chapter, their outputs are those that
the notebooks hold, which the tests of the module compare with what the cells say."""

import json
import re
from pathlib import Path

from markupsafe import Markup, escape

from ..ecsv import Fault
from . import code, prose
from .bind import PageBinding


def read(root):
    """Page, title and cells of every notebook, by name."""
    out = []
    for path in sorted((Path(root) / "python").glob("*.ipynb")):
        cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
        title = re.search(r"^# (.+)$", "".join(cells[0]["source"]), re.M)
        if not title:
            raise Fault(f"{path}: no title (a line '# ...' in its first cell)")
        out.append((f"notebook-{path.stem.replace('_', '-')}.html", title[1], cells, path.name))
    return out


def shown(output):
    """An output of a cell: a picture or a text."""
    data = output.get("data", {})
    if picture := data.get("image/png"):
        return f'<img class="drawn" alt="What the cell above draws." src="data:image/png;base64,{picture}">'
    return f'<pre class="said">{escape("".join(output.get("text") or data["text/plain"]).rstrip())}</pre>'


def page(book, name, cells, file):
    """The body of a page, and what was bound in it."""
    binding = PageBinding(book.binder, page=name)
    binding.anchor = "main"
    texts = iter(prose.to_html(["".join(c["source"]) for c in cells if c["cell_type"] == "markdown"]))
    parts = []
    for cell in cells:
        if cell["cell_type"] == "markdown":
            parts.append(f'<div class="prose">{binding.prose(next(texts))}</div>')
        else:
            body = code.coloured("".join(cell["source"]), "python")
            parts.append(f'<pre class="code cell" tabindex="0"><code>{body}</code></pre>')
            parts += map(shown, cell["outputs"])
    card = Markup('<p class="card">A notebook for Python: <code>python/{}</code></p>').format(file)
    parts[0] = re.sub(r"(</h1>)", lambda m: m[0] + str(card), parts[0], count=1)
    return Markup("\n".join(parts)), binding
