"""Figure 27: velocities at three times after an impact on a compressed chain, s = 1."""

import draw
import matplotlib.pyplot as plt

data, out = draw.arguments()
table = draw.where(draw.read(f"{data}/sec4_precompression_mi/impact_profiles.ecsv"), "s", 1)

figure, rows = plt.subplots(3, 1, figsize=(draw.TWO_COLUMNS, 125 * draw.MM))
for axes, time, end, name in zip(rows, [291, 724, 3000], [250, 600, 2100], "abc"):
    shown = draw.where(table, "t", time)
    axes.axhline(0, color="#888888", lw=0.5)
    axes.plot(shown["n"], shown["v"], "-", color="#0072B2", lw=0.7)
    for sign in (1, -1):
        axes.plot(shown["n"], sign * shown["sech"], "--", color="#D55E00", lw=1,
                  label="fitted sech" if sign > 0 else None)
    axes.set(xlim=(0, end), ylim=(-0.45, 0.45), ylabel=r"velocity $\dot y_n$")
    draw.letter(axes, name)
    axes.text(0.07, 0.97, f"$t = {time}$", transform=axes.transAxes, va="top")
rows[0].legend(loc="upper right", handlelength=2.2)
rows[-1].set_xlabel("site $n$")
draw.save(figure, out)
