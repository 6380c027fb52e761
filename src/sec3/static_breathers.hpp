#pragma once
/**
# What is read from a static breather

The growth of its family; its symmetry, found without imposing it; its asymmetry, its width and its tail. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "lattice/algebra/dense.hpp"
#include "lattice/diagnostics/observe.hpp"
#include "lattice/gsl/random.hpp"
#include "lattice/model/sites.hpp"
#include "lattice/orbits/breather.hpp"
#include "sec3/resolutions.hpp"

namespace lattice {

/// The exponent of the amplitude in omega_b - 1 between two breathers: two near a bifurcation from rest, by Eq. (20),
/// zero where a family begins at a finite amplitude.
inline double growth_exponent(const Orbit<double>& lower, const Orbit<double>& upper) {
  return std::log(upper.amplitude / lower.amplitude) /
         std::log((upper.omega - 1) / (lower.omega - 1));
}

/// A breather that was found without its symmetry: how far from it, over the amplitude, and the condition number of DR.
struct FreeBreather {
  double broken;
  Estimate condition;  // its error: the difference from that at the symmetric breather
};

/// Newton's method in extended precision knows only that the breather of `problem` is even in time, and starts with all
/// positions changed by a random part of themselves, at most `perturbation`. The symmetries: symmetry.hpp.
inline FreeBreather without_symmetry(const Shooting<double>& problem, double perturbation,
                                     unsigned long seed) {
  const std::size_t sites = problem.chain.sites;
  Shooting<double> even = problem;
  even.symmetry = even_in_time(sites);
  State<double> start = find_breather(problem).start;
  const auto symmetric = even.evaluate(even.reduce(start), {});
  start.y = perturbed(start.y, perturbation, seed);
  const auto free = in_precision<Wide>(even);
  const Orbit<Wide> orbit = newton(free, newton(even, even.reduce(start)));
  State<Wide> image = orbit.start;
  if (sites % 2 == 1) flow(free.chain, image, free.period() / 2);  // around a site
  Wide most = 0;
  for (std::size_t n = 0; n < sites; ++n)
    most = std::max(most, std::abs(orbit.start.y[n] + image.y[sites - 1 - n]));
  return {double(most / orbit.amplitude), with_error(condition_of(symmetric.jacobian).condition,
                                                     condition_of(orbit.jacobian).condition)};
}

/// The largest |y_n(0) - y_-n(0)|, relative to the largest |y_n(0)|.
inline double asymmetry(const Orbit<double>& orbit) {
  double most = 0;
  for (std::size_t n = 0, last = orbit.start.y.size() - 1; n < last - n; ++n)
    most = std::max(most, std::abs(orbit.start.y[n] - orbit.start.y[last - n]));
  return most / orbit.amplitude;
}

/// Participation number of the displacements at t = 0, (sum y^2)^2 / sum y^4, in sites, at two tolerances.
inline Estimate width_of(const Shooting<double>& problem) {
  const auto width = [&](Resolution resolution) {
    auto squares = find_breather(problem, Phase::compressed, rule<double>(resolution)).start.y;
    for (double& y_n : squares) y_n *= y_n;
    return participation(squares);
  };
  return with_error(width(Resolution::coarse), width(Resolution::fine));
}

/// The article's residual of positions x at t = 0: the change of positions and velocities after a whole period, over the
/// largest of them, computed in extended precision.
inline double return_after_period(const Shooting<double>& problem, const Vector<double>& x) {
  const auto same = in_precision<Wide>(problem);
  const State<Wide> start = same.expand(x.cast<Wide>());
  State<Wide> end = start;
  flow(same.chain, end, same.period());
  return double(largest_difference(end, start) / largest(start));
}

/// |y_n(0)| of a breather, each site as accurate as the largest, and zero beyond the end of the chain.
template <class T>
struct Tail {
  std::vector<T> y;

  explicit Tail(const Shooting<double>& problem)
      : y(newton(in_precision<T>(problem), find_breather(problem), scaled_rule<T>()).start.y) {}
  T operator()(long n) const {
    const std::size_t i = site_index(n, y.size());
    return i < y.size() ? std::abs(y[i]) : T(0);
  }
  /// ln(-ln |y_n|), which grows by ln(3/2) a site; nan where there is no number.
  double double_log(long n) const {
    const T y = (*this)(n);
    return y > 0 ? double(std::log(-std::log(y))) : std::numeric_limits<double>::quiet_NaN();
  }
  /// ln |y_(n+1)| / ln |y_n|, outwards; nan where there is no number.
  double exponent(long n) const {
    const T y = (*this)(n), outer = (*this)(n < 0 ? n - 1 : n + 1);
    return outer > 0 ? double(std::log(outer) / std::log(y))
                     : std::numeric_limits<double>::quiet_NaN();
  }
};

}  // namespace lattice
