"""What others are told of this repository: its version, title, authors and licences, and the article behind it.

codemeta.json is the one place where that is written; it is JSON because CMake, Python and the world read it alike.
`make refresh` writes from it CITATION.cff (for GitHub and reference managers), .zenodo.json (for the archive) and
paper/metadata.yaml (for ReScience C); CMakeLists.txt takes the version from it, the paper its title and keywords. The
date of the version is its `datePublished`, if it has one: report and CITATION.cff show that and no other day."""

import json
from pathlib import Path

from . import ecsv

SOURCE = "codemeta.json"
NOTE = f"# Written by `make refresh` from {SOURCE}; do not edit.\n"
REQUIRED = ("name", "version", "description", "keywords", "author", "license", "hasPart", "referencePublication")


def read(root):
    """The metadata; Fault if it cannot be used."""
    path = Path(root) / SOURCE
    try:
        meta = json.loads(ecsv.text_of(path))
    except json.JSONDecodeError as error:
        raise ecsv.Fault(f"{path}: line {error.lineno}: not JSON ({error.msg})") from None
    for name in REQUIRED:
        if not meta.get(name):
            raise ecsv.Fault(f"{path}: there is no '{name}'")
    return meta


def licences(meta):
    """The identifiers of SPDX: that of the code, and that of prose, data and pictures, which are parts of the whole. Two
    in one list would mean that the reader may choose."""
    return [one["license"].rsplit("/", 1)[-1] for one in (meta, *meta["hasPart"])]


def article(meta):
    """What the article is cited by, under the names of CITATION.cff."""
    a = meta["referencePublication"]
    return {"type": "article", "title": a["name"],
            "authors": [{"family-names": p["familyName"], "given-names": p["givenName"]} for p in a["author"]],
            "journal": a["isPartOf"]["isPartOf"]["name"], "volume": int(a["isPartOf"]["volumeNumber"]),
            "start": a["pageStart"], "end": a["pageEnd"], "year": int(a["datePublished"]),
            "doi": a["@id"].removeprefix("https://doi.org/")}


def said(meta):
    """What the report says of itself, as plain texts by name; empty where nothing is known yet."""
    code, text = licences(meta)
    a = article(meta)
    edition = ", ".join(["Version " + meta["version"], *([day] if (day := meta.get("datePublished")) else [])])
    contact = [one["email"].removeprefix("mailto:") for one in meta["author"] if one.get("email")]
    return {"version": meta["version"], "edition": edition, "keywords": ", ".join(meta["keywords"]), "code": code,
            "text": text, "title": f"[Re] {a['title']}", "authors": ", ".join(one["name"] for one in meta["author"]),
            "contact": ", ".join(contact), "repository": meta.get("codeRepository", ""),
            "doi": meta.get("identifier", ""), "article": cited(a)}


def yaml(value, indent=0):
    """A value in YAML, whose texts are quoted as in JSON, which YAML reads; an empty one stays empty."""
    lead = "  " * indent
    if isinstance(value, dict):
        return "".join(f"{lead}{key}:{' ' if isinstance(item, (str, int)) and item != '' else chr(10)}{yaml(item, indent + 1)}"
                       for key, item in value.items())
    if isinstance(value, list):
        return "".join(f"{lead}- {yaml(item, indent + 1).lstrip()}" for item in value)
    return json.dumps(value, ensure_ascii=False) + "\n" if value != "" else ""


def citation(meta):
    """CITATION.cff, version 1.2.0 of the format, whose licence is that of the software; several would be a choice."""
    return NOTE + yaml({
        "cff-version": "1.2.0",
        "message": "If you use this software, please cite it together with the article that it reproduces.",
        "type": "software", "title": meta["name"], "version": meta["version"],
        **({"date-released": meta["datePublished"]} if meta.get("datePublished") else {}),
        "abstract": meta["description"], "keywords": meta["keywords"], "license": licences(meta)[0],
        "authors": [{"name": a["name"]} for a in meta["author"]], "references": [article(meta)]})


def zenodo(meta):
    """.zenodo.json, the form of a deposit. It has room for one licence; that of texts and data stands in the notes."""
    code, *others = licences(meta)
    return json.dumps({
        "upload_type": "software", "title": meta["name"], "version": meta["version"],
        "description": f"<p>{meta['description']}</p>", "creators": [{"name": a["name"]} for a in meta["author"]],
        "keywords": meta["keywords"], "access_right": "open", "license": code,
        "notes": f"Source code under {code}; prose, data and pictures under {', '.join(others)}; REUSE.toml says which file is which.",
        "related_identifiers": [{"identifier": article(meta)["doi"], "relation": "isDerivedFrom", "scheme": "doi"}],
    }, ensure_ascii=False, indent=2) + "\n"


def cited(a):
    """The article as one line of text."""
    names = ", ".join(f"{p['given-names']} {p['family-names']}" for p in a["authors"])
    return f"{names}, {a['title']}, {a['journal']} {a['volume']} ({a['year']}) {a['start']}-{a['end']}"


def rescience(meta):
    """paper/metadata.yaml, what ReScience C asks of a replication. What is known at submission or after
    acceptance only stays empty."""
    a = article(meta)
    return NOTE + yaml({
        "title": said(meta)["title"],
        "authors": [{"name": one["name"], "orcid": "", "email": "", "affiliations": ""} for one in meta["author"]],
        "affiliations": [{"code": "", "name": "", "address": ""}],
        "keywords": ", ".join(["rescience c", *meta["programmingLanguage"], *meta["keywords"]]),
        "code": [{"url": meta.get("codeRepository", "")}, {"doi": meta.get("identifier", "")}, {"swh": ""}],
        "data": [{"url": meta.get("codeRepository", "")}, {"doi": meta.get("identifier", "")}],
        "replication": [{"cite": cited(a)}, {"bib": "james2013breathers"}, {"url": f"https://doi.org/{a['doi']}"},
                        {"doi": a["doi"]}],
        "abstract": meta["description"], "bibliography": "refs.bib", "type": "Replication",
        "domain": "Nonlinear Physics", "language": meta["programmingLanguage"][0],
        "review": [{"url": ""}],
        "contributors": [{"name": "", "orcid": "", "role": role} for role in ("editor", "reviewer", "reviewer")],
        "dates": [{"received": ""}, {"accepted": ""}, {"published": ""}],
        "article": [{"number": ""}, {"doi": ""}, {"url": ""}],
        "journal": [{"name": "ReScience C"}, {"issn": "2430-3658"}, {"volume": ""}, {"issue": ""}]})


FILES = {"CITATION.cff": citation, ".zenodo.json": zenodo, "paper/metadata.yaml": rescience}


def generated(root):
    """(path, text) of every file that says the same to somebody else."""
    meta = read(root)
    for name, write in FILES.items():
        yield Path(root) / name, write(meta)
