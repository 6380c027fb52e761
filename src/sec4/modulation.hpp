#pragma once
/**
# A modulated phonon on a ring

In a compressed chain linear waves, phonons (dispersion.hpp), can travel. An unstable phonon does not stay
uniform: a slight modulation of it grows until the energy has gathered in a packet. Eq. (39) shows this
on a ring of $N$ beads that starts from a phonon of amplitude $a$ running to the right, modulated along
the ring by the fraction $b$,
$$x_n(0) = a\sin qn\,(1 + b\cos(2\pi n/N)), \qquad
  \dot x_n(0) = -a\,\omega\cos qn\,(1 + b\cos(2\pi n/N)).$$
No contact ever opens, so the motion is smooth, and a symplectic splitting of order six with fourteen
stages (schemes.hpp) keeps its full order. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "lattice/numbers/criterion.hpp"
#include "lattice/numbers/estimate.hpp"
#include "sec4/flight.hpp"

namespace lattice {

using CompressedRing = Chain<Quartic, CompressedHertz>;

/// The start of Eq. (39), with the values of the article.
struct ModulatedPhonon {
  double s = -1.0 / 6, d = 0.5, q = std::numbers::pi / 4, a = 0.15, b = 0.01;
  std::size_t sites = 200;

  CompressedRing ring() const { return {sites, {s}, {d}, Ends::periodic}; }
  State<double> start() const {
    const double pi = std::numbers::pi, omega = phonon(q, contact_series(d).v1).omega;
    State<double> state(sites);
    for (std::size_t i = 0; i < sites; ++i) {
      const double n = double(i + 1), factor = 1 + b * std::cos(2 * pi * n / double(sites));
      state.y[i] = a * std::sin(q * n) * factor;
      state.v[i] = -a * omega * std::cos(q * n) * factor;
    }
    return state;
  }
};

/**
One long run answers two questions: what becomes of the wave in the end, and whether that moves. For the
second we follow the packet's centre during the last 60 units of time, about ten oscillations. */
struct Modulated {
  State<double> end;
  std::vector<double> density{}, t{}, centre{};
  double drift = 0;
  Snapshot shown{};
};

/// The run of length `time`, with steps of at most `step`.
inline Modulated modulate(const ModulatedPhonon& phonon, double time, double step) {
  const CompressedRing ring = phonon.ring();
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

/**
Is such a state a fact about the equations or about the integrator? An instability magnifies differences.
So we let two runs go on side by side, with steps that differ by a factor of two, and check from time to
time whether their relative distance has reached a tenth. Until then statements about the state are not
merely statistical. The time at which they part is known to within one interval; if they have not parted by
`longest`, that is how long they were watched, an exact number. */
inline Estimate agreement_time(const ModulatedPhonon& phonon, double longest) {
  const double interval = 50;
  const CompressedRing ring = phonon.ring();
  State<double> coarse = phonon.start(), fine = coarse;
  while (fine.t < longest && distance(coarse, fine) < 0.1) {
    evolve(Splitting{blanes_moan_6_14(), 0.4}, ring, coarse, interval, interval, Unobserved{});
    evolve(Splitting{blanes_moan_6_14(), 0.2}, ring, fine, interval, interval, Unobserved{});
  }
  return distance(coarse, fine) < 0.1 ? exact(fine.t) : Estimate{fine.t, interval};
}

/**
What has become of the wave is judged by a few numbers: the largest energy density over the mean, how many
sites share the energy, and the speed of the centre with the error of its fit. */
struct Formed {
  double peak_over_mean, participation, speed, speed_error;
  std::size_t sites;
};

/// The numbers by which a run is judged.
inline Formed formed(const Modulated& m) {
  const std::size_t sites = m.density.size();
  const double mean = total(m.density) / double(sites);
  const Line line = fit_line(m.t, m.centre);
  return {*std::max_element(m.density.begin(), m.density.end()) / mean, participation(m.density),
          line.slope, line.slope_error, sites};
}

/// Speed of the centre from two runs, with the errors of the fit and of the step.
inline Estimate ring_speed(const Formed& coarse, const Formed& fine) {
  return {fine.speed, fine.speed_error + std::abs(fine.speed - coarse.speed)};
}

/**
We say that a travelling breather has formed if the largest energy density is more than five times the
mean, if less than half of the sites share the energy (188 of 200 at the start of the article's run), and
if the centre moves to the right at a speed larger than its error. Where no density reaches five times the
mean, the wave has stayed uniform. */
/// From runs with two steps.
inline Criterion formed_breather(const Formed& coarse, const Formed& fine) {
  const auto share = [](const Formed& f) { return f.participation / double(f.sites); };
  return {above("peak_over_mean", compare(coarse.peak_over_mean, fine.peak_over_mean), 5),
          below("share_of_sites", compare(share(coarse), share(fine)), 0.5),
          above("speed", ring_speed(coarse, fine), 0)};
}

/// From runs with two steps: no breather has formed.
inline Criterion uniform_still(const Formed& coarse, const Formed& fine) {
  return {below("peak_over_mean", compare(coarse.peak_over_mean, fine.peak_over_mean), 5)};
}

}  // namespace lattice
