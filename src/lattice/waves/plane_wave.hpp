#pragma once
/**
# Exact periodic waves and what becomes of a disturbance

A wave of finite amplitude keeps its form: $y_n(t) = \varphi(\theta)$ with
$\theta = qn - \omega t$ and $\varphi$ of period $2\pi$ solves
$$\omega^2\varphi'' + W'(\varphi) = V'(r) - V'(r^-), \qquad
  r(\theta) = \varphi(\theta+q) - \varphi(\theta),\quad r^-(\theta) = r(\theta-q).$$
For an even well $\theta\to-\theta$, $\varphi\to-\varphi$ leaves this equation alone, so we look for
odd waves $\varphi = \sum_k b_k \sin k\theta$ with $b_1 = a$ given and the frequency unknown. As long
as all contacts stay closed, everything is analytic and the series converges geometrically.

A disturbance $e^{iQn + \lambda t}p(\theta)$ of such a wave obeys a linear equation with coefficients
of period $2\pi$. With the shift $S p = p(\theta+q)$ and $B = e^{iQ}S - 1$ it is
$$(\lambda - \omega\partial_\theta)^2 p = -W''(\varphi)\,p - B^\dagger V''(r)\,B\,p,$$
an eigenvalue problem on a grid of $\theta$, and the growth rate is the largest real part. */

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "lattice/model/chain.hpp"

namespace lattice {

/// An exact wave: wavenumber, frequency, and the coefficients of sin(k theta), k = 1, 2, ...
struct PlaneWave {
  double q = 0, omega = 0;
  std::vector<double> b{};

  double profile(double theta) const {
    double sum = 0;
    for (std::size_t k = b.size(); k-- > 0;) sum += b[k] * std::sin(double(k + 1) * theta);
    return sum;
  }
  double slope(double theta) const {
    double sum = 0;
    for (std::size_t k = b.size(); k-- > 0;)
      sum += double(k + 1) * b[k] * std::cos(double(k + 1) * theta);
    return sum;
  }
  double relative(double theta) const { return profile(theta + q) - profile(theta); }
};

/// One Newton step for the coefficients b_2, b_3, ... and the frequency; returns its size relative
/// to the amplitude. The equation is asked for at as many points as there are harmonics.
template <class Onsite, class Contact>
double improve(PlaneWave& wave, const Onsite& onsite, const Contact& contact) {
  const Eigen::Index count = Eigen::Index(wave.b.size());
  Eigen::MatrixXd jacobian(count, count);
  Eigen::VectorXd residual(count);
  for (Eigen::Index j = 0; j < count; ++j) {
    const double theta = std::numbers::pi * double(j + 1) / double(count + 1);
    const double y = wave.profile(theta), right = wave.relative(theta),
                 left = wave.relative(theta - wave.q);
    double second = 0;
    for (Eigen::Index i = 0; i < count; ++i) {
      const double k = double(i + 1), here = std::sin(k * theta);
      const double ahead = std::sin(k * (theta + wave.q)), behind = std::sin(k * (theta - wave.q));
      second -= k * k * wave.b[std::size_t(i)] * here;
      jacobian(j, i) = -wave.omega * wave.omega * k * k * here + onsite.stiffness(y) * here -
                       contact.stiffness(right) * (ahead - here) +
                       contact.stiffness(left) * (here - behind);
    }
    jacobian(j, 0) = 2 * wave.omega * second;  // b_1 is given; its place is the frequency's
    residual[j] = wave.omega * wave.omega * second - onsite.force(y) + contact.force(right) -
                  contact.force(left);
  }
  const Eigen::VectorXd step = jacobian.partialPivLu().solve(residual);
  wave.omega -= step[0];
  for (Eigen::Index i = 1; i < count; ++i) wave.b[std::size_t(i)] -= step[i];
  return std::abs(step[0]) + step.tail(count - 1).cwiseAbs().maxCoeff() / std::abs(wave.b[0]);
}

/**
Newton starts from the phonon. Throws std::runtime_error if it does not settle or if the wave opens
a contact, where the series would lose its convergence. */
template <class Onsite, class Contact>
PlaneWave plane_wave(const Onsite& onsite, const Contact& contact, double q, double a,
                     std::size_t harmonics = 12) {
  PlaneWave wave{q, 0, std::vector<double>(harmonics, 0.0)};
  wave.b[0] = a;
  wave.omega = std::sqrt(onsite.stiffness(0.0) + 2 * contact.stiffness(0.0) * (1 - std::cos(q)));
  double step = 1;
  for (int i = 0; i < 20 && step > 1e-13; ++i) step = improve(wave, onsite, contact);
  double widest = 0;
  for (int j = 0; j < 64; ++j) widest = std::max(widest, wave.relative(std::numbers::pi * j / 32));
  if (!(step < 1e-10) || !(widest < contact.opening()))
    throw std::runtime_error("no plane wave of this amplitude with all contacts closed");
  return wave;
}

/// The wave on a ring whose length is a whole number of wavelengths, its first site being n = 1.
inline State<double> on_ring(const PlaneWave& wave, std::size_t sites) {
  State<double> state(sites);
  for (std::size_t n = 0; n < sites; ++n) {
    const double theta = wave.q * double(n + 1);
    state.y[n] = wave.profile(theta);
    state.v[n] = -wave.omega * wave.slope(theta);
  }
  return state;
}

/// Operators on a grid of `points` values of theta: derivative and shift by `q`.
struct PeriodicGrid {
  Eigen::MatrixXcd derivative, shift;
};

inline PeriodicGrid periodic_grid(Eigen::Index points, double q) {
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

/// Growth rate of the fastest disturbance with wavenumber `modulation` relative to the wave.
template <class Onsite, class Contact>
double growth_rate(const PlaneWave& wave, const Onsite& onsite, const Contact& contact,
                   double modulation) {
  using Matrix = Eigen::MatrixXcd;
  const Eigen::Index points = 2 * Eigen::Index(wave.b.size()) + 1;
  const PeriodicGrid grid = periodic_grid(points, wave.q);
  const Matrix one = Matrix::Identity(points, points);
  const Matrix difference = std::polar(1.0, modulation) * grid.shift - one;
  Eigen::VectorXcd well(points), bond(points);
  for (Eigen::Index j = 0; j < points; ++j) {
    const double theta = 2 * std::numbers::pi * double(j) / double(points);
    well[j] = onsite.stiffness(wave.profile(theta));
    bond[j] = contact.stiffness(wave.relative(theta));
  }
  Matrix system = Matrix::Zero(2 * points, 2 * points);
  system.topLeftCorner(points, points) = wave.omega * grid.derivative;
  system.topRightCorner(points, points) = one;
  system.bottomLeftCorner(points, points) =
      -Matrix(well.asDiagonal()) - difference.adjoint() * bond.asDiagonal() * difference;
  system.bottomRightCorner(points, points) = wave.omega * grid.derivative;
  const Eigen::VectorXcd lambda = Eigen::ComplexEigenSolver<Matrix>(system, false).eigenvalues();
  return lambda.real().maxCoeff();
}

}  // namespace lattice
