"""Figure x15: mean speed against kick, and the drift of several integrators against their work."""

import draw
import matplotlib.pyplot as plt

data, out = draw.arguments()


def rows(name):
    """The rows of a table with texts in it."""
    return draw.records(f"{data}/sec33_mobility/{name}.ecsv")


def column(table, name):
    return [float(row[name]) for row in table]


figure, (left, right) = plt.subplots(1, 2, figsize=(draw.TWO_COLUMNS, 70 * draw.MM))
for centre, color, mark, dash in [("site", "#D55E00", "s", "--"),
                                  ("bond_stretched", "#0072B2", "o", "-")]:
    table = [row for row in rows("speeds") if row["centre"] == centre]
    c = column(table, "c")
    left.loglog(c, column(table, "pendulum"), dash, color=color, lw=0.9)
    left.loglog(c, column(table, "speed"), mark, color=color, ms=4, mfc="white",
                label=centre.replace("_stretched", ""))
left.plot([], [], "-", color="black", lw=0.9, label="pendulum")
facts = {row["quantity"]: float(row["value"]) for row in rows("facts")}
left.axvline(facts["threshold_bond_stretched"], color="#0072B2", lw=0.8, ls=(0, (1, 1)),
             label="threshold")
left.axvline(6.19e-6, color="#888888", lw=0.8, ls=(0, (5, 2)), label="printed threshold")
left.set(xlabel="size $c$ of the kick", ylabel="mean speed (sites per unit of time)")
left.legend(loc="lower right")
draw.letter(left, "a")

table = rows("integrators")
for name, label, color, style in [
        ("verlet", "velocity Verlet", "#888888", "v-"),
        ("blanes_moan_4", "splitting, order 4", "#56B4E9", "^-"),
        ("blanes_moan_4_wide", "the same, 64-bit mantissa", "#000000", "+:"),
        ("contact_aware_6", "event-corrected, order 6", "#D55E00", "o-"),
        ("contact_aware_14", "event-corrected, 14 stages", "#0072B2", "s--"),
        ("landing", "exact event location", "#009E73", "D")]:
    part = [row for row in table if row["integrator"] == name]
    right.loglog(column(part, "work"), column(part, "drift"), style, color=color, ms=3.5, lw=0.9,
                 label=label)
right.axhline(float(table[0]["allowed"]), color="black", lw=0.8, ls=(0, (1, 1)))
right.set(xlabel="work (site forces per unit of time)", ylabel="relative drift of the energy",
          ylim=(1e-15, 3e-1))
right.legend(loc="lower left", fontsize=6)
right.text(0.97, 0.97, "(b)", transform=right.transAxes, va="top", ha="right")
draw.save(figure, out)
