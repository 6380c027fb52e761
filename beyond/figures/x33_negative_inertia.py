"""Figure x33: speed against momentum, energy against action, and waves beside a breather at rest."""

import draw
import matplotlib.pyplot as plt
import numpy as np

data, out = draw.arguments()
folder = f"{data}/sec34_why_packets_turn"
relation, along = draw.read(f"{folder}/relation.ecsv"), draw.read(f"{folder}/along.ecsv")
rest, beside = draw.read(f"{folder}/at_rest.ecsv"), draw.read(f"{folder}/beside.ecsv")

figure, (a, b, c) = plt.subplots(1, 3, figsize=(draw.TWO_COLUMNS, 62 * draw.MM), layout="constrained")
for s, mark, colour in [(0, "o", "#000000"), (0.3, "s", "#0072B2"), (1, "^", "#D55E00"), (3, "D", "#009E73")]:
    run = draw.where(relation, "s", s)
    a.plot(run["momentum"], run["speed"], mark, ms=2.2, mfc="none", mew=0.6, color=colour, label=f"$s = {s:g}$")
a.axhline(0, color="#888888", lw=0.5)
a.axvline(0, color="#888888", lw=0.5)
a.set(xlabel="momentum $P$", ylabel="speed (sites per unit of time)", xlim=(-0.15, 0.95), ylim=(-0.04, 0.29))
a.legend(loc="lower right", fontsize=7)

way = along["t"] <= 840
turn = int(np.argmin(along["action"][way]))
J, E = along["action"][way], along["energy"][way]
b.plot(rest["action"], rest["energy"], color="#888888", lw=1, label="breathers at rest")
b.plot(J[: turn + 1], E[: turn + 1], "o-", ms=2.5, lw=0.7, color="#0072B2", label="way out")
b.plot(J[turn:], E[turn:], "s--", ms=2.5, lw=0.7, mfc="white", color="#D55E00", label="way back")
b.set(xlabel="action $J$", ylabel="energy", xlim=(0.88, 1.15), ylim=(1.35, 1.72))
b.legend(loc="lower right", fontsize=7)

c.errorbar(beside["s"], beside["pull"], beside["pull_error"], fmt="o-", ms=3.5, lw=0.8, color="#000000",
           label="pull (sites)")
c.errorbar(beside["s"], beside["passed"], beside["passed_error"], fmt="s--", ms=3.5, lw=0.8, mfc="white",
           color="#D55E00", label="energy passed")
c.set(xlabel="anharmonicity $s$", ylim=(0, 6.5))
c.legend(loc="upper left", bbox_to_anchor=(0.02, 0.86), fontsize=6.5)
for axes, name in zip((a, b, c), "abc"):
    draw.letter(axes, name)
draw.save(figure, out)
