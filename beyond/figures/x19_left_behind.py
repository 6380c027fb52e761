"""Figure x19: what travelling breathers leave behind against their shift time, and where nothing."""

import draw
import matplotlib.pyplot as plt

data, out = draw.arguments()
folder = f"{data}/sec5_travelling_families"
table = draw.read(f"{folder}/left_behind.ecsv")
orbits = draw.read(f"{folder}/orbits.ecsv")

figure, (a, b) = plt.subplots(1, 2, figsize=(draw.TWO_COLUMNS, 70 * draw.MM), layout="constrained")
for axes, k, low in ((a, 1, 0.7), (b, 2, 1.5)):
    family = draw.where(draw.where(table, "k", k), "sign", 1)
    axes.plot(family["turns"], family["log_tail"], "-", color="#0072B2", lw=1,
              label=r"$|1-e^{-iT}|\,|Z|$")
    axes.plot(family["turns"], family["log_pulse"], "--", color="#D55E00", lw=1,
              label=r"$|1-e^{-iT}|\,|\int e^{it}f_0\,dt|$")
    axes.plot(family["turns"], family["log_beads"], "o", ms=3, mfc="none", mew=0.7, color="black",
              label="beads left behind")
    exact = draw.where(draw.where(orbits, "k", k), "sign", 1)
    for kind, mark, name in ((1, "^", "type I"), (2, "v", "type II")):
        found = draw.where(exact, "type", kind)
        inside = found["turns"] >= low
        axes.plot(found["turns"][inside], [-9.1] * int(inside.sum()), mark, ms=5, color="#009E73",
                  mfc="#009E73" if kind == 1 else "none", label=name, clip_on=False)
    axes.set(xlabel=r"shift time $T/2\pi$", xlim=(low, k + 0.01), ylim=(-9.5, -2))
a.set_ylabel(r"$\log_{10}$ of the tail over the amplitude")
a.legend(loc="lower left", bbox_to_anchor=(0, 0.07), fontsize=6.5)
draw.letter(a, "a")
draw.letter(b, "b")
draw.save(figure, out)
