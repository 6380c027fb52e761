#include "secB/alternating.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "lattice/gsl/reference.hpp"

namespace lattice {

namespace {

/// The struck chain; `x` has the displacements and then the velocities.
struct Alternating {
  TwoExponents law;
  std::size_t sites;

  double exponent(std::size_t contact) const { return contact % 2 == 0 ? law.second : law.first; }
  double push(std::size_t contact, double overlap) const {
    if (!(overlap > 0)) return 0;
    return (contact % 2 == 0 ? law.strength_ratio() : 1) * std::pow(overlap, exponent(contact));
  }
  void operator()(double, const double* x, double* dx) const {
    std::copy(x + sites, x + 2 * sites, dx);
    std::fill(dx + sites, dx + 2 * sites, 0.0);
    for (std::size_t i = 0; i + 1 < sites; ++i) {
      const double force = push(i, x[i] - x[i + 1]);
      dx[sites + i] -= force;
      dx[sites + i + 1] += force;
    }
  }
  /// Energy of the beads from `first` on and of their contacts.
  double energy_from(std::size_t first, const std::vector<double>& x) const {
    double sum = 0;
    for (std::size_t i = first; i < sites; ++i) {
      sum += x[sites + i] * x[sites + i] / 2;
      if (i + 1 == sites) break;
      const double overlap = x[i] - x[i + 1];
      if (overlap > 0) sum += push(i, overlap) * overlap / (exponent(i) + 1);
    }
    return sum;
  }
  /// Where a bead moves fastest.
  std::size_t crest(const std::vector<double>& x) const {
    const auto v = x.begin() + std::ptrdiff_t(sites);
    return std::size_t(std::max_element(v, x.end()) - v);
  }
};

}  // namespace

double TwoExponents::strength_ratio() const {
  return (second + 1) / (first + 1) * std::pow(length, second - first);
}

/**
The pulse is what lies within twelve sites of its crest; what it has left behind is slower. */
double loss_per_site(const TwoExponents& law, std::size_t from, std::size_t to, double tolerance) {
  constexpr std::size_t width = 12;
  const Alternating chain{law, to + 2 * width};
  std::vector<double> x(2 * chain.sites, 0.0);
  x[chain.sites] = 1;
  Reference integrator(chain, x.size(), tolerance);
  double t = 0;
  const auto energy_at = [&](std::size_t site) {
    while (chain.crest(x) < site) integrator.advance(t, t + 0.5, x);
    return chain.energy_from(chain.crest(x) - width, x);
  };
  const double before = energy_at(from);
  const auto passed = double(chain.crest(x));
  const double after = energy_at(to);
  return std::log(before / after) / (double(chain.crest(x)) - passed);
}

double lossless_exponent(TwoExponents law, double low, double high, std::size_t from,
                         std::size_t to, double tolerance) {
  const auto root_of_loss = [&](double second) {
    law.second = second;
    return std::sqrt(std::max(0.0, loss_per_site(law, from, to, tolerance)));
  };
  const double below = root_of_loss(low), above = root_of_loss(high);
  return low + (high - low) * below / (below + above);
}

}  // namespace lattice
