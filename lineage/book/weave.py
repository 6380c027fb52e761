"""Weaves the book. Chapters and library headers become pages; prose, code, figures and numbers stay where the
sources have them. What cannot be bound (an unknown id, a formula that is refused, a link that leads nowhere) stops
the build, and the old book stays as it was."""

import base64
import gzip
import json
import os
import re
import shutil
from pathlib import Path

from .. import inventory
from ..ecsv import Fault, check_written, text_of
from ..findings import with_kind, with_sentences
from . import check, pages, prose
from ..volumes import joined
from .bind import Binder, PageBinding, read_live
from .record import Record
from .source import find_sources, title_of

KATEX = [Path("/usr/share/javascript/katex"), Path("/usr/share/nodejs/katex/dist")]


def size_of(svg):
    """Width and height of a drawing in CSS pixels."""
    head = text_of(svg)[:4000]
    units = {"": 1, "px": 1, "pt": 96 / 72, "mm": 96 / 25.4, "cm": 96 / 2.54, "in": 96}
    out = []
    for name in ("width", "height"):
        found = re.search(rf'<svg[^>]*?\b{name}="([\d.]+)(\w*)"', head, re.S)
        if not found:
            raise Fault(f"{svg}: no {name}")
        out.append(round(float(found[1]) * units[found[2]]))
    return tuple(out)


def find_images(record, folder):
    """Name, width, height and whether there is a PDF, for each figure."""
    images = {}
    for id, figure in record.figures.items():
        stem = Path(figure["script"]).stem
        path = folder / f"{stem}.svg"
        if not path.exists():
            raise Fault(f"{path} is missing: draw it first (make figures)")
        images[id] = (stem, *size_of(path), path.with_suffix(".pdf").exists())
    return images


def read_order(path):
    return [line.strip() for line in text_of(path).splitlines() if line.strip() and line[0] not in "#="]


def read_parts(path, chapters):
    """The parts of the book, each a title with its chapters; one that is not named stands where those before it do."""
    part, part_of = "", {}
    for line in text_of(path).splitlines():
        part = line[1:].strip() if line.startswith("=") else part
        part_of[line.strip()] = part
    parts = []
    for chapter in chapters:
        title = part_of.get(chapter.stem, parts[-1][0] if parts else "")
        if not parts or parts[-1][0] != title:
            parts.append((title, []))
        parts[-1][1].append(chapter)
    return parts


def link_sources(record, chapters, library):
    """Which sources may write a number of a program: its own, and what it needs of the library and of section code."""
    by_path = {s.included: s for module in library.values() for s in module}
    for chapter in chapters:
        needed = [i for i in chapter.includes if i in by_path]
        halves = [i[:-4] + ".cpp" for i in needed if i[:-4] + ".cpp" in by_path]
        record.sources[chapter.stem] = [chapter] + [by_path[i] for i in dict.fromkeys(needed + halves)]


def tell_findings(sources, findings):
    """Puts the sentences of findings where prose quotes them; a sentence is one line, so that lines keep their numbers."""
    for source in sources:
        for block in source.blocks:
            if block.kind == "prose":
                block.lines = with_sentences(block.text, findings, with_kind).split("\n")


def bind_all(binder, sources):
    """The body of every source's page. All prose goes through one pandoc, all formulas through one KaTeX."""
    html = iter(prose.to_html([b.text for s in sources for b in s.blocks if b.kind == "prose"]))
    bodies = {}
    for source in sources:
        binding, parts = PageBinding(binder, source), []
        if not title_of(source.blocks):
            parts.append(binding.heading(1, source.title))
        for block in source.blocks:
            if block.kind == "prose":
                binding.anchor = f"P{block.first}"
                body = binding.prose(next(html))
                parts.append(f'<div class="prose" id="P{block.first}">{body}</div>')
            elif block.text.strip() != "#pragma once":
                parts.append(binding.listing(block))
        bodies[source.path] = (binding, parts)
    return bodies


def copy_katex(out):
    katex = next((k for k in KATEX if (k / "katex.min.css").exists()), None)
    if not katex:
        raise Fault("katex.min.css is not installed (Debian: libjs-katex, fonts-katex)")
    css = re.sub(r"src:[^;}]*?url\(([^)]*?\.woff2)\)[^;}]*", r"src:url(\1) format('woff2')", text_of(katex / "katex.min.css"))
    (out / "katex.css").write_text(css, encoding="utf-8")
    (out / "fonts").mkdir()
    for font in sorted(set(re.findall(r"fonts/(\w[\w-]*\.woff2)", css))):
        shutil.copyfile(katex / "fonts" / font, out / "fonts" / font)


