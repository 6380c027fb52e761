"""Looks through a finished book: links that lead nowhere, ids used twice, formulas left in TeX, and
anything that would be fetched from a network."""

import re
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

from ..ecsv import text_of


class Reader(HTMLParser):
    """The ids, links and free texts of a page."""

    def __init__(self):
        super().__init__()
        self.ids, self.twice, self.links, self.loads, self.dollars, self.stack = set(), [], [], [], [], []

    def handle_starttag(self, tag, attrs):
        given = dict(attrs)
        if "id" in given:
            if given["id"] in self.ids:
                self.twice.append(given["id"])
            self.ids.add(given["id"])
        for name, value in attrs:
            if name == "href" and tag == "a":
                self.links.append(value)
            elif name in ("src", "action", "srcset", "poster") or name == "href":
                self.loads.append(value)
            elif name == "popovertarget":
                self.links.append("#" + value)
        if tag not in ("img", "br", "hr", "input", "meta", "link", "col", "wbr"):
            self.stack.append(tag)

    def handle_endtag(self, tag):
        while self.stack and self.stack.pop() != tag:
            pass

    def handle_data(self, text):
        if {"code", "pre", "script", "style", "math", "annotation"} & set(self.stack):
            return
        self.dollars += re.findall(r".{0,20}(?<!\\)\$.{0,20}|.{0,10}\\\(.{0,20}", text)


def complaints(folder):
    pages, out = {}, []
    for path in sorted(Path(folder).glob("*.html")):
        pages[path.name] = Reader()
        pages[path.name].feed(text_of(path))
    for name, page in pages.items():
        out += [f"{name}: two elements have the id '{i}'" for i in sorted(set(page.twice))]
        out += [f"{name}: a formula was left as text: {t.strip()}" for t in page.dollars]
        for link in page.links + page.loads:
            out += complaint(folder, name, pages, link, link in page.loads)
    for path in sorted(Path(folder).glob("*.css")):
        out += [f"{path.name}: {found} is missing" for found in re.findall(r"url\((?!data:)([^)]+)\)", text_of(path))
                if not (path.parent / found.strip("'\"")).exists()]
    return out


def complaint(folder, name, pages, link, loaded):
    parts = urlsplit(link)
    if parts.scheme in ("http", "https", "mailto"):
        return [f"{name}: loads {link} from a network"] if loaded else []
    if parts.scheme:
        return [] if parts.scheme == "data" else [f"{name}: cannot follow {link}"]
    target = unquote(parts.path) or name
    if target in pages:
        return [f"{name}: {link} leads to no place"] if unquote(parts.fragment) not in {"", *pages[target].ids} else []
    return [] if (Path(folder) / target).exists() else [f"{name}: {link} leads nowhere"]
