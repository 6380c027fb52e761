#include "lattice/orbits/other_chains.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <vector>

namespace lattice {

Chain between(const Chain& a, const Chain& b, double part) {
  const auto mixed = [&](double from, double to) { return (1 - part) * from + part * to; };
  for (const Chain* chain : {&a, &b}) assert_fits(*chain, b.sites);
  Chain out = b;
  if (part == 1) return out;
  // What differs from bead to bead
  std::vector<double> mass(b.sites), eta(b.sites + 1);
  for (std::size_t i = 0; i < b.sites; ++i) mass[i] = mixed(a.mass_of(i), b.mass_of(i));
  for (std::size_t i = 0; i <= b.sites; ++i) eta[i] = mixed(a.eta_of(i), b.eta_of(i));
  if (a.variation || b.variation) vary(out, mass, eta);
  // What all wells and contacts have
  if (const auto* from = a.well.get_if<Quartic>(), *to = b.well.get_if<Quartic>();
      from && to && from->s != to->s)
    out.well = Quartic{mixed(from->s, to->s)};
  if (b.contact.is<OwnContact>()) return out;
  const double root = mixed(std::sqrt(a.contact.opening()), std::sqrt(b.contact.opening()));
  out.contact =
      without_cutoff(PowerContact{mixed(a.contact.exponent(), b.contact.exponent()), root * root});
  return out;
}

// Along the path the guess lies on the line through the last two orbits
Orbit<double> continue_to(Shooting<double> problem, const Orbit<double>& from,
                          const Chain& target) {
  if (target.sites != problem.chain.sites)
    throw std::invalid_argument("continuation between two chains needs chains of equal length");
  NewtonRule<double> rule;
  rule.damped = true, rule.most_steps = 12, rule.reuse_below = 1e-9;
  const Chain start = problem.chain;
  Orbit<double> here = from;
  Vector<double> slope = Vector<double>::Zero(from.x.size());
  for (double part = 0, step = 1.0 / 8; part < 1;) {
    const double next = std::min(1.0, part + step);
    problem.chain = between(start, target, next);
    const Vector<double> guess = here.x + (next - part) * slope;
    History history;
    try {
      const Orbit<double> there = newton(problem, guess, rule);
      history = there.history;
      if (sup<double>(there.x - guess) < 0.1 * here.amplitude) {
        slope = (there.x - here.x) / (next - part);
        here = there, part = next, step *= 2;
        continue;
      }
    } catch (const NewtonFailed& error) {
      history = error.history;
    }
    // It failed or went too far
    step /= 2;
    if (step > 1.0 / 4096) continue;
    char text[160];
    std::snprintf(text, sizeof text,
                  ": continuation to this chain stops at the fraction %.3g, with contacts of "
                  "exponent %.4g compressed by %.4g",
                  part, problem.chain.contact.exponent(), problem.chain.contact.opening());
    throw NewtonFailed(problem.name() + text, history);
  }
  return here;
}

}  // namespace lattice
