"""Figure x30: numbers of the article, computed with five methods and fixed steps."""

import draw
import matplotlib.pyplot as plt

data, out = draw.arguments()
folder = f"{data}/sec33_article_integrator"
settings = draw.records(f"{folder}/settings.ecsv")
kicks = draw.records(f"{folder}/thresholds.ecsv")
looks = {"verlet": ("#888888", "v", ":", "Verlet"),
         "runge-kutta-4": ("#0072B2", "o", "-", "Runge–Kutta 4"),
         "fehlberg-5": ("#E69F00", "^", "--", "Fehlberg 5"),
         "dormand-prince-5": ("#009E73", "D", "-.", "Dormand–Prince 5"),
         "calvo-sanz-serna-4": ("#D55E00", "s", (0, (1, 1)), "Calvo–Sanz-Serna 4")}


def curve(axes, rows, method, y, scale=1, x="steps"):
    """One column of one method against the steps."""
    color, mark, dash, name = looks[method]
    part = [row for row in rows if row["method"] == method]
    axes.plot([float(row[x]) for row in part], [scale * float(row[y]) for row in part], mark,
              ls=dash, color=color, ms=3, lw=0.9, mfc="white", mew=0.8, label=name)


def beyond(axes, x, y, length, method):
    """The mark of a method with an arrow: what is known lies beyond."""
    color, mark, _, _ = looks[method]
    axes.annotate("", (x, y + length), (x, y), arrowprops={"arrowstyle": "->", "color": color,
                                                           "lw": 0.9, "shrinkA": 0, "shrinkB": 0})
    axes.plot(x, y, mark, color=color, ms=4, mfc="white", mew=0.8)


figure, axes = plt.subplots(2, 3, figsize=(draw.TWO_COLUMNS, 115 * draw.MM),
                            layout="constrained")
(a, b, c), (d, e, f) = axes
methods = list(looks)[:5]
for method in methods:
    curve(a, settings, method, "residual")
    curve(b, settings, method, "barrier_size")
    curve(c, settings, method, "off_bond")
for panel, value in [(a, 1.5e-9), (b, 1.77e-11), (c, 1e-3)]:
    panel.set(xscale="log", yscale="log", xlabel="steps for one period")
    panel.axhline(value, color="black", lw=0.8)
a.set(ylabel="Newton's residual")
b.set(ylabel="barrier $|E_{PN}|$")
c.set(ylabel="multipliers off $+1$")

# A threshold is between two kicks, or known to be below or above one
for shift, method in enumerate(methods):
    color, mark, _, _ = looks[method]
    for row in kicks:
        if row["method"] != method:
            continue
        low, high = 1e6 * float(row["pinned_at"]), 1e6 * float(row["freed_at"])
        x = float(row["steps"]) * (1 + 0.012 * (shift - 2))
        if row["outcome"] == "between":
            d.plot([x, x], [low, high], "-", color=color, lw=2.5)
            d.plot(x, (low + high) / 2, mark, color=color, ms=4, mfc="white", mew=0.8)
        elif row["outcome"] == "above":
            beyond(d, x, low, 0.2, method)
        else:
            beyond(d, x, high, -0.2, method)
d.axhline(6.19, color="black", lw=0.8)
d.set(ylabel="threshold $c_c$ ($10^{-6}$)", xlabel="steps for one period", xlim=(94, 134), ylim=(5.15, 7.4))

for method in methods:
    curve(e, settings, method, "near")
e.set(xscale="log", ylabel="numbers near the printed ones", xlabel="steps for one period",
      ylim=(-0.2, 6.2))
f.legend(*e.get_legend_handles_labels(), loc="center", fontsize=8, frameon=False)
f.axis("off")
for panel, text in zip(axes.flat, "abcde"):
    panel.minorticks_off()
    ticks = [100, 120, 128] if text == "d" else [50, 100, 200, 400]
    panel.set_xticks(ticks, [str(tick) for tick in ticks])
    draw.letter(panel, text, x=0.03 if text == "d" else 0.97)
draw.save(figure, out)
