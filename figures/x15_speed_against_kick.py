"""Figure x15: mean speed against kick."""

import draw
import matplotlib.pyplot as plt

data, out = draw.arguments()


def rows(name):
    """The rows of a table with texts in it."""
    return draw.records(f"{data}/sec33_mobility/{name}.ecsv")


def column(table, name):
    return [float(row[name]) for row in table]


figure, axes = plt.subplots(figsize=(draw.ONE_COLUMN, 70 * draw.MM))
for centre, color, mark, dash in [("site", "#D55E00", "s", "--"),
                                  ("bond_stretched", "#0072B2", "o", "-")]:
    table = [row for row in rows("speeds") if row["centre"] == centre]
    c = column(table, "c")
    axes.loglog(c, column(table, "pendulum"), dash, color=color, lw=0.9)
    axes.loglog(c, column(table, "speed"), mark, color=color, ms=4, mfc="white",
                label=centre.replace("_stretched", ""))
axes.plot([], [], "-", color="black", lw=0.9, label="pendulum")
threshold, = [float(row["threshold"]) for row in rows("thresholds") if row["breather"] == "bond_stretched"]
axes.axvline(threshold, color="#0072B2", lw=0.8, ls=(0, (1, 1)),
             label="threshold")
axes.axvline(6.19e-6, color="#888888", lw=0.8, ls=(0, (5, 2)), label="printed threshold")
axes.set(xlabel="size $c$ of the kick", ylabel="mean speed (sites per unit of time)")
axes.legend(loc="lower right")
draw.save(figure, out)
