"""Figure x24: the kernel, waves of both signs, the iteration that maximizes the quotient, and the quotients against alpha."""

import draw
import matplotlib.pyplot as plt
import numpy as np

data, out = draw.arguments()
folder = f"{data}/sec5_kernel_equation"
kernel = draw.read(f"{folder}/kernel.ecsv")
profiles = draw.read(f"{folder}/profiles.ecsv")
ascents = draw.read(f"{folder}/ascents.ecsv")
quotients = draw.read(f"{folder}/quotients.ecsv")

BLUE, RED, GREEN = "#0072B2", "#D55E00", "#009E73"
figure, ((a, b), (c, d)) = plt.subplots(2, 2, figsize=(draw.TWO_COLUMNS, 105 * draw.MM),
                                        layout="constrained")
for k, colour, dash in ((2, "#888888", "--"), (1, "black", "-")):
    one = draw.where(kernel, "k", k)
    a.plot(one["turns"], one["kernel"], dash, color=colour, lw=1, label=f"$k={k}$")
a.set(xlabel=r"$\sigma/2\pi$", ylabel=r"kernel $K(\sigma)$", xlim=(-2.5, 2.5), ylim=(-1.2, 1.45))
a.legend(loc="upper right", fontsize=7, ncols=2)

inset = b.inset_axes([0.66, 0.60, 0.33, 0.37])
for sign, name, colour, dash in ((1, "plus", BLUE, "-"), (-1, "minus", RED, "--")):
    one = draw.where(profiles, "sign", sign)
    t = np.concatenate((-one["turns"][::-1], one["turns"]))
    b.plot(t, np.concatenate((one["d"][::-1], one["d"])), dash, color=colour, lw=1, label=name)
    inset.plot(one["turns"], one["log_d"], dash, color=colour, lw=0.7)
b.axhline(0, color="#888888", lw=0.5)
b.set(xlabel=r"time $t/2\pi$", ylabel="compression $d$", xlim=(-3, 11), ylim=(-0.5, 0.62))
b.legend(loc="lower right", fontsize=7)
inset.set(xlim=(0, 6), ylim=(-7, 0.5))
inset.set_yticks([-6, -3, 0])
inset.tick_params(labelsize=6)
inset.set_ylabel(r"$\log_{10}|d|/d_{\mathrm{max}}$", fontsize=6.5, labelpad=1)

dashes = ["-", "--", ":", "-.", (0, (5, 1)), (0, (1, 2))]
colours = [BLUE, RED, GREEN, "#CC79A7", "#E69F00", "black"]
for start, dash, colour in zip(np.unique(ascents["start"]), dashes, colours):
    one = draw.where(ascents, "start", start)
    c.plot(one["step"], one["log_missing"], ls=dash, color=colour, lw=0.9, label=f"{start:.0f}")
c.set(xlabel="steps of the iteration", ylabel=r"$\log_{10}(1-Q/Q_{\mathrm{max}})$", ylim=(-9, 0.5))
c.set_xscale("symlog", linthresh=10)
c.set_xlim(0, None)
c.legend(loc="lower left", fontsize=7, ncols=2, title="random start", title_fontsize=7)

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
