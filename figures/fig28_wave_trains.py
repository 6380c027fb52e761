"""Figure 28: wave trains after an impact, s = 0 and s = -1/6, and the packets' share of the energy."""

import draw
import matplotlib.pyplot as plt

data, out = draw.arguments()
folder = f"{data}/sec4_precompression_mi"
profiles = draw.read(f"{folder}/impact_profiles.ecsv")
history = draw.read(f"{folder}/packet_history.ecsv")

figure = plt.figure(figsize=(draw.TWO_COLUMNS, 85 * draw.MM))
figure.get_layout_engine().set(wspace=0.05)
panels = figure.add_gridspec(2, 2, width_ratios=[1.7, 1])
trains = [figure.add_subplot(panels[i, 0]) for i in range(2)]
for axes, s, time, end, text, name in [(trains[0], 0, 4399, 3000, "0", "a"),
                                       (trains[1], -1 / 6, 1998, 1400, "-1/6", "b")]:
    shown = draw.where(draw.where(profiles, "s", s), "t", time)
    axes.axhline(0, color="#888888", lw=0.5)
    axes.plot(shown["n"], shown["v"], "-", color="#0072B2", lw=0.4)
    axes.set(xlim=(0, end), ylim=(-0.16, 0.16), ylabel=r"velocity $\dot y_n$")
    draw.letter(axes, name)
    axes.text(0.11, 0.97, f"$s = {text}$, $t = {time}$", transform=axes.transAxes, va="top")
trains[1].set_xlabel("site $n$")
share = figure.add_subplot(panels[:, 1])
for s, text, style, color in [(1, "1", "-", "#009E73"), (0, "0", "--", "#0072B2"),
                              (-1 / 6, "-1/6", ":", "#D55E00")]:
    rows = draw.where(draw.where(history, "s", s), "d", 0.5)
    share.loglog(rows["t"], rows["share"], style, color=color, lw=1.4, label=f"$s = {text}$")
guide = [500, 4500]
share.loglog(guide, [0.5 * (t / 500) ** (-1 / 2) for t in guide], "-", color="#888888", lw=0.8,
             label="$t^{-1/2}$")
share.set(xlabel="time $t$", ylabel="share of the energy in the packet", xlim=(10, 5000),
          ylim=(0.09, 1.1), yticks=[0.1, 0.2, 0.5, 1], yticklabels=["0.1", "0.2", "0.5", "1"])
share.minorticks_off()
share.legend(loc="lower left")
draw.letter(share, "c")
share.texts[-1].set_position((0.88, 0.97))
draw.save(figure, out)
