// Plane waves of the DpS equation, their modulation, the waves of the chain, and what they leave.

#include <numbers>

#include <Eigen/Eigenvalues>

#include "lattice/integrators/event_corrected.hpp"
#include "lattice/standing/stationary.hpp"
#include "sec5/dps_tracks.hpp"
#include "sec5/dps_waves.hpp"
#include "support/check.hpp"

using namespace lattice;
using std::numbers::pi;

namespace {

/// Shows the same field, turned on by `shift` sites each time, for 40 units of time.
BreatherWatch watched(const Field& field, int shift, double least) {
  BreatherWatch watch(least);
  const std::size_t n = field.size();
  for (int t = 0; t <= 40; ++t) {
    Field turned(n);
    for (std::size_t i = 0; i < n; ++i) turned[(i + std::size_t(shift * t)) % n] = field[i];
    watch.look(t, turned);
  }
  return watch;
}

/// What the DpS equation, linearised about the wave in its own frame, makes of the disturbance `z`.
Field linearised(const ModulatedWave& at, const Field& z) {
  const TurningDps flow{{at.sites, Ends::periodic}, -at.wave().frequency()};
  const double change = 1e-5;
  std::vector<double> slope[2];
  for (int sign : {0, 1}) {
    Field field(at.sites);
    for (std::size_t n = 0; n < at.sites; ++n)
      field[n] =
          std::polar(1.0, at.wave().q * double(n)) * (1.0 + (sign ? change : -change) * z[n]);
    slope[sign].resize(2 * at.sites);
    flow(0, interleaved(field).data(), slope[sign].data());
  }
  Field out(at.sites);
  for (std::size_t n = 0; n < at.sites; ++n) {
    const auto entry = [&](int sign) {
      return std::complex<double>(slope[sign][2 * n], slope[sign][2 * n + 1]);
    };
    out[n] = (entry(1) - entry(0)) / (2 * change) * std::polar(1.0, -at.wave().q * double(n));
  }
  return out;
}

/// A static breather of norm 20 on a ring, its peak at `peak`.
Field with_breather(std::size_t sites, std::size_t peak) {
  const auto breather = stationary<double>(Centre::site, 1.0, 31);
  const double scale = std::sqrt(20 / breather.norm());
  std::size_t highest = 0;
  for (std::size_t i = 0; i < breather.u.size(); ++i)
    if (std::abs(breather.u[i]) > std::abs(breather.u[highest])) highest = i;
  Field field(sites);
  for (std::size_t i = 0; i < breather.u.size(); ++i)
    field[(i + peak + sites - highest) % sites] = scale * breather.u[i];
  return field;
}

}  // namespace

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

TEST_CASE("growth of a modulated plane wave, by hand", "[unit][dps_waves]") {
  // q = pi, c = -1: growth^2 = 2 rho^2 (1 - C)(3 C - 1)
  const DpsWave<double> opposite{pi};
  check_close(opposite.rate(), std::sqrt(2.0) / (2 * tau_0()), 1e-15);
  check_close(opposite.frequency(), -4 * opposite.rate(), 1e-15);
  check_close(std::cos(opposite.edge()), 1.0 / 3, 1e-14);
  check_close(std::cos(opposite.fastest()), 2.0 / 3, 1e-14);
  check_close(opposite.growth(opposite.fastest()), opposite.rate() * std::sqrt(2.0 / 3), 1e-14);
  // c = -1/2 has its edge at 1/7, c = -1/10 at -7/15 and grows below it only
  check_close(std::cos(DpsWave<double>{2 * pi / 3}.edge()), -0.5 / -3.5, 1e-14);
  const DpsWave<double> tenth{std::acos(-0.1)};
  check_close(std::cos(tenth.edge()), -0.7 / 1.5, 1e-14);
  check_close(tenth.fastest(), pi, 0);
  check_close(tenth.growth(pi), 2 * tenth.rate() * std::sqrt(0.05), 1e-14);
  CHECK(tenth.growth(pi / 2) == 0);
  CHECK(opposite.growth(pi / 2) == 0);
  // Nothing grows exponentially for c >= 0, and hardly anything at c = -1/5
  for (double Q : {0.1, 1.0, 2.0, pi}) {
    CHECK(DpsWave<double>{1.5}.growth(Q) == 0);
    CHECK(DpsWave<double>{std::acos(-0.2)}.growth(Q) < 1e-7);
  }
  CHECK(std::isnan(DpsWave<double>{1.5}.edge()));
  CHECK(std::isnan(DpsWave<double>{1.5}.fastest()));
  // Sixteen times the amplitude, four times the rate; the slope of the frequency
  check_close(DpsWave<double>{2.5, 16}.growth(0.7), 4 * DpsWave<double>{2.5}.growth(0.7), 1e-14);
  const double slope =
      (DpsWave<double>{2.5001}.frequency() - DpsWave<double>{2.4999}.frequency()) / 2e-4;
  check_close(DpsWave<double>{2.5}.group_velocity(), slope, 1e-7);
}

