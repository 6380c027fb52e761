/**
# Light and heavy beads in wells of one's own

How fast does the packet of an impact travel if every other bead is light? The equation of motion is Eq. (9) with masses,
$$\mu_n\ddot y_n = -W'(y_n) + (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2},\qquad W = \cosh y - 1,$$
with $\mu_n = 1$ and $\mu_n = \mu$ in turn. A light bead oscillates faster in its well, by the factor $\mu^{-1/2}$. So
neighbours are out of tune and pass their energy on less easily: down to $\mu = 0.94$ the packet becomes slower and weaker
with every step of $\mu$. `statements.cpp` asserts this. The figure shows how little the time step matters for the speed;
its error in the table is mostly that of the straight line whose slope it is. */
#include <cmath>
#include <vector>

#include "lattice/impact/impact.hpp"
#include "report/program.hpp"

using namespace lattice;
using namespace report;

constexpr std::size_t sites = 400;  // so many that no wave comes back from the far end
constexpr double v_0 = 1.9;         // velocity of the impact
constexpr double last_site = 60;    // where a run ends; the speed is that from site 20 on
constexpr double duration = 900;    // of a run, at most
constexpr double tolerance = 1e-6;  // to which the end states of two steps agree, relative
const std::vector<double> masses{0.94, 0.95, 0.96, 0.97, 0.98, 0.99, 1};

/// W = cosh y - 1, written so that it is accurate for small y. Three functions make a well.
struct Cosh {
  double energy(double y) const { return 2 * std::sinh(y / 2) * std::sinh(y / 2); }
  double force(double y) const { return -std::sinh(y); }
  double stiffness(double y) const { return std::cosh(y); }
};

/// The impact, on bead 1 at t = 0.
Impact impact_with(double mu) {
  Chain chain{sites, Cosh{}};
  std::vector<double> mass(sites, 1);
  for (std::size_t n = 1; n < sites; n += 2) mass[n] = mu;  // beads 2, 4, ...
  vary(chain, mass, {});
  Impact impact{v_0, chain, duration};
  impact.until = last_site;
  return impact;
}

// What is measured, each a function of a run
Estimate speed(const ImpactRun& run) {
  return packet_speed(run.path, last_site);
}
double fraction(const ImpactRun& run) {
  return run.path.energy_at(last_site) / (v_0 * v_0 / 2);
}

/// Halves the step until two runs agree. What is read from them has their difference as its error.
void report_speeds(Report& report) {
  const auto row = [](double mu) {
    const Impact impact = impact_with(mu);
    const auto runs =
        refined(tolerance, [&](const EventCorrected& method) { return strike(method, impact); });
    return Row{{"mu", mu}, {"speed", runs.of(speed)}, {"fraction", runs.of(fraction)}};
  };
  report.table("speeds").fill(masses, row, "masses");  // on all cores; "masses" is what is counted
}

/// How the speed depends on the time step, up to 0.2, the time between two samples: longer steps are cut to that.
void report_convergence(Report& report) {
  const auto speed_with = [](double step) {
    return speed(strike(EventCorrected{step}, impact_with(masses.front()))).value;
  };
  const double best = speed_with(0.00625);
  Table& table = report.table("convergence");
  for (double step : {0.2, 0.1, 0.05, 0.025})
    table.add({{"step", step}, {"error", std::abs(speed_with(step) - best)}});
}

void reproduce(Report& report) {
  report_speeds(report);
  report_convergence(report);
}

/**
**To change it.** The well is `Cosh`, the masses are set in `impact_with`, what is measured is a function of a run and a cell
of a row. A cell may say what it means, `{"mu", "mass of every other bead", mu}`, and the header of the table does.

*Exercise.* Does the speed fall further below $\mu = 0.94$? Add masses from 0.8 on, and look at the energy that the packet
keeps. Is it one packet still? (The statement is about 0.94 to 1, and both must stay among the masses.) */
int main(int argc, char** argv) {
  return run({"own_chain", "", "Light and heavy beads in turn", reproduce}, argc, argv);
}
