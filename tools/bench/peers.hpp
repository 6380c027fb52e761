#pragma once
/**
# The peers

What would one use instead? The integrators of the GNU Scientific Library and of
Boost.odeint, through their ordinary interfaces. They are given our own vectorised force,
so that the comparison is one of methods. They know nothing of the chain and always move the whole of it. */

#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lattice/gsl/reference.hpp"
#include "measure.hpp"

namespace bench {

namespace odeint = boost::numeric::odeint;
using lattice::Chain, lattice::State, lattice::Window;
using Numbers = std::vector<double>;

/**
A problem is a chain, its start and its duration. The judge sees the state every
`sample` units of time and compares it once, at `compare_at`, with the reference. */
struct Problem {
  std::string name;
  Chain chain;
  State<double> start;
  double time, sample = 100, compare_at = 100;
  Numbers reference{};  ///< displacements at `compare_at`
};

class Judge {
 public:
  explicit Judge(const Problem& problem)
      : problem_(problem), energy_(energy(problem.chain, problem.start)) {}
  void operator()(const State<double>& now) {
    const double drift = std::abs(energy(problem_.chain, now) / energy_ - 1);
    score.energy = std::max(score.energy, std::isfinite(drift) ? drift : 1e300);
    if (std::abs(now.t - problem_.compare_at) > 1e-9) return;
    for (std::size_t n = 0; n < now.y.size(); ++n)
      score.solution = std::max(score.solution, std::abs(now.y[n] - problem_.reference[n]));
  }
  Score score;

 private:
  const Problem& problem_;
  double energy_;
};

/// The force on the whole chain, as our peers ask for it; counts its evaluations.
struct Force {
  const Chain& chain;
  double& count;
  void operator()(const Numbers& y, Numbers& a) const { accelerate_all(y.data(), a.data()); }
  void operator()(const Numbers& y, const Numbers&, Numbers& a, double) const { (*this)(y, a); }
  /// Positions and then velocities, as a first-order system.
  void operator()(double, const double* z, double* dz) const {
    std::copy(z + chain.sites, z + 2 * chain.sites, dz);
    accelerate_all(z, dz + chain.sites);
  }
  void operator()(const Numbers& z, Numbers& dz, double t) const {
    (*this)(t, z.data(), dz.data());
  }
  void accelerate_all(const double* y, double* a) const {
    Window all{0, chain.sites};
    accelerate(chain, y, a, all);
    count += 1;
  }
};

/// Carries `z`, positions and then velocities, from sample to sample with `advance(force, z, t0, t1)`.
template <class Advance>
Score carry_samples(const Problem& p, Advance advance) {
  const std::size_t n = p.chain.sites;
  State<double> s = p.start;
  Numbers z(s.y);
  z.insert(z.end(), s.v.begin(), s.v.end());
  Judge judge(p);
  const Force force{p.chain, judge.score.evaluations};
  for (double t = 0; t < p.time - 1e-9;) {
    const double next = std::min(t + p.sample, p.time);
    advance(force, z, t, next);
    s.y.assign(z.begin(), z.begin() + long(n));
    s.v.assign(z.begin() + long(n), z.end());
    s.t = t = next;
    judge(s);
  }
  return judge.score;
}

Score gsl(const Problem& p, const gsl_odeiv2_step_type* type, double tolerance) {
  std::optional<lattice::Reference> reference;
  return carry_samples(p, [&](const Force& force, Numbers& z, double t, double next) {
    if (!reference)
      reference.emplace(force, z.size(), lattice::Tolerance(tolerance, tolerance, type));
    reference->advance(t, next, z);
  });
}

/// A controlled stepper of odeint that knows how to `try_step`.
template <class Stepper>
Score controlled(const Problem& p, Stepper stepper) {
  return carry_samples(p, [&](const Force& force, Numbers& z, double t, double next) {
    odeint::integrate_adaptive(std::ref(stepper), force, z, t, next, 0.01);
  });
}

/**
The two steppers with a fixed step keep positions and velocities apart, and the step is
shortened to divide the sampling interval, as ours is. */
template <class Stepper>
Score fixed(const Problem& p, double h, Stepper stepper) {
  const auto n = long(p.chain.sites);
  return carry_samples(p, [&](const Force& force, Numbers& z, double t, double next) {
    std::pair<Numbers, Numbers> x{{z.begin(), z.begin() + n}, {z.begin() + n, z.end()}};
    const auto steps = std::size_t(std::ceil((next - t) / h));
    for (std::size_t k = 0; k < steps; ++k)
      stepper.do_step(force, x, t, (next - t) / double(steps));
    std::copy(x.first.begin(), x.first.end(), z.begin());
    std::copy(x.second.begin(), x.second.end(), z.begin() + n);
  });
}

/// Our own steppers, with the window or, for comparison, on the whole chain.
template <class Stepper>
Score own(const Problem& p, const Stepper& stepper, bool windowed) {
  Judge judge(p);
  State<double> s = p.start;
  double work = 0;
  if (windowed) {
    work = evolve(stepper, p.chain, s, p.time, Every{p.sample}, std::ref(judge)).work;
  } else {
    Window all{0, p.chain.sites};
    const lattice::Advance advance = lattice::Method(stepper).on(p.chain);
    for (double t = 0; t < p.time - 1e-9; t = s.t) {
      const double next = std::min(t + p.sample, p.time);
      const auto steps = std::size_t(std::ceil((next - t) / stepper.step));
      work += advance(p.chain, s, all, (next - t) / double(steps), steps);
      s.t = next;
      judge(s);
    }
  }
  judge.score.evaluations = work / double(p.chain.sites);
  return judge.score;
}

}  // namespace bench
