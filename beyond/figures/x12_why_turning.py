"""Figure x12: why packets turn: what is left of the waves, accelerations, late fates, and waves beside a breather."""

import draw
import matplotlib.pyplot as plt
import numpy as np

data, out = draw.arguments()
folder = f"{data}/sec34_boomeron_why"
runs = draw.read(f"{folder}/experiments.ecsv")
inside = draw.read(f"{folder}/packet_inside.ecsv")
rest = draw.read(f"{folder}/breathers_at_rest.ecsv")
beside = draw.read(f"{folder}/waves_beside.ecsv")
force = draw.read(f"{folder}/force_against_distance.ecsv")
budgets = draw.read(f"{folder}/budgets.ecsv")
fates = draw.read(f"{folder}/late_fates.ecsv")

figure, ((a, b), (c, d), (e, f)) = plt.subplots(3, 2, figsize=(draw.TWO_COLUMNS, 180 * draw.MM),
                                                layout="constrained")
styles = [(0, "#000000", "-", "waves left"), (1, "#D55E00", "--", "absorbed behind"),
          (2, "#E69F00", "-.", "absorbed at the end")]
for k, colour, dash, name in styles:
    run = draw.where(runs, "experiment", k)
    a.plot(run["t"], run["centre"], dash, color=colour, lw=1.2, label=name)
for k in range(3, 7):
    run = draw.where(runs, "experiment", k)
    a.plot(run["t"], run["centre"], ":", color="#0072B2", lw=1.2,
           label="cut out, on a quiet chain" if k == 3 else None)
    a.plot(run["t"][:1], run["centre"][:1], "o", ms=3, color="#0072B2")
a.set(xlabel="time $t$", ylabel="centre $X$ (site)", xlim=(0, 4000), ylim=(0, 125))
a.legend(loc="upper left", bbox_to_anchor=(0.08, 1))

for s, cut, mark, colour, name in [(1, 0, "o-", "#000000", "$s = 1$"),
                                   (1, 60, "s--", "#0072B2", "$s = 1$, cut out at 60"),
                                   (0, 0, "^-.", "#D55E00", "$s = 0$")]:
    part = draw.where(draw.where(force, "s", s), "cut", cut)
    some = part["behind"] > 0
    b.plot(part["behind"][some], 1e4 * part["force"][some], mark, color=colour, lw=1, ms=3,
           label=name)
b.set(xlabel="waves left behind the packet (sites)", ylabel=r"acceleration ($10^{-4}$ site / time$^2$)",
      xlim=(3, 21), ylim=(-5, 0))
b.legend(loc="center right", bbox_to_anchor=(1, 0.42))

for cut, behind, mark, colour, name in [
        (0, 6, "^", "#D55E00", "6 sites"), (0, 8, "v", "#E69F00", "8 sites"),
        (0, 10, "D", "#009E73", "10 sites"), (0, 15, "o", "#000000", "15 sites"),
        (60, 6, "<", "#56B4E9", "6, cut out"), (60, 30, "s", "#0072B2", "30, cut out")]:
    part = draw.where(draw.where(fates, "cut", cut), "behind", behind)
    back = part["fate"] == 1
    e.plot(part["velocity"][back], part["furthest"][back], mark, color=colour, ms=4)
    e.plot(part["velocity"][~back], part["furthest"][~back], mark, color=colour, ms=4, mfc="none")
    e.plot([], [], mark, color=colour, ms=4, mfc="none", label=name)
e.set(xlabel="impact velocity $v_0$", xlim=(1.78, 1.98), ylabel="furthest centre (site)", yscale="log", ylim=(10, 1500))
e.set_yticks([10, 30, 100, 300], ["10", "30", "100", "300"])
e.minorticks_off()
e.set_xticks([1.8, 1.84, 1.88, 1.92, 1.96])
e.legend(loc="upper right", ncols=2, fontsize=7, title="waves left (filled: returned)",
         title_fontsize=7)

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
shares = [("packet", "#000000", "", "packet"), ("near", "#E69F00", "///", "up to 15 sites behind"),
          ("far", "#56B4E9", "...", "further behind"), ("friction", "#D55E00", "xx", "absorbed")]
for i, (name, colour, hatch, text) in enumerate(shares):
    f.bar(np.arange(4) + 0.2 * (i - 1.5), budgets[name], 0.2, color=colour, hatch=hatch,
          edgecolor="white", lw=0.5, label=text)
f.axhline(0, color="black", lw=0.6)
f.set_xticks(range(4), ["$s=1$,\nleft", "$s=1$,\nabsorbed", "$s=0$,\nleft", "$s=0$,\nabsorbed"])
f.set(ylabel="change of energy, $100 < t < 220$")
f.legend(loc="upper left", fontsize=7)
for axes, name in [(a, "a"), (b, "b"), (c, "c"), (d, "d"), (e, "e")]:
    draw.letter(axes, name)
draw.letter(f, "f", x=0.97)
draw.save(figure, out)
