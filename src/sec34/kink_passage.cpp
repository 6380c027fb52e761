#include "sec34/kink_passage.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "lattice/diagnostics/pulse.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "report/program.hpp"

namespace lattice {

double KinkPassage::scaled() const {
  return speed / std::pow(largest, 0.2);
}

// The speed with which this displacement passes the beads of a stretch
static double speed_on(const Beads& stretch, double level, const std::vector<double>& t,
                       const std::vector<std::vector<double>>& y) {
  std::vector<double> times, places;
  for (std::size_t n = stretch.first; n <= stretch.last; ++n) {
    times.push_back(upward_crossings(t, y[n - 1], level).at(0));
    places.push_back(double(n));
  }
  return fit_line(times, places).slope;
}

KinkPassage passage(const KinkWatch& watch, double v0, double step) {
  const Beads &near = watch.near, &far = watch.far;
  std::vector<double> t;
  std::vector<std::vector<double>> y(far.last), v(near.last);
  State<double> state = struck(watch.chain.sites, v0);
  const auto sample = [&](const State<double>& now) {
    t.push_back(now.t);
    for (std::size_t n = 0; n < y.size(); ++n) y[n].push_back(now.y[n]);
    for (std::size_t n = 0; n < v.size(); ++n) v[n].push_back(now.v[n]);
    return now.y[far.last] < watch.passed_at;
  };
  evolve(EventCorrected{step}, watch.chain, state, 400, step, sample);
  if (state.y[far.last] < watch.passed_at) throw Failure("nothing passes the chain");

  // Each bead: its largest velocity, and for how long it has more than half of it
  std::vector<double> largest;
  double duration = 0;
  for (std::size_t n = near.first; n <= near.last; ++n) {
    largest.push_back(largest_modulus(t, v[n - 1]));
    duration += time_above(t, v[n - 1], largest.back() / 2) / double(near.last - near.first + 1);
  }
  const auto [least, most] = std::minmax_element(largest.begin(), largest.end());
  KinkPassage out{.speed = speed_on(near, watch.passed_at, t, y),
                  .later = speed_on(far, watch.passed_at, t, y)};
  for (double one : largest) out.largest += one / double(largest.size());
  out.spread = (*most - *least) / out.largest;
  out.length = out.speed * duration;
  out.way = state.y[near.last - 1];
  return out;
}

double kink_energy(const KinkWatch& watch, double v0, std::size_t bead, double step) {
  const Chain& chain = watch.chain;
  State<double> state = struck(chain.sites, v0);
  const auto first = std::ptrdiff_t(bead < 4 ? 0 : bead - 4);
  std::vector<double> y, energy;
  evolve(EventCorrected{step}, chain, state, 400, step, [&](const State<double>& now) {
    const std::vector<double> e = energy_density(chain, now);
    y.push_back(now.y[bead - 1]);
    energy.push_back(std::accumulate(e.begin() + first, e.end(), 0.0));
    return y.back() < watch.passed_at;
  });
  const std::size_t k = y.size() - 1;
  if (y[k] < watch.passed_at) throw Failure("the bead does not pass");
  return energy[k] + (energy[k - 1] - energy[k]) * (y[k] - watch.passed_at) / (y[k] - y[k - 1]);
}

}  // namespace lattice
