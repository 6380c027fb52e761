"""Figure x12: packets whose waves are absorbed: paths, and furthest sites against what is left."""

import draw
import matplotlib.pyplot as plt

data, out = draw.arguments()
folder = f"{data}/sec34_boomeron_map"
runs, reach = draw.read(f"{folder}/experiments.ecsv"), draw.read(f"{folder}/range_of_waves.ecsv")

figure, (a, b) = plt.subplots(1, 2, figsize=(draw.TWO_COLUMNS, 70 * draw.MM), layout="constrained")
for k, colour, dash, name in [(0, "#000000", "-", "waves left"), (1, "#D55E00", "--", "absorbed behind"),
                              (2, "#0072B2", "-.", "absorbed at the end")]:
    run = draw.where(runs, "experiment", k)
    a.plot(run["t"], run["centre"], dash, color=colour, lw=1.2, label=name)
a.set(xlabel="time $t$", ylabel="centre $X$ (site)", xlim=(0, 4000), ylim=(0, 100))
a.legend(loc="upper left", bbox_to_anchor=(0.08, 1))

ALL = 36  # where packets with all their waves are drawn
for s, velocity, mark, colour in [(1, 1.9, "o", "#000000"), (0.8, 2.2, "s", "#D55E00"),
                                  (1, 1.7, "^", "#0072B2"), (0.6, 2.5, "D", "#009E73")]:
    part = draw.where(draw.where(reach, "s", s), "velocity", velocity)
    behind = [d if d > 0 else ALL for d in part["behind"]]
    order = sorted(range(len(behind)), key=lambda i: behind[i])
    b.plot([behind[i] for i in order], [part["furthest"][i] for i in order], color=colour, lw=0.8)
    for d, site, fate in zip(behind, part["furthest"], part["fate"]):
        b.plot([d], [site], mark, color=colour, ms=4, mfc=colour if fate == 1 else "white")
    b.plot([], [], mark + "-", color=colour, ms=4, lw=0.8, label=f"$s = {s:g}$, $v_0 = {velocity:g}$")
b.set(xlabel="waves left behind the packet (sites)", ylabel="furthest centre (site)", yscale="log",
      xlim=(4, 38), ylim=(15, 400))
b.set_xticks([6, 15, 20, 30, ALL], ["6", "15", "20", "30", "all"])
b.set_yticks([20, 50, 100, 200], ["20", "50", "100", "200"])
b.minorticks_off()
b.legend(loc="upper right", fontsize=7)
draw.letter(a, "a")
draw.letter(b, "b")
draw.save(figure, out)
