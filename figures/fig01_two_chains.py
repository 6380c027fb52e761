"""Figure 01: the two chains. Sizes are those of the table; displacements are amplified."""

import draw
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Circle, Polygon, Rectangle

data, out = draw.arguments()
sizes = draw.read(f"{data}/sec35_scales/schematic.ecsv")
size = {(id, name): value for id, name, value in zip(sizes["id"], sizes["parameter"], sizes["value"])}
BEAD, BEAM, WALL, LINE = "#56B4E9", "#E69F00", "#BBBBBB", "black"
LIFT = 0.5  # angle at which the first bead of the cradle is drawn

figure, (cradle, array) = plt.subplots(1, 2, figsize=(draw.TWO_COLUMNS, 64 * draw.MM),
                                       gridspec_kw={"width_ratios": [1, 1.35]})


def wall(axes, left, bottom, width, height):
    axes.add_patch(Rectangle((left, bottom), width, height, fc=WALL, ec="#666666", lw=0.6,
                             hatch="////"))


def bead(axes, x, y, radius):
    axes.add_patch(Circle((x, y), radius, fc=BEAD, ec=LINE, lw=0.7, zorder=3))


def measure(axes, start, end, text, offset, **place):
    axes.annotate("", end, start, arrowprops={"arrowstyle": "<->", "lw": 0.7, "shrinkA": 0,
                                              "shrinkB": 0}, zorder=4)
    middle = (np.array(start) + np.array(end)) / 2 + np.array(offset)
    axes.text(*middle, text, zorder=4, **place)


# Left: beads on strings. The first one has been lifted.
string = size["cradle", "string_length"]
radius = size["cradle", "bead_radius_drawn"]
count = int(size["cradle", "beads_drawn"])
wall(cradle, -radius * 2.2, 0, 2 * radius * (count + 1.2), 0.06)
for n in range(count):
    angle = -LIFT if n == 0 else 0.0
    pivot = 2 * radius * n
    x, y = pivot + string * np.sin(angle), -string * np.cos(angle)
    cradle.plot([pivot, x], [0, y], color=LINE, lw=0.8, zorder=2)
    bead(cradle, x, y, radius)
cradle.plot([0, 0], [0, -string], color="#888888", lw=0.7, ls="--", zorder=1)
right = 2 * radius * (count - 1)
measure(cradle, (right + 1.6 * radius, 0), (right + 1.6 * radius, -string),
        f"{string:g} m", (0.02, 0), va="center")
lifted = (-string * np.sin(LIFT) + radius, -string * np.cos(LIFT))
measure(cradle, lifted, (0, lifted[1]), "$y_1$", (0, 0.02), ha="center")
for n in range(1, count):
    cradle.text(2 * radius * n, -string - 2.1 * radius, f"{n + 1}", ha="center")
cradle.set(xlim=(-0.32, 0.5), ylim=(-0.63, 0.1))

# Right: beams clamped at both ends, a bead at either side of each; millimetres.
length, thickness, radius, pitch = (1e3 * size["cantilever", name] for name in
                                    ["length", "thickness", "bead_radius", "pitch"])
count = int(size["cantilever", "cantilevers_drawn"])
deflection = np.linspace(-2, 2, count)
height = np.linspace(0, length, 101)
shape = (1 - np.cos(2 * np.pi * height / length)) / 2
for bottom in (-2, length):
    wall(array, -pitch * 0.7, bottom, pitch * (count + 0.4), 2)
for n in range(count):
    centre = pitch * n + deflection[n] * shape
    array.add_patch(Polygon(np.concatenate([
        np.column_stack([centre - thickness / 2, height]),
        np.column_stack([centre + thickness / 2, height])[::-1]]), fc=BEAM, ec=LINE, lw=0.6,
        zorder=2))
    for side in (-1, 1):
        bead(array, pitch * n + deflection[n] + side * (thickness / 2 + radius), length / 2, radius)
    array.text(pitch * n, -4.6, f"{n + 1}", ha="center")
edge = pitch * (count - 1) + 0.9 * pitch
measure(array, (edge, 0), (edge, length), rf"$\ell = {length:g}$ mm", (0.7, 0), va="center")
rest = pitch * (count // 2)
measure(array, (rest - pitch, length + 3.4), (rest, length + 3.4), f"{pitch:g} mm", (0, 0.7),
        ha="center")
array.annotate(f"$R =$\n{radius:g} mm", (rest + thickness / 2 + radius, length / 2 - radius),
               (rest + 0.9, 1.2), fontsize=7, arrowprops={"arrowstyle": "-", "lw": 0.6, "shrinkB": 0},
               zorder=4)
array.annotate(f"$h =$\n{thickness:g} mm", (-thickness / 2, length * 0.94),
               (-0.8 * pitch, length * 0.74), fontsize=7,
               arrowprops={"arrowstyle": "-", "lw": 0.6, "shrinkB": 0}, zorder=4)
array.set(xlim=(-pitch * 0.85, edge + 11), ylim=(-6, length + 6))

for axes, name in [(cradle, "a"), (array, "b")]:
    axes.set_aspect("equal")
    axes.axis("off")
    axes.text(0.0, 1.0, f"({name})", transform=axes.transAxes, va="top")
draw.save(figure, out)
