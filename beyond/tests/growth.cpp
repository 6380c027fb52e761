// Plane waves of the DpS equation, their modulation, the waves of the chain, and what they leave.

#include <numbers>

#include "check.hpp"
#include "lattice/standing/stationary.hpp"
#include "sec5/dps_tracks.hpp"
#include "sec5/dps_waves.hpp"

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