def copy_assets(out, record, figures, images):
    for name in ("book.css", "book.js", "chain.js"):
        shutil.copyfile(prose.ASSETS / name, out / name)
    (out / "figures").mkdir()
    for name, *_ in images.values():
        for path in (figures / f"{name}.svg", figures / f"{name}.pdf"):
            if path.exists():
                shutil.copyfile(path, out / "figures" / path.name)
    for program in sorted(record.sources):
        for path in sorted((record.data / program).glob("[!.]*.ecsv")):
            (out / "data" / program).mkdir(parents=True, exist_ok=True)
            check_written(path, text_of(path))
            shutil.copyfile(path, out / "data" / program / path.name)
    copy_katex(out)


def wells_of(root):
    """The wells that the library knows by name, in the order of its list, each with the names of its parameters."""
    path = root / "src/lattice/model/well.hpp"
    structs = dict(re.findall(r"^struct (\w+).*?\{\n(.*?)^\};", text_of(path), re.M | re.S))
    listed = re.search(r"^struct Well : OneOf<OwnWell, ([\w,\s]+)>", text_of(path), re.M)
    if not listed:
        raise Fault(f"{path}: no list of wells")
    bodies = [structs[name] for name in re.split(r",\s*", listed[1])]
    return {re.search(r'name = "(\w+)"', body)[1]: re.findall(r'Parameter<\w+>\{"(\w+)"', body) for body in bodies}


def copy_live(out, root, lives, folder):
    """The compiled library as scripts, because a page from a folder may not fetch a file."""
    for _, page, _ in lives:
        packed = base64.b64encode(gzip.compress((folder / f"{page}.wasm").read_bytes(), mtime=0)).decode()
        (out / f"{page}.module.js").write_text(f'(window.LIVE_MODULES ??= {{}}).{page} = "{packed}";\n', encoding="utf-8")
    shared, *kinds = (text_of(place / f"{name}.js") for place, name in [(prose.ASSETS / "live", "live")] + [one[:2] for one in lives])
    (out / "live.js").write_text(f"{shared}Live.wells = {json.dumps(wells_of(root))};\n{''.join(kinds)}", encoding="utf-8")


def make(root, data, figures, out, live="", programs=""):
    """The verb; returns the number of files that are text."""
    root, figures, out, live = Path(root), Path(figures), Path(out), Path(live)
    record = Record(root, data)
    chapters, library = find_sources(root, record.volumes, read_order(prose.ASSETS / "contents.txt"))
    link_sources(record, chapters, library)
    sources = chapters + [s for module in library.values() for s in module]
    tell_findings(sources, record.findings)
    images = find_images(record, figures)
    lives = pages.live_in(record.volumes)
    has_live = bool(lives) and all((live / f"{name}.wasm").exists() for _, name, _ in lives)
    binder = Binder(record, sources, images, joined(read_live, [v / "book/live/figures.txt" for v in record.volumes]) if has_live else {})
    there = {"tables": list(inventory.tables(root, data)), "commands": list(inventory.commands(root, programs)),
             "packages": inventory.packages(root)}
    book = pages.Book(record, binder, read_parts(prose.ASSETS / "contents.txt", chapters), library, there)

    found = book.assemble(bind_all(binder, sources))  # page name -> HTML with formulas still in TeX
    done = prose.typeset([f for page in found.values() for f in prose.formulas(page)])
    part = Path(f"{out}.part")
    shutil.rmtree(part, ignore_errors=True)
    part.mkdir(parents=True)
    for name, page in found.items():
        (part / name).write_text(prose.with_formulas(page, done) if name.endswith(".html") else page, encoding="utf-8")
    copy_assets(part, record, figures, images)
    if has_live:
        copy_live(part, root, lives, live)
    if complaints := check.complaints(part):
        raise Fault("\n  ".join([f"the book is not whole (left in {part}):"] + complaints[:40]))
    shutil.rmtree(out, ignore_errors=True)
    os.rename(part, out)
    return len(found)
