#pragma once
/**
# Striking an array of cantilevers

The first cantilever of a resting array gets a velocity, in metres a second, and a packet runs away
from it. This file gives the run and its clock in milliseconds, watches the packet pass a
given cantilever, and follows it for ten milliseconds if the array is damped. */

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <vector>

#include "lattice/measure/impact.hpp"
#include "lattice/measure/pulse.hpp"
#include "lattice/model/cantilever.hpp"
#include "lattice/stepping/damped.hpp"

namespace lattice {

/// The packet did not do what its measurement needs.
struct NoPacket : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// An array and the impact on its first cantilever, Eq. (28).
struct ArrayImpact {
  CantileverArray array{};
  double velocity = 1;  // m/s
  Scales scales = array.scales();

  double struck_velocity() const { return velocity / scales.unit_velocity(); }
  double time(double milliseconds) const { return milliseconds * 1e-3 / scales.tau_c(); }
  double milliseconds(double t) const { return t * scales.tau_c() * 1e3; }
};

/// Step and sampling interval of a run, in units of tau_c; the step divides the interval.
struct Resolution {
  double step, sample;
};

/// What one cantilever and the contact to its right do, in units of xi and tau_c.
struct Watched {
  std::vector<double> t, force, v, y;
};

/// The packet at one cantilever, in SI units: when the contact pushes hardest and how hard, the
/// largest velocity and deflection, and the internal period.
struct Pulse {
  double arrival, force, velocity, deflection, period;  // SI
};

inline Pulse pulse_of(const Watched& w, const Scales& s) {
  const auto push = strongest_push(w.t, w.force);
  if (!push) throw NoPacket("the packet did not pass the site at which it is watched");
  return {push->t * s.tau_c(), push->force * s.unit_force(),
          largest_modulus(w.t, w.v) * s.unit_velocity(), largest_modulus(w.t, w.y) * s.xi(),
          push->period * s.tau_c()};
}

/// The homogeneous array after an impact, up to a time in ms, watched at site `n` (from one).
struct Way {
  Watched at;
  Track track;
  double drift;
};

inline Way pass(const ArrayImpact& impact, std::size_t n, double until, const Resolution& r) {
  const auto chain = cantilever_chain(impact.array, 1);
  State<double> state = struck(chain.sites, impact.struck_velocity());
  Way out;
  std::size_t k = 0;
  const auto watch = [&](const State<double>& now) {
    out.at.t.push_back(now.t);
    out.at.force.push_back(contact_push(chain, now.y.data(), n));
    out.at.v.push_back(now.v[n - 1]);
    out.at.y.push_back(now.y[n - 1]);
    if (++k % 8 != 0) return;
    const auto density = energy_density(chain, now);
    if (const auto peak = front_packet(density)) out.track.add(now.t, density, *peak);
  };
  out.drift =
      evolve(ContactAware{r.step}, chain, state, impact.time(until), r.sample, watch).energy_drift;
  return out;
}

/**
## With damping

In a damped array (damped.hpp) the packet reaches one contact after the other, each at the time of its
strongest push. Between two of them it oscillates with the period of the later one. */
struct Journey {
  double sites = 0, oscillations = 0;  ///< after 10 ms, from the first contact on
  double speed = 0, period = 0;        ///< sites/s and s, at the end
  double energy = 0;                   ///< of the packet, over that of the impact
};

/// The strongest push of each contact, in the order of the contacts, or nothing where it is missing.
using Pushes = std::vector<std::optional<Push>>;

inline Journey journey_of(const ArrayImpact& impact, const Pushes& pushes) {
  const double end = impact.time(10);
  Journey out;
  double last = 0, site = 0;
  for (std::size_t n = 1; n < pushes.size() && last < end; ++n) {
    if (!pushes[n]) continue;
    const Push& push = *pushes[n];
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

/// An impact with the damping rate `rate` of the velocities, in 1/s.
inline Journey travel(const ArrayImpact& impact, double rate, const Resolution& r) {
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
  Pushes pushes;
  for (const auto& f : force) pushes.push_back(strongest_push(t, f));
  Journey out = journey_of(impact, pushes);
  if (const auto peak = front_packet(density))
    out.energy = window_sum(density, *peak) / (struck_v * struck_v / 2);
  return out;
}

}  // namespace lattice
