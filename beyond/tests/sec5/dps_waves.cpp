// Plane waves of the DpS equation, their modulation, and the waves of the chain.

#include <numbers>

#include <Eigen/Eigenvalues>

#include "lattice/integrators/event_corrected.hpp"
#include "sec5/dps_waves.hpp"
#include "support/check.hpp"

using namespace lattice;
using std::numbers::pi;

TEST_CASE("a plane wave solves the DpS equation on a ring", "[unit][dps_waves]") {
  for (int waves : {1, 3, 5, 6}) {
    const DpsWave<double> wave{2 * pi * waves / 12, 0.3};
    Field field(12);
    for (std::size_t n = 0; n < 12; ++n) field[n] = std::polar(0.3, wave.q * double(n));
    const std::vector<double> a = interleaved(field);
    std::vector<double> da(a.size());
    Dps{12, Ends::periodic}(0, a.data(), da.data());
    for (std::size_t n = 0; n < 12; ++n) {
      const auto expected = std::complex<double>(0, -wave.frequency()) * field[n];
      check_close(da[2 * n], expected.real(), 1e-14);
      check_close(da[2 * n + 1], expected.imag(), 1e-14);
    }
    // Twelve contacts of equal stretch
    const double stretch = 0.6 * std::abs(std::sin(wave.q / 2));
    check_close(energy(field, true), 12 * 0.4 * stretch * stretch * std::sqrt(stretch), 1e-14);
  }
}

namespace {

using Complex = std::complex<double>;

constexpr Complex i_unit{0, 1};

/// 2 tau_0, from Gamma(1/4) = 3.6256099082219083.
const double twice_tau = 5 * std::pow(3.6256099082219083, 2) / (12 * std::sqrt(pi));

/// D exp(...) |...|^(1/2) / (2 tau_0): the right-hand side of the DpS equation on a ring, times -i.
Field slope_by_hand(const Field& a) {
  const std::size_t n = a.size();
  Field out(n);
  for (std::size_t k = 0; k < n; ++k) {
    const Complex right = a[(k + 1) % n] - a[k], left = a[k] - a[(k + n - 1) % n];
    out[k] = -i_unit / twice_tau *
             (right * std::sqrt(std::abs(right)) - left * std::sqrt(std::abs(left)));
  }
  return out;
}

/// Both exponents of a modulation, from the matrix in the header's text.
std::array<Complex, 2> exponents_by_hand(double q, double Q) {
  const double c = std::cos(q), C = std::cos(Q),
               rho = std::sqrt(2 * std::abs(std::sin(q / 2))) / twice_tau;
  const double a = 2.5 * c * C - 0.5 - 2 * c, e = -2.5 * std::sin(q) * std::sin(Q), k = (c - C) / 2;
  const Complex root = std::sqrt(Complex(k * k - a * a, 0));
  return {rho * (-i_unit * e + root), rho * (-i_unit * e - root)};
}

/// The state of the chain for unknowns over eps, one shift later and read at the neighbour, less what it was.
Eigen::VectorXd miss_by_hand(const Eigen::VectorXd& x, double time, double eps, std::size_t steps) {
  const Eigen::Index n = x.size() / 2;
  State<double> s{std::size_t(n)};
  for (Eigen::Index i = 0; i < n; ++i)
    s.y[std::size_t(i)] = eps * x[i], s.v[std::size_t(i)] = eps * x[n + i];
  evolve(EventCorrected{time, dormand_prince_6(), 1e-16 * std::pow(eps, 1.5)},
         Chain{std::size_t(n), Harmonic{}, Hertz{}, Ends::periodic}, s, TimeGrid{time, 1, steps});
  Eigen::VectorXd out = -x;
  for (Eigen::Index i = 0; i < n; ++i)
    out[(i + 1) % n] += s.y[std::size_t(i)] / eps,
        out[n + (i + 1) % n] += s.v[std::size_t(i)] / eps;
  return out;
}

}  // namespace

