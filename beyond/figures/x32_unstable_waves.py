"""Figure x32: growth of modulations of plane waves without precompression, the chain against it, and its marginal wave."""

import draw
import matplotlib.pyplot as plt
import numpy as np

data, out = draw.arguments()
folder = f"{data}/sec5_experiment"
growth = draw.read(f"{folder}/growth.ecsv")
edge = draw.read(f"{folder}/edge.ecsv")
chain = draw.read(f"{folder}/chain_growth.ecsv")

figure, (chart, order, between) = plt.subplots(1, 3, figsize=(draw.TWO_COLUMNS, 70 * draw.MM),
                                               gridspec_kw={"width_ratios": [1.5, 1, 1]})

image, extent = draw.grid(growth, "q", "modulation", "growth")
scaled = [x / np.pi for x in extent]
shown = chart.imshow(np.where(image > 0, image, np.nan), extent=scaled, origin="lower",
                     aspect="auto", cmap="viridis", interpolation="nearest")
figure.colorbar(shown, ax=chart, label=r"growth rate (at $|A|=1$)", pad=0.02)
for short in (True, False):
    rows = (np.cos(edge["q"]) > -0.2) == short
    chart.plot(edge["q"][rows] / np.pi, edge["edge"][rows] / np.pi, "-", color="#D55E00", lw=1.2,
               label="edge of the band" if short else None)
    chart.plot(edge["q"][rows] / np.pi, edge["fastest"][rows] / np.pi, "--", color="black", lw=0.9,
               label="fastest" if short else None)
chart.set(xlabel=r"wavenumber $q/\pi$ of the wave", ylabel=r"wavenumber $Q/\pi$ of the modulation",
          xlim=(0.4, 1), ylim=(0, 1))
for q in (np.pi / 2, np.arccos(-0.2)):
    chart.axvline(q / np.pi, color="gray", ls=":", lw=0.9, label="marginal" if q < 1.6 else None)
chart.text(0.45, 0.4, "no exponential\ngrowth", ha="center", rotation=90, va="center")
chart.legend(loc="upper right")
draw.letter(chart, "a")

marks = [("#0072B2", "o"), ("#E69F00", "s"), ("#009E73", "^")]
unstable = {name: x[chain["dps"] > 0] for name, x in chain.items()}
for (color, mark), q in zip(marks, sorted(np.unique(np.round(unstable["q"], 9)), reverse=True)):
    rows = draw.where(unstable, "q", q)
    order.loglog(rows["eps"], np.abs(rows["growth"] / rows["dps"] - 1), mark + "-", color=color, ms=3.5, lw=0.7, mfc="white",
                 label=r"$q = \pi$" if q > 3.14 else rf"$q = {q / np.pi:.3g}\pi$")
sizes = np.array([1e-7, 1e-4])
order.loglog(sizes, 25 * np.sqrt(sizes), "k:", lw=0.9, label=r"slope $\frac{1}{2}$")
order.set(xlabel=r"amplitude scale $\epsilon$", ylabel="relative difference of the growth", ylim=(2e-5, 1))
order.legend(loc="lower right", fontsize=6)
draw.letter(order, "b")

rows = draw.where(chain, "q", np.pi / 2)
between.loglog(rows["eps"], rows["growth"], "o-", color="#0072B2", ms=3.5, lw=0.7, mfc="white", label=r"$q = \frac{1}{2}\pi$")
between.loglog(sizes, 1.1 * sizes**0.25, "k:", lw=0.9, label=r"slope $\frac{1}{4}$")
between.set(xlabel=r"amplitude scale $\epsilon$", ylabel="growth rate in the chain")
between.legend(loc="lower right", fontsize=6)
draw.letter(between, "c")
draw.save(figure, out)
