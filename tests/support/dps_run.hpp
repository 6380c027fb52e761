#pragma once
// A perturbed DpS breather in time, written anew for the tests, for contacts of any exponent.

#include <algorithm>
#include <cmath>
#include <complex>

#include "lattice/dps/evolve.hpp"
#include "lattice/model/sites.hpp"
#include "sec33/dps_motion.hpp"

/// The centre of |v_n|^4, in sites from where a breather with this centre rests.
inline double place_of(lattice::Centre centre, const lattice::Field& v) {
  const double origin = centre == lattice::Centre::bond ? 0.5 : 0;
  double all = 0, moment = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const double weight = std::pow(std::abs(v[i]), 4);
    all += weight;
    moment += weight * (double(lattice::site_number(i, v.size())) - origin);
  }
  return moment / all;
}

/// `breather` plus z times its translational mode.
inline lattice::Field pushed(const lattice::PinnedBreather& breather, std::complex<double> z) {
  lattice::Field v = breather.u;
  breather.pair.add(z, v);
  return v;
}

/// Follows `v` in the frame that turns with the breather, for contacts of exponent `alpha`.
inline lattice::DpsRun run_of(const lattice::PinnedBreather& breather, lattice::Field v,
                              double time, double tolerance, double samples = 1, double alpha = 1.5,
                              const lattice::DpsLook& look = {}) {
  const double start = lattice::energy(v, false, alpha);
  lattice::DpsRun run;
  evolve_dps(lattice::TurningDps{{v.size(), lattice::Ends::free, alpha, 1}, breather.mu}, v, time,
             std::size_t(std::lround(samples * time)), tolerance,
             [&](double t, const lattice::Field& now) {
               run.t.push_back(t);
               run.X.push_back(place_of(breather.centre, now));
               run.drift =
                   std::max(run.drift, std::abs(lattice::energy(now, false, alpha) / start - 1));
               look(t, now);
             });
  return run;
}

/// At which rate the shift of `breather` changes along its growing (sign 1) or decaying (-1) direction.
inline double rate_along(const lattice::PinnedBreather& breather, double sign, double size,
                         double time, double alpha = 1.5) {
  double first = 0, last = 0;
  run_of(breather, pushed(breather, {size, sign * size / breather.pair.push}), time, 1e-12,
         1 / time, alpha, [&](double t, lattice::Field w) {
           for (std::size_t i = 0; i < w.size(); ++i) w[i] -= breather.u[i];
           (t > 0 ? last : first) = breather.pair.of(w).real();
         });
  return std::log(last / first) / time;
}
