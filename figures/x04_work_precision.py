"""Figure x04: error against processor time and against force evaluations.

Holds timings, so `make bench` draws it and figures.ecsv does not list it.
"""

import draw
import matplotlib.pyplot as plt
import numpy as np

data, out = draw.arguments()
rows = draw.ecsv.read(f"{data}/work_precision.ecsv").rows

impact = [("contact-aware", "#D55E00", "o-"), ("verlet, window", "#888888", "v-"),
          ("blanes-moan-4, window", "#56B4E9", "^-"), ("blanes-moan-6, window", "#0072B2", "s-"),
          ("GSL rk8pd", "#009E73", "D--"), ("GSL rkf45", "#E69F00", "x--"),
          ("Boost dopri5", "#CC79A7", "+--"), ("Boost bulirsch_stoer", "#000000", "*--"),
          ("Boost sb3a_mclachlan", "#000000", "1:"), ("Boost velocity_verlet", "#888888", "2:")]
monodromy = [("event location", "#D55E00", "o-"), ("GSL rk8pd, tridiagonal", "#009E73", "D--"),
             ("GSL rkf45, tridiagonal", "#E69F00", "x--")]
panels = [("B1", "energy_error", "relative energy error", impact),
          ("B1", "solution_error", "displacement error at $t=100$", impact),
          ("M, N=31", "tangent_error", "error of the monodromy matrix", monodromy)]

figure, grid = plt.subplots(3, 3, figsize=(draw.TWO_COLUMNS, 140 * draw.MM),
                            height_ratios=[1, 1, 0.3])
for line, (cost, label) in enumerate([("cpu_seconds", "processor time (s)"),
                                      ("evaluations", "force evaluations")]):
    for axes, (problem, error, title, methods), name in zip(grid[line], panels, "abcdef"[3 * line:]):
        for method, colour, style in methods:
            points = [(float(r[cost]), float(r[error])) for r in rows
                      if r["problem"] == problem and r["method"] == method]
            points = [p for p in points if 0 < p[1] < 1]
            if points:
                axes.loglog(*zip(*points), style, color=colour, ms=2.5, lw=0.8, mew=0.6, label=method)
        axes.set(xlabel=label, ylabel=title)
        if cost == "evaluations" and problem == "B1":
            low, high = axes.get_xlim()
            x = np.array([high / 30, high])
            axes.loglog(x, 3e-6 * (x / x[0]) ** -2.5, color="black", lw=0.7, ls=(0, (1, 1)))
            axes.text(x[1], 3e-6 * 30**-2.5, "order 2.5", ha="right", va="top", fontsize=7)
        draw.letter(axes, name)
for axes in grid[2]:
    axes.axis("off")
handles, names = grid[0, 0].get_legend_handles_labels()
for axes, part in [(grid[2, 0], slice(0, 5)), (grid[2, 1], slice(5, None))]:
    axes.legend(handles[part], names[part], loc="upper center", fontsize=6.5)
grid[2, 2].legend(*grid[0, 2].get_legend_handles_labels(), loc="upper center", fontsize=6.5)
draw.save(figure, out)
