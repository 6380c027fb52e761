"""The gallery of the README: figures small enough to be committed.

A picture is out of date when it looks different from today's figure: the fonts and rounding of another machine move
edges, so that bytes may differ where nothing has changed. Hence small patches are compared by their mean colour, and
one that differs by more than a tenth of the scale is a change. A picture may have BUDGET bytes on the average."""

import io
import subprocess
from pathlib import Path

from . import ecsv
from .refresh import read_figures

WIDTH, COLOURS, PATCH, CHANGE, BUDGET = 340, 160, 12, 255 // 10, 9_000


def small(svg):
    """The figure WIDTH pixels wide on white."""
    from PIL import Image
    command = ["rsvg-convert", "--width", str(WIDTH), "--keep-aspect-ratio", str(svg)]
    try:
        png = subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout
    except (OSError, subprocess.CalledProcessError) as error:
        raise ecsv.Fault(f"{svg}: cannot be drawn ({error})") from None
    image = Image.open(io.BytesIO(png)).convert("RGBA")
    return Image.alpha_composite(Image.new("RGBA", image.size, "white"), image).convert("RGB")


def difference(a, b):
    """Largest difference of the mean colours of patches, 0 to 255; 255 where the shapes differ."""
    from PIL import Image, ImageChops
    if abs(a.size[0] - b.size[0]) > 2 or abs(a.size[1] - b.size[1]) > 6:
        return 255
    patches = (max(1, a.size[0] // PATCH), max(1, a.size[1] // PATCH))
    a, b = (image.convert("RGB").resize(patches, Image.BOX) for image in (a, b))
    return max(high for _, high in ImageChops.difference(a, b).getextrema())


def draw(names, source, gallery):
    """Draws the pictures that are missing or older than their figure, and no other, and removes those of no figure."""
    from PIL import Image
    gallery.mkdir(parents=True, exist_ok=True)
    for old in gallery.glob("*.png"):
        if old.stem not in names:
            old.unlink()
    for name in names:
        svg, png = source / f"{name}.svg", gallery / f"{name}.png"
        if not png.exists() or svg.exists() and svg.stat().st_mtime > png.stat().st_mtime:
            small(svg).quantize(COLOURS, Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE).save(png, optimize=True)


def faults(names, source, gallery):
    """What is wrong with the gallery, a line each."""
    from PIL import Image
    out = [f"{old.name}: no such figure" for old in sorted(gallery.glob("*.png")) if old.stem not in names]
    for name in names:
        path = gallery / f"{name}.png"
        if not path.exists():
            out.append(f"{name}: missing")
            continue
        change = difference(Image.open(path), small(source / f"{name}.svg"))
        if change > CHANGE:
            out.append(f"{name}: a patch differs by {change} of 255 (allowed {CHANGE})")
    return out + too_large(names, gallery)


def too_large(names, gallery):
    size, allowed = sum(path.stat().st_size for path in gallery.glob("*.png")), BUDGET * len(names)
    return [f"{size} bytes together (allowed {allowed})"] if size > allowed else []


def renew(root, figures):
    """The verb."""
    gallery, names = Path(root) / "figures/gallery", [Path(figure["script"]).stem for figure in read_figures(root).values()]
    draw(names, Path(figures), gallery)
    if wrong := too_large(names, gallery):
        raise ecsv.Fault(f"{gallery}: {wrong[0]}")