TEST_CASE("the closed form has the exponents of a ring", "[property][dps_waves]") {
  for (int waves : {1, 2, 3, 4, 5, 6, 7, 9}) {
    CAPTURE(waves);
    CHECK(exponents_apart(18, waves) < 1e-8);
  }
}

TEST_CASE("the matrix of a marginal wave is nilpotent and not zero", "[unit][dps_waves]") {
  const ModulatedWave quarter{8, 2, 4}, below{32, 7, 16};
  Field z(8), other(32);
  for (std::size_t n = 0; n < 32; ++n) other[n] = {0, n % 2 ? -1.0 : 1.0};
  for (std::size_t n = 0; n < 8; ++n) z[n] = other[n];
  const Field once = linearised(quarter, z), twice = linearised(quarter, once);
  check_close(std::sqrt(norm(once) / 8), quarter.wave().drift(pi), 1e-8);
  check_close(std::sqrt(norm(twice)), 0, 1e-8);
  CHECK(quarter.wave().drift(pi) > 0.3);
  CHECK(quarter.growth() < 1e-7);
  // Below pi/2 the same modulation turns
  CHECK(norm(linearised(below, linearised(below, other))) > 0.1);
  // At cos q = -1/5 every modulation but one drifts, and none grows
  const DpsWave<double> fifth{std::acos(-0.2)};
  for (double Q : {0.3, 1.0, 2.5, pi}) {
    CHECK(fifth.drift(Q) > 0.05);
    CHECK(fifth.growth(Q) < 1e-7);
  }
  check_close(fifth.drift(fifth.q), 0, 1e-14);
}

TEST_CASE("a marginal side band grows in proportion to time", "[property][dps_waves]") {
  const ModulatedWave quarter{8, 2, 4};
  for (double until : {100.0, 400.0}) {
    Field field(8);
    for (std::size_t n = 0; n < 8; ++n)
      field[n] =
          std::polar(1.0, pi / 2 * double(n)) * std::complex<double>(1, n % 2 ? -1e-7 : 1e-7);
    evolve_dps(Dps{8, Ends::periodic}, field, until, 1, 1e-12, [](double, const Field&) {});
    check_close(std::sqrt(wave_share(field, 3 * pi / 2)) / 1e-7,
                std::hypot(1, quarter.wave().drift(pi) * until), 0, 1e-5);
  }
}

TEST_CASE("side bands grow in runs of the DpS equation", "[property][dps_waves]") {
  for (const ModulatedWave& wave : {ModulatedWave{16, 6, 2}, {34, 9, 17}}) {
    const WaveRates seen = run_in_dps(wave, 1e-11);
    check_close(seen.growth, wave.growth(), 0, 1e-6);
    check_close(seen.frequency, wave.wave().frequency(), 0, 1e-9);
  }
  CHECK_THROWS_AS((ModulatedWave{8, 1, 1}.start(1e-7)), std::invalid_argument);
}

TEST_CASE("opposite neighbours of the chain are one oscillator", "[unit][dps_waves]") {
  // x'' + x + (2 x)^{3/2} = 0; a quarter of the period by x = a sin(phi), the midpoint rule and its errors
  const ChainWave found = chain_wave({8, 4, 1}, 1e-2, 32);
  const double a = std::abs(found.state.y[0]);
  const auto rest = [](double x) { return x * x / 2 + 0.2 * std::pow(2 * x, 2.5); };
  double quarter = 0;
  const int points = 20000;
  for (int i = 0; i < points; ++i) {
    const double phi = pi / 2 * (i + 0.5) / points;
    quarter +=
        pi / 2 / points * a * std::cos(phi) / std::sqrt(2 * (rest(a) - rest(a * std::sin(phi))));
  }
  CHECK(std::abs(found.state.v[0]) < 1e-8);
  check_close(found.state.y[1], -found.state.y[0], 1e-9);
  check_close(found.omega, pi / 2 / quarter, 0, 1e-6);
}

TEST_CASE("growth in the chain approaches its limit like a root", "[convergence][dps_waves]") {
  const ModulatedWave wave{16, 6, 2};
  const double limit = largest_growth(wave), shift = wave.wave().frequency();
  const WaveRates coarse = chain_rates(wave, 1e-4, 16), fine = chain_rates(wave, 1e-6, 16);
  check_close(std::log10(std::abs(coarse.growth / limit - 1) / std::abs(fine.growth / limit - 1)),
              1, 0.02);
  check_close(
      std::log10(std::abs(coarse.frequency / shift - 1) / std::abs(fine.frequency / shift - 1)), 1,
      0.03);
  // A run shows the same, where it starts close enough to a wave of the chain
  const ModulatedWave three{12, 4, 2};
  const WaveRates run = run_in_chain(three, 1e-3, 0.2), own = chain_rates(three, 1e-3, 16);
  check_close(run.growth, own.growth, 0, 1e-3);
  check_close(run.frequency, own.frequency, 0, 1e-2);
}

