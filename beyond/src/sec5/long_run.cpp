#include "sec5/long_run.hpp"

#include <cmath>
#include <complex>

#include "lattice/impact/impact.hpp"
#include "sec5/travelling.hpp"

namespace lattice {
namespace {

struct StretchMeans {
  double begin_t = 0, begin_x = 0, energy = 0, contact = 0, looks = 0;
};

/// Adds what is seen at one instant; a row is written when the centre has passed `next`.
void look(LongRun& run, StretchMeans& s, const Chain& chain, const State<double>& now,
          std::size_t offset, double next) {
  const auto e = energy_density(chain, now);
  const auto peak = front_packet(e);
  if (!peak || *peak < 13) return;
  const double x = energy_centre(e, *peak) + double(offset);
  for (std::size_t n = *peak - 6; n <= *peak + 6; ++n) {
    s.energy += e[n];
    s.contact += contact_energy(chain, now.y.data(), n + 1);
  }
  ++s.looks;
  if (x < next) return;
  const std::size_t b = *peak - 11;
  const std::complex<double> z(now.y[b], now.v[b]), behind(now.y[b - 1], now.v[b - 1]);
  run.t.push_back(now.t), run.site.push_back(x);
  run.left.push_back(std::abs(z)), run.angle.push_back(std::arg(z / behind));
  run.energy.push_back(s.energy / s.looks), run.contact.push_back(s.contact / s.looks);
  run.speed.push_back((x - s.begin_x) / (now.t - s.begin_t));
  s = {now.t, x};
}

}  // namespace

LongRun long_run(double velocity, const MovingFrame& frame, std::size_t rows) {
  const Chain chain{frame.sites};
  const auto steps = std::size_t(std::lround(1 / frame.step));
  State<double> state = struck(chain.sites, velocity);
  LongRun run;
  StretchMeans stretch;
  std::size_t offset = 0;
  while (run.t.size() < rows) {
    const double next = 20 * std::pow(10.0, double(run.t.size()) / 12);
    evolve(EventCorrected{frame.step}, chain, state, TimeGrid{1, 1, steps});
    look(run, stretch, chain, state, offset, next);
    const auto peak = front_packet(energy_density(chain, state));
    if (peak && *peak + 20 > chain.sites) move_on(state, frame.drop), offset += frame.drop;
  }
  return run;
}

}  // namespace lattice
