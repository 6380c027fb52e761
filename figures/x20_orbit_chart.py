"""Figure x20: all exact travelling breathers found at s = 0, and their limit of small amplitude."""

import matplotlib.pyplot as plt
import numpy as np

import draw

data, out = draw.arguments()
folder = f"{data}/sec5_travelling_families"
orbits = draw.read(f"{folder}/orbits.ecsv")
families = draw.read(f"{folder}/left_behind.ecsv")

figure, (a, b) = plt.subplots(1, 2, figsize=(draw.TWO_COLUMNS, 75 * draw.MM), layout="constrained")
for k in np.unique(families["k"]):
    family = draw.where(draw.where(families, "k", k), "sign", 1)
    a.semilogy(family["turns"], family["energy"], ":", color="#888888", lw=0.8,
               label="family" if k == 1 else None)
for kind, colour, name in ((1, "#0072B2", "type I"), (2, "#D55E00", "type II")):
    for sign, mark, size, sign_name in ((1, "+", 6, "+"), (-1, "_", 6, "−")):
        part = draw.where(draw.where(orbits, "type", kind), "sign", sign)
        a.semilogy(part["turns"], part["energy"], mark, ms=size, mew=1.2, color=colour,
                   label=f"{name}, {sign_name}")
a.set(xlabel=r"shift time $T/2\pi$", ylabel="energy", xlim=(0.6, 6.4), ylim=(1e-5, 1e2))
a.legend(loc="upper right", fontsize=7)

one = draw.where(draw.where(orbits, "type", 1), "sign", 1)
b.plot(one["inverse_k"], one["scaled_energy"], "o", ms=3.5, mfc="none", mew=0.8, color="#0072B2",
       label=r"$E/c^4$ of type I")
b.set(xlabel=r"$2\pi/T = 1/k$", ylabel=r"$E/c^4$", xlim=(0, 1.05), ylim=(50, 300))
b.legend(loc="lower right")
draw.letter(a, "a")
draw.letter(b, "b")
draw.save(figure, out)
