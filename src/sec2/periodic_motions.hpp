#pragma once
/**
# 2 Periodic motions of chains without wells

Motions that are not localized, on which the identity of section 2 can be tested: a wave on a uniform ring, and
standing waves of chains whose masses, stiffnesses and exponents differ from place to place. */

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "lattice/gsl/random.hpp"
#include "lattice/orbits/shooting.hpp"
#include "sec2/mean_force.hpp"

namespace motions {

using namespace lattice;

/// Numbers that vary along the chain, each within `by` of one.
inline std::vector<double> uneven(std::size_t count, double by, unsigned long seed) {
  return shaken(std::vector<double>(count, 1), by, seed);
}

/**
Newton's method needs a guess. All motions here have frequency one; any other is a matter of scale. The
push of an overlap $R\cos\phi$ has the first harmonic $0.457\,R^\alpha$ at $\alpha = 3/2$; the factor is
$1/(\sqrt2\,\tau_0)$ with the $\tau_0$ of section 3.1. If all other harmonics are neglected, a wave of wave
number $q$ on a uniform ring has the amplitude computed below. At $q = \pi$ this is a standing wave, from
which we start on uneven chains. On a ring the origin of the displacements is arbitrary: of all Newton steps
that differ by a shift we take the shortest (`rank`). */
inline double wave_amplitude(double q, double alpha) {
  const double neighbours = 2 * std::sin(q / 2);  // amplitude of the difference of two neighbours
  return std::pow(0.457 * std::pow(neighbours, alpha + 1), 1 / (1 - alpha));
}

/// Newton's method where the motion may move freely: damped, blind to directions that change nothing.
inline NewtonRule<double> free_rule() {
  NewtonRule<double> rule;
  rule.damped = true;
  rule.most_steps = 60;
  rule.rank = 1e-9;
  return rule;
}

/// A wave of wave number 6 pi / N and frequency one, which moves on by one site in the time q.
inline Orbit<double> ring_wave(Shooting<double>& problem) {
  const std::size_t sites = problem.chain.sites;
  const double q = 6 * std::numbers::pi / double(sites);
  problem.symmetry = travelling(sites, 1, true);
  problem.omega = 2 * std::numbers::pi / q;
  State<double> guess(sites);
  const double amplitude = wave_amplitude(q, problem.chain.contact.exponent());
  for (std::size_t n = 0; n < sites; ++n) {
    guess.y[n] = amplitude * std::cos(q * double(n));
    guess.v[n] = amplitude * std::sin(q * double(n));
  }
  return newton(problem, problem.reduce(guess), free_rule());
}

/**
On an uneven chain nothing travels without a change of form, so we look for the simplest motions that
remain: those that begin at rest and come to rest again after half a period. On a uniform ring beads that
all swing against their neighbours do so; from there we make masses, stiffnesses and exponents uneven
step by step. */
inline constexpr int degrees = 4;

/// Beads that swing against their neighbours on a ring, as a guess.
inline State<double> zigzag(std::size_t sites) {
  State<double> guess(sites);
  for (std::size_t n = 0; n < sites; ++n)
    guess.y[n] = (n % 2 == 0 ? 1 : -1) * wave_amplitude(std::numbers::pi, 1.5);
  return guess;
}

/// The chain of `problem` with the given exponent, masses and stiffnesses that differ by 15 per cent.
inline Orbit<double> standing_wave(Shooting<double>& problem, double alpha) {
  Chain& chain = problem.chain;
  problem.symmetry = even_in_time(chain.sites);
  Orbit<double> orbit;
  orbit.x = problem.reduce(zigzag(chain.sites));
  for (int k = 0; k <= degrees; ++k) {
    const double part = double(k) / degrees;
    std::vector<double> eta = uneven(chain.sites + 1, 0.15 * part, 12);
    if (chain.ends == Ends::periodic) eta.back() = eta.front();
    vary(chain, uneven(chain.sites, 0.15 * part, 11), eta);
    chain.contact = PowerContact{1.5 + part * (alpha - 1.5)};
    orbit = newton(problem, orbit.x, free_rule());
  }
  return orbit;
}

/**
The library has one exponent for a whole chain, and the theorem holds for any. Where every contact between
the two walls has its own, we write the push here, and mean_force.hpp does the rest. */
struct MixedChain {
  std::size_t sites = 0;
  None well{};
  std::vector<double> mass{}, stiffness{}, exponent{};
  double mass_of(std::size_t n) const { return mass[n]; }
};

/// The push of contact `i` at the positions `y`; never negative.
inline double contact_push(const MixedChain& chain, const double* y, std::size_t i) {
  const double left = i > 0 ? y[i - 1] : 0, right = i < chain.sites ? y[i] : 0;
  return left > right ? chain.stiffness[i] * std::pow(left - right, chain.exponent[i]) : 0;
}

/**
The library's Newton method takes any residual. For the mixed chain it is that of GSL's integrator, and the derivative is a
central difference over a hundred-thousandth of the amplitude: then its error, of second order, does not slow the
method down. */
/// The velocities of a chain after half a period of frequency one from rest at `x`, which must vanish.
inline Vector<double> velocities_after_half(const MixedChain& chain, const Vector<double>& x) {
  State<double> start(chain.sites);
  std::copy(x.begin(), x.end(), start.y.begin());
  const auto v = mean_forces(chain, start, std::numbers::pi, 1e-14).end.v;
  return Eigen::Map<const Vector<double>>(v.data(), Eigen::Index(v.size()));
}
inline Equations<double> rest_after_half(const MixedChain& chain) {
  const auto residual = [=](const Vector<double>& x) { return velocities_after_half(chain, x); };
  return by_differences("standing wave with mixed exponents", residual, 1e-5);
}

/**
The exponents are to differ as much as the masses do. At full unevenness, `part` = 1, masses and
stiffnesses vary by 15 per cent and exponents lie between 1.4 and 1.8; all these numbers are our choice. */
inline MixedChain mixed_chain(double part) {
  MixedChain chain{5,
                   {},
                   uneven(5, 0.15 * part, 13),
                   uneven(6, 0.15 * part, 14),
                   {1.5, 1.7, 1.4, 1.6, 1.8, 1.5}};
  for (double& alpha : chain.exponent) alpha = 1.5 + part * (alpha - 1.5);
  return chain;
}

/// The start of the standing wave; throws NewtonFailed.
inline State<double> mixed_wave() {
  State<double> start = zigzag(5);
  NewtonRule<double> rule = free_rule();
  rule.rank = 0;
  for (int k = 0; k <= degrees; ++k) {
    const auto x = Eigen::Map<const Vector<double>>(start.y.data(), 5).eval();
    const MixedChain chain = mixed_chain(double(k) / degrees);
    const Vector<double> found = newton(rest_after_half(chain), x, rule).x;
    std::copy(found.begin(), found.end(), start.y.begin());
  }
  return start;
}

}  // namespace motions
