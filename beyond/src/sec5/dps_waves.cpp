#include "sec5/dps_waves.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "lattice/algebra/dense.hpp"
#include "lattice/integrators/event_corrected.hpp"
#include "lattice/orbits/newton.hpp"

namespace lattice {

// The wave with a little of its growing disturbance
Field ModulatedWave::start(double size) const {
  if (!(growth() > 0)) throw std::invalid_argument("this modulation does not grow");
  const double c = std::cos(wave().q), C = std::cos(modulation());
  const double a = 2.5 * c * C - 0.5 - 2 * c, k = (c - C) / 2;
  const std::complex<double> y = std::complex<double>(-a, growth() / wave().rate()) / k;
  Field field(sites);
  for (std::size_t n = 0; n < sites; ++n) {
    const auto turn = std::polar(1.0, modulation() * double(n));
    field[n] = std::polar(1.0, wave().q * double(n)) * (1.0 + size * (turn + std::conj(y * turn)));
  }
  return field;
}

namespace {

/// The ring of one period of the wave.
ModulatedWave one_period(const ModulatedWave& wave) {
  const int periods = std::gcd(int(wave.sites), wave.waves);
  return {wave.sites / std::size_t(periods), wave.waves / periods, 0};
}

/// After the time q / omega each bead is in the state of its neighbour: by how much is this wrong?
Eigen::VectorXd shift_residual(const Eigen::VectorXd& x, double time, double eps,
                               std::size_t steps) {
  const std::size_t n = std::size_t(x.size()) / 2;
  State<double> state(n);
  for (std::size_t i = 0; i < n; ++i) {
    state.y[i] = eps * x[Eigen::Index(i)];
    state.v[i] = eps * x[Eigen::Index(n + i)];
  }
  const double force = eps * std::sqrt(eps);
  const EventCorrected method{time, dormand_prince_6(), 1e-16 * force};
  evolve(method, Chain{n, Harmonic{}, Hertz{}, Ends::periodic}, state, TimeGrid{time, 1, steps});
  Eigen::VectorXd out(x.size());
  for (std::size_t i = 0; i < n; ++i) {
    const auto next = Eigen::Index((i + 1) % n);
    out[next] = state.y[i] / eps - x[next];
    out[Eigen::Index(n) + next] = state.v[i] / eps - x[Eigen::Index(n) + next];
  }
  return out;
}

/// Its derivative by central differences, which are wider where the steps are, so that runs with other steps tell their
/// error, too.
Eigen::MatrixXd shift_slopes(const Eigen::VectorXd& x, double time, double eps, std::size_t steps) {
  const auto residual = [=](const Eigen::VectorXd& at) {
    return shift_residual(at, time, eps, steps);
  };
  return central_differences<double>(residual, x, 2.4e-4 / double(steps));
}

}  // namespace

// Unknown are the state over eps and, last, the time q / omega
ChainWave chain_wave(const ModulatedWave& wave, double eps, std::size_t steps) {
  const ModulatedWave ring = one_period(wave);
  const double q = ring.wave().q;
  const Eigen::Index n = Eigen::Index(ring.sites);
  Eigen::VectorXd x(2 * n), real(2 * n), imaginary(2 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double c = std::cos(q * double(i)), s = std::sin(q * double(i));
    x[i] = 2 * c, x[n + i] = -2 * s;
    real[i] = c / double(n), real[n + i] = -s / double(n);
    imaginary[i] = -s / double(n), imaginary[n + i] = -c / double(n);
  }
  // One equation too many, which the flow meets to the error of its steps
  double time = q / (1 - std::sqrt(eps) * ring.wave().frequency()), moved = 1;
  for (int k = 0; k < 20; ++k) {
    Eigen::VectorXd residual(2 * n + 2);
    residual << shift_residual(x, time, eps, steps), real.dot(x) - 2, imaginary.dot(x);
    if (moved < 1e-9 && residual.cwiseAbs().maxCoeff() < 1e-5) {
      ChainWave out{State<double>(ring.sites), q / time};
      for (std::size_t i = 0; i < ring.sites; ++i) {
        out.state.y[i] = eps * x[Eigen::Index(i)];
        out.state.v[i] = eps * x[n + Eigen::Index(i)];
      }
      return out;
    }
    Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(2 * n + 2, 2 * n + 1);
    slopes.topLeftCorner(2 * n, 2 * n) = shift_slopes(x, time, eps, steps);
    const double change = 1e-5;
    slopes.col(2 * n).head(2 * n) = (shift_residual(x, time + change, eps, steps) -
                                     shift_residual(x, time - change, eps, steps)) /
                                    (2 * change);
    slopes.row(2 * n).head(2 * n) = real.transpose();
    slopes.row(2 * n + 1).head(2 * n) = imaginary.transpose();
    const Eigen::VectorXd step = shortest_solution<double>(slopes, residual);
    x -= step.head(2 * n);
    time -= step[2 * n];
    moved = step.cwiseAbs().maxCoeff();
  }
  throw std::runtime_error("no wave of the chain at q = " + std::to_string(q) +
                           " and eps = " + std::to_string(eps));
}

// The wave again and again along the longer ring, and the map linearised about it
WaveRates chain_rates(const ModulatedWave& wave, double eps, std::size_t steps) {
  const ChainWave found = chain_wave(wave, eps, steps);
  const std::size_t period = found.state.y.size();
  const Eigen::Index n = Eigen::Index(wave.sites);
  Eigen::VectorXd x(2 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    x[i] = found.state.y[std::size_t(i) % period] / eps;
    x[n + i] = found.state.v[std::size_t(i) % period] / eps;
  }
  const double time = one_period(wave).wave().q / found.omega;
  const Eigen::MatrixXd map =
      shift_slopes(x, time, eps, steps) + Eigen::MatrixXd::Identity(2 * n, 2 * n);
  double most = 0;
  for (const std::complex<double>& z : eigenvalues_of(map)) most = std::max(most, std::abs(z));
  const double slow = std::sqrt(eps);
  return {std::log(most) / (time * slow), (1 - found.omega) / slow};
}

double largest_growth(const ModulatedWave& wave) {
  double most = 0;
  for (int turns = 1; turns < int(wave.sites); ++turns)
    most = std::max(most, ModulatedWave{wave.sites, wave.waves, turns}.growth());
  return most;
}

}  // namespace lattice
