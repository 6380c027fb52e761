"""Figure x22: how an impact's packet loses its tail, and where its speed and energy go."""

import draw
import matplotlib.pyplot as plt
import numpy as np

data, out = draw.arguments()
courses = draw.read(f"{data}/sec5_travelling_breathers/courses.ecsv")
line = draw.read(f"{data}/sec5_travelling_breathers/line_of_type_one.ecsv")

figure, (a, b, c) = plt.subplots(1, 3, figsize=(draw.TWO_COLUMNS, 62 * draw.MM),
                                 layout="constrained")
styles = [("#0072B2", "o"), ("#D55E00", "s")]
for (colour, mark), velocity in zip(styles, np.unique(courses["velocity"])):
    run = draw.where(courses, "velocity", velocity)
    name = f"$v_0={velocity:g}$"
    a.loglog(run["site"], run["left"], mark, ms=2.8, mfc="none", mew=0.7, color=colour, label=name)
    b.plot(run["site"] / 1000, run["inverse_angle"], mark, ms=2.8, mfc="none", mew=0.7, color=colour,
           label=name)
    c.plot(run["turns"][6:], run["energy"][6:], mark, ms=2.8, mfc="none", mew=0.7, color=colour,
           label=name)
n = np.array([1e3, 1.5e4])
a.loglog(n, 4.0 / n, "k:", lw=1, label=r"$\propto 1/n$")
a.set(xlabel="site $n$", ylabel="amplitude left behind $|z_n|$", ylim=(1e-4, 1))
a.legend(loc="lower left", fontsize=7)
b.set(xlabel="site $n$ (thousands)", ylabel=r"$1/\vartheta$", xlim=(0, 17), ylim=(0, 55))
curve = draw.where(line, "exact", 0)
c.plot(curve["turns"], curve["energy"], "-", color="#888888", lw=0.8, label="line of type I")
one = draw.where(line, "exact", 1)
c.plot(one["turns"], one["energy"], "^", ms=5, color="#009E73", label="exact, type I")
c.set_yscale("log")
c.set(xlabel=r"shift time $T/2\pi$", ylabel="energy", xlim=(0.7, 1.3), ylim=(0.05, 1))
c.legend(loc="upper right", fontsize=6.5)
for axes, name in zip((a, b, c), "abc"):
    draw.letter(axes, name)
draw.save(figure, out)
