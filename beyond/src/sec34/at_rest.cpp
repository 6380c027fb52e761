#include "sec34/at_rest.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lattice/diagnostics/path.hpp"
#include "lattice/gsl/random.hpp"
#include "lattice/integrators/event_corrected.hpp"
#include "lattice/orbits/breather.hpp"
#include "sec34/momentum.hpp"

namespace lattice {

AtRest::AtRest(double s) {
  std::vector<double> omegas;
  for (int k = 0; k <= 11; ++k) omegas.push_back(1.26 + 0.04 * k);
  orbits = breathers_at(breather_problem(Centre::bond, omegas[0], s, 24), omegas);
}

double AtRest::action(std::size_t k) const {
  return orbits[k].action_integral / (2 * std::numbers::pi);
}

namespace {

// Energy and frequency at the action J, between two of every `each` breathers
struct Point {
  double energy, frequency;
};

Point between(const AtRest& rest, double J, std::size_t each) {
  const auto& orbits = rest.orbits;
  std::size_t k = 0;
  while (k + 2 * each < orbits.size() && rest.action(k + each) < J) k += each;
  const double more = J - rest.action(k), slope = (orbits[k + each].omega - orbits[k].omega) /
                                                  (rest.action(k + each) - rest.action(k));
  return {orbits[k].energy + orbits[k].omega * more + slope * more * more / 2,
          orbits[k].omega + slope * more};
}

}  // namespace

Estimate AtRest::energy(double J) const {
  return with_error(between(*this, J, 2).energy, between(*this, J, 1).energy);
}

Estimate AtRest::frequency(double J) const {
  return with_error(between(*this, J, 2).frequency, between(*this, J, 1).frequency);
}

Exposed exposed(const Orbit<double>* orbit, double s, double slope, unsigned long seed,
                double step) {
  const std::size_t sites = 200, middle = 100;
  const double time = 200, amplitude = 0.15, last = 4 * cycle;
  Chain chain{sites, Quartic{s}};
  std::vector<double> eta(sites + 1);
  for (std::size_t i = 0; i <= sites; ++i)
    eta[i] = 1 + slope * std::clamp(double(i) - double(middle), -20.0, 20.0);
  if (slope != 0) vary(chain, {}, eta);

  // The breather, and forty sites of waves on its left
  State<double> state = orbit ? resized(orbit->start, sites) : State<double>(sites);
  Random random(seed);
  for (std::size_t n = middle - 6; seed > 0 && n > middle - 46; --n) {
    const double phase = random.uniform(0, 2 * std::numbers::pi);
    state.y[n] += amplitude * std::cos(phase);
    state.v[n] += amplitude * std::sin(phase);
  }

  // By how much the centre has moved from the first four internal periods to the last four
  Exposed out;
  double early = 0, late = 0, looks_early = 0, looks_late = 0;
  evolve(EventCorrected{step}, chain, state, time, Every{0.2}, [&](const State<double>& now) {
    if (now.t > last && now.t < time - last) return;
    const std::vector<double> density = energy_density(chain, now);
    const double x = energy_centre(density, strongest(density));
    (now.t <= last ? early : late) += x;
    ++(now.t <= last ? looks_early : looks_late);
  });
  out.moved = late / looks_late - early / looks_early;
  const std::vector<double> density = energy_density(chain, state);
  for (std::size_t n = middle + 9; n < sites; ++n) out.passed += density[n];
  return out;
}

}  // namespace lattice
