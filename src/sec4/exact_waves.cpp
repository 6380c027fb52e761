#include "sec4/exact_waves.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "lattice/algebra/dense.hpp"

namespace lattice {

using Eigen::Index, Eigen::MatrixXcd;
using std::numbers::pi;

double PlaneWave::profile(double theta) const {
  double sum = 0;
  for (std::size_t k = b.size(); k-- > 0;) sum += b[k] * std::sin(double(k + 1) * theta);
  return sum;
}

// One step of Newton's method, with the equation at as many points as there are harmonics; its relative size. The
// amplitude b_1 is given, so the first column belongs to the frequency and the others to b_2, b_3, ...
static double improve(PlaneWave& wave) {
  const auto& [q, omega, b, well, contact] = wave;
  const Index count = Index(b.size());
  Eigen::MatrixXd jacobian(count, count);
  Eigen::VectorXd residual(count);
  for (Index j = 0; j < count; ++j) {
    const double theta = pi * double(j + 1) / double(count + 1);
    const double y = wave.profile(theta), right = wave.relative(theta),
                 left = wave.relative(theta - q);
    double second = 0;
    for (Index i = 0; i < count; ++i) {
      const double k = double(i + 1), here = std::sin(k * theta);
      const double ahead = std::sin(k * (theta + q)), behind = std::sin(k * (theta - q));
      second -= k * k * b[std::size_t(i)] * here;
      jacobian(j, i) = -omega * omega * k * k * here + well.stiffness(y) * here -
                       contact.stiffness(right) * (ahead - here) +
                       contact.stiffness(left) * (here - behind);
    }
    jacobian(j, 0) = 2 * omega * second;
    residual[j] =
        omega * omega * second - well.force(y) + contact.force(right) - contact.force(left);
  }
  const Eigen::VectorXd step = solve_square<double>(jacobian, residual);
  wave.omega -= step[0];
  for (Index i = 1; i < count; ++i) wave.b[std::size_t(i)] -= step[i];
  return std::abs(step[0]) + step.tail(count - 1).cwiseAbs().maxCoeff() / std::abs(b[0]);
}

// From the phonon on, until the steps are rounding
PlaneWave plane_wave(const Well& well, const Contact& contact, double q, double a,
                     std::size_t harmonics) {
  PlaneWave wave{q, 0, std::vector<double>(harmonics, 0.0), well, contact};
  wave.b[0] = a;
  wave.omega = std::sqrt(well.stiffness(0.0) + 2 * contact.stiffness(0.0) * (1 - std::cos(q)));
  double step = 1, widest = 0;
  for (int i = 0; i < 20 && step > 1e-13; ++i) step = improve(wave);
  for (int j = 0; j < 64; ++j) widest = std::max(widest, wave.relative(pi * j / 32));
  if (!(step < 1e-10) || !(widest < contact.opening()))
    throw std::runtime_error("no plane wave of this amplitude keeps all contacts closed");
  return wave;
}

// On an odd number of points derivative and shift are full matrices, exact for every harmonic that the grid can hold.
// With w = (lambda - omega d/dtheta) p as a second unknown the problem becomes linear in lambda
static MatrixXcd linearisation(const PlaneWave& wave, double modulation) {
  using namespace std::complex_literals;
  const Index top = Index(wave.b.size()), points = 2 * top + 1;
  MatrixXcd derivative = MatrixXcd::Zero(points, points), shift = derivative;
  for (Index j = 0; j < points; ++j)
    for (Index l = 0; l < points; ++l)
      for (Index k = -top; k <= top; ++k) {
        const double angle = 2 * pi * double((j - l) * k) / double(points);
        const std::complex<double> mode = std::polar(1 / double(points), angle);
        derivative(j, l) += 1i * double(k) * mode;
        shift(j, l) += std::polar(1.0, double(k) * wave.q) * mode;
      }
  Eigen::VectorXcd held(points), bond(points);
  for (Index j = 0; j < points; ++j) {
    const double theta = 2 * pi * double(j) / double(points);
    held[j] = wave.well.stiffness(wave.profile(theta));
    bond[j] = wave.contact.stiffness(wave.relative(theta));
  }
  // Transport on the diagonal; the stiffnesses of well and contacts couple p and w
  const MatrixXcd one = MatrixXcd::Identity(points, points);
  const MatrixXcd difference = std::polar(1.0, modulation) * shift - one;
  MatrixXcd system = MatrixXcd::Zero(2 * points, 2 * points);
  system.topLeftCorner(points, points) = wave.omega * derivative;
  system.topRightCorner(points, points) = one;
  system.bottomLeftCorner(points, points) =
      -MatrixXcd(held.asDiagonal()) - difference.adjoint() * bond.asDiagonal() * difference;
  system.bottomRightCorner(points, points) = wave.omega * derivative;
  return system;
}

// A real matrix of twice the size has the eigenvalues of the complex one and their conjugates
double growth_rate(const PlaneWave& wave, double modulation) {
  const MatrixXcd z = linearisation(wave, modulation);
  Eigen::MatrixXd all(2 * z.rows(), 2 * z.cols());
  all << z.real(), -z.imag(), z.imag(), z.real();
  double rate = 0;
  for (const std::complex<double>& e : eigenvalues_of(all)) rate = std::max(rate, e.real());
  return rate;
}

}  // namespace lattice
