// The constants of the proof for the chain's breathers, each against what it bounds: none may be too small, and
// none is so large that a wrong factor would not be seen.

#include "sec5/chain_bounds.hpp"

#include <algorithm>

#include <Eigen/LU>

#include "check.hpp"
#include "lattice/algebra/dense.hpp"
#include "lattice/orbits/shooting.hpp"
#include "sec5/chain_enclosure.hpp"

using namespace lattice;

namespace {

const double omega = 1.1;
const Interval<double> enclosed_omega = Interval<double>(11) / Interval<double>(10);

/// The kernel of the response of the wells, whose Fourier coefficients are 1 / (1 - omega^2 k^2).
double g(double theta) {
  return pi<double>() / omega * std::cos((pi<double>() - theta) / omega) /
         std::sin(pi<double>() / omega);
}

double cosine_sum(const std::vector<double>& c, double theta) {
  double sum = 0;
  for (std::size_t k = 0; k < c.size(); ++k) sum += c[k] * std::cos(double(k) * theta);
  return sum;
}

/// The variation of the derivative of c_+^(3/2) over the circle, over 2 pi, from samples.
double sampled_variation(const std::vector<double>& c) {
  const int n = 20000;
  double sum = 0, before = 0;
  for (int i = 0; i <= n; ++i) {
    const double theta = 2 * pi<double>() * i / n;
    double slope = 0;
    for (std::size_t k = 0; k < c.size(); ++k)
      slope -= c[k] * double(k) * std::sin(double(k) * theta);
    const double now = 1.5 * std::sqrt(std::max(0.0, cosine_sum(c, theta))) * slope;
    if (i > 0) sum += std::abs(now - before);
    before = now;
  }
  return sum / (2 * pi<double>());
}

}  // namespace

TEST_CASE("mean and maximum of the kernel of a well", "[unit]") {
  const int n = 200000;
  double mean = 0, most = 0, third = 0;
  for (int i = 0; i < n; ++i) {
    const double theta = 2 * pi<double>() * (i + 0.5) / n, value = g(theta);
    mean += std::abs(value) / n, third += value * std::cos(3 * theta) / n;
    most = std::max(most, std::abs(value));
  }
  check_close(third, 1 / (1 - 9 * omega * omega), 1e-8);
  check_close(mean_of_kernel(enclosed_omega).middle(), mean, 1e-8);
  check_close(largest_of_kernel(enclosed_omega).middle(), most, 1e-8);
  CHECK(mean_of_kernel(enclosed_omega).radius() < 1e-11);
}

TEST_CASE("the variation of the force", "[property]") {
  for (const std::vector<double>& c :
       {std::vector<double>{0, 1}, {0.2, 1, -0.3}, {-0.3, 1, 0.4, 0.1}, {1, 0, 0, 0, 0, 0.01}}) {
    const double bound = variation_of_force(c).lower, sampled = sampled_variation(c);
    CAPTURE(c.size(), bound, sampled);
    CHECK(sampled <= bound);
    CHECK(sampled > 0.08 * bound);
  }
}

TEST_CASE("coefficients that are folded back or left out", "[unit]") {
  // Those of a force decrease as the bound at least: folded back by few samples
  const std::vector<double> c{0.1, 1, 0.2};
  const auto coefficients = [&](std::size_t samples) {
    const CosineTable table(samples);
    std::vector<Interval<double>> f;
    for (double x : sample(c, table).value) f.push_back(hertz(Interval<double>(x)));
    return discrete_coefficients(f, 8, table);
  };
  const auto few = coefficients(32), many = coefficients(32768);
  const double bound = (variation_of_force(c) * folded_back(32, 8)).lower;
  for (std::size_t k = 0; k < 8; ++k) CHECK(std::abs(few[k].middle() - many[k].middle()) <= bound);
  // The sums themselves
  double folded = 0, left = 0;
  for (int j = 1; j < 100000; ++j)
    for (int sign : {1, -1}) folded += 2 / std::pow(32.0 * sign * j + 7, 2);
  for (int k = 8; k < 100000; ++k)
    left += 2 / (double(k) * k * (omega * omega * double(k) * k - 1));
  CHECK(folded <= folded_back(32, 8).lower);
  CHECK(folded > 0.5 * folded_back(32, 8).upper);
  CHECK(left <= left_out(enclosed_omega, 8).lower);
  CHECK(left > 0.5 * left_out(enclosed_omega, 8).upper);
}

TEST_CASE("ranges of a cosine sum on cells", "[unit]") {
  // An extremum in the middle of a cell, as far above its ends as the bound allows
  std::vector<double> c(8);
  c[7] = 1;
  const auto cells = ranges(c, 64);
  double above = 0;
  for (std::size_t p = 0; p < cells.size(); ++p) {
    const auto at = [&](double x) {
      return cosine_sum(c, pi<double>() * (double(p) + x) / double(cells.size()));
    };
    for (int i = 0; i <= 40; ++i) CHECK(cells[p].contains(at(i / 40.0)));
    above = std::max(above, at(0.5) - std::max(at(0), at(1)));
  }
  const double allowed = cells[0].upper - 1;
  CHECK(above > 0.7 * allowed);
}

TEST_CASE("the norm of the inverse is that of a finer discretization", "[convergence]") {
  // 1 - B with rectangles instead of broken lines, around a bond; its inverse has the norm 1 + kappa or less
  Fineness fine;
  fine.samples = 4096, fine.harmonics = 64;
  const ChainGuess guess = chain_guess(Centre::bond, 11, 10, fine);
  const ChainProof proof(guess, fine);
  const long m = 64, window = long(guess.c.size());
  Matrix<double> one_minus_b = Matrix<double>::Identity(m * window, m * window);
  for (long n = 0; n < window; ++n)
    for (long i = 0; i < m; ++i)
      for (long l = 0; l < m; ++l) {
        const double t = pi<double>() * (double(i) + 0.5) / double(m),
                     s = pi<double>() * (double(l) + 0.5) / double(m);
        const double both = (g(std::abs(t - s)) + g(t + s)) / 2 / double(m);
        const auto act = [&](long contact, double factor) {
          const double d = cosine_sum(guess.c[std::size_t(contact)], s);
          one_minus_b(n * m + i, contact * m + l) -=
              factor * both * 1.5 * std::sqrt(std::max(0.0, d));
        };
        act(n, -2);
        if (n + 1 < window) act(n + 1, 1);
        act(n > 0 ? n - 1 : 1, 1);
      }
  const Matrix<double> inverse = one_minus_b.inverse();
  const double norm = inverse.cwiseAbs().rowwise().sum().maxCoeff();
  CAPTURE(norm, proof.kappa());
  CHECK(proof.kappa() > 0.97 * (norm - 1));
  CHECK(proof.kappa() < 1.1 * norm);
  // What broken lines miss: between two nodes the response bends
  CHECK(proof.delta() < 1e-2);
  CHECK(proof.epsilon() > 1e-4);
}
