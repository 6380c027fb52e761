#include "sec5/half_line.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lattice {

namespace {

/// P_0, ..., P_n at z.
std::vector<double> legendre(std::size_t n, double z) {
  std::vector<double> p{1, z};
  for (std::size_t k = 1; k < n; ++k) {
    const double m = double(k);
    p.push_back(((2 * m + 1) * z * p[k] - m * p[k - 1]) / (m + 1));
  }
  return p;
}

/// The derivative of P_n at z, from the last two of the list.
double legendre_slope(const std::vector<double>& p, double z) {
  const std::size_t n = p.size() - 1;
  return double(n) * (z * p[n] - p[n - 1]) / (z * z - 1);
}

}  // namespace

QuadraturePanel::QuadraturePanel(std::size_t count, std::size_t zeros)
    : nodes(count), order(zeros) {
  const auto n = Eigen::Index(count);
  x.resize(n), weight.resize(n), lagrange.resize(n), integral.resize(n, n);
  // The zeros of the Legendre polynomial by Newton's method
  std::vector<std::vector<double>> p;
  for (Eigen::Index i = 0; i < n; ++i) {
    double z = -std::cos(std::numbers::pi * (double(i) + 0.75) / (double(n) + 0.5));
    for (int pass = 0; pass < 8; ++pass) {
      const auto at = legendre(count, z);
      z -= at.back() / legendre_slope(at, z);
    }
    p.push_back(legendre(count + 1, z));
    const double slope =
        legendre_slope({p.back().begin(), p.back().begin() + std::ptrdiff_t(count) + 1}, z);
    x[i] = (1 + z) / 2, weight[i] = 1 / ((1 - z * z) * slope * slope);
    lagrange[i] = (i % 2 ? -1 : 1) * std::sqrt((1 - z * z) * weight[i]);
  }
  // A Lagrange polynomial is a sum of Legendre polynomials, whose integrals are known
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      double sum = x[i];
      for (std::size_t k = 1; k < count; ++k)
        sum += p[std::size_t(j)][k] * (p[std::size_t(i)][k + 1] - p[std::size_t(i)][k - 1]) / 2;
      integral(i, j) = weight[j] * sum;
    }
}

double QuadraturePanel::map(double s) const {
  return order == 2 ? s * s * (3 - 2 * s) : s * s * s * (10 - s * (15 - 6 * s));
}

double QuadraturePanel::slope(double s) const {
  const double both = s * (1 - s);
  return order == 2 ? 6 * both : 30 * both * both;
}

// On the left half w is convex, so Newton's method comes down to the solution after its first step
double QuadraturePanel::inverse(double u) const {
  if (u > 0.5) return 1 - inverse(1 - u);
  if (!(u > 0)) return 0;
  double x = order == 2 ? std::sqrt(u / 3) : std::cbrt(u / 10);
  for (int pass = 0; pass < 7; ++pass) x -= (map(x) - u) / slope(x);
  return x;
}

double QuadraturePanel::interpolate(const double* values, double s) const {
  double above = 0, below = 0;
  for (std::size_t j = 0; j < nodes; ++j) {
    const double apart = s - x[Eigen::Index(j)];
    if (apart == 0) return values[j];
    const double share = lagrange[Eigen::Index(j)] / apart;
    above += share * values[j], below += share;
  }
  return above / below;
}

HalfLine::HalfLine(double shift_time, std::vector<double> cuts, std::size_t periods,
                   const QuadraturePanel& panel)
    : shift_time_(shift_time), periods_(periods), panel_(panel) {
  // Reflect the cuts of half a shift, and repeat them
  for (std::size_t i = cuts.size() - 1; i-- > 0;) cuts.push_back(shift_time - cuts[i]);
  per_shift_ = cuts.size() - 1;
  const auto n = Eigen::Index(panel.nodes);
  t_.resize(Eigen::Index(periods * per_shift_) * n);
  weight_ = jacobian_ = cosine_ = sine_ = t_;
  Eigen::Index at = 0;
  for (std::size_t p = 0; p < periods * per_shift_; ++p) {
    const std::size_t b = p % per_shift_;
    start_.push_back(double(p / per_shift_) * shift_time + cuts[b]);
    length_.push_back(cuts[b + 1] - cuts[b]);
    for (Eigen::Index i = 0; i < n; ++i, ++at) {
      t_[at] = start_[p] + length_[p] * panel.map(panel.x[i]);
      jacobian_[at] = length_[p] * panel.slope(panel.x[i]);
      weight_[at] = jacobian_[at] * panel.weight[i];
      cosine_[at] = std::cos(t_[at]), sine_[at] = std::sin(t_[at]);
    }
  }
}

// A function between its nodes
double HalfLine::at(const Vector<double>& values, double t) const {
  t = std::abs(t);
  const auto next = std::upper_bound(start_.begin(), start_.end(), t);
  const auto p = std::size_t(next - start_.begin()) - 1;
  const double u = (t - start_[p]) / length_[p];
  if (u > 1) return 0;
  return panel_.interpolate(values.data() + p * panel_.nodes, panel_.inverse(u));
}

Vector<double> HalfLine::onto(const HalfLine& other, const Vector<double>& values) const {
  Vector<double> there(other.size());
  for (Eigen::Index i = 0; i < there.size(); ++i) there[i] = at(values, other.t_[i]);
  return there;
}

HalfLine::Response HalfLine::respond(const Vector<double>& f) const {
  const auto n = Eigen::Index(panel_.nodes);
  Response r{Vector<double>(size()), {}, {}, 0};
  r.half.resize(periods_), r.half_v.resize(periods_);
  double c = 0, s = 0;  // integrals of f cos and f sin from the panel's end to infinity
  Vector<double> fc(n), fs(n), part_c(n), part_s(n);
  for (std::size_t p = start_.size(); p-- > 0;) {
    const Eigen::Index first = Eigen::Index(p) * n;
    if (p % per_shift_ == per_shift_ / 2 - 1) {
      const double half = start_[p] + length_[p];
      r.half[p / per_shift_] = s * std::cos(half) - c * std::sin(half);
      r.half_v[p / per_shift_] = -c * std::cos(half) - s * std::sin(half);
    }
    for (Eigen::Index i = 0; i < n; ++i) {
      const double area = jacobian_[first + i] * f[first + i];
      fc[i] = area * cosine_[first + i], fs[i] = area * sine_[first + i];
    }
    // What lies beyond a node is the rest of its panel and all panels beyond
    const double all_c = panel_.weight.dot(fc), all_s = panel_.weight.dot(fs);
    part_c.noalias() = panel_.integral * fc, part_s.noalias() = panel_.integral * fs;
    for (Eigen::Index i = 0; i < n; ++i) {
      const double rest_c = c + (all_c - part_c[i]), rest_s = s + (all_s - part_s[i]);
      r.x[first + i] = rest_s * cosine_[first + i] - rest_c * sine_[first + i];
    }
    c += all_c, s += all_s;
  }
  r.component = 2 * c;
  return r;
}

Vector<double> HalfLine::convolve(const Vector<double>& f) const {
  const Response r = respond(f);
  const Eigen::Index shift = Eigen::Index(per_shift_ * panel_.nodes);
  Vector<double> d(size());
  for (Eigen::Index i = 0; i < size(); ++i) {
    const double ahead = i + shift < size() ? r.x[i + shift] : 0,
                 behind = r.x[i < shift ? shift - 1 - i : i - shift];
    d[i] = ahead - 2 * r.x[i] + behind;
    if (i < shift) d[i] += r.component * std::sin(shift_time_ - t_[i]);
  }
  return d;
}

}  // namespace lattice
