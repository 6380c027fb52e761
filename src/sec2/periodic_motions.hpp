#pragma once
/**
# 2 Periodic motions of chains without wells

Motions that are not localized, on which the identity of section 2 can be tested: a wave on a uniform ring, and
standing waves of chains whose masses and stiffnesses differ from place to place. */

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "lattice/gsl/random.hpp"
#include "lattice/orbits/shooting.hpp"

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

}  // namespace motions
