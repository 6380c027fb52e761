#include "sec34/at_rest.hpp"

#include <algorithm>
#include <cmath>

namespace lattice {

BreathersAtRest breathers_at_rest(double s) {
  std::vector<double> omegas;
  for (int k = 0; k <= 14; ++k) omegas.push_back(1.58 + 0.02 * k);
  BreathersAtRest f{
      breathers_at(Centre::bond, s, omegas), breathers_at(Centre::site, s, omegas), {}};
  for (std::size_t k = 0; k < std::min(f.bond.size(), f.site.size()); ++k)
    f.gap.push_back(
        barrier(problem_of(Centre::site, omegas[k], s), f.site[k], f.bond[k]).equal_area);
  return f;
}

namespace {

// A quantity of the bond-centred family at the frequency `omega`, interpolated linearly between two of
// every `each` members.
template <class Of>
double at_frequency(const BreathersAtRest& f, double omega, Of of, std::size_t each = 1) {
  std::size_t k = each;
  while (k + each < f.gap.size() && f.bond[k].omega < omega) k += each;
  const double a = f.bond[k - each].omega, b = f.bond[k].omega;
  return of(k - each) + (of(k) - of(k - each)) * (omega - a) / (b - a);
}

// Its error has two sources: the spacing of the members, which shows when only every second one is taken, and the
// error of the frequency
template <class Of>
Estimate value_at_rest(const BreathersAtRest& f, const Estimate& omega, Of of) {
  const double here = at_frequency(f, omega.value, of);
  Estimate out = compare(at_frequency(f, omega.value, of, 2), here);
  out.error += std::abs(at_frequency(f, omega.value + omega.error, of) - here);
  return out;
}

Estimate mean_inside(const std::vector<Inside>& coarse, const std::vector<Inside>& fine,
                     double Inside::*of) {
  const auto over = [&](const std::vector<Inside>& list) {
    double sum = 0, n = 0;
    for (const Inside& r : list)
      if (r.t > 100 && r.t < 300) sum += r.*of, ++n;
    return sum / n;
  };
  return compare(over(coarse), over(fine));
}

}  // namespace

void compare_inside(Quantities& facts, const std::string& name, const BreathersAtRest& f,
                    const std::vector<Inside>& coarse, const std::vector<Inside>& fine) {
  const auto mean = [&](double Inside::*of) { return mean_inside(coarse, fine, of); };
  const Estimate omega = mean(&Inside::omega);
  const std::string same = "bond-centred breather of the packet's frequency";
  facts.add("omega" + name, omega);
  facts.add("energy" + name, mean(&Inside::energy));
  facts.add("area" + name, mean(&Inside::area));
  facts.add("energy_at_rest" + name,
            value_at_rest(f, omega, [&](auto i) { return f.bond[i].energy; }), same);
  facts.add("area_at_rest" + name, value_at_rest(f, omega, [&](auto i) { return f.bond[i].area; }),
            same);
  facts.add("barrier" + name, value_at_rest(f, omega, [&](auto i) { return f.gap[i]; }),
            "E_site - E_bond at equal area");
}

}  // namespace lattice
