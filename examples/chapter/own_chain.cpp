/**
# Light and heavy beads in wells of one's own

How fast does the packet of an impact travel if every other bead is light? The equation of motion is Eq. (9) with masses,
$$\mu_n\ddot y_n = -W'(y_n) + (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2},\qquad W = \cosh y - 1,$$
with $\mu_n = 1$ and $\mu_n = \mu$ in turn. A light bead oscillates faster in its well, by the factor $\mu^{-1/2}$. So
neighbours are out of tune, and we expect a slow packet. */
#include <cmath>
#include <vector>

#include "lattice/impact/impact.hpp"
#include "report/program.hpp"

using namespace lattice;

constexpr std::size_t sites = 400;           // so many that no wave comes back from the far end
constexpr double v_0 = 1.9, duration = 700;  // of the impact, of the run at most
constexpr double end_of_run = 60;            // site: the speed is that from site 20 to here
constexpr double tolerance = 1e-6;           // to which the end states of two steps agree

/// W = cosh y - 1: three functions make a well.
struct Cosh {
  double energy(double y) const { return std::cosh(y) - 1; }
  double force(double y) const { return -std::sinh(y); }
  double stiffness(double y) const { return std::cosh(y); }
};

Chain own_chain(double mu) {
  Chain chain{sites, Cosh{}};
  std::vector<double> mass(sites, 1);
  for (std::size_t n = 1; n < sites; n += 2) mass[n] = mu;
  vary(chain, mass, {});
  return chain;
}

/// Speed of the packet, with the difference of two steps as its error.
Estimate speed(double mu) {
  Impact impact{v_0, own_chain(mu), duration};
  impact.until = end_of_run;
  const auto runs =
      refined(tolerance, [&](const EventCorrected& method) { return strike(method, impact); });
  return runs.of([](const ImpactRun& run) { return packet_speed(run.path, end_of_run); });
}

void reproduce(Report& report) {
  const auto row = [](double mu) {
    return Row{{"mu", "mass of every other bead", mu},
               {"speed", "speed of the packet", speed(mu), "site per unit of time"}};
  };
  report.table("speeds").fill(std::vector{0.8, 0.85, 0.9, 0.95, 1.0}, row, "masses");
}

int main(int argc, char** argv) {
  return run({"own_chain", "", "Light and heavy beads in turn", reproduce}, argc, argv);
}
