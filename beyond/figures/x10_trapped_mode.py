"""Figure x10: energy around the defect against time, and the breather in which it is trapped."""

import draw
import matplotlib.pyplot as plt

data, out = draw.arguments()
times = draw.read(f"{data}/sec36_trapped_mode/trapping.ecsv")
mode = draw.read(f"{data}/sec36_trapped_mode/trapped_mode.ecsv")
CURVES = [(0.925, "#009E73", "-"), (0.8, "#56B4E9", (0, (5, 1.5))), (1.0, "#000000", ":"),
          (1.1, "#E69F00", "-."), (1.6, "#D55E00", "--")]

figure, (near, profile) = plt.subplots(1, 2, figsize=(draw.TWO_COLUMNS, 70 * draw.MM))
for ratio, color, dash in CURVES:
    rows = draw.where(times, "ratio", ratio)
    label = rf"$\tilde R_{{100}} = {ratio:g}$" + (" (no defect)" if ratio == 1 else "")
    near.plot(rows["t"], rows["near"], color=color, ls=dash, label=label)
near.set(yscale="log", xlabel="time $t$ (ms)", ylabel="share of the energy on sites 96 to 104",
         xlim=(50, 100), ylim=(3e-4, 20))
near.legend(loc="upper right", handlelength=2.6, ncols=2, columnspacing=1)
profile.bar(mode["n"], mode["run"], width=0.8, color="#CCCCCC", edgecolor="#888888", lw=0.5,
            label="after the impact, 65 to 100 ms")
profile.plot(mode["n"], mode["mode"], "o", color="#009E73", ms=4, mfc="none", mew=1,
             label="breather of the defect")
profile.set(xlabel="site $n$", ylabel="share of the energy around the defect", ylim=(0, 1),
            xticks=mode["n"].astype(int))
profile.legend(loc="upper right", handlelength=1.4)
draw.letter(near, "a")
draw.letter(profile, "b")
draw.save(figure, out)
