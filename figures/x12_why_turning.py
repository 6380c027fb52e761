"""Figure x12: why packets turn: without waves, alone, inside, and waves beside a breather at rest."""

import matplotlib.pyplot as plt
import numpy as np

import draw

data, out = draw.arguments()
folder = f"{data}/sec34_boomeron_why"
runs = draw.read(f"{folder}/experiments.ecsv")
inside = draw.read(f"{folder}/packet_inside.ecsv")
rest = draw.read(f"{folder}/breathers_at_rest.ecsv")
beside = draw.read(f"{folder}/waves_beside.ecsv")

figure, ((a, b), (c, d)) = plt.subplots(2, 2, figsize=(draw.TWO_COLUMNS, 125 * draw.MM),
                                        layout="constrained")
styles = [(0, "#000000", "-", "waves left"), (1, "#D55E00", "--", "absorbed behind"),
          (2, "#E69F00", "-.", "absorbed at the end")]
for k, colour, dash, name in styles:
    run = draw.where(runs, "experiment", k)
    a.plot(run["t"], run["centre"], dash, color=colour, lw=1.2, label=name)
    if k < 2:
        b.plot(run["t"], run["energy"], dash, color=colour, lw=1.2, label=name)
for k in range(3, 7):
    run = draw.where(runs, "experiment", k)
    a.plot(run["t"], run["centre"], ":", color="#0072B2", lw=1.2,
           label="cut out, on a quiet chain" if k == 3 else None)
    a.plot(run["t"][:1], run["centre"][:1], "o", ms=3, color="#0072B2")
a.set(xlabel="time $t$", ylabel="centre $X$ (site)", xlim=(0, 1000), ylim=(0, 78))
a.legend(loc="upper left", bbox_to_anchor=(0.08, 1))
b.set(xlabel="time $t$", ylabel="energy of the packet", xlim=(0, 1000), ylim=(1.3, 1.8))
b.legend(loc="upper left", bbox_to_anchor=(0.1, 1))

c.plot(rest["omega"], rest["area_bond"], color="#0072B2", lw=1.2, label="at rest, bond-centred")
c.plot(rest["omega"], rest["area_site"], "--", color="#009E73", lw=1.2,
       label="at rest, site-centred")
for k, mark, colour, name in [(0, "o", "#000000", "packet, waves left"),
                              (1, "^", "#D55E00", "packet, absorbed behind")]:
    run = draw.where(inside, "experiment", k)
    late = run["t"] > 50
    c.plot(run["omega"][late], run["area"][late], mark, ms=3.5, mfc="none", mew=0.8, color=colour,
           label=name)
c.set(xlabel=r"frequency $\omega$", ylabel=r"area $\mathcal{A}$", xlim=(1.65, 1.73), ylim=(4.2, 7.5))
c.legend(loc="lower right", fontsize=7)

for s, dash, colour, name in [(1, "-", "#000000", "$s = 1$"), (0, "--", "#D55E00", "$s = 0$")]:
    for side in (-1, 1):
        part = draw.where(draw.where(beside, "s", s), "side", side)
        for trial in np.unique(part["trial"]):
            run = draw.where(part, "trial", trial)
            d.plot(run["t"], run["displacement"], dash, color=colour, lw=0.6)
    d.plot([], [], dash, color=colour, lw=1.2, label=name)
d.set(xlabel="time $t$", ylabel="displacement (site)", xlim=(0, 300), ylim=(-12, 12))
d.text(0.45, 0.88, "waves on the right", transform=d.transAxes, ha="center")
d.text(0.62, 0.05, "waves on the left", transform=d.transAxes, ha="center")
d.legend(loc="lower left")
for axes, name in zip((a, c, d), "acd"):
    draw.letter(axes, name)
draw.letter(b, "b", x=0.97)
draw.save(figure, out)
