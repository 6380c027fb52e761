#include "sec4/modulation.hpp"

namespace lattice {

// Let the modulation grow, then follow the packet's centre during the last part of the run
Modulated modulate(const ModulatedPhonon& phonon, double time, double step) {
  const Chain ring = phonon.ring();
  const Splitting stepper{blanes_moan_6_14(), step};
  Modulated out{phonon.start()};
  const double tail = 60;
  const Run wait = evolve(stepper, ring, out.end, time - tail, tail, Unobserved{});
  const Run look = evolve(stepper, ring, out.end, tail, 1, [&](const State<double>& now) {
    out.density = energy_density(ring, now);
    out.t.push_back(now.t);
    out.centre.push_back(packet_sample(now.t, out.density).centre);
  });
  out.drift = std::max(wait.energy_drift, look.energy_drift);
  out.shown = snapshot(ring, out.end);
  return out;
}

// How long two steps give the same state, before the instability has magnified their difference
Estimate nls_agreement_time(const ModulatedPhonon& phonon, double longest) {
  const double interval = 50;
  const Chain ring = phonon.ring();
  State<double> coarse = phonon.start(), fine = coarse;
  while (fine.t < longest && distance(coarse, fine) < 0.1) {
    evolve(Splitting{blanes_moan_6_14(), 0.4}, ring, coarse, interval, interval, Unobserved{});
    evolve(Splitting{blanes_moan_6_14(), 0.2}, ring, fine, interval, interval, Unobserved{});
  }
  return distance(coarse, fine) < 0.1 ? exact(fine.t) : Estimate{fine.t, interval};
}

// The state of the wave at the end, in numbers; the slope of the centre's path is its speed
Formed formed(const Modulated& m) {
  const std::size_t sites = m.density.size();
  const double mean = total(m.density) / double(sites);
  const Line line = fit_line(m.t, m.centre);
  return {*std::max_element(m.density.begin(), m.density.end()) / mean, participation(m.density),
          line.slope, line.slope_error, sites};
}

Estimate ring_speed(const Formed& coarse, const Formed& fine) {
  return {fine.speed, fine.speed_error + std::abs(fine.speed - coarse.speed)};
}

// Energy gathered in a peak, on a part of the ring, that moves
Criterion formed_breather(const Formed& coarse, const Formed& fine) {
  const auto share = [](const Formed& f) { return f.participation / double(f.sites); };
  return {above("peak_over_mean", compare(coarse.peak_over_mean, fine.peak_over_mean), 5),
          below("share_of_sites", compare(share(coarse), share(fine)), 0.5),
          above("speed", ring_speed(coarse, fine), 0)};
}

// The same measure of a peak, for a wave that has stayed uniform
Criterion uniform_still(const Formed& coarse, const Formed& fine) {
  return {below("peak_over_mean", compare(coarse.peak_over_mean, fine.peak_over_mean), 5)};
}

}  // namespace lattice
