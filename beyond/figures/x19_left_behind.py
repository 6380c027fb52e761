"""Figure x19: what travelling breathers leave behind against their shift time, and all exact ones found."""

import draw
import matplotlib.pyplot as plt
import numpy as np

data, out = draw.arguments()
folder = f"{data}/sec5_travelling_breathers"
table = draw.read(f"{folder}/left_behind.ecsv")
orbits = draw.read(f"{folder}/orbits.ecsv")

figure, (a, b) = plt.subplots(1, 2, figsize=(draw.TWO_COLUMNS, 70 * draw.MM), layout="constrained")
family = draw.where(draw.where(table, "k", 1), "sign", 1)
a.plot(family["turns"], family["log_tail"], "-", color="#0072B2", lw=1, label=r"$|1-e^{-iT}|\,|Z|$")
a.plot(family["turns"], family["log_beads"], "o", ms=3, mfc="none", mew=0.7, color="black",
       label="beads left behind")
exact = draw.where(draw.where(orbits, "k", 1), "sign", 1)
for kind, mark, colour, name in ((1, "^", "#0072B2", "type I"), (2, "v", "#D55E00", "type II")):
    found = draw.where(exact, "type", kind)
    a.plot(found["turns"], [-9.1] * len(found["turns"]), mark, ms=5, color=colour,
           mfc=colour if kind == 1 else "none", label=name, clip_on=False)
a.set(xlabel=r"shift time $T/2\pi$", xlim=(0.7, 1.01), ylim=(-9.5, -2),
      ylabel=r"$\log_{10}$ of the tail over the amplitude")
a.legend(loc="lower left", bbox_to_anchor=(0, 0.07), fontsize=6.5)
for k in np.unique(table["k"]):
    family = draw.where(draw.where(table, "k", k), "sign", 1)
    b.semilogy(family["turns"], family["energy"], ":", color="#888888", lw=0.8,
               label="family" if k == 1 else None)
for kind, colour, name in ((1, "#0072B2", "type I"), (2, "#D55E00", "type II")):
    for sign, mark, size, sign_name in ((1, "+", 6, "+"), (-1, "o", 7, "−")):
        part = draw.where(draw.where(orbits, "type", kind), "sign", sign)
        b.semilogy(part["turns"], part["energy"], mark, ms=size, mew=0.9, mfc="none", color=colour,
                   label=f"{name}, {sign_name}")
b.set(xlabel=r"shift time $T/2\pi$", ylabel="energy", xlim=(0.6, 6.4), ylim=(1e-5, 1e3))
b.legend(loc="upper right", fontsize=7)
draw.letter(a, "a")
draw.letter(b, "b")
draw.save(figure, out)
