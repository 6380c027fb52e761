#include "lattice/packets/array_impact.hpp"

namespace lattice {

// What the article quotes of a packet, in SI units
Pulse pulse_of(const Watched& w, const Scales& s) {
  const auto push = strongest_push(w.t, w.force);
  if (!push) throw NoPacket("the packet did not pass the site at which it is watched");
  return {push->t * s.tau_c(), push->force * s.unit_force(),
          largest_modulus(w.t, w.v) * s.unit_velocity(), largest_modulus(w.t, w.y) * s.xi(),
          push->period * s.tau_c()};
}

// One run shows both what the watched cantilever does and how the packet moves
Way pass(const ArrayImpact& impact, std::size_t n, double until, const Resolution& r) {
  const auto chain = cantilever_chain(impact.array, 1);
  State<double> state = struck(chain.sites, impact.struck_velocity());
  Way out;
  std::size_t k = 0;
  const auto watch = [&](const State<double>& now) {
    out.at.t.push_back(now.t);
    out.at.force.push_back(contact_push(chain, now.y.data(), n));
    out.at.v.push_back(now.v[n - 1]);
    out.at.y.push_back(now.y[n - 1]);
    // The centre of the packet moves slowly: every eighth sample will do
    if (++k % 8 != 0) return;
    const auto density = energy_density(chain, now);
    if (const auto peak = front_packet(density)) out.track.add(now.t, density, *peak);
  };
  out.drift =
      evolve(ContactAware{r.step}, chain, state, impact.time(until), r.sample, watch).energy_drift;
  return out;
}

// Speed and duration as one would read them off the force at the watched contact
double mean_speed(const Way& way, const ArrayImpact& impact, std::size_t n) {
  return double(n) / pulse_of(way.at, impact.scales).arrival;
}

double duration_above(const Way& way, const ArrayImpact& impact, double threshold) {
  const double most = *std::max_element(way.at.force.begin(), way.at.force.end());
  return impact.milliseconds(time_above(way.at.t, way.at.force, threshold * most));
}

// Of each contact keep the strongest push in each interval, so that no short push is missed
std::vector<double> strongest_forces(const ArrayImpact& impact, double ratio, double end,
                                     std::size_t bins) {
  const auto chain = cantilever_chain(impact.array, ratio);
  const std::size_t contacts = chain.sites - 1;
  const double duration = impact.time(end), unit = impact.scales.unit_force();
  std::vector<double> map(bins * contacts, 0.0);
  State<double> state = struck(chain.sites, impact.struck_velocity());
  evolve(ContactAware{0.1}, chain, state, duration, 0.1, [&](const State<double>& now) {
    const std::size_t bin = std::min(bins - 1, std::size_t(now.t / duration * double(bins)));
    for (std::size_t n = 0; n < contacts; ++n) {
      double& most = map[bin * contacts + n];
      most = std::max(most, contact_push(chain, now.y.data(), n + 1) * unit);
    }
  });
  return map;
}

// From one contact to the next the packet oscillates with the period that it has at the later one
Transit journey_of(const ArrayImpact& impact, const Pushes& pushes) {
  const double end = impact.time(10);
  Transit out;
  double last = 0, site = 0;
  for (std::size_t n = 1; n < pushes.size() && last < end; ++n) {
    if (!pushes[n]) continue;
    const Push& push = *pushes[n];
    // Of the last stretch only what lies before the end counts
    const double until = std::min(push.t, end), dwell = (push.t - last) / (double(n) - site);
    out.oscillations += (until - last) / push.period;
    out.sites += (until - last) / dwell;
    out.speed = 1 / (dwell * impact.scales.tau_c());
    out.period = push.period * impact.scales.tau_c();
    last = until, site = double(n);
  }
  if (last < end) throw NoPacket("the packet cannot be followed for 10 ms");
  return out;
}

// Follow a packet through a damped array
Transit travel(const ArrayImpact& impact, double rate, const Resolution& r) {
  const auto chain = cantilever_chain(impact.array, 1);
  const double end = impact.time(10), struck_v = impact.struck_velocity();
  State<double> state = struck(chain.sites, struck_v);
  std::vector<double> t, density;
  std::vector<std::vector<double>> force(40);
  const Damped damped(ContactAware{r.step}, rate * impact.scales.tau_c());
  evolve(damped, chain, state, 1.3 * end, r.sample, [&](const State<double>& now) {
    t.push_back(now.t);
    for (std::size_t n = 0; n < force.size(); ++n)
      force[n].push_back(contact_push(chain, now.y.data(), n + 1));
    if (now.t <= end) density = energy_density(chain, now);
  });
  // The pushes tell how far it comes, the energy at 10 ms what it has kept on the way
  Pushes pushes;
  for (const auto& f : force) pushes.push_back(strongest_push(t, f));
  Transit out = journey_of(impact, pushes);
  if (const auto peak = front_packet(density))
    out.energy = window_sum(density, *peak) / (struck_v * struck_v / 2);
  return out;
}

}  // namespace lattice
