#pragma once
/**
# Strong impacts on pendulum wells stay bounded

With $W = 1-\cos y$ no term of the energy is negative, so no bead is faster than $v_0$ or farther away than $v_0t$. This file
sees whether the runs keep to it, and for how long. */

#include <algorithm>
#include <cmath>
#include <vector>

#include "lattice/impact/impact.hpp"
#include "report/program.hpp"

namespace lattice {

/// Table `confinement`: largest speed and displacement until `time`, and the drift of the energy, for these impacts.
inline void report_confinement(Report& report, const Chain& chain,
                               const std::vector<double>& velocities, double time) {
  struct Excursion {
    double speed = 0, way = 0, drift = 0, lasted = 0;
  };
  const auto run = [&](double v0, double step) {
    State<double> state = struck(chain.sites, v0);
    Excursion out;
    const auto look = [&](const State<double>& now) {
      for (double v : now.v) out.speed = std::max(out.speed, std::abs(v) / v0);
      for (double y : now.y)
        if (now.t > 0) out.way = std::max(out.way, std::abs(y) / (v0 * now.t));
    };
    out.drift = evolve(EventCorrected{step}, chain, state, time, 0.2, look).energy_drift;
    out.lasted = state.t / time;
    return out;
  };
  const auto row = [&](double v0) -> Row {
    const TwoRuns<Excursion> runs{run(v0, 0.1), run(v0, 0.05)};
    return {{"velocity", "velocity of the impact on the first bead", v0},
            {"speed", "largest speed of a bead, in units of the impact's",
             runs.of([](const Excursion& x) { return x.speed; })},
            {"way",
             "largest displacement at any time, in units of the impact's velocity times this time",
             runs.of([](const Excursion& x) { return x.way; })},
            {"drift", "drift of the energy, relative",
             runs.of([](const Excursion& x) { return x.drift; }), "",
             "difference of two resolutions, relative"},
            {"lasted", "end of the run, in units of its length",
             runs.of([](const Excursion& x) { return x.lasted; })}};
  };
  report.table("confinement").fill(velocities, row, "strong impacts");
}

}  // namespace lattice
