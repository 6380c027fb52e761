#include "sec4/plane_wave.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "lattice/algebra/eigenvalues.hpp"
#include "lattice/model/contact.hpp"
#include "lattice/model/well.hpp"

namespace lattice {

double PlaneWave::profile(double theta) const {
  double sum = 0;
  for (std::size_t k = b.size(); k-- > 0;) sum += b[k] * std::sin(double(k + 1) * theta);
  return sum;
}

double PlaneWave::slope(double theta) const {
  double sum = 0;
  for (std::size_t k = b.size(); k-- > 0;)
    sum += double(k + 1) * b[k] * std::cos(double(k + 1) * theta);
  return sum;
}

namespace {

/**
Newton's method needs the wave's equation at a given $\theta$ and its derivatives with respect to the
unknowns. The amplitude $b_1$ is given, so the first entry belongs to the frequency and the others to
$b_2, b_3, \dots$ */
struct WaveEquation {
  double residual;
  Eigen::RowVectorXd slopes;
};

/// Residual and derivatives of the equation of `wave` at `theta`.
WaveEquation equation_at(const PlaneWave& wave, const Well& well, const Contact& contact,
                         double theta) {
  const double y = wave.profile(theta), right = wave.relative(theta),
               left = wave.relative(theta - wave.q);
  WaveEquation at{0, Eigen::RowVectorXd(Eigen::Index(wave.b.size()))};
  double second = 0;
  for (Eigen::Index i = 0; i < at.slopes.size(); ++i) {
    const double k = double(i + 1), here = std::sin(k * theta);
    const double ahead = std::sin(k * (theta + wave.q)), behind = std::sin(k * (theta - wave.q));
    second -= k * k * wave.b[std::size_t(i)] * here;
    at.slopes[i] = -wave.omega * wave.omega * k * k * here + well.stiffness(y) * here -
                   contact.stiffness(right) * (ahead - here) +
                   contact.stiffness(left) * (here - behind);
  }
  at.slopes[0] = 2 * wave.omega * second;
  at.residual =
      wave.omega * wave.omega * second - well.force(y) + contact.force(right) - contact.force(left);
  return at;
}

/**
The equation is imposed at as many points as there are harmonics. `improve` takes one step of Newton's
method and returns its size, relative to the amplitude, which tells when to stop. */
double improve(PlaneWave& wave, const Well& well, const Contact& contact) {
  const Eigen::Index count = Eigen::Index(wave.b.size());
  Eigen::MatrixXd jacobian(count, count);
  Eigen::VectorXd residual(count);
  for (Eigen::Index j = 0; j < count; ++j) {
    const double theta = std::numbers::pi * double(j + 1) / double(count + 1);
    const WaveEquation at = equation_at(wave, well, contact, theta);
    jacobian.row(j) = at.slopes;
    residual[j] = at.residual;
  }
  const Eigen::VectorXd step = solve_square<double>(jacobian, residual);
  wave.omega -= step[0];
  for (Eigen::Index i = 1; i < count; ++i) wave.b[std::size_t(i)] -= step[i];
  return std::abs(step[0]) + step.tail(count - 1).cwiseAbs().maxCoeff() / std::abs(wave.b[0]);
}

}  // namespace

PlaneWave plane_wave(const Well& well, const Contact& contact, double q, double a,
                     std::size_t harmonics) {
  PlaneWave wave{q, 0, std::vector<double>(harmonics, 0.0)};
  wave.b[0] = a;
  wave.omega = std::sqrt(well.stiffness(0.0) + 2 * contact.stiffness(0.0) * (1 - std::cos(q)));
  double step = 1;
  for (int i = 0; i < 20 && step > 1e-13; ++i) step = improve(wave, well, contact);
  double widest = 0;
  for (int j = 0; j < 64; ++j) widest = std::max(widest, wave.relative(std::numbers::pi * j / 32));
  if (!(step < 1e-10) || !(widest < contact.opening()))
    throw std::runtime_error("no plane wave of this amplitude with all contacts closed");
  return wave;
}

State<double> on_ring(const PlaneWave& wave, std::size_t sites) {
  State<double> state(sites);
  for (std::size_t n = 0; n < sites; ++n) {
    const double theta = wave.q * double(n + 1);
    state.y[n] = wave.profile(theta);
    state.v[n] = -wave.omega * wave.slope(theta);
  }
  return state;
}

namespace {

/**
A disturbance is represented by its values on a grid of $\theta$. Derivative and shift by $q$ are then full
matrices, exact for every harmonic that the grid can hold, so that the growth rate converges like the
wave. */
struct PeriodicGrid {
  Eigen::MatrixXcd derivative, shift;
};

/// Both matrices for an odd number of `points` and the shift by `q`.
PeriodicGrid periodic_grid(Eigen::Index points, double q) {
  using namespace std::complex_literals;
  const Eigen::Index top = (points - 1) / 2;
  PeriodicGrid grid{Eigen::MatrixXcd::Zero(points, points), Eigen::MatrixXcd::Zero(points, points)};
  for (Eigen::Index j = 0; j < points; ++j)
    for (Eigen::Index l = 0; l < points; ++l)
      for (Eigen::Index k = -top; k <= top; ++k) {
        const double angle = 2 * std::numbers::pi * double((j - l) * k) / double(points);
        const std::complex<double> wave = std::polar(1 / double(points), angle);
        grid.derivative(j, l) += 1i * double(k) * wave;
        grid.shift(j, l) += std::polar(1.0, double(k) * q) * wave;
      }
  return grid;
}

/**
With $w = (\lambda - \omega\partial_\theta)p$ as a second unknown the problem becomes linear in
$\lambda$: the matrix of $(p, w)$ has the transport term $\omega\partial_\theta$ on its diagonal, and the
stiffnesses of well and contacts couple the two. */
Eigen::MatrixXcd linearisation(const PlaneWave& wave, const Well& well, const Contact& contact,
                               double modulation) {
  using Matrix = Eigen::MatrixXcd;
  const Eigen::Index points = 2 * Eigen::Index(wave.b.size()) + 1;
  const PeriodicGrid grid = periodic_grid(points, wave.q);
  const Matrix one = Matrix::Identity(points, points);
  const Matrix difference = std::polar(1.0, modulation) * grid.shift - one;
  Eigen::VectorXcd held(points), bond(points);
  for (Eigen::Index j = 0; j < points; ++j) {
    const double theta = 2 * std::numbers::pi * double(j) / double(points);
    held[j] = well.stiffness(wave.profile(theta));
    bond[j] = contact.stiffness(wave.relative(theta));
  }
  Matrix system = Matrix::Zero(2 * points, 2 * points);
  system.topLeftCorner(points, points) = wave.omega * grid.derivative;
  system.topRightCorner(points, points) = one;
  system.bottomLeftCorner(points, points) =
      -Matrix(held.asDiagonal()) - difference.adjoint() * bond.asDiagonal() * difference;
  system.bottomRightCorner(points, points) = wave.omega * grid.derivative;
  return system;
}

// A complex matrix as a real one of twice the size, which has its eigenvalues and their conjugates
Eigen::MatrixXd in_real_numbers(const Eigen::MatrixXcd& z) {
  Eigen::MatrixXd all(2 * z.rows(), 2 * z.cols());
  all << z.real(), -z.imag(), z.imag(), z.real();
  return all;
}

}  // namespace

double growth_rate(const PlaneWave& wave, const Well& well, const Contact& contact,
                   double modulation) {
  double rate = 0;
  for (const std::complex<double>& e :
       eigenvalues_of(in_real_numbers(linearisation(wave, well, contact, modulation))))
    rate = std::max(rate, e.real());
  return rate;
}

}  // namespace lattice
