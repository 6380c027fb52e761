"""Figure x27: thresholds of a driven array, quiet orbits, and a chart of what it sends out."""

import draw
import matplotlib.pyplot as plt
import numpy as np

data, out = draw.arguments()
folder = f"{data}/sec5_driving"
folds = draw.records(f"{folder}/folds.ecsv")
thresholds = draw.records(f"{folder}/thresholds.ecsv")
orbits = draw.read(f"{folder}/quiet_orbits.ecsv")
chart = draw.read(f"{folder}/chart.ecsv")

figure, axes = plt.subplots(2, 2, figsize=(draw.TWO_COLUMNS, 125 * draw.MM))
(law, quiet), (kinds, power) = axes

colors = {"piston": "#0072B2", "base": "#009E73"}
for by, dash in [("piston", "-"), ("base", "--")]:
    rows = [row for row in folds if row["by"] == by]
    law.semilogx([float(row["delta"]) for row in rows], [float(row["ratio"]) for row in rows], "o" + dash,
                 color=colors[by], ms=4, lw=0.9, mfc="white", label=f"fold, {by}")
law.axhline(1, color="#888888", lw=0.8, ls=":")
marks = {"up": ("^", "slowly up"), "lasting": ("s", "at once, lasting"), "down": ("v", "slowly down"),
         "once": ("x", "at once, first packet")}
for way, (mark, name) in marks.items():
    for (by, color), beside in zip(colors.items(), (1 / 1.03, 1.03)):
        # 7 kHz would hide beside 0.1
        rows = [row for row in thresholds
                if row["way"] == way and row["by"] == by and row["name"] != "recipe_7000"]
        law.plot([beside * float(row["delta"]) for row in rows], [float(row["over_law"]) for row in rows], mark,
                 color=color, ms=4.5, mfc="none", mew=0.9)
    law.plot([], [], mark, color="#000000", ms=4.5, mfc="none", mew=0.9, label=name)
law.set(xlabel=r"relative distance $\delta$ from the frequency of a beam",
        ylabel="amplitude over asymptotic threshold", ylim=(0.93, 1.92))
law.set_xticks([0.025, 0.05, 0.1, 0.2, 0.35], ["0.025", "0.05", "0.1", "0.2", "0.35"])
law.set_xticks([], minor=True)
law.legend(loc="upper left", fontsize=6, bbox_to_anchor=(0.08, 1))
draw.letter(law, "a")

quiet.plot(orbits["amplitude"], orbits["response"], "o-", color="#0072B2", ms=2.5, lw=0.9)
quiet.set(xlabel=r"amplitude of the piston ($\mathrm{\mu m}$)",
          ylabel=r"amplitude of the first bead ($\mathrm{\mu m}$)", xlim=(0, None), ylim=(0, None))
# The fold, where the lower and the upper branch of quiet orbits meet
fold = next(float(row["fold"]) for row in folds if row["by"] == "piston" and abs(float(row["delta"]) - 0.1) < 1e-9)
quiet.axvline(fold, color="#888888", lw=0.8, ls=":")
quiet.annotate("fold", (fold, 0), xytext=(-3, 4), textcoords="offset points", ha="right", fontsize=7)
draw.letter(quiet, "b")

STYLE = [(0, "quiet", ".", "#888888"), (1, "periodic", "o", "#0072B2"),
         (2, "irregular", "x", "#D55E00")]
for kind, name, mark, color in STYLE:
    rows = draw.where(chart, "kind", kind)
    kinds.plot(rows["frequency"] / 1000, rows["amplitude"], mark, color=color, ms=4, mfc="none",
               label=name)
unsure = {name: column[chart["kind"] != chart["kind_rough"]] for name, column in chart.items()}
kinds.plot(unsure["frequency"] / 1000, unsure["amplitude"], "s", color="#000000", ms=6, mew=0.5, mfc="none",
           label="another kind in half the time")
kinds.set(xlabel="frequency (kHz)", ylabel=r"amplitude of the piston ($\mathrm{\mu m}$)",
          yscale="log")
kinds.legend(loc="lower right", fontsize=6)
draw.letter(kinds, "c")

for color, mark, dash, delta in zip(["#0072B2", "#009E73", "#D55E00"], "os^", ["-", "--", "-."],
                                    np.unique(chart["delta"])[::3]):
    rows = draw.where(chart, "delta", delta)
    power.semilogy(rows["ratio"], np.maximum(rows["power"], 1e-12) * 1e3, mark + dash, color=color,
                   ms=3, lw=0.9, mfc="white", label=f"{rows['frequency'][0] / 1000:.1f} kHz")
power.set(xlabel="amplitude over asymptotic threshold", ylabel="mean power (mW)")
power.legend(loc="lower right")
draw.letter(power, "d")
draw.save(figure, out)
