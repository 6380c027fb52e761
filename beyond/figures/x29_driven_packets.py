"""Figure x29: what the first packet of a drive is, against the strength of the drive."""

import draw
import matplotlib.pyplot as plt

data, out = draw.arguments()
seen = draw.read(f"{data}/sec5_driving/strengths.ecsv")
strength = seen["strength"]

figure, (a, b) = plt.subplots(1, 2, figsize=(draw.TWO_COLUMNS, 62 * draw.MM), layout="constrained")


def points(axes, column, mark, colour, label):
    axes.errorbar(strength, seen[column], seen[f"{column}_spread"], fmt=mark, ms=3.5, mfc="none", mew=0.9,
                  lw=0.9, capsize=1.5, color=colour, label=label)


for whole in (2, 3, 4):
    a.axhline(whole, color="#888888", lw=0.8, ls=":")
a.axhline(0, color="#888888", lw=0.8)
points(a, "family", "o", "#0072B2", r"$(T+\varphi)/2\pi$")
points(a, "phase", "s", "#D55E00", r"$\varphi$")
a.set(xlabel="amplitude of the piston over asymptotic threshold", ylabel="two numbers of the packet", ylim=(-0.6, 4.7))
a.legend(fontsize=7, loc="center right", bbox_to_anchor=(1, 0.35))
b.axhline(1, color="#888888", lw=0.8)
points(b, "energy_ratio", "o", "#0072B2", "energy")
points(b, "width_ratio", "s", "#D55E00", "width")
b.set(xlabel="amplitude of the piston over asymptotic threshold", ylabel="ratio to the family's member")
b.legend(fontsize=7, loc="upper center")
for axes, name in zip((a, b), "ab"):
    draw.letter(axes, name)
draw.save(figure, out)
