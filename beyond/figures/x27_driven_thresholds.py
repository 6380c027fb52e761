"""Figure x27: the non-emitting motion of a driven end, thresholds by four ways, and the fold over its asymptotic value."""

import draw
import matplotlib.pyplot as plt
import numpy as np

data, out = draw.arguments()
folder = f"{data}/sec5_experiment"
orbits = draw.read(f"{folder}/quiet_orbits.ecsv")
thresholds = draw.read(f"{folder}/thresholds.ecsv")
folds = draw.read(f"{folder}/folds.ecsv")
fold = thresholds["threshold"][0] / thresholds["over_fold"][0]

figure, (quiet, ways, law) = plt.subplots(1, 3, figsize=(draw.TWO_COLUMNS, 62 * draw.MM), layout="constrained")

quiet.plot(orbits["amplitude"], orbits["response"], "o-", color="#0072B2", ms=2.5, lw=0.9)
quiet.set(xlabel=r"amplitude $u_0$ of the piston ($\mathrm{\mu m}$)",
          ylabel=r"$(y_1^2+\dot y_1^2)^{1/2}$ of the first bead ($\mathrm{\mu m}$)", xlim=(0, None), ylim=(0, None))
quiet.axvline(fold, color="#888888", lw=0.8, ls=":")
quiet.annotate("fold", (fold, 0), xytext=(-3, 4), textcoords="offset points", ha="right", fontsize=7)
draw.letter(quiet, "a")

names = {"once": "switched on:\nfirst packet", "lasting": "switched on:\nlasting", "down": "slowly down:\nlasting",
         "up": "slowly up:\nfirst packet"}
for k, way in enumerate(names):
    row = draw.where(thresholds, "way", way)
    ways.errorbar(row["threshold"], [k], xerr=row["threshold_error"], fmt="o", ms=4, color="#D55E00", mfc="white", capsize=2)
ways.axvline(fold, color="#888888", lw=0.8, ls=":")
ways.set(xlabel=r"threshold ($\mathrm{\mu m}$)", yticks=range(4), yticklabels=names.values(), ylim=(-0.5, 3.5))
draw.letter(ways, "b")

law.semilogx(folds["delta"], folds["ratio"], "o-", color="#0072B2", ms=4, lw=0.9, mfc="white", label=r"$T_E = 10$ ms")
law.semilogx(folds["delta"], folds["lossless"], "s--", color="#009E73", ms=4, lw=0.9, mfc="white", label="no losses")
line = np.geomspace(0.025, 0.35, 50)
law.plot(line, 1 + 1.2 * line, ":", color="black", lw=0.9, label=r"$1+1.2\,\delta$")
law.set(xlabel=r"relative detuning $\delta$", ylabel="fold over asymptotic value", ylim=(1, None))
law.set_xticks([0.025, 0.05, 0.1, 0.2, 0.35], ["0.025", "0.05", "0.1", "0.2", "0.35"])
law.set_xticks([], minor=True)
law.legend(loc="upper left", bbox_to_anchor=(0.08, 1), fontsize=7)
draw.letter(law, "c")
draw.save(figure, out)
