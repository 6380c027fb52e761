#include "secB/solitary_wave.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "lattice/algebra/dense.hpp"

namespace lattice {

namespace {

/**
Even functions on a periodic grid are known from the crest to the end of the window. A convolution with an even
kernel, given by its multiplier, is a matrix between such halves, made once. Of a point inside the window the
mirror image counts too; crest and end are their own. */
template <class Multiplier>
Matrix<double> convolution(std::size_t half, double h, Multiplier multiplier) {
  const std::size_t period = 2 * half;
  std::vector<double> kernel(period, 0.0);
  for (std::size_t j = 0; j < period; ++j) {
    double sum = multiplier(0.0);
    for (std::size_t k = 1; k < half; ++k)
      sum += 2 * multiplier(2 * std::numbers::pi * double(k) / (double(period) * h)) *
             std::cos(2 * std::numbers::pi * double(k * j % period) / double(period));
    kernel[j] = sum / double(period);
  }
  Matrix<double> out(Eigen::Index(half + 1), Eigen::Index(half + 1));
  for (std::size_t i = 0; i <= half; ++i)
    for (std::size_t j = 0; j <= half; ++j) {
      const double mirrored = j == 0 || j == half ? 0 : kernel[(i + j) % period];
      out(Eigen::Index(i), Eigen::Index(j)) = kernel[i > j ? i - j : j - i] + mirrored;
    }
  return out;
}

double sinc(double k) {
  return k == 0 ? 1 : std::sin(k / 2) / (k / 2);
}

/// The integral over the whole line of an even function.
double integral(const Vector<double>& half, double h) {
  return h * (2 * half.sum() - half(0) - half(half.size() - 1));
}

Vector<double> force_of(const Vector<double>& overlap, double alpha) {
  return overlap.unaryExpr([alpha](double x) {
    const double d = std::max(x, 0.0);
    return alpha == 1.5 ? d * std::sqrt(d) : std::pow(d, alpha);
  });
}

/// The overlap, by Petviashvili's iteration from a Gaussian.
Vector<double> petviashvili(const Matrix<double>& tent, double h, double alpha) {
  Vector<double> overlap(tent.rows());
  for (Eigen::Index j = 0; j < overlap.size(); ++j)
    overlap(j) = std::exp(-std::pow(h * double(j), 2));
  for (int k = 0; k < 1000; ++k) {
    const Vector<double> pushed = tent * force_of(overlap, alpha);
    const double ratio =
        integral(overlap.cwiseProduct(overlap), h) / integral(overlap.cwiseProduct(pushed), h);
    const Vector<double> next = std::pow(ratio, alpha / (alpha - 1)) * pushed;
    const double change = (next - overlap).cwiseAbs().maxCoeff() / next.maxCoeff();
    overlap = next;
    if (change < 1e-15) return overlap;
  }
  throw std::runtime_error("the iteration for the solitary wave does not converge");
}

std::vector<double> plain(const Vector<double>& x) {
  return {x.data(), x.data() + x.size()};
}

}  // namespace

/**
A bead between two contacts is accelerated by the difference of their forces, so its velocity is the integral of $f$
over the site around it. */
SolitaryWave solitary_wave(double alpha, std::size_t points, std::size_t half_width) {
  const std::size_t half = points * half_width;
  const double h = 1 / double(points);
  const Vector<double> overlap =
      petviashvili(convolution(half, h, [](double k) { return sinc(k) * sinc(k); }), h, alpha);
  const Vector<double> force = force_of(overlap, alpha);
  const Vector<double> velocity = convolution(half, h, sinc) * force;
  SolitaryWave out{h, plain(overlap), plain(velocity)};
  out.shift = integral(force, h);
  out.kinetic = integral(velocity.cwiseProduct(velocity), h) / 2;
  out.potential = integral(overlap.cwiseProduct(force), h) / (alpha + 1);
  return out;
}

/**
Between two points the logarithm of the velocity is interpolated by a parabola, because far out it bends while the
velocity falls by a decade a site. */
double SolitaryWave::width(double level) const {
  std::size_t j = 1;
  while (j + 2 < velocity.size() && velocity[j] > level * velocity[0]) ++j;
  const double goal = std::log(level * velocity[0]);
  const double a = std::log(velocity[j - 1]), b = std::log(velocity[j]),
               c = std::log(velocity[j + 1]);
  // x(log v) through the three points, by Lagrange
  const double x = double(j - 1) * (goal - b) * (goal - c) / ((a - b) * (a - c)) +
                   double(j) * (goal - a) * (goal - c) / ((b - a) * (b - c)) +
                   double(j + 1) * (goal - a) * (goal - b) / ((c - a) * (c - b));
  return 2 * h * x;
}

}  // namespace lattice
