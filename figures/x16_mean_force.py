"""Figure x16: mean contact forces and a localized state, without and with wells."""

import draw
import matplotlib.pyplot as plt

data, out = draw.arguments()
folder = f"{data}/sec2_nonexistence"
means = draw.read(f"{folder}/mean_forces.ecsv")
dispersal = draw.read(f"{folder}/dispersal.ecsv")

figure, grid = plt.subplot_mosaic([["a", "b"], ["c", "d"]],
                                  figsize=(draw.TWO_COLUMNS, 110 * draw.MM))
free, wells, core, mean = (grid[name] for name in "abcd")
for name, mark, label in [("uneven_ring", "s--", r"uneven ring, $\alpha = 3/2$"),
                          ("walls", "^:", r"walls, $\alpha = 2$")]:
    motion = draw.where(means, "motion", name)
    free.plot(motion["n"], motion["force"], mark, ms=3.5, mfc="white", mew=0.8,
              lw=0.8, label=label)
free.set(xlabel="contact $n$", ylabel=r"mean contact force $\bar F_n$", xticks=range(1, 9))
free.set_ylim(0, 0.17)
free.legend(loc="upper left", handlelength=2, labelspacing=0.3)
for name, centre, mark, color, label in [("breather_bond", 12, "o-", "#0072B2", "bond-centred"),
                                         ("breather_site", 12.5, "s--", "#D55E00", "site-centred")]:
    motion = draw.where(means, "motion", name)
    wells.plot(motion["n"] - centre, motion["force"], mark, ms=3.5, mfc="white",
               mew=0.8, lw=0.8, color=color, label=label)
wells.set(xlabel="contact, from the centre", ylabel=r"mean contact force $\bar F_n$", xlim=(-7, 7))
wells.set_ylim(0, 0.22)
wells.legend(loc="upper left", handlelength=2, labelspacing=0.3)
for name, style, color, label in [("breather", "-", "#0072B2", "free chain"),
                                  ("breather_in_wells", "--", "#D55E00", "in wells")]:
    part = draw.where(dispersal, "motion", name)
    core.plot(part["t"], part["core"], style, color=color, label=label)
    mean.plot(part["t"], part["mean"], style, color=color, label=label)
core.set(xlabel="time $t$", ylabel="fraction of energy on nine sites", xscale="log", yscale="log")
mean.set(xlabel="time $t$", ylabel=r"mean force from 0 to $t$", xscale="log", yscale="log")
core.legend(loc="lower left")
mean.legend(loc="lower left")
for name, axes in grid.items():
    axes.set_title(f"({name})", loc="left", pad=3)
draw.save(figure, out)
