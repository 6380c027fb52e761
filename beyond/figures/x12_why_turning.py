"""Figure x12: the balance of the momentum of packets, in time and at one instant."""

import draw
import matplotlib.pyplot as plt
import numpy as np

data, out = draw.arguments()
table = draw.read(f"{data}/sec34_why_packets_turn/balance.ecsv")
terms = [("edges", "edges", "#0072B2", "-"), ("window", "window", "#E69F00", ":"),
         ("wells", "wells", "#D55E00", "--"), ("contacts", "contacts", "#009E73", "-.")]

figure, ((a, b), (c, d)) = plt.subplots(2, 2, figsize=(draw.TWO_COLUMNS, 95 * draw.MM), sharex="col",
                                        height_ratios=(3, 1), width_ratios=(1, 1.25), layout="constrained")
turning = draw.where(table, "run", "all waves")
a.plot(turning["t"], turning["change"], color="black", lw=1.6, label="change of $P$")
for name, label, colour, dash in terms:
    a.plot(turning["t"], turning[name], dash, color=colour, lw=1.2, label=label)
a.axhline(0, color="#888888", lw=0.5)
a.set(ylabel="since $t = 98$", ylim=(-0.55, 0.62))
a.legend(loc="upper left", bbox_to_anchor=(0.13, 1), fontsize=6.5, ncols=2, handlelength=1.6, columnspacing=1)
c.errorbar(turning["t"], 1000 * turning["residual"], 1000 * turning["residual_error"], fmt="o", ms=2,
           color="black", lw=0.7)
c.axhline(0, color="#888888", lw=0.5)
c.set(xlabel="time $t$", ylabel="residual\n(thousandths)", xlim=(95, 302), ylim=(-3, 3))

last = table["t"] == 298
runs = list(dict.fromkeys(table["run"]))
places = np.arange(len(runs))
for k, (name, label, colour, dash) in enumerate(terms):
    b.bar(places - 0.3 + 0.15 * k, table[name][last], 0.15, color=colour)
b.bar(places + 0.3, table["change"][last], 0.15, color="black")
b.axhline(0, color="#888888", lw=0.5)
b.set(ylabel="from $t = 98$ to 298", ylim=(-0.55, 0.62))
d.errorbar(places, 1000 * table["residual"][last], 1000 * table["residual_error"][last], fmt="o", ms=3,
           color="black", lw=0.7)
d.axhline(0, color="#888888", lw=0.5)
d.set(ylabel="residual\n(thousandths)", ylim=(-3, 3))
short = ["all\nwaves", "wiped", "$d=20$", "$d=10$", "isol-\nated", "$s=0.6$", "$s=0$"]
d.set_xticks(places, short, fontsize=7)
draw.letter(a, "a")
draw.letter(b, "b")
draw.save(figure, out)
