"""Refreshes the generated tables of README.md from the products under build/.

The text between `<!-- NAME -->` and `<!-- /NAME -->` is replaced; everything else is left alone.
"""

import csv
import math
import pathlib
import re


def rows(path):
    with open(path, encoding="utf8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def figure_table():
    lines = ["| figure | command | program | shows |", "|---|---|---|---|"]
    for row in rows("figures/figures.ecsv"):
        name = row["id"] if row["id"].startswith("x") else "fig" + row["id"]
        lines.append(f"| {row['id']} | `make {name}` | [`{row['program']}`](src/{row['program']}.cpp)"
                     f" | {row['caption']} |")
    return lines


def digits(value, error):
    """A number with the digits that its error supports and one more, at most six."""
    if value == 0:
        return "0"
    places = 6 if error == 0 else min(6, max(1, math.ceil(math.log10(abs(value) / error)) + 1))
    return f"{value:.{places}g}"


def published_table():
    lines = ["| claim | article | here | error | verdict |", "|---|---|---|---|---|"]
    for row in rows("build/report/published.ecsv"):
        if row["verdict"] == "open":
            continue
        value, error = float(row["reproduced"]), float(row["error"])
        statement = row["verdict"] == "claim" or row["unit"] == "claim"
        here = ("holds" if value == 1 else "does not hold") if statement else digits(value, error)
        bar = "" if statement else f"{error:.0e}"
        lines.append(f"| `{row['id']}` | {row['published']} | {here} | {bar} | {row['verdict']} |")
    return lines


def costs():
    total = 0
    lines = ["| program | seconds |", "|---|---|"]
    for path in sorted(pathlib.Path("build/report/cost").iterdir()):
        seconds = float(path.read_text())
        total += seconds
        lines.append(f"| `{path.name}` | {seconds:.0f} |" if seconds >= 1 else f"| `{path.name}` | < 1 |")
    return lines + [f"| together | {total:.0f} |"]


def main():
    readme = pathlib.Path("README.md")
    text = readme.read_text(encoding="utf8")
    for name, make in [("figures", figure_table), ("published", published_table), ("costs", costs)]:
        block = "\n".join([f"<!-- {name} -->", *make(), f"<!-- /{name} -->"])
        text, count = re.subn(f"<!-- {name} -->.*?<!-- /{name} -->", lambda _: block, text, flags=re.S)
        if count != 1:
            raise SystemExit(f"README.md: no place for the table '{name}'")
    readme.write_text(text, encoding="utf8")


main()
