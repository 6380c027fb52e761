#!/usr/bin/env python3
"""The gallery of the README: figures small enough to be committed.

  gallery.py FIGURES GALLERY           draw GALLERY/<figure>.png from FIGURES/<figure>.svg
  gallery.py FIGURES GALLERY --check   say which are missing, superfluous or out of date

A picture is out of date when it looks different from today's figure: the fonts and rounding of
another machine move edges, so that bytes may differ where nothing has changed. Hence small patches
are compared by their mean colour, and one that differs by more than a tenth of the scale is a change.
"""

import csv
import io
import pathlib
import subprocess
import sys

from PIL import Image, ImageChops

WIDTH, COLOURS, PATCH, CHANGE, BUDGET = 340, 160, 12, 255 // 10, 400_000


def figures(index):
    """Names of the scripts without their ending, in the order of figures.ecsv."""
    rows = csv.DictReader(line for line in open(index, encoding="utf-8") if line[0] != "#")
    return [pathlib.Path(row["script"]).stem for row in rows]


def small(svg):
    """The figure WIDTH pixels wide on white, with few colours."""
    command = ["rsvg-convert", "--width", str(WIDTH), "--keep-aspect-ratio", str(svg)]
    png = subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout
    image = Image.open(io.BytesIO(png)).convert("RGBA")
    white = Image.new("RGBA", image.size, "white")
    return Image.alpha_composite(white, image).convert("RGB")


def difference(a, b):
    """Largest difference of the mean colours of patches, 0 to 255; 255 where the shapes differ."""
    if abs(a.size[0] - b.size[0]) > 2 or abs(a.size[1] - b.size[1]) > 6:
        return 255
    patches = (max(1, a.size[0] // PATCH), max(1, a.size[1] // PATCH))
    a, b = (image.convert("RGB").resize(patches, Image.BOX) for image in (a, b))
    return max(high for low, high in ImageChops.difference(a, b).getextrema())


def draw(names, source, gallery):
    gallery.mkdir(parents=True, exist_ok=True)
    for old in gallery.glob("*.png"):
        if old.stem not in names:
            old.unlink()
    for name in names:
        image = small(source / f"{name}.svg").quantize(COLOURS, Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE)
        image.save(gallery / f"{name}.png", optimize=True)


def faults(names, source, gallery):
    """What is wrong with the gallery, a line each."""
    out = [f"{old.name}: no such figure" for old in sorted(gallery.glob("*.png"))
           if old.stem not in names]
    for name in names:
        path = gallery / f"{name}.png"
        if not path.exists():
            out.append(f"{name}: missing")
            continue
        change = difference(Image.open(path), small(source / f"{name}.svg"))
        if change > CHANGE:
            out.append(f"{name}: a patch differs by {change} of 255 (allowed {CHANGE})")
    size = sum(path.stat().st_size for path in gallery.glob("*.png"))
    if size > BUDGET:
        out.append(f"{size} bytes together (allowed {BUDGET})")
    return out


def main(arguments):
    if len(arguments) not in (2, 3) or arguments[2:] not in ([], ["--check"]):
        sys.exit(__doc__)
    source, gallery = pathlib.Path(arguments[0]), pathlib.Path(arguments[1])
    names = figures(pathlib.Path(__file__).resolve().parent.parent / "figures" / "figures.ecsv")
    if len(arguments) == 2:
        draw(names, source, gallery)
    wrong = faults(names, source, gallery)
    for line in wrong:
        print(f"  gallery  {line}")
    if wrong:
        sys.exit("the gallery is not current (make gallery)")


if __name__ == "__main__":
    main(sys.argv[1:])
