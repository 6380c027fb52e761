"""Figure x01: the transition from breather to kink in pendulum wells, and two examples."""

import matplotlib.pyplot as plt
from matplotlib.colors import SymLogNorm

import draw

data, out = draw.arguments()
scan = draw.read(f"{data}/sec34_kink/kink_transition.ecsv")
examples = draw.read(f"{data}/sec34_kink/kink_examples.ecsv")

figure, (curve, low, high) = plt.subplots(1, 3, figsize=(draw.TWO_COLUMNS, 66 * draw.MM),
                                          width_ratios=[1.25, 1, 1])
curve.plot(scan["velocity"], scan["moved"], color="#0072B2", label="share moved on")
curve.plot(scan["velocity"], scan["ejected_far"] / 10, ".", ms=2.5, color="#D55E00",
           label="thrown off far end / 10")
curve.plot(scan["velocity"], scan["ejected_near"] / 10, "x", ms=2.5, mew=0.6, color="#009E73",
           label="thrown back / 10")
curve.set(xlabel="impact velocity $v_0$", xlim=(1, 8), ylim=(-0.03, 1.6))
curve.legend(loc="upper right", handlelength=1.2, fontsize=7, borderaxespad=0.2)
draw.letter(curve, "a")
for axes, velocity, name in [(low, 2.0, "b"), (high, 5.0, "c")]:
    image, extent = draw.grid(draw.where(examples, "velocity", velocity), "n", "t", "wells")
    picture = axes.imshow(image, extent=extent, origin="lower", aspect="auto", cmap="PuOr_r",
                          norm=SymLogNorm(0.02, vmin=-2, vmax=2), interpolation="none")
    axes.set(xlabel="site $n$")
    axes.text(0.97, 0.03, f"$v_0 = {velocity:g}$", transform=axes.transAxes, ha="right")
    draw.letter(axes, name)
low.set_ylabel("time $t$")
bar = figure.colorbar(picture, ax=high, extend="both", ticks=[-1, -0.1, 0, 0.1, 1])
bar.ax.set_yticklabels(["−1", "−0.1", "0", "0.1", "1"])
bar.ax.minorticks_off()
bar.set_label(r"displacement $y_n / 2\pi$")
draw.save(figure, out)
