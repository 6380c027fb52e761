#pragma once
/**
# The peers

What would one use instead? The integrators of the GNU Scientific Library and of
Boost.odeint, through their ordinary interfaces. They are given our own vectorised force,
so that the comparison is one of methods. They know nothing of the chain and always move the whole of it. */

#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "lattice/gsl/reference.hpp"
#include "lattice/integrators/contact_rkn.hpp"
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

/// The force on every site of the chain.
inline void accelerate_all(const Chain& chain, const double* y, double* a) {
  Window all{0, chain.sites};
  accelerate(chain, y, a, all);
}

/// Carries `z`, positions and then velocities, from sample to sample with `advance(z, t0, t1)`.
template <class Advance>
Score carry_samples(const Problem& p, Advance advance) {
  const std::size_t n = p.chain.sites;
  State<double> s = p.start;
  Numbers z(s.y);
  z.insert(z.end(), s.v.begin(), s.v.end());
  Judge judge(p);
  for (double t = 0; t < p.time - 1e-9;) {
    const double next = std::min(t + p.sample, p.time);
    advance(z, t, next);
    s.y.assign(z.begin(), z.begin() + long(n));
    s.v.assign(z.begin() + long(n), z.end());
    s.t = t = next;
    judge(s);
  }
  return judge.score;
}

/// The equations of motion as a first-order system; counts its evaluations.
struct FirstOrder {
  const Chain& chain;
  double& count;
  void operator()(double, const double* z, double* dz) const {
    const std::size_t n = chain.sites;
    std::copy(z + n, z + 2 * n, dz);
    accelerate_all(chain, z, dz + n);
    count += 1;
  }
  void operator()(const Numbers& z, Numbers& dz, double t) const {
    (*this)(t, z.data(), dz.data());
  }
};

Score gsl(const Problem& p, const gsl_odeiv2_step_type* type, double tolerance) {
  double count = 0;
  lattice::Reference reference(FirstOrder{p.chain, count}, 2 * p.chain.sites,
                               lattice::Tolerance(tolerance, tolerance, type));
  Score score =
      carry_samples(p, [&](Numbers& z, double t, double next) { reference.advance(t, next, z); });
  score.evaluations = count;
  return score;
}

/// A controlled stepper of odeint that knows how to `try_step`.
template <class Stepper>
Score controlled(const Problem& p, Stepper stepper) {
  double count = 0;
  const FirstOrder system{p.chain, count};
  Score score = carry_samples(p, [&](Numbers& z, double t, double next) {
    odeint::integrate_adaptive(std::ref(stepper), system, z, t, next, 0.01);
  });
  score.evaluations = count;
  return score;
}

/**
The two steppers with a fixed step keep positions and velocities apart, and the step is
shortened to divide the sampling interval, as ours is. */
template <class Step>
Score fixed(const Problem& p, double h, Step step) {
  const std::size_t n = p.chain.sites;
  std::pair<Numbers, Numbers> x{Numbers(n), Numbers(n)};
  Score score = carry_samples(p, [&](Numbers& z, double t, double next) {
    std::copy_n(z.begin(), n, x.first.begin());
    std::copy_n(z.begin() + long(n), n, x.second.begin());
    const auto steps = std::size_t(std::ceil((next - t) / h));
    for (std::size_t k = 0; k < steps; ++k) step(x, t, (next - t) / double(steps));
    std::copy_n(x.first.begin(), n, z.begin());
    std::copy_n(x.second.begin(), n, z.begin() + long(n));
  });
  return score;
}

Score velocity_verlet(const Problem& p, double h) {
  odeint::velocity_verlet<Numbers> stepper;
  double count = 0;
  const auto system = [&](const Numbers& y, const Numbers&, Numbers& a, double) {
    accelerate_all(p.chain, y.data(), a.data());
    count += 1;
  };
  Score score =
      fixed(p, h, [&](auto& x, double t, double dt) { stepper.do_step(system, x, t, dt); });
  score.evaluations = count;
  return score;
}

Score mclachlan(const Problem& p, double h) {
  odeint::symplectic_rkn_sb3a_mclachlan<Numbers> stepper;
  double count = 0;
  const auto kick = [&](const Numbers& y, Numbers& a) {
    accelerate_all(p.chain, y.data(), a.data());
    count += 1;
  };
  Score score = fixed(p, h, [&](auto& x, double t, double dt) { stepper.do_step(kick, x, t, dt); });
  score.evaluations = count;
  return score;
}

/// Our own steppers, with the window or, for comparison, on the whole chain.
template <class Stepper>
Score own(const Problem& p, const Stepper& stepper, bool windowed) {
  Judge judge(p);
  State<double> s = p.start;
  double work = 0;
  if (windowed) {
    work = evolve(stepper, p.chain, s, p.time, p.sample, std::ref(judge)).work;
  } else {
    Window all{0, p.chain.sites};
    for (double t = 0; t < p.time - 1e-9; t = s.t) {
      const double next = std::min(t + p.sample, p.time);
      const auto steps = std::size_t(std::ceil((next - t) / stepper.step));
      work += stepper.advance(p.chain, s, all, (next - t) / double(steps), steps);
      s.t = next;
      judge(s);
    }
  }
  judge.score.evaluations = work / double(p.chain.sites);
  return judge.score;
}

}  // namespace bench
