"""Figure x21: exact travelling breathers in soft and hard wells, and the packet that turns at s = 1."""

import matplotlib.pyplot as plt
import numpy as np

import draw

data, out = draw.arguments()
folder = f"{data}/sec5_travelling_families"
branches = draw.read(f"{folder}/branches.ecsv")
exact = draw.read(f"{folder}/exact_at_one.ecsv")
packet = draw.read(f"{folder}/packet_at_one.ecsv")

figure, (a, b) = plt.subplots(1, 2, figsize=(draw.TWO_COLUMNS, 75 * draw.MM), layout="constrained")
colours = {1: "#0072B2", 2: "#D55E00", 3: "#009E73", 4: "#E69F00", 6: "#CC79A7"}
dashes = {1: "-", 2: "--", 3: "-.", 4: ":", 6: (0, (5, 1, 1, 1, 1, 1))}
for k in np.unique(branches["k"]):
    for direction in (1, -1):
        way = draw.where(draw.where(branches, "k", k), "direction", direction)
        a.plot(way["s"], way["turns"], ls=dashes[int(k)], color=colours[int(k)], lw=1.1,
               label=f"$k={int(k)}$" if direction > 0 else None)
a.axvline(0, color="#888888", lw=0.5)
a.set(xlabel="anharmonicity $s$", ylabel=r"shift time $T/2\pi$", xlim=(-1, 3), ylim=(0.5, 6.3))
a.legend(loc="center right", fontsize=7)

moving = packet["speed"] > 1e-4
b.loglog(packet["speed"][moving], packet["energy"][moving], "-", color="black", lw=1,
         label="packet, $v_0=1.9$")
b.loglog(exact["speed"], exact["energy"], "o", ms=4, mfc="none", color="#0072B2", label="exact orbits")
b.set(xlabel="speed (sites per unit of time)", ylabel="energy")
b.legend(loc="center left", fontsize=7)
draw.letter(a, "a")
draw.letter(b, "b")
draw.save(figure, out)
