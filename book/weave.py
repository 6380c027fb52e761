"""Weaves the book: `python3 book/weave.py --data build/data --figures build/figures --out build/book`.

Chapters and library headers become pages; prose, code, figures and numbers stay where the sources
have them. What cannot be bound (an unknown id, a formula that is refused, a link that leads nowhere)
stops the build, and the old book stays as it was."""

import argparse
import base64
import gzip
import os
import re
import shutil
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import check  # noqa: E402
import pages  # noqa: E402
import prose  # noqa: E402
from bind import Binder, PageBinding  # noqa: E402
from record import Record  # noqa: E402
from source import BookError, find_sources  # noqa: E402

KATEX = ["/usr/share/javascript/katex", "/usr/share/nodejs/katex/dist"]


def size_of(svg):
    """Width and height of a drawing in CSS pixels."""
    with open(svg, encoding="utf-8") as file:
        head = file.read(4000)
    units = {"": 1, "px": 1, "pt": 96 / 72, "mm": 96 / 25.4, "cm": 96 / 2.54, "in": 96}
    out = []
    for name in ("width", "height"):
        found = re.search(rf'<svg[^>]*?\b{name}="([\d.]+)(\w*)"', head, re.S)
        if not found:
            raise BookError(f"{svg}: no {name}")
        out.append(round(float(found[1]) * units[found[2]]))
    return tuple(out)


def find_images(record, folder):
    images = {}
    for id, figure in record.figures.items():
        stem = os.path.splitext(figure["script"])[0]
        path = os.path.join(folder, stem + ".svg")
        if not os.path.exists(path):
            raise BookError(f"{path} is missing: draw it first (make figures)")
        images[id] = (stem, *size_of(path), os.path.exists(path[:-4] + ".pdf"))
    return images


def read_order(path):
    with open(path, encoding="utf-8") as file:
        return [line.strip() for line in file if line.strip() and not line.startswith("#")]


def link_sources(record, chapters, library):
    """Which sources may write a number of a program: its own, its parts, the headers that they need."""
    by_path = {h.path[len("src/"):]: h for room in library.values() for h in room}
    parts = {s.name: s for s in chapters if s.path.endswith(".hpp")}
    for chapter in chapters:
        if not chapter.path.endswith(".cpp"):
            continue
        own = [chapter] + [parts[i] for i in chapter.includes if i in parts]
        needed = [by_path[i] for s in own for i in s.includes if i in by_path]
        record.sources[chapter.stem] = own + list({s.path: s for s in needed}.values())


def weave(book, binder, sources):
    """The body of every source's page. All prose goes through one pandoc, all formulas through one
    KaTeX."""
    found = prose.to_html([b.text for s in sources for b in s.blocks if b.kind == "prose"])
    html = iter(found)
    bodies = {}
    for source in sources:
        binding, parts = PageBinding(binder, source), []
        for block in source.blocks:
            if block.kind == "prose":
                binding.anchor = f"P{block.first}"
                body = binding.prose(next(html))
                parts.append(f'<div class="prose" id="P{block.first}">{body}</div>')
            elif block.text.strip() != "#pragma once":
                parts.append(binding.code(block))
        bodies[source.path] = (binding, parts)
    return bodies


def copy_assets(out, here, record, figures, images):
    for name in ("book.css", "book.js"):
        shutil.copyfile(os.path.join(here, name), os.path.join(out, name))
    os.makedirs(os.path.join(out, "figures"))
    for name, *_ in images.values():
        for kind in (".svg", ".pdf"):
            path = os.path.join(figures, name + kind)
            if os.path.exists(path):
                shutil.copyfile(path, os.path.join(out, "figures", name + kind))
    for program in sorted(record.sources):
        folder = os.path.join(record.data, program)
        if os.path.isdir(folder):
            os.makedirs(os.path.join(out, "data", program))
            for name in sorted(os.listdir(folder)):
                if name.endswith(".ecsv") and not name.startswith("."):
                    shutil.copyfile(os.path.join(folder, name), os.path.join(out, "data", program, name))
    katex = next((k for k in KATEX if os.path.exists(os.path.join(k, "katex.min.css"))), None)
    if not katex:
        raise BookError("katex.min.css is not installed (Debian: libjs-katex, fonts-katex)")
    with open(os.path.join(katex, "katex.min.css"), encoding="utf-8") as file:
        css = file.read()
    css = re.sub(r"src:[^;}]*?url\(([^)]*?\.woff2)\)[^;}]*", r"src:url(\1) format('woff2')", css)
    with open(os.path.join(out, "katex.css"), "w", encoding="utf-8") as file:
        file.write(css)
    os.makedirs(os.path.join(out, "fonts"))
    for font in sorted(set(re.findall(r"fonts/(\w[\w-]*\.woff2)", css))):
        shutil.copyfile(os.path.join(katex, "fonts", font), os.path.join(out, "fonts", font))


LIVE = ["strike", "breather", "defect"]


def copy_live(out, here, folder):
    """The compiled library as scripts, because a page from a folder may not fetch a file."""
    for page in LIVE:
        with open(os.path.join(folder, page + ".wasm"), "rb") as file:
            packed = base64.b64encode(gzip.compress(file.read(), mtime=0)).decode()
        with open(os.path.join(out, page + ".module.js"), "w", encoding="utf-8") as file:
            file.write(f'(window.LIVE_MODULES ??= {{}}).{page} = "{packed}";\n')
    with open(os.path.join(out, "live.js"), "w", encoding="utf-8") as file:
        for name in ["live"] + LIVE:
            with open(os.path.join(here, "live", name + ".js"), encoding="utf-8") as part:
                file.write(part.read())


def make(root, data, figures, out, live=""):
    here = os.path.dirname(os.path.abspath(__file__))
    record = Record(root, data)
    chapters, library = find_sources(root, read_order(os.path.join(here, "contents.txt")))
    link_sources(record, chapters, library)
    headers = [h for room in library.values() for h in room]
    images = find_images(record, figures)
    has_live = bool(live) and all(os.path.exists(os.path.join(live, p + ".wasm")) for p in LIVE)
    binder = Binder(record, chapters + headers, images, has_live)
    book = pages.Book(record, binder, chapters, library)

    bodies = weave(book, binder, chapters + headers)
    found = book.assemble(bodies)  # page name -> HTML with formulas still in TeX
    done = prose.typeset([f for page in found.values() for f in prose.formulas(page)])
    part = out.rstrip("/") + ".part"
    shutil.rmtree(part, ignore_errors=True)
    os.makedirs(part)
    for name, page in found.items():
        with open(os.path.join(part, name), "w", encoding="utf-8") as file:
            file.write(prose.with_formulas(page, done) if name.endswith(".html") else page)
    copy_assets(part, here, record, figures, images)
    if has_live:
        copy_live(part, here, live)
    complaints = check.complaints(part)
    if complaints:
        raise BookError("\n  ".join(["the book is not whole (left in " + part + "):"] + complaints[:40]))
    shutil.rmtree(out, ignore_errors=True)
    os.rename(part, out)
    return len(found)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--root", default=".")
    parser.add_argument("--data", default="build/data")
    parser.add_argument("--figures", default="build/figures")
    parser.add_argument("--live", default="build/live", help="folder of the module for live pages")
    parser.add_argument("--out", default="build/book")
    given = parser.parse_args()
    try:
        count = make(given.root, given.data, given.figures, given.out, given.live)
    except BookError as error:
        print(f"book: {error}", file=sys.stderr)
        return 1
    print(f"book       : {count} pages, {given.out}/index.html")
    return 0


if __name__ == "__main__":
    sys.exit(main())
