#include "secB/exponents.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "lattice/numerics/parallel.hpp"
#include "lattice/quadruple/extended.hpp"
#include "lattice/standing/spectrum.hpp"

namespace lattice {

namespace {

/// What is computed with numbers of one type.
template <class T>
struct Computed {
  T norm, margin, rate, bend;
};

template <class T>
Computed<T> compute(Centre centre, double alpha, std::size_t longer) {
  using std::abs, std::log;
  const T mu(1);
  const auto state = stationary<T>(centre, mu, sites_of(centre, alpha) + longer, alpha);
  const T m = counted_eigenvalue(state, 2);
  // Around a bond both central sites have the same modulus, and the centre lies between them
  const auto size = [&](long n) { return T(log(abs(state.u[site_index(n, state.u.size())]))); };
  const T bend = centre == Centre::site ? T(size(1) - T(2) * size(0) + size(-1))
                                        : T((size(2) - size(1) - size(0) + size(-1)) / T(2));
  return {state.norm(), instability_margin(mu, m, alpha), lambda_modulus(mu, m, alpha),
          bend / (T(-2) * (T(alpha) - T(1)))};
}

template <class T>
double rounded(const T& x) {
  return static_cast<double>(x);
}

/// The two precisions and the two lengths.
struct Thrice {
  Computed<Quadruple> coarse;
  Computed<FiftyDigits> fine, longest;

  Thrice(Centre centre, double alpha, std::size_t longer)
      : coarse(compute<Quadruple>(centre, alpha, longer)),
        fine(compute<FiftyDigits>(centre, alpha, longer)),
        longest(compute<FiftyDigits>(centre, alpha, longer + 10)) {}

  /// `of` the results. The differences are taken before anything is rounded to double.
  template <class Of>
  Estimate estimate(Of of) const {
    const FiftyDigits value = of(fine);
    const double precision = rounded(FiftyDigits(FiftyDigits(of(coarse)) - value));
    const double length = rounded(FiftyDigits(of(longest) - value));
    const double rounding = 4 * rounded(FiftyDigits(abs(of(fine)) + FiftyDigits(1))) *
                            rounded(std::numeric_limits<FiftyDigits>::epsilon());
    return {rounded(value), std::abs(precision) + std::abs(length) + rounding};
  }
};

BreatherOfExponent breather(const Thrice& all) {
  return {all.estimate([](const auto& c) { return c.norm; }),
          all.estimate([](const auto& c) { return c.margin; }),
          all.estimate([](const auto& c) { return c.rate; }),
          all.estimate([](const auto& c) { return c.bend; })};
}

/// N_bond / N_site - 1 with numbers of one type.
template <class T>
T norm_difference(const Computed<T>& site, const Computed<T>& bond) {
  return bond.norm / site.norm - T(1);
}

}  // namespace

// At its ends the integrand is the limit of a quotient
Estimate pinning_exponent() {
  const auto on = [](int steps) {
    const double half = std::numbers::pi / 2, h = half / steps;
    double sum = 2 * std::numbers::pi + 8 / std::numbers::pi;
    for (int k = 1; k < steps; ++k) {
      const double theta = k * h;
      sum += (k % 2 ? 4 : 2) * (2 * std::numbers::pi - 4 * theta) * std::tan(theta) / theta;
    }
    return sum * h / 3;
  };
  return compare(on(100), on(200));
}

OfExponent breathers_of_exponent(double alpha, std::size_t longer) {
  const Thrice site(Centre::site, alpha, longer), bond(Centre::bond, alpha, longer);
  const FiftyDigits value = norm_difference(site.fine, bond.fine);
  const FiftyDigits coarse(norm_difference(site.coarse, bond.coarse)),
      longest = norm_difference(site.longest, bond.longest);
  const double error = std::abs(rounded(FiftyDigits(coarse - value))) +
                       std::abs(rounded(FiftyDigits(longest - value)));
  return {alpha, breather(site), breather(bond), {rounded(value), error}};
}

std::vector<OfExponent> scan_exponents(const std::vector<double>& alphas) {
  std::vector<OfExponent> rows(alphas.size());
  parallel_for("exponents", rows.size(),
               [&](std::size_t i) { rows[i] = breathers_of_exponent(alphas[i]); });
  return rows;
}

}  // namespace lattice
