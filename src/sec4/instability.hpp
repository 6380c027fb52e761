#pragma once
/**
# Where phonons are unstable, for any compression and well

Values of formulas have no step to halve, but they have rounding errors: we evaluate in `double` and in `long double`
and take the difference as the error. Where large terms cancel, the last digit of an argument decides, in both alike. So
each argument is changed by one unit in its last place, and what that changes is added. */

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <tuple>
#include <vector>

#include "lattice/numerics/estimate.hpp"
#include "sec4/phonons.hpp"

namespace lattice {

/// A formula of these arguments in two precisions, with the error that rounding them makes.
template <class Formula, std::same_as<double>... Arguments>
Estimate in_two_precisions(Formula formula, Arguments... x) {
  const auto fine = [&](const std::array<double, sizeof...(x)>& at) {
    return std::apply([&](auto... y) { return formula(static_cast<long double>(y)...); }, at);
  };
  const std::array<double, sizeof...(x)> given{x...};
  const long double value = fine(given);
  Estimate out = compare(double(formula(x...)), double(value));
  for (std::size_t i = 0; i < given.size(); ++i) {
    long double most = 0;
    for (double side : {-HUGE_VAL, HUGE_VAL}) {
      auto beside = given;
      beside[i] = std::nextafter(given[i], side);
      most = std::max(most, std::abs(fine(beside) - value));
    }
    out.error += double(most);
  }
  return out;
}

/**
Both factors of $\Phi$ can change sign, so the unstable wavenumbers may be one interval, or several, or none. None is
lost if we know all zeros. That of $\omega_2$ has a closed form, and with $x = 1-\cos q$ those of $\beta$ are the zeros
of
$$\tfrac{2d}9\,(4v_1x^2+3)\,\beta = -x^4 + x^3 + \bigl(2sd^{3/2}-\tfrac14d^{-1/2}\bigr)x^2 + sd,$$
of which three stationary points are known, one of them at $x = 0$. */
/// The edges of these intervals between 0 and pi, in 1/site: from, to, from, to ...
template <class T>
std::vector<T> edges_of_instability(T d, T s);

}  // namespace lattice
