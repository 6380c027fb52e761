#include "sec5/dps_waves.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "lattice/algebra/eigenvalues.hpp"
#include "lattice/integrators/event_corrected.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "lattice/orbits/newton.hpp"

namespace lattice {
namespace {

/// The entries a, e and k of the matrix.
struct Coupling {
  double a, e, k;

  Coupling(double q, double Q)
      : a(2.5 * std::cos(q) * std::cos(Q) - 0.5 - 2 * std::cos(q)),
        e(-2.5 * std::sin(q) * std::sin(Q)),
        k((std::cos(q) - std::cos(Q)) / 2) {}
};

/// Follows side band and wave from sample to sample and fits lines to them.
class SideBand {
 public:
  explicit SideBand(const ModulatedWave& wave) : wave_(wave), from_(3 / wave.growth()), last_(0) {}

  double until() const { return 3 * from_; }

  /// At the slow time tau, for the field in any constant unit.
  void look(double tau, const Field& field) {
    const double q = wave_.wave().q;
    const double phase = std::arg(component(field, q));
    if (tau > 0) turned_ += std::remainder(phase - last_, 2 * std::numbers::pi);
    last_ = phase;
    if (tau < from_) return;
    tau_.push_back(tau), phase_.push_back(turned_);
    log_.push_back(std::log(std::abs(component(field, q + wave_.modulation()))));
  }
  WaveRates result() const { return {fit_line(tau_, log_).slope, -fit_line(tau_, phase_).slope}; }

 private:
  static std::complex<double> component(const Field& field, double wavenumber) {
    std::complex<double> sum = 0;
    for (std::size_t n = 0; n < field.size(); ++n)
      sum += field[n] * std::polar(1.0, -wavenumber * double(n));
    return sum;
  }

  ModulatedWave wave_;
  double from_, last_, turned_ = 0;
  std::vector<double> tau_, phase_, log_;
};

}  // namespace

// Differences of the right-hand side in the frame that turns with the wave
std::vector<std::complex<double>> ring_exponents(std::size_t sites, int waves) {
  const DpsWave<double> wave = ModulatedWave{sites, waves, 0}.wave();
  const TurningDps flow{{sites, Ends::periodic}, -wave.frequency()};
  Field field(sites);
  for (std::size_t n = 0; n < sites; ++n) field[n] = std::polar(1.0, wave.q * double(n));
  std::vector<double> x = interleaved(field), more(x.size()), less(x.size());
  const Eigen::Index rows = Eigen::Index(x.size());
  Eigen::MatrixXd matrix(rows, rows);
  const double change = 1e-5;
  for (Eigen::Index k = 0; k < rows; ++k) {
    double& entry = x[std::size_t(k)];
    const double kept = entry;
    entry = kept + change, flow(0, x.data(), more.data());
    entry = kept - change, flow(0, x.data(), less.data());
    entry = kept;
    for (Eigen::Index i = 0; i < rows; ++i)
      matrix(i, k) = (more[std::size_t(i)] - less[std::size_t(i)]) / (2 * change);
  }
  return eigenvalues_of(matrix);
}

// Each closed form against the nearest eigenvalue
double exponents_apart(std::size_t sites, int waves) {
  const auto found = ring_exponents(sites, waves);
  double most = 0;
  for (int turns = 1; turns < int(sites); ++turns) {
    const ModulatedWave at{sites, waves, turns};
    const Coupling c(at.wave().q, at.modulation());
    const double rate = at.wave().rate(), grow = at.growth();
    const double turn = rate * std::sqrt(std::max(0.0, c.a * c.a - c.k * c.k));
    for (int sign : {-1, 1}) {
      const std::complex<double> sigma(sign * grow, -rate * c.e + (grow > 0 ? 0 : sign * turn));
      double nearest = std::numeric_limits<double>::infinity();
      for (const auto& s : found) nearest = std::min(nearest, std::abs(s - sigma));
      most = std::max(most, nearest / rate);
    }
  }
  return most;
}

// The wave with a little of its growing disturbance
Field ModulatedWave::start(double size) const {
  if (!(growth() > 0)) throw std::invalid_argument("this modulation does not grow");
  const Coupling c(wave().q, modulation());
  const std::complex<double> y = std::complex<double>(-c.a, growth() / wave().rate()) / c.k;
  Field field(sites);
  for (std::size_t n = 0; n < sites; ++n) {
    const auto turn = std::polar(1.0, modulation() * double(n));
    field[n] = std::polar(1.0, wave().q * double(n)) * (1.0 + size * (turn + std::conj(y * turn)));
  }
  return field;
}

WaveRates run_in_dps(const ModulatedWave& wave, double tolerance) {
  SideBand band(wave);
  Field field = wave.start(1e-7);
  evolve_dps(Dps{wave.sites, Ends::periodic}, field, band.until(), 200, tolerance,
             [&](double tau, const Field& now) { band.look(tau, now); });
  return band.result();
}

// The fast oscillation is taken out of each sample
void evolve_in_chain(Field& field, double eps, double duration, double every, double step,
                     const DpsLook& observe) {
  const Chain ring{field.size(), Harmonic{}, Hertz{}, Ends::periodic};
  const double slow = std::sqrt(eps);
  State<double> state = dps_state(field, eps, 0);
  evolve(EventCorrected{step}, ring, state, time_grid(duration / slow, every / slow, step),
         [&](const State<double>& now) {
           const auto back = std::polar(1 / (2 * eps), -now.t);
           for (std::size_t n = 0; n < field.size(); ++n)
             field[n] = std::complex<double>(now.y[n], -now.v[n]) * back;
           observe(slow * now.t, field);
         });
}

WaveRates run_in_chain(const ModulatedWave& wave, double eps, double step) {
  SideBand band(wave);
  Field field = wave.start(1e-7);
  evolve_in_chain(field, eps, band.until(), 0.8 * std::sqrt(eps), step,
                  [&](double tau, const Field& now) { band.look(tau, now); });
  return band.result();
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
