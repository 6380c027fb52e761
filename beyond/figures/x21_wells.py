"""Figure x21: exact travelling breathers in soft and hard wells, and the packet that turns at s = 1."""

import draw
import matplotlib.pyplot as plt

data, out = draw.arguments()
folder = f"{data}/sec5_travelling_families"
branches = draw.read(f"{folder}/branches.ecsv")
exact = draw.read(f"{folder}/exact_at_one.ecsv")
packet = draw.read(f"{folder}/packet_at_one.ecsv")

figure, axes = plt.subplots(1, 4, figsize=(draw.TWO_COLUMNS, 65 * draw.MM), layout="constrained",
                            width_ratios=[1, 1, 1, 1.2])
bounds = {1: (-0.03, 0.02, 0.86, 1.012), 2: (-0.15, 0.4, 1.65, 2.015), 3: (-0.5, 2.1, 2.78, 3.015)}
for panel, (k, (left, right, low, high)) in zip(axes, bounds.items()):
    for direction in (1, -1):
        way = draw.where(draw.where(branches, "k", k), "direction", direction)
        panel.plot(way["s"], way["turns"], "-", color="#0072B2", lw=1.1)
    panel.axvline(0, color="#888888", lw=0.5)
    panel.plot([0], [k], "^", ms=4, color="#009E73", label="type I")
    panel.set(xlabel="anharmonicity $s$", xlim=(left, right), ylim=(low, high))
    panel.xaxis.set_major_locator(plt.MaxNLocator(2))
axes[0].set_ylabel(r"shift time $T/2\pi$")
axes[0].legend(loc="center left", fontsize=6, handletextpad=0.1, borderpad=0)

moving = packet["speed"] > 0
axes[3].semilogy(packet["speed"][moving], packet["energy"][moving], "-", color="black", lw=1,
                 label="packet, $v_0=1.9$")
axes[3].semilogy(exact["speed"], exact["energy"], "o", ms=4, mfc="none", color="#0072B2",
                 label="exact, $s=1$")
axes[3].set(xlabel="speed (sites/time)", ylabel="energy", xlim=(0, 0.16), ylim=(1e-4, 5))
axes[3].legend(loc="center right", fontsize=7)
for panel, name in zip(axes, "abcd"):
    panel.set_title(f"({name})" + (f" $k = {'abc'.find(name) + 1}$" if name in "abc" else ""), loc="left", pad=3)
draw.save(figure, out)
