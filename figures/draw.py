"""What the matplotlib figures share: reading tables by column name, sizes, panel letters.

A script is called with the folder of all tables and the SVG file to write; it computes nothing
beyond scaling. It imports this file first, which says what is missing.
"""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1] / "tools"))
from lineage import ecsv, lacking  # noqa: E402

try:
    import matplotlib.pyplot as plt
    import numpy as np
except ModuleNotFoundError as error:
    sys.exit(f"figures: {lacking(error)}")

MM = 1 / 25.4
ONE_COLUMN, TWO_COLUMNS = 85 * MM, 170 * MM


def arguments():
    """The folder of all tables and the file to write."""
    data, out = sys.argv[1:3]
    return data, out


def read(path):
    """The columns of a table, by name, as arrays; ends the script unless it is what its program wrote."""
    try:
        table = ecsv.read_written(path)
    except ecsv.Fault as fault:
        sys.exit(str(fault))
    return {c.name: np.array([row[c.name] for row in table.rows], dtype=str if c.kind == "string" else float) for c in table.columns}


def grid(table, x, y, value):
    """A long table as an image: values[y, x] and the extent for `imshow`."""
    xs, ys = np.unique(table[x]), np.unique(table[y])
    image = np.full((len(ys), len(xs)), np.nan)
    image[np.searchsorted(ys, table[y]), np.searchsorted(xs, table[x])] = table[value]
    dx, dy = (xs[1] - xs[0]) / 2, (ys[1] - ys[0]) / 2
    return image, (xs[0] - dx, xs[-1] + dx, ys[0] - dy, ys[-1] + dy)


def image(axes, table, x, y, value, norm, scale=1, **more):
    """Shows a long table as an image; returns it, for a colour bar."""
    values, extent = grid(table, x, y, value)
    return axes.imshow(scale * values, extent=extent, origin="lower", aspect="auto", norm=norm, interpolation="none", **more)


def where(table, column, value):
    """The rows in which `column` has `value`."""
    keep = table[column] == value if isinstance(value, str) else np.isclose(table[column], value)
    return {name: entries[keep] for name, entries in table.items()}


def letter(axes, text, color="black", x=0.03):
    """A panel letter in the upper left corner; with x > 0.5 in the right one."""
    axes.text(x, 0.97, f"({text})", transform=axes.transAxes, va="top", color=color,
              ha="right" if x > 0.5 else "left")


def save(figure, out):
    """Writes the SVG without a date, so that equal data give equal bytes."""
    figure.savefig(out, format="svg", metadata={"Date": None, "Creator": None})
    plt.close(figure)
