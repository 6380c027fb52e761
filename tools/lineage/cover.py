"""index.html of the archive, what a reader without a compiler opens: the article's figures, its claims with their
verdicts, and the way to the book and the papers. The archive is as a checkout after `make figures`, `make book` and
`make paper`, and only what is in it is linked."""

from html import escape as escaped
from pathlib import Path

from . import codecheck, ecsv, metadata
from .values import Finding

PAGE = """<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>{title}</title>
<style>
body {{ max-width: 60em; margin: 2em auto; padding: 0 1em; font: 16px/1.5 serif; }}
figure {{ display: inline-block; width: 45%; margin: 1em 2%; vertical-align: top; }}
img {{ width: 100%; }}
td, th {{ padding: .2em .6em; text-align: left; vertical-align: top; border-bottom: 1px solid #ccc; }}
</style>
<h1>{title}</h1>
<p>Version {version}. {description}</p>
<ul>
{links}
</ul>
<h2>The figures of the article</h2>
{figures}
<h2>What the article claims</h2>
<table>
<tr><th>claim<th>printed<th>computed<th>error<th>verdict</tr>
{claims}
</table>
</html>
"""
LINKS = {"build/book/index.html": "the book: every chapter with its equations, figures, numbers and commands",
         "build/paper.pdf": "the paper: what survives and what does not, in three cases",
         "build/supplement.pdf": "its supplement: all other figures, results and claims",
         "build/theorem.pdf": "the theorem on exact travelling breathers, with its proof",
         "build/data": "all tables", "build/figures": "all figures as svg, pdf and png",
         "README.md": "how to compute all of it", "DATA.md": "how to read the tables",
         "codecheck.yml": "what a codechecker compares", "LICENSES": "the licences"}


def links(root):
    for path, said in LINKS.items():
        if (root / path).exists():
            yield f'<li><a href="{path}">{said}</a>'


def figures(root):
    rows = ecsv.read(root / "figures/figures.ecsv", ("id", "script", "caption")).by("id", "figures")
    for id, row in rows.items():
        path = codecheck.drawn(row) + ".svg"
        if not id.startswith("x") and (root / path).exists():
            caption = escaped(row["caption"])
            yield (f'<figure><a href="{path}"><img src="{path}" alt="{caption}" loading="lazy"></a>'
                   f"<figcaption>Figure {int(id)}. {caption}</figcaption></figure>")


def claims(root):
    """A row for each claim; a statement is told by its verdict alone."""
    if not (path := root / codecheck.CLAIMS).exists():
        return
    for row in ecsv.read(path, ("id", "quantity", "printed", "value", "error", "unit", "verdict", "program")).rows:
        f = Finding(row["program"], row["id"], row["value"], row["error"], row["unit"])
        number, error = (f.shown + f.shown_unit, f.shown_error) if f.value == f.value else ("", "")
        told = [row["quantity"], row["printed"], number, error, row["verdict"]]
        yield "<tr>" + "".join(f"<td>{escaped(cell)}" for cell in told) + "</tr>"


def write(root):
    """The verb: index.html in the folder of the archive."""
    root = Path(root)
    meta = metadata.read(root)
    ecsv.write_whole(root / "index.html", PAGE.format(
        title=escaped(meta["name"]), version=meta["version"], description=escaped(meta["description"]),
        **{name: "\n".join(lines(root)) for name, lines in [("links", links), ("figures", figures), ("claims", claims)]}))
