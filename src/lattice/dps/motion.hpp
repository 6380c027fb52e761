#pragma once
/**
# A breather of the DpS equation that moves

Section 3.3 perturbs a stationary breather (stationary.hpp) and sees it move. Its place is the centre of
$|v_n|^4$: the fourth power keeps out small noise along the chain. For a small shift $x$ and push $y$ along
the pinning pair of spectrum.hpp the displacement is $X = gx$, where $g$ is the derivative of the centre,
and $\ddot X = \pm\lambda^2X$ with the plus at a site and the minus at a bond. The simplest energy
landscape with both is a sine, in which the centre moves like a pendulum; about a site
$$\ddot X = \frac{\lambda^2}{2\pi}\sin 2\pi X,$$
and a push $y$ gives it the initial speed $g(\mu-m)y$. This predicts the push that frees a bond-centred
breather, $y_c = |\lambda|/(\pi g(\mu-m))$, and the time that a site-centred one takes to the next bond. If
its push has the growing share $c = (\mu-m)y/(2\lambda)$, it starts with the speed $v = 2g\lambda c$, and
$$t = \int_0^{1/2}\frac{dX}{\sqrt{v^2+(\lambda/\pi)^2\sin^2\pi X}},$$
a complete elliptic integral, for which the arithmetic-geometric mean suffices. */

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>
#include "lattice/dps/evolve.hpp"
#include "lattice/dps/spectrum.hpp"
#include "lattice/numbers/criterion.hpp"
#include "lattice/numbers/line_fit.hpp"
#include "lattice/numbers/random.hpp"

namespace lattice {

/// Centre of |v_n|^4 in sites, counted from the rest position of a breather with this centre.
inline double quartic_centre(Centre centre, const Field& v) {
  double sum = 0, moment = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const double weight = std::norm(v[i]) * std::norm(v[i]);
    sum += weight;
    moment += weight * double(site_number(i, v.size()));
  }
  return moment / sum - (centre == Centre::bond ? 0.5 : 0);
}

/**
An eigenvector has neither a sign nor a scale in sites, and the pendulum needs both. The derivative of the
centre along $V$ gives them: its modulus is $g$, and the sign of $V$ is chosen such that a positive shift
leads to larger $n$. */
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
  With $g$ and $\lambda$ the pendulum has no free parameter left, and its predictions can be compared with
  runs of the whole equation. The arithmetic-geometric mean converges within a few rounds, because every
  round squares the relative distance of the two means. */
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
interpolated between two samples; its error comes mainly from noise that oscillates faster than the
samples can show. */
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
We integrate in the frame that turns with the breather (evolve.hpp), where only the perturbation moves.
Norm and energy are watched at every sample: unless their drift stays far below the share of the energy
that pins the breather, the run says nothing about pinning. */
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
                                out.X.push_back(quartic_centre(breather.centre, now));
                                out.energy_drift =
                                    std::max(out.energy_drift, std::abs(energy(now) / start - 1));
                                watch(t, now);
                              });
  return out;
}

/// The same without an observer.
inline Course follow_breather(const PinnedBreather& breather, Field v, double time,
                              const Accuracy& accuracy) {
  return follow_breather(breather, std::move(v), time, accuracy, [](double, const Field&) {});
}

/**
Two questions can be put to a breather that is perturbed along the pinning pair and in no other way. The
first: does a perturbation in the growing direction grow at the rate that the matrix says?
`measured_rate` is the slope of a line through the logarithm of its growing share. */
inline double measured_rate(const PinnedBreather& site, double size, const Accuracy& accuracy) {
  Field v = site.u;
  site.pair.add({size, size / site.pair.push}, v);
  std::vector<double> t, share;
  follow_breather(site, v, 4 / site.pair.rate, accuracy, [&](double now, Field w) {
    for (std::size_t i = 0; i < w.size(); ++i) w[i] -= site.u[i];
    t.push_back(now);
    share.push_back(std::log(site.pair.growing(w)));
  });
  return fit_line(t, share).slope;
}

/// Has it passed the next rest position of its own kind?
inline bool moved(const Course& course) {
  return course.largest() > 1;
}

/**
The second: which push frees a breather? The interval between a push that does not and one that does is
halved `steps` times. The pendulum says where to look, within 20 per cent. Throws std::runtime_error if
the threshold is not there. */
inline double bisect_push(const PinnedBreather& bond, const Accuracy& accuracy, int steps) {
  const auto freed = [&](double push) {
    Field v = bond.u;
    bond.pair.add({0, push}, v);
    return moved(follow_breather(bond, v, 12 / bond.pair.rate, accuracy));
  };
  double low = 0.8 * bond.freeing_push(), high = 1.2 * bond.freeing_push();
  if (freed(low) || !freed(high))
    throw std::runtime_error("the push that frees the bond-centred breather is not between " +
                             std::to_string(low) + " and " + std::to_string(high));
  for (int k = 0; k < steps; ++k) {
    const double middle = (low + high) / 2;
    (freed(middle) ? high : low) = middle;
  }
  return (low + high) / 2;
}

/**
## Breathers under noise

The article adds uniformly distributed noise to the breather. For complex numbers this is not definite: the
noise may be complex or real, of both signs or positive, absolute or a share of
$u_n$. The difference matters, since a push counts far more than a shift, so the kind of noise is a
parameter. One seed gives the same perturbation on every machine. */
struct Noise {
  const char* name;
  bool imaginary, positive, relative;
  double amplitude;

