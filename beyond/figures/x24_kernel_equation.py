"""Figure x24: the kernel, waves of both signs with their tails, and the quotients against alpha."""

import draw
import matplotlib.pyplot as plt
import numpy as np

data, out = draw.arguments()
folder = f"{data}/sec5_kernel_equation"
kernel = draw.read(f"{folder}/kernel.ecsv")
profiles = draw.read(f"{folder}/profiles.ecsv")
quotients = draw.read(f"{folder}/quotients.ecsv")

BLUE, RED = "#0072B2", "#D55E00"
figure, ((a, b), (c, d)) = plt.subplots(2, 2, figsize=(draw.TWO_COLUMNS, 105 * draw.MM),
                                        layout="constrained")
for k, colour, dash in ((2, "#888888", "--"), (1, "black", "-")):
    one = draw.where(kernel, "k", k)
    a.plot(one["turns"], one["kernel"], dash, color=colour, lw=1, label=f"$k={k}$")
a.set(xlabel=r"$\sigma/2\pi$", ylabel=r"kernel $K(\sigma)$", xlim=(-2.5, 2.5), ylim=(-1.2, 1.45))
a.legend(loc="upper right", fontsize=7, ncols=2)

for sign, name, colour, dash in ((1, "plus", BLUE, "-"), (-1, "minus", RED, "--")):
    one = draw.where(profiles, "sign", sign)
    t = np.concatenate((-one["turns"][::-1], one["turns"]))
    b.plot(t, np.concatenate((one["d"][::-1], one["d"])), dash, color=colour, lw=1, label=name)
    c.plot(one["turns"], one["log_d"], dash, color=colour, lw=0.8, label=name)
b.axhline(0, color="#888888", lw=0.5)
b.set(xlabel=r"time $t/2\pi$", ylabel="compression $d$", xlim=(-5, 5), ylim=(-0.5, 0.62))
c.set(xlabel=r"time $t/2\pi$", ylabel=r"$\log_{10}|d|/d_{\mathrm{max}}$", xlim=(0, 6), ylim=(-7.5, 0.8))
for axes in (b, c):
    axes.legend(loc="upper right" if axes is b else "lower left", fontsize=7, ncols=2 if axes is b else 1)

sure = np.abs(quotients["difference"]) > 10 * quotients["difference_error"]
positive = quotients["difference"] > 0
d.plot(quotients["alpha"], quotients["log_difference"], "-", color="#BBBBBB", lw=0.8)
for keep, mark, colour, name in ((sure & positive, "o", BLUE, "plus larger"),
                                 (sure & ~positive, "s", RED, "minus larger"),
                                 (~sure, "x", "#666666", "not separable")):
    d.plot(quotients["alpha"][keep], quotients["log_difference"][keep], mark, ms=3.4, mfc="none",
           mew=0.8, color=colour, label=name)
d.set(xlabel=r"exponent $\alpha$ of the contacts", ylim=(-16.6, 1),
      ylabel=r"$\log_{10}|Q_+/Q_- - 1|$")
d.set_xscale("function", functions=(lambda x: np.log(np.maximum(x, 1.01) - 1),
                                    lambda x: np.exp(x) + 1))
d.set_xticks([1.2, 1.3, 1.5, 2, 3, 4, 6, 8], ["1.2", "1.3", "1.5", "2", "3", "4", "6", "8"])
d.set_xlim(1.18, 8.6)
d.legend(loc="lower right", fontsize=7)
for axes, name in zip((a, b, c, d), "abcd"):
    draw.letter(axes, name, x=0.97 if axes is c else 0.03)
draw.save(figure, out)
