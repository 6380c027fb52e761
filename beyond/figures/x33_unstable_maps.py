"""Figure x33: unstable waves in space and time, and the breathers that they leave."""

import draw
import matplotlib.pyplot as plt
import numpy as np

data, out = draw.arguments()
maps = draw.read(f"{data}/sec5_growth/maps.ecsv")
left = draw.read(f"{data}/sec5_growth/breathers.ecsv")

figure, axes = plt.subplots(1, 4, figsize=(draw.TWO_COLUMNS, 82 * draw.MM),
                            gridspec_kw={"width_ratios": [1, 1, 1, 1.25]}, layout="constrained")
panels, energies = axes[:3], axes[3]
names = [r"DpS, $q=\pi$", r"chain, $q=\pi$", r"DpS, $q=\frac{3}{4}\pi$"]
for axis, panel, name, letter in zip(panels, range(3), names, "abc"):
    image, extent = draw.grid(draw.where(maps, "panel", panel), "n", "tau", "density")
    shown = axis.imshow(image, extent=extent, origin="lower", aspect="auto", cmap="viridis",
                        vmin=0, vmax=6, interpolation="nearest")
    axis.set(xlabel="site $n$")
    axis.text(0.97, 0.97, name, transform=axis.transAxes, va="top", ha="right", color="white")
    draw.letter(axis, letter, color="white")
    if panel:
        axis.tick_params(labelleft=False)
panels[0].set(ylabel=r"slow time $\tau$")
figure.colorbar(shown, ax=list(panels), label="$|A_n|^2$", location="bottom", aspect=40, shrink=0.7,
                extend="max")

for q, color, mark, name in [(np.pi, "#0072B2", "o", r"\pi"),
                             (0.75 * np.pi, "#D55E00", "^", r"\frac{3}{4}\pi")]:
    rows = draw.where(left, "q", q)
    energies.plot(rows["norm"], rows["energy"], mark, color=color, ms=3.5, mfc="none",
                  label=f"after $q={name}$")
line = np.argsort(left["norm"])
energies.plot(left["norm"][line], left["static_energy"][line], "k-", lw=0.8, label="static")
energies.set(xlabel="norm of the breather", ylabel="its energy")
energies.legend(loc="lower right", fontsize=6)
draw.letter(energies, "d")
draw.save(figure, out)
