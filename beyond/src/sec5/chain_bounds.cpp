#include "sec5/chain_bounds.hpp"

namespace lattice {

namespace {

using Number = Interval<double>;

const Number one(1), two(2);

/// sin(pi / omega), which is positive for 1 < omega < 2.
Number sine(const Number& omega) {
  return enclosed_cosine(enclosed_pi() / omega - enclosed_pi() / two);
}

enum class Weight { one, square };

/// Sum of the moduli of coefficients, the k-th weighted with 1 or, for the second derivative, k^2.
Number weighted_sum(const std::vector<double>& c, Weight weight) {
  Number sum{};
  for (std::size_t k = 0; k < c.size(); ++k)
    sum += Number(std::abs(c[k])) * double(weight == Weight::one ? 1 : k * k);
  return sum;
}

}  // namespace

Number mean_of_kernel(const Number& omega) {
  return two / sine(omega) - one;
}

Number largest_of_kernel(const Number& omega) {
  return enclosed_pi() / (omega * sine(omega));
}

Number variation_of_force(const std::vector<double>& c) {
  return Number(3) * root(weighted_sum(c, Weight::one)) * weighted_sum(c, Weight::square);
}

Number folded_back(std::size_t samples, std::size_t harmonics) {
  const Number gap = Number(double(samples)) - double(harmonics);
  return two * enclosed_pi() * enclosed_pi() / Number(3) / (gap * gap);
}

Number left_out(const Number& omega, std::size_t harmonics) {
  const double last = double(harmonics - 1);
  return two / (Number(3) * (omega * omega - one / (Number(last) * last)) * last * last * last);
}

std::vector<Number> ranges(const std::vector<double>& c, std::size_t cells) {
  const Sampled values = sample(c, CosineTable(2 * cells));
  const Number h = enclosed_pi() / double(cells);
  const Number bend = h * h / Number(8) * weighted_sum(c, Weight::square) + Number(values.error);
  std::vector<Number> out;
  for (std::size_t p = 0; p < cells; ++p)
    out.push_back(hull(Number(values.value[p]), Number(values.value[p + 1])) +
                  Number(-bend.upper, bend.upper));
  return out;
}

}  // namespace lattice
