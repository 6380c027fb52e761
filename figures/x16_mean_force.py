"""Figure x16: mean contact forces, searches and a localized state, without and with wells."""

import csv

import matplotlib.pyplot as plt
import numpy as np

import draw

data, out = draw.arguments()


def texts(path):
    """The columns of a table with words in it, as lists of text."""
    with open(path, encoding="utf8") as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))
    return {name: [row[i] for row in rows[1:]] for i, name in enumerate(rows[0])}


means = texts(f"{data}/sec2_nonexistence/mean_forces.ecsv")


def motion(name, column):
    """One column of one motion, as numbers."""
    return np.array([float(x) for x, m in zip(means[column], means["motion"]) if m == name])


figure, grid = plt.subplot_mosaic([["a", "a", "b", "b", "c", "c"], ["d", "d", "d", "e", "e", "e"]],
                                  figsize=(draw.TWO_COLUMNS, 112 * draw.MM), height_ratios=[1.2, 1])
free, wells, ends, core, mean = (grid[name] for name in "abcde")
for name, mark, label in [("ring_wave", "o-", "wave on a ring"),
                          ("uneven_ring", "s--", "uneven ring"),
                          ("walls", "^:", r"uneven, walls, $\alpha = 2$"),
                          ("mixed_exponents", "v-.", r"walls, mixed $\alpha_n$")]:
    free.plot(motion(name, "n"), motion(name, "force"), mark, ms=3.5, mfc="white", mew=0.8,
              lw=0.8, label=label)
free.set(xlabel="contact $n$", ylabel=r"mean contact force $\bar F_n$", ylim=(0, None))
free.set_ylim(0, 1.75 * free.get_ylim()[1])
free.legend(loc="upper right", handlelength=2.2)
name = "breather_bond"
n = motion(name, "n") - 12
wells.plot(n, motion(name, "force"), "o-", ms=3, color="#0072B2", label=r"$\bar F_n$")
wells.plot(n + 0.5, motion(name, "step"), "s", ms=5, mfc="none", mew=0.8, color="#D55E00",
           label=r"$\bar F_{n-1} - \bar F_n$")
wells.plot(n + 0.5, motion(name, "well"), ".", ms=3, color="black", label="mean force of the well")
wells.set(xlabel="contact, from the centre", ylabel="mean force", xlim=(-7, 7))
wells.set_ylim(None, 1.6 * wells.get_ylim()[1])
wells.legend(loc="upper right", handlelength=1.2)
found = texts(f"{data}/sec2_nonexistence/searches.ecsv")
place = np.arange(len(found["ends_in"]))
for shift, column, color, hatch, label in [(-0.2, "free_fine", "#56B4E9", "", "free chain"),
                                           (0.2, "wells_fine", "#D55E00", "///", "in wells")]:
    counts = [int(x) for x in found[column]]
    bars = ends.bar(place + shift, counts, 0.4, color=color, hatch=hatch, ec="black", lw=0.5,
                    label=label)
    ends.bar_label(bars, fontsize=7, padding=1)
ends.set_xticks(place, found["ends_in"], rotation=35, ha="right")
ends.set(ylabel="searches")
ends.set_ylim(0, 1.15 * ends.get_ylim()[1])
ends.legend(loc="upper right", handlelength=1.2)
with open(f"{data}/sec2_nonexistence/dispersal.ecsv", encoding="utf8") as file:
    rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
for chain, style, color, label in [("free", "-", "#0072B2", "free chain"),
                                   ("wells", "--", "#D55E00", "in wells")]:
    part = {key: np.array([float(r[key]) for r in rows if r["chain"] == chain and float(r["t"]) > 0])
            for key in ("t", "core", "mean")}
    core.plot(part["t"], part["core"], style, color=color, label=label)
    mean.plot(part["t"], part["mean"], style, color=color, label=label)
core.set(xlabel="time $t$", ylabel="share of energy in the core", xscale="log", yscale="log")
mean.set(xlabel="time $t$", ylabel=r"mean force from 0 to $t$", xscale="log", yscale="log")
core.legend(loc="lower left")
mean.legend(loc="lower left")
for name, axes in grid.items():
    axes.set_title(f"({name})", loc="left", pad=3)
draw.save(figure, out)
