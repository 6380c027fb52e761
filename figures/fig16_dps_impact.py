"""Figure 16: |A_n|^2 over site and slow time after the impact, with the final profile inset."""

import draw
import matplotlib.pyplot as plt
from matplotlib.colors import PowerNorm

data, out = draw.arguments()
field = draw.read(f"{data}/sec34_dps_impact/dps_impact_map.ecsv")
final = draw.read(f"{data}/sec34_dps_impact/dps_impact_profile.ecsv")

figure, axes = plt.subplots(figsize=(draw.ONE_COLUMN, 70 * draw.MM))
picture = draw.image(axes, field, "n", "tau", "density", PowerNorm(0.5, vmin=0, vmax=0.3))
axes.set(xlabel="site $n$", ylabel=r"slow time $\tau$", xlim=(0.5, 105))
bar = figure.colorbar(picture, ax=axes, extend="max", ticks=[0, 0.02, 0.05, 0.1, 0.2, 0.3])
bar.set_label(r"$|A_n(\tau)|^2$")

inset = axes.inset_axes([0.57, 0.13, 0.4, 0.34])
inset.plot(final["n"], final["density"], ".-", ms=2.5, lw=0.7, color="black")
inset.set_xlim(0, 105)
inset.set_ylim(0, None)
inset.set_xlabel("$n$", labelpad=0, fontsize=7)
inset.set_ylabel(r"$|A_n|^2$", labelpad=1, fontsize=7)
inset.tick_params(labelsize=7, pad=1.5)
inset.patch.set_alpha(1)
for text in [inset.xaxis.label, inset.yaxis.label, *inset.get_xticklabels(), *inset.get_yticklabels()]:
    text.set_color("white")
draw.save(figure, out)
