#include "sec5/circle.hpp"

namespace lattice {

Interval<double> enclosed_cosine(const Interval<double>& x) {
  if (!(magnitude(x) <= 4)) return {-1, 1};
  const Interval<double> square = x * x;
  Interval<double> term(1), sum(1);
  // The terms from 4^2/2! on decrease, so that the remainder is smaller than the first that is left out
  for (int k = 1; k <= 20; ++k) {
    term = -(term * square) / Interval<double>(double((2 * k - 1) * (2 * k)));
    sum += term;
  }
  const double rest = magnitude(term);
  return common(sum + Interval<double>(-rest, rest), Interval<double>(-1, 1));
}

CosineTable::CosineTable(std::size_t count) : cosine(count), error(0) {
  // A quarter of the circle by the series; the rest by symmetry
  const auto angle = [&](std::size_t j) {
    return Interval<double>(2) * enclosed_pi() * double(j) / double(count);
  };
  for (std::size_t j = 0; j <= count / 4; ++j) {
    const Interval<double> c = enclosed_cosine(angle(j));
    cosine[j] = c.middle();
    error = std::max(error, c.radius());
  }
  for (std::size_t j = count / 4 + 1; j <= count / 2; ++j) cosine[j] = -cosine[count / 2 - j];
  for (std::size_t j = count / 2 + 1; j < count; ++j) cosine[j] = cosine[count - j];
}

double rounding_of_sum(std::size_t n) {
  const Interval<double> nu = Interval<double>(double(n)) * std::ldexp(1.0, -53);
  return (nu / (Interval<double>(1) - nu)).upper;
}

Sampled sample(const std::vector<double>& c, const CosineTable& table) {
  const std::size_t half = table.count() / 2;
  Sampled out{std::vector<double>(half + 1), 0};
  Interval<double> size{};
  for (double x : c) size += Interval<double>(std::abs(x));
  for (std::size_t j = 0; j <= half; ++j) {
    double sum = 0;
    for (std::size_t k = 0, at = 0; k < c.size(); ++k) {
      sum += c[k] * table.cosine[at];
      at += j;
      if (at >= table.count()) at -= table.count();
    }
    out.value[j] = sum;
  }
  // The entries of the table are at most one, wrong by `error`
  out.error =
      (size * (Interval<double>(table.error) + rounding_of_sum(c.size() + 1)) + underflow).upper;
  return out;
}

std::vector<Interval<double>> discrete_coefficients(const std::vector<Interval<double>>& half,
                                                    std::size_t count, const CosineTable& table) {
  const std::size_t m = table.count();
  std::vector<double> middle;
  Interval<double> radius{}, size{};
  for (const Interval<double>& f : half) {
    middle.push_back(f.middle());
    radius += Interval<double>(f.radius());
    size += Interval<double>(std::abs(middle.back()));
  }
  // The ends count half
  const double scale = 4.0 / double(m);  // exact: m is a power of two
  const Interval<double> error =
      scale * (radius + size * (Interval<double>(table.error) + rounding_of_sum(half.size() + 2)) +
               underflow);
  std::vector<Interval<double>> out(count);
  for (std::size_t k = 0; k < count; ++k) {
    double sum = middle.front() / 2;
    std::size_t at = k;
    for (std::size_t j = 1; j + 1 < middle.size(); ++j) {
      sum += middle[j] * table.cosine[at];
      at += k;
      if (at >= m) at -= m;
    }
    sum += middle.back() / 2 * (k % 2 ? -1 : 1);
    out[k] = (k == 0 ? 0.5 : 1.0) *
             (Interval<double>(scale * sum) + Interval<double>(-error.upper, error.upper));
  }
  return out;
}

}  // namespace lattice
