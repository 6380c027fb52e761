"""Figure x32: growth of modulations of plane waves without precompression, the chain against it, and the waves between."""

import draw
import matplotlib.pyplot as plt
import numpy as np

data, out = draw.arguments()
folder = f"{data}/sec5_growth"
growth = draw.read(f"{folder}/growth.ecsv")
edge = draw.read(f"{folder}/edge.ecsv")
chain = draw.read(f"{folder}/chain_growth.ecsv")
marginal = draw.read(f"{folder}/marginal_growth.ecsv")

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

marks = [("#0072B2", "o"), ("#E69F00", "s"), ("#009E73", "^"), ("#CC79A7", "D"), ("#D55E00", "v")]
for (color, mark), q in zip(marks, sorted(np.unique(np.round(chain["q"], 9)), reverse=True)):
    rows = draw.where(chain, "q", q)
    order.loglog(rows["eps"], rows["apart"], mark + "-", color=color, ms=3.5, lw=0.7, mfc="white",
                 label=r"$q = \pi$" if q > 3.14 else rf"$q = {q / np.pi:.3g}\pi$")
sizes = np.array([1e-7, 1e-4])
order.loglog(sizes, 25 * np.sqrt(sizes), "k:", lw=0.9, label=r"slope $\frac{1}{2}$")
order.set(xlabel=r"amplitude scale $\epsilon$", ylabel="relative difference of the growth", ylim=(2e-5, 1))
order.legend(loc="lower right", fontsize=6)
draw.letter(order, "b")

for color, mark, q, name in [("#0072B2", "o", np.pi / 2, r"$q = \frac{1}{2}\pi$"),
                             ("#D55E00", "v", 22 * np.pi / 39, r"$\cos q \approx -\frac{1}{5}$")]:
    rows = draw.where(marginal, "q", q)
    between.loglog(rows["eps"], rows["growth"], mark + "-", color=color, ms=3.5, lw=0.7, mfc="white", label=name)
between.loglog(sizes, 1.1 * sizes**0.25, "k:", lw=0.9, label=r"slope $\frac{1}{4}$")
between.set(xlabel=r"amplitude scale $\epsilon$", ylabel="growth rate in the chain")
between.legend(loc="lower right", fontsize=6)
draw.letter(between, "c")
draw.save(figure, out)
