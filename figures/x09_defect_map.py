"""Figure x09: what a defect reflects, keeps and lets pass, against the radius of its beads."""

import draw
import matplotlib.pyplot as plt

data, out = draw.arguments()
table = draw.read(f"{data}/sec36_cantilever_defect/defect_map.ecsv")
STYLES = [("reflected", "o", "-", "#0072B2"), ("near", "s", "--", "#009E73"),
          ("transmitted", "^", "-.", "#D55E00")]

figure, (fractions, small) = plt.subplots(1, 2, figsize=(draw.TWO_COLUMNS, 70 * draw.MM))
for axes in (fractions, small):
    for name, mark, dash, color in STYLES:
        label = {"near": "near (96 to 104)"}.get(name, name)
        axes.plot(table["ratio"], table[f"net_{name}"], marker=mark, ls=dash, color=color, ms=2.4,
                  mfc="none", mew=0.6, lw=0.8, label=label)
    for ratio in (1.1, 1.6):
        axes.axvline(ratio, color="#888888", lw=0.5, ls=":", zorder=0)
    axes.set(xlabel=r"radius of the defect's beads $\tilde R_{100}$", xlim=(0.48, 2.02))
fractions.set(ylabel="fraction of arriving energy", ylim=(-0.03, 1.17))
fractions.legend(loc="center right", handlelength=2.4, frameon=True, framealpha=1, edgecolor="none")
wake = table["net_near"][table["ratio"] == 1][0]
small.axhline(wake, color="#009E73", lw=0.5, zorder=0)
small.set(yscale="log", ylim=(3e-4, 4), ylabel="fraction of arriving energy")
draw.letter(fractions, "a")
draw.letter(small, "b")
draw.save(figure, out)
