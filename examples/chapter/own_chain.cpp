/**
# Light and heavy beads in wells of one's own

How fast does the packet of an impact travel if every other bead is light? The equation of motion is Eq. (9) with masses,
$$\mu_n\ddot y_n = -W'(y_n) + (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2},\qquad W = \cosh y - 1,$$
with $\mu_n = 1$ and $\mu_n = \mu$ in turn. A light bead oscillates faster in its well, by the factor $\mu^{-1/2}$. So
neighbours are out of tune, and we expect a slow packet. It is slow; but its speed does not simply fall with $\mu$. Why not? */
#include <cmath>
#include <vector>

#include "lattice/impact/impact.hpp"
#include "report/program.hpp"

using namespace lattice;

constexpr std::size_t sites = 400;           // so many that no wave comes back from the far end
constexpr double v_0 = 1.9, duration = 900;  // of the impact, of the run at most
constexpr double last_site = 60;    // where the run ends; the speed is that from site 20 on
constexpr double tolerance = 1e-6;  // to which the end states of two steps agree

/// W = cosh y - 1: three functions make a well.
struct Cosh {
  double energy(double y) const { return std::cosh(y) - 1; }
  double force(double y) const { return -std::sinh(y); }
  double stiffness(double y) const { return std::cosh(y); }
};

Chain own_chain(double mu) {
  Chain chain{sites, Cosh{}};
  std::vector<double> mass(sites, 1);
  for (std::size_t n = 1; n < sites; n += 2) mass[n] = mu;  // beads 2, 4, ...
  vary(chain, mass, {});
  return chain;
}

/// Halves the step until two runs agree. What is read from them has their difference as its error.
auto runs_with(double mu) {
  Impact impact{v_0, own_chain(mu), duration};
  impact.until = last_site;
  return refined(tolerance, [&](const EventCorrected& method) { return strike(method, impact); });
}

// What is measured, each a function of a run
Estimate speed(const ImpactRun& run) {
  return packet_speed(run.path, last_site);
}
double fraction(const ImpactRun& run) {
  return run.path.energy_at(last_site) / (v_0 * v_0 / 2);
}

void reproduce(Report& report) {
  const auto row = [](double mu) {
    const auto runs = runs_with(mu);
    return Row{{"mu", "mass of every other bead", mu},
               {"speed", "speed of the packet", runs.of(speed), "site per unit of time"},
               {"fraction", "of the energy, in the packet at the end", runs.of(fraction)}};
  };
  const std::vector<double> masses{0.8, 0.82, 0.84, 0.86, 0.88, 0.9, 0.92, 0.94, 0.96, 0.98, 1};
  report.table("speeds").fill(masses, row, "masses");  // on all cores; "masses" is what is counted
}

int main(int argc, char** argv) {
  return run({"own_chain", "", "Light and heavy beads in turn", reproduce}, argc, argv);
}
