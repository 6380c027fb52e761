"""Figure x28: energy in space and time in a driven array, quiet, with periodic emission, and irregular."""

import draw
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm

data, out = draw.arguments()
maps = draw.read(f"{data}/sec5_experiment/maps.ecsv")
amplitudes = np.unique(maps["amplitude"])
most = maps["energy"].max()

figure, panels = plt.subplots(1, len(amplitudes), figsize=(draw.TWO_COLUMNS, 80 * draw.MM), sharey=True)
for axes, amplitude, name in zip(panels, amplitudes, "abc"):
    image, extent = draw.grid(draw.where(maps, "amplitude", amplitude), "n", "t", "energy")
    shown = axes.imshow(np.maximum(image, 1e-6 * most), extent=extent, origin="lower",
                        aspect="auto", norm=LogNorm(1e-6 * most, most), cmap="viridis",
                        interpolation="nearest")
    axes.set(xlabel="bead $n$")
    axes.set_title(rf"({name}) $u_0 = {amplitude:g}$ $\mathrm{{\mu m}}$", loc="left", pad=3, fontsize=7)
panels[0].set(ylabel="time (ms)")
figure.colorbar(shown, ax=panels, label="energy of a bead (J)", fraction=0.05, pad=0.02)
draw.save(figure, out)