  /// Noise for every site of the breather `u`.
  Field operator()(const Field& u, std::size_t seed) const {
    Random random(seed);
    const auto draw = [&] {
      return amplitude * (positive ? random.uniform(0, 1) : random.uniform(-1, 1));
    };
    Field w;
    for (const auto& u_n : u) {
      const double re = draw(), im = imaginary ? draw() : 0;
      w.push_back(std::complex<double>(re, im) * (relative ? u_n : 1.0));
    }
    return w;
  }
};

/**
To first order the noise moves the breather only through its component along the pinning pair. A trial
notes that component together with the runs, so that we can ask later whether it predicts them. It can
also be removed from the noise, which leaves a control that differs in nothing else. */
struct Trial {
  std::size_t seed;
  std::complex<double> kick{};  ///< shift and push of the noise
  double growing = 0;           ///< size of its growing share
  Course rough{}, good{};       ///< at two tolerances
};

/// Breather plus noise, the latter with or without (`pinned` false) its component along the pinning pair;
/// notes that component in `trial`.
inline Field perturbed(const PinnedBreather& breather, const Noise& noise, bool pinned,
                       Trial& trial) {
  Field w = noise(breather.u, trial.seed);
  if (!pinned) breather.pair.add(-breather.pair.of(w), w);
  trial.kick = breather.pair.of(w);
  trial.growing = std::abs(breather.pair.growing(w));
  for (std::size_t i = 0; i < w.size(); ++i) w[i] += breather.u[i];
  return w;
}

/**
The effect of noise is a matter of counting cases. A breather has left when its centre is half a site
away, and it has moved when it has passed the next rest position of its own kind; one that only falls
into the well beside it swings back before that. Cases are counted at both tolerances, because a count is
exact only if both give the same. */
struct Census {
  std::size_t left = 0, moved = 0;
  std::vector<double> departures{}, speeds{};  ///< sorted; no departure is infinite

  double departure() const { return departures[departures.size() / 2]; }
};

/**
The speed of a trial is the mean over the first site that its breather crosses after leaving, if it does. A
departure that has not happened counts as infinitely late, so that the median is not biased by the end of
the run. */
inline Census tally(const std::vector<Trial>& trials, Course Trial::*run) {
  Census out;
  for (const Trial& trial : trials) {
    const Course& course = trial.*run;
    const double leaves = course.reaches(0.5), there = course.reaches(1.5);
    out.left += std::isfinite(leaves);
    out.moved += moved(course);
    out.departures.push_back(std::isfinite(leaves) ? leaves : HUGE_VAL);
    if (std::isfinite(there)) out.speeds.push_back(1 / (there - leaves));
  }
  std::sort(out.departures.begin(), out.departures.end());
  std::sort(out.speeds.begin(), out.speeds.end());
  return out;
}

/**
Does the pendulum predict these runs? Departures are compared one by one, and the largest relative
difference counts. PushCounts are compared with the one that frees: `over` counts the trials that are pushed
harder, `told` those whose fate is what this alone predicts. */
inline double departure_difference(const std::vector<Trial>& trials, Course Trial::*run,
                                   const PinnedBreather& site) {
  double apart = 0;
  for (const Trial& trial : trials) {
    const double pendulum = site.departure(trial.growing);
    apart = std::max(apart, std::abs((trial.*run).reaches(0.5) / pendulum - 1));
  }
  return apart;
}

/// How many trials are pushed harder than the push that frees, and how many fates that tells.
struct PushCount {
  std::size_t over = 0, told = 0;
};

inline PushCount count_pushes(const std::vector<Trial>& trials, Course Trial::*run,
                              double freeing) {
  PushCount out;
  for (const Trial& trial : trials) {
    const bool pushed = std::abs(trial.kick.imag()) > freeing;
    out.over += pushed;
    out.told += pushed == moved(trial.*run);
  }
  return out;
}

/**
A pinned breather and a free one differ by a minute share of the energy, so whether these runs can be
trusted is decided by the largest drift of energy and norm among them. */
inline double largest_drift(const std::vector<Trial>& trials, Course Trial::*run) {
  double drift = 0;
  for (const Trial& trial : trials)
    drift = std::max({drift, (trial.*run).energy_drift, (trial.*run).norm_drift});
  return drift;
}

/**
## The statements of section 3.3

Stability is a sign, and `Margin::safe` (spectrum.hpp) must have it beyond its error. That the growth rate is
linear in $\mu$ is tested by its ratio to $\mu$, which may vary by a fraction of $10^{-8}$. The instability
moves breathers if at least half of those under noise move, none of the `controls` does, whose noise lacks
the pinning pair, and both tolerances give every breather the same fate; the bounds are ours. */
/// Around a bond, from its margin.
inline Condition surely_stable(const std::string& name, const Margin& found) {
  return below(name, found.safe(), 0);
}

/// Around a site, from the safe margin closest to zero and the largest variation of the rate over mu.
inline Criterion linear_growth(const Estimate& weakest, const Estimate& variation) {
  return {above("weakest", weakest, 0), below("variation", variation, 1e-8)};
}

/// From trials at both tolerances.
inline Criterion moved_by_instability(const std::vector<Trial>& trials,
                                      const std::vector<Trial>& controls) {
  std::int64_t torn = 0;
  for (const auto* list : {&trials, &controls})
    for (const Trial& trial : *list) torn += moved(trial.good) != moved(trial.rough);
  const auto count = [](const std::vector<Trial>& list) {
    return compare(tally(list, &Trial::rough).moved, tally(list, &Trial::good).moved);
  };
  return {above("trials", count(trials), (double(trials.size()) - 1) / 2),
          below("controls", count(controls), 0.5), below("torn", exact(double(torn)), 0.5)};
}

}  // namespace lattice
