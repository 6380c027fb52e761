"""Figure x15: mean speed against kick."""

import draw
import matplotlib.pyplot as plt

data, out = draw.arguments()


def rows(name):
    """The rows of a table with texts in it."""
    return draw.records(f"{data}/sec33_mobility/{name}.ecsv")


def column(table, name):
    return [float(row[name]) for row in table]


figure, (axes, below) = plt.subplots(2, 1, sharex=True, figsize=(draw.ONE_COLUMN, 88 * draw.MM),
                                     height_ratios=[3, 1])
for centre, color, mark in [("site", "#D55E00", "s"), ("bond_stretched", "#0072B2", "o")]:
    table = [row for row in rows("speeds") if row["centre"] == centre]
    c, speed, pendulum = (column(table, name) for name in ("c", "speed", "pendulum"))
    axes.loglog(c, pendulum, "x", color=color, ms=7, mew=0.7)
    axes.loglog(c, speed, mark, color=color, ms=4, mfc="white", label=centre.replace("_stretched", ""))
    below.errorbar(c, [1e4 * (v / p - 1) for v, p in zip(speed, pendulum)],
                   [1e4 * e / p for e, p in zip(column(table, "speed_error"), pendulum)],
                   fmt=mark, color=color, ms=3, mfc="white", elinewidth=0.7)
axes.plot([], [], "x", color="black", ms=7, mew=0.7, label="pendulum")
threshold, = [float(row["threshold"]) for row in rows("thresholds") if row["breather"] == "bond_stretched"]
axes.axvline(threshold, color="#0072B2", lw=0.8, ls=(0, (1, 1)),
             label="threshold")
axes.axvline(6.19e-6, color="#888888", lw=0.8, ls=(0, (5, 2)), label="printed threshold")
axes.set(ylabel="mean speed (sites per unit of time)")
axes.legend(loc="lower right")
below.axhline(0, color="black", lw=0.5)
below.set(xlabel="size $c$ of the kick", ylabel="diff. ($10^{-4}$)", ylim=(-3, 3))
draw.save(figure, out)
