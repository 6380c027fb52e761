"""Figure x20: all exact travelling breathers found at s = 0, with the families on which they lie."""

import draw
import matplotlib.pyplot as plt
import numpy as np

data, out = draw.arguments()
folder = f"{data}/sec5_travelling_families"
orbits = draw.read(f"{folder}/orbits.ecsv")
families = draw.read(f"{folder}/left_behind.ecsv")

figure, a = plt.subplots(figsize=(draw.ONE_COLUMN, 75 * draw.MM), layout="constrained")
for k in np.unique(families["k"]):
    family = draw.where(draw.where(families, "k", k), "sign", 1)
    a.semilogy(family["turns"], family["energy"], ":", color="#888888", lw=0.8,
               label="family" if k == 1 else None)
for kind, colour, name in ((1, "#0072B2", "type I"), (2, "#D55E00", "type II")):
    for sign, mark, size, sign_name in ((1, "+", 6, "+"), (-1, "o", 7, "−")):
        part = draw.where(draw.where(orbits, "type", kind), "sign", sign)
        a.semilogy(part["turns"], part["energy"], mark, ms=size, mew=0.9, mfc="none", color=colour,
                   label=f"{name}, {sign_name}")
a.set(xlabel=r"shift time $T/2\pi$", ylabel="energy", xlim=(0.6, 6.4), ylim=(1e-5, 1e2))
a.legend(loc="upper right", fontsize=7)
draw.save(figure, out)