TEST_CASE("closed forms of plane waves in plain numbers", "[unit][dps_waves]") {
  CHECK(DpsWave<double>{1}.amplitude == 1);
  for (double q : {0.4, 1.5, 1.7, 1.9, 2.4, pi, -2.0})
    for (double amplitude : {1.0, 0.3}) {
      const DpsWave<double> wave{q, amplitude};
      const double s = std::sin(q / 2), rho = std::sqrt(2 * amplitude * std::abs(s)) / twice_tau,
                   c = std::cos(q);
      CAPTURE(q);
      check_close(wave.rate(), rho, 1e-14);
      check_close(wave.frequency(), -2 * rho * (1 - c), 1e-14);
      for (double Q : {0.2, 0.9, 1.6, 2.5, pi}) {
        const auto both = exponents_by_hand(q, Q);
        check_close(wave.growth(Q), std::sqrt(amplitude) * std::abs(both[0].real()), 1e-13);
      }
      CHECK(wave.unstable() == (c < 0));
      if (c >= 0) continue;
      const double edge = std::acos((1 + 3 * c) / (5 * c - 1)), inside = c < -0.2 ? -1e-3 : 1e-3;
      check_close(wave.edge(), edge, 1e-13);
      CHECK((wave.growth(edge + inside) > 0 && wave.growth(edge - inside) == 0));
      check_close(wave.fastest(), c > -0.2 ? pi : std::acos(0.5 + std::cos(edge) / 2), 1e-13);
    }
  // cos q = -1/5 to the last bit, and both sides of cos q = 0
  const DpsWave<double> fifth{std::acos(-0.2)}, right{1.5707}, left{1.5709};
  CHECK(fifth.unstable() == (std::cos(fifth.q) != -0.2));
  CHECK((!right.unstable() && left.unstable()));
  CHECK((std::isnan(right.edge()) && std::isnan(right.fastest()) && left.fastest() == pi));
}

TEST_CASE("a ring has the exponents of the closed form", "[unit][dps_waves]") {
  // Eigenvalues of differences of the right-hand side, in the frame that turns with the wave
  const int sites = 18;
  for (int waves = 1; waves < 9; ++waves) {
    const double q = 2 * pi * waves / sites, rho = std::sqrt(2 * std::sin(q / 2)) / twice_tau;
    const auto rate = [&](const Eigen::VectorXd& b) {
      Field field(sites);
      for (int n = 0; n < sites; ++n)
        field[std::size_t(n)] = std::polar(1.0, q * n) * Complex(1 + b[2 * n], b[2 * n + 1]);
      const Field slope = slope_by_hand(field);
      Eigen::VectorXd out(2 * sites);
      for (int n = 0; n < sites; ++n) {
        const Complex z = (slope[std::size_t(n)] -
                           2.0 * i_unit * rho * (1 - std::cos(q)) * field[std::size_t(n)]) *
                          std::polar(1.0, -q * n);
        out[2 * n] = z.real(), out[2 * n + 1] = z.imag();
      }
      return out;
    };
    Eigen::MatrixXd matrix(2 * sites, 2 * sites);
    for (int k = 0; k < 2 * sites; ++k) {
      const Eigen::VectorXd e = 1e-5 * Eigen::VectorXd::Unit(2 * sites, k);
      matrix.col(k) = (rate(e) - rate(-e)) / 2e-5;
    }
    const Eigen::VectorXcd found = Eigen::EigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
    CAPTURE(waves);
    for (int turns = 1; turns < sites; ++turns)
      for (const Complex& sigma : exponents_by_hand(q, 2 * pi * turns / sites))
        CHECK((found.array() - sigma).abs().minCoeff() < 1e-8);
    // Stable below pi/2 but for the root of an error, unstable above
    const double most = found.real().maxCoeff();
    CHECK((waves < 5 ? most < 1e-4 : most > 0.02));
  }
}

