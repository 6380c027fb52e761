#pragma once
/**
# A breather of the DpS equation that moves

The place of a breather is the centre of $|v_n|^4$: the fourth power keeps small noise of the whole
chain out. Its displacement $X$ is followed in the turning frame.

For a small perturbation along the pinning pair $(x, y)$ of spectrum.hpp, $X = gx$, where $g$ is the
derivative of the centre, and $\ddot X = \pm\lambda^2X$ with a plus at a site and a minus at a bond.
The simplest landscape with both is a sine, in which the centre is a pendulum,
$$\ddot X = \frac{\lambda^2}{2\pi}\sin 2\pi X$$
about a site, and a push $y$ its initial speed $g(\mu-m)y$. It predicts the push that frees a
bond-centred breather, $y_c = |\lambda|/(\pi g(\mu-m))$, and how long a site-centred one takes to the
neighbouring bond. If a push has the growing share $c = (\mu-m)y/(2\lambda)$, it starts with the speed
$v = 2g\lambda c$, and
$$t = \int_0^{1/2}\frac{dX}{\sqrt{v^2+(\lambda/\pi)^2\sin^2\pi X}},$$
a complete elliptic integral, for which the arithmetic-geometric mean suffices. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>
#include "lattice/dps/evolve.hpp"
#include "lattice/dps/spectrum.hpp"

namespace lattice {

/// Centre of |v_n|^4 in sites, counted from the rest position of a breather with this centre.
inline double breather_place(Centre centre, const Field& v) {
  double sum = 0, moment = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const double weight = std::norm(v[i]) * std::norm(v[i]);
    sum += weight;
    moment += weight * double(site_number(i, v.size()));
  }
  return moment / sum - (centre == Centre::bond ? 0.5 : 0);
}

/**
An eigenvector has no sign and no scale in sites, and the pendulum needs both. The derivative of the
centre along $V$ gives them: its modulus is $g$, and we turn $V$ so that a positive shift leads to
larger $n$. */
/// A breather with its pinning pair, whose sign is such that a shift x > 0 goes to larger n.
struct PinnedBreather {
  Centre centre;
  double mu;
  Field u;
  PinningPair pair;
  double shift;  ///< g: how far the centre moves, in sites, for a unit of x

  PinnedBreather(Centre c, double frequency, std::size_t sites)
      : PinnedBreather(stationary<double>(c, frequency, sites)) {}
  explicit PinnedBreather(const Stationary<double>& state)
      : centre(state.centre),
        mu(state.mu),
        u(state.u.begin(), state.u.end()),
        pair(contact_spectrum(state, true)),
        shift(0) {
    double sum = 0, moment = 0;
    for (std::size_t i = 0; i < u.size(); ++i) {
      const double x = state.u[i], cube = x * x * x;
      const double n = double(site_number(i, u.size())) - (centre == Centre::bond ? 0.5 : 0);
      sum += cube * x;
      moment += 4 * n * cube * pair.V(Eigen::Index(i));
    }
    shift = std::abs(moment / sum);
    if (moment < 0) pair.V = -pair.V;
  }

  /**
  With $g$ and $\lambda$ the pendulum has no parameter left, and what it predicts can be held against
  runs of the whole equation. The mean of arithmetic and geometric means settles within a few rounds,
  because every round squares the relative distance of the two. */
  /// The push at which a pendulum passes the site beside its bond.
  double freeing_push() const { return pair.rate / (std::numbers::pi * shift * (mu - pair.m)); }

  /// When a pendulum that is pushed from a site, with this growing share, is half a site away.
  double departure(double growing) const {
    const double speed = 2 * shift * pair.rate * std::abs(growing);
    double a = std::hypot(speed, pair.rate / std::numbers::pi), b = speed;
    if (!(speed > 0)) return std::numeric_limits<double>::infinity();
    while (a - b > 1e-15 * a) {
      const double mean = (a + b) / 2;
      b = std::sqrt(a * b);
      a = mean;
    }
    return 1 / (2 * a);
  }
};

/**
What a breather does is read from its displacement at samples in time, so a second resolution has to
differ in the samples as well as in the tolerance. The moment at which a distance is passed is
interpolated between two samples; noise that oscillates faster than they follow each other is the main
part of its error. */
/// Tolerance of the integrator, and samples for each unit of time.
struct Accuracy {
  double tolerance, samples;
};

/// Displacement against time, with the relative drifts of what is conserved.
struct Course {
  std::vector<double> t{}, X{};
  double norm_drift = 0, energy_drift = 0;

  double largest() const {
    double top = 0;
    for (const double x : X) top = std::max(top, std::abs(x));
    return top;
  }
  /// When |X| exceeds `distance` for the first time, interpolated; nan if it never does.
  double reaches(double distance) const {
    for (std::size_t k = 1; k < X.size(); ++k)
      if (const double now = std::abs(X[k]), before = std::abs(X[k - 1]); now > distance)
        return t[k - 1] + (t[k] - t[k - 1]) * (distance - before) / (now - before);
    return std::nan("");
  }
};

/**
We integrate in the frame that turns with the breather, where all that moves is the perturbation. Norm
and energy are looked at with every sample: their drift must stay far below the share of the energy
that pins the breather, or the run says nothing about pinning. */
/// Follows the field `v`, given in the frame that turns with the breather; `watch(t, v)` sees every
/// sample.
template <class Watch>
Course follow_breather(const PinnedBreather& breather, Field v, double time,
                       const Accuracy& accuracy, Watch watch) {
  Course out;
  const double start = energy(v);
  const TurningDps equation{{v.size(), Ends::free, 1}, breather.mu};
  out.norm_drift = evolve_dps(equation, v, time, std::size_t(std::ceil(accuracy.samples * time)),
                              accuracy.tolerance, [&](double t, const Field& now) {
                                out.t.push_back(t);
                                out.X.push_back(breather_place(breather.centre, now));
                                out.energy_drift =
                                    std::max(out.energy_drift, std::abs(energy(now) / start - 1));
                                watch(t, now);
                              });
  return out;
}

inline Course follow_breather(const PinnedBreather& breather, Field v, double time,
                              const Accuracy& accuracy) {
  return follow_breather(breather, std::move(v), time, accuracy, [](double, const Field&) {});
}

}  // namespace lattice