TEST_CASE("the chain makes marginal waves grow like a fourth root", "[convergence][dps_waves]") {
  const ModulatedWave quarter{8, 2, 4};
  const double small = chain_rates(quarter, 1e-6, 16).growth;
  // From another program: splitting, variational equation, 400 steps, 0.0533(2) and 0.01796(15)
  check_close(chain_rates(quarter, 1e-4, 16).growth, 0.0534, 2e-4);
  check_close(small, 0.01796, 1.5e-4);
  check_close(std::log10(small / chain_rates(quarter, 1e-8, 16).growth) / 2, 0.25, 3e-3);
  CHECK(chain_rates({16, 3, 0}, 1e-3, 16).growth < 1e-3);
  // Runs lose the one wave and keep the other
  const auto left = [](int waves) {
    Field field = noisy_wave(32, waves, 1e-4, 1);
    evolve_in_chain(field, 1e-3, 80, 80, 0.2, [](double, const Field&) {});
    return wave_share(field, 2 * pi * waves / 32);
  };
  check_close(left(8), 0.054, 2e-3);
  check_close(left(7), 1, 1e-3);
}

TEST_CASE("breathers on a ring are counted with their energy and their way", "[unit][dps_tracks]") {
  const Field field = with_breather(40, 39);  // across the seam
  const auto rest = watched(field, 0, 25).breathers();
  REQUIRE(rest.size() == 1);
  check_close(rest[0].norm, 20, 0, 5e-3);  // the sixth and seventh site hold the rest
  check_close(rest[0].energy, static_energy(20), 0, 1e-3);
  CHECK(rest[0].lived == 40);
  CHECK(rest[0].strayed < 1e-12);
  const auto moving = watched(field, 1, 25).breathers();
  REQUIRE(moving.size() == 1);
  check_close(moving[0].speed, 1, 1e-12);
  check_close(moving[0].strayed, 40, 1e-9);          // once round
  CHECK(watched(field, 2, 25).breathers().empty());  // too fast to be one
  CHECK(watched(field, 0, 41).breathers().empty());  // too short a life
  CHECK(watched(noisy_wave(40, 20, 0.01, 1), 0, 25).breathers().empty());
}

TEST_CASE("none seen leaves an upper limit", "[unit][dps_tracks]") {
  check_close(rate_below(0, 4000), 3.0 / 4000, 0, 2e-3);
  // So many or fewer must have the probability of five per cent
  for (int births : {0, 1, 5, 40}) {
    const double mean = rate_below(std::size_t(births), 10) * 10;
    double term = std::exp(-mean), below = term;
    for (int k = 1; k <= births; ++k) below += term *= mean / k;
    check_close(below, 0.05, 1e-10);
  }
  CHECK(rate_below(1, 100) > rate_below(0, 100));
  check_close(rate_below(3, 200), rate_below(3, 100) / 2, 1e-15);
}

TEST_CASE("noise has a seed and a size", "[unit][dps_tracks]") {
  const Field wave = noisy_wave(24, 6, 0.01, 7), again = noisy_wave(24, 6, 0.01, 7);
  CHECK(wave == again);
  CHECK(wave != noisy_wave(24, 6, 0.01, 8));
  for (std::size_t n = 0; n < 24; ++n)
    check_close(std::abs(wave[n] - std::polar(1.0, pi / 2 * double(n))), 0, 0.0142);
  check_close(wave_share(wave, pi / 2), 1, 2e-4);
  CHECK(wave_share(wave, pi) < 1e-4);
  check_close(norm(random_field(24, 3)), 24, 1e-12);
  // The energy of infinite temperature, 2/5 * 2^{5/4} * Gamma(9/4)
  double mean = 0;
  for (unsigned long seed = 1; seed <= 200; ++seed)
    mean += energy(random_field(500, seed), true) / (200 * 500);
  check_close(mean, 1.0779, 0.02);
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
      check_close(wave.group_velocity(), -2.5 * rho * std::sin(q), 1e-14);
      for (double Q : {0.2, 0.9, 1.6, 2.5, pi}) {
        const auto both = exponents_by_hand(q, Q);
        check_close(wave.growth(Q), std::sqrt(amplitude) * std::abs(both[0].real()), 1e-13);
        check_close(wave.drift(Q), 2 * rho * std::abs(2.5 * c * std::cos(Q) - 0.5 - 2 * c), 1e-13);
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

TEST_CASE("exponents and growing modes on a ring, from the equation itself", "[unit][dps_waves]") {
  const auto found = ring_exponents(7, 3);
  REQUIRE(found.size() == 14);
  const double q = 6 * pi / 7;
  double farthest = 0;
  for (int turns = 1; turns < 7; ++turns)
    for (const Complex& sigma : exponents_by_hand(q, 2 * pi * turns / 7)) {
      double nearest = 1;
      for (const Complex& z : found) nearest = std::min(nearest, std::abs(z - sigma));
      farthest = std::max(farthest, nearest);
    }
  check_close(exponents_apart(7, 3), farthest / (std::sqrt(2 * std::sin(q / 2)) / twice_tau),
              1e-14);
  CHECK((farthest > 1e-14 && farthest < 1e-8));
  for (int waves : {1, 2, 3, 4}) CHECK(exponents_apart(9, waves) < 1e-8);
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