TEST_CASE("the growing mode of a ring, from the equation itself", "[unit][dps_waves]") {
  // The mode grows as it is: its slope is that of the wave times 1 + (sigma b), to first order
  for (const ModulatedWave& wave : {ModulatedWave{12, 5, 2}, {15, 6, 3}, {34, 9, 17}}) {
    const double Q = 2 * pi * wave.turns / double(wave.sites), size = 1e-6;
    const double p = 2 * pi * wave.waves / double(wave.sites);
    check_close(wave.modulation(), Q, 1e-14);
    check_close(wave.wave().q, p, 1e-14);
    const auto both = exponents_by_hand(p, Q);
    const Complex sigma = both[0].real() > 0 ? both[0] : both[1];
    check_close(wave.growth(), sigma.real(), 1e-14);
    const Field start = wave.start(size), slope = slope_by_hand(start);
    for (std::size_t n = 0; n < wave.sites; ++n) {
      const Complex carrier = std::exp(i_unit * p * double(n)),
                    turn = std::exp(i_unit * Q * double(n));
      const Complex b = start[n] / carrier - 1.0;
      // b = x e^{iQn} + conj(y) e^{-iQn}: x is the size, y follows from the rest
      const Complex rest = (b - size * turn) * turn;
      if (n > 0) check_close(std::abs(rest - (start[0] - 1.0 - size)), 0, 1e-14);
      const Complex expected = sigma * size * turn + std::conj(sigma) * rest / turn;
      const Complex relative = slope[n] / carrier + i_unit * wave.wave().frequency() * (1.0 + b);
      check_close(std::abs(relative - expected), 0, 30 * size * size);
    }
  }
  CHECK_THROWS_AS((ModulatedWave{8, 2, 1}.start(1e-3)), std::invalid_argument);
  double most = 0;
  for (int turns = 1; turns < 9; ++turns)
    most = std::max(most, exponents_by_hand(8 * pi / 9, 2 * pi * turns / 9)[0].real());
  check_close(largest_growth({9, 4, 0}), most, 1e-13);
  // Only the modulation of half a turn grows here
  check_close(largest_growth({34, 9, 0}), exponents_by_hand(18 * pi / 34, pi)[0].real(), 1e-13);
}

TEST_CASE("a wave of the chain is in the state of its neighbour", "[unit][dps_waves]") {
  struct Case {
    ModulatedWave wave;
    double eps;
    std::size_t steps;
    Eigen::Index sites;
  };
  for (const Case& c :
       {Case{{9, 3, 1}, 1e-3, 8, 3}, {{4, 2, 1}, 1e-2, 16, 2}, {{10, 4, 1}, 1e-4, 6, 5}}) {
    const ChainWave found = chain_wave(c.wave, c.eps, c.steps);
    const double q = 2 * pi * c.wave.waves / double(c.wave.sites), time = q / found.omega;
    const auto unknowns = [&](Eigen::Index n) {
      Eigen::VectorXd x(2 * n);
      for (Eigen::Index i = 0; i < n; ++i) {
        x[i] = found.state.y[std::size_t(i % c.sites)] / c.eps;
        x[n + i] = found.state.v[std::size_t(i % c.sites)] / c.eps;
      }
      return x;
    };
    REQUIRE(Eigen::Index(found.state.y.size()) == c.sites);
    const Eigen::VectorXd x = unknowns(c.sites);
    CAPTURE(c.sites, found.omega);
    CHECK(miss_by_hand(x, time, c.eps, c.steps).norm() < 3e-7);
    Complex sum = 0;
    for (Eigen::Index i = 0; i < c.sites; ++i)
      sum += Complex(x[i], -x[c.sites + i]) * std::exp(-i_unit * q * double(i)) / double(c.sites);
    check_close(std::abs(sum - 2.0), 0, 1e-9);
    CHECK((found.omega > 1 && found.omega < 1.5));
    // The map of the longer ring by differences of its own
    const Eigen::VectorXd far = unknowns(Eigen::Index(c.wave.sites));
    Eigen::MatrixXd map = Eigen::MatrixXd::Identity(far.size(), far.size());
    for (Eigen::Index k = 0; k < far.size(); ++k) {
      const Eigen::VectorXd e = 2.4e-4 / double(c.steps) * Eigen::VectorXd::Unit(far.size(), k);
      map.col(k) += (miss_by_hand(far + e, time, c.eps, c.steps) -
                     miss_by_hand(far - e, time, c.eps, c.steps)) /
                    (2 * e.norm());
    }
    const double most =
        Eigen::EigenSolver<Eigen::MatrixXd>(map).eigenvalues().cwiseAbs().maxCoeff();
    const WaveRates rates = chain_rates(c.wave, c.eps, c.steps);
    check_close(rates.growth, std::log(most) / time / std::sqrt(c.eps), 1e-7);
    check_close(rates.frequency, (1 - found.omega) / std::sqrt(c.eps), 0, 1e-12);
  }
  CHECK_THROWS_AS(chain_wave({6, 3, 1}, 1e12, 3), std::runtime_error);
}
