// Phonons, the NLS coefficients, exact waves, their growth and the soliton, by second formulas.

#include <algorithm>
#include <functional>

#include "check.hpp"
#include "lattice/algebra/eigenvalues.hpp"
#include "lattice/gsl/random.hpp"
#include "sec4/instability.hpp"
#include "sec4/plane_wave.hpp"

namespace plane_waves_again {

using namespace lattice;
using std::numbers::pi;

namespace {

const double d = 0.5, rest = std::pow(d, 1.5);

/// The force of a compressed contact of relative displacement r, Eq. (33), and its derivative.
double bond(double r) {
  return r < d ? rest - std::pow(d - r, 1.5) : rest;
}
double bend(double r) {
  return r < d ? 1.5 * std::sqrt(d - r) : 0;
}

/// Positions, then velocities, on a ring of wells of anharmonicity s; classical Runge-Kutta.
using Flow = std::function<std::vector<double>(const std::vector<double>&)>;
std::vector<double> stepped(const std::vector<double>& z, double h, const Flow& rate) {
  const auto at = [&](double by, const std::vector<double>& k) {
    std::vector<double> x(z);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += by * k[i];
    return x;
  };
  const auto a = rate(z), b = rate(at(h / 2, a)), c = rate(at(h / 2, b)), e = rate(at(h, c));
  std::vector<double> x(z);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + e[i]);
  return x;
}

/// The rates of a ring and of `columns` small disturbances of it, one after the other in z.
Flow ring_rates(std::size_t n, double s, std::size_t columns) {
  return [=](const std::vector<double>& z) {
    std::vector<double> out(z.size());
    for (std::size_t i = 0; i < n; ++i) {
      const double y = z[i], right = z[(i + 1) % n] - y, left = y - z[(i + n - 1) % n];
      out[i] = z[n + i];
      out[n + i] = -y - s * y * y * y + bond(right) - bond(left);
      for (std::size_t c = 1; c <= columns; ++c) {
        const double *u = &z[2 * n * c], x = u[i];
        out[2 * n * c + i] = u[n + i];
        out[2 * n * c + n + i] = -(1 + 3 * s * y * y) * x + bend(right) * (u[(i + 1) % n] - x) -
                                 bend(left) * (x - u[(i + n - 1) % n]);
      }
    }
    return out;
  };
}

std::vector<double> flat(const State<double>& z) {
  std::vector<double> x(z.y);
  x.insert(x.end(), z.v.begin(), z.v.end());
  return x;
}

/// The anharmonicity at which beta vanishes.
double without_beta(double q, double compression) {
  const double x = 1 - std::cos(q), v1 = 1.5 * std::sqrt(compression), sine = std::sin(q);
  return -1.5 * sine * sine * x * x / compression / (4 * v1 * x * x + 3) +
         x * x / (4 * std::pow(compression, 1.5));
}

}  // namespace

TEST_CASE("what the band and the NLS equation say of a phonon, by a second formula", "[unit]") {
  for (double D : {0.5, 2.0})
    for (double q : {0.4, pi / 2, 2.7})
      for (double s : {-0.3, 0.2, 1.0}) {
        CAPTURE(D, q, s);
        const double v1 = 1.5 * std::sqrt(D), x = 1 - std::cos(q);
        const double omega = std::sqrt(1 + 2 * v1 * x), c = v1 * std::sin(q) / omega;
        const double curvature = (v1 * std::cos(q) - c * c) / omega;
        const double beta = 1.5 * (s - without_beta(q, D));
        const Coefficients<double> at = coefficients(q, D, s);
        check_close(at.omega, omega, 1e-14);
        check_close(at.group_velocity, c, 1e-14);
        check_close(at.curvature, curvature, 1e-14);
        check_close(at.beta, beta, 1e-13);
        check_close(at.omega_2, curvature * omega / v1, 1e-14);
        check_close(at.phi, -beta * at.omega_2, 1e-13);
        check_close(at.h(), beta / omega, 1e-13);
        // The rate of growth from the formula with moduli, and the modulation that grows fastest
        const double a = 0.1, h = std::abs(beta / omega), size = a * a / 4;
        for (double part : {0.3, 1.0, 1.3, 1.5}) {
          const double Q = part * std::sqrt(2 * h * size / std::abs(curvature));
          const double half = std::abs(curvature) * Q * Q / 2;
          const double square = beta * curvature < 0 ? half * (2 * h * size - half) : 0;
          check_close(nls_growth(at, a, Q), square > 0 ? std::sqrt(square) : 0, 1e-14);
          if (beta * curvature < 0 && part == 1) check_close(fastest_modulation(at, a), Q, 1e-14);
        }
      }
  check_close(upper_edge(2.0), 3, 1e-15);
}

TEST_CASE("no interval of unstable wavenumbers is too narrow to be found", "[unit]") {
  const auto ends = [](double D, double s) {
    std::vector<double> out;
    for (const auto& part : unstable_wavenumbers(D, s)) out.insert(out.end(), {part.from, part.to});
    return out;
  };
  const auto check = [&](double D, double s, const std::vector<double>& right) {
    const std::vector<double> found = ends(D, s);
    CAPTURE(D, s, found);
    REQUIRE(found.size() == right.size());
    for (std::size_t k = 0; k < right.size(); ++k) check_close(found[k], right[k], 3e-8, 1e-11);
  };
  // An edge next to 0 and next to pi, and a narrow gap; the values are those of a program with sixty digits
  check(1e-6, 2.27e-5, {0.000776312306718529, 1.56930080943298});
  check(0.5, 2.828427, {1.16795002276345, 3.14134384488821});
  check(1, 1e-9, {0.0112475972836517, 1.04710809692715, 1.0472869823720304, 1.1024444801741456});
  // Both edges of an interval of this width between the zeros of the curvature and of beta
  for (double width : {1e-4, 1e-6, 1e-9}) {
    const double zero = 1.2,
                 D = std::pow(2 * std::cos(zero) / std::pow(1 - std::cos(zero), 2) / 3, 2);
    const auto seen = unstable_wavenumbers(D, without_beta(zero - width, D)).back();
    check_close(seen.from, zero - width, 1e-14);
    check_close(seen.to, zero, 1e-14);
  }
  CHECK(ends(0.5, 0) == std::vector<double>{0, inflection(contact_series(0.5).v1)});
  CHECK(ends(0.5, 4).back() == pi);
}

TEST_CASE("unstable are the wavenumbers at which Phi is positive", "[property]") {
  Random random(3);
  for (int k = 0; k < 3000; ++k) {
    const double D = std::pow(10, random.uniform(-6, 2)),
                 s = std::copysign(std::pow(10, random.uniform(-12, 2)), random.uniform(-1, 1));
    const auto parts = unstable_wavenumbers(D, s);
    for (int j = 0; j < 20; ++j) {
      const double q = random.uniform(0, pi), phi = coefficients(q, D, s).phi;
      bool inside = false, beside = std::abs(phi) < 1e-9 * std::abs(s);
      for (const auto& part : parts) {
        inside = inside || (q > part.from && q < part.to);
        beside = beside || std::abs(q - part.from) < 1e-9 || std::abs(q - part.to) < 1e-9;
      }
      if (!beside && inside != (phi > 0)) FAIL_CHECK("d = " << D << ", s = " << s << ", q = " << q);
    }
  }
  // By bisection between two wavenumbers, too
  CHECK_THROWS_AS(sign_change_of_phi(d, 0.0, 0.0, 1.3), std::invalid_argument);
  CHECK_THROWS_AS(sign_change_of_phi(d, 0.0, 1.3, 0.0), std::invalid_argument);
  check_close(largest_phi(d, -4, 1), 6, 1e-14);                      // at q = 0
  check_close(largest_phi(d, 4, 1), 6 - 3 * std::sqrt(2.0), 1e-13);  // at q = pi, if it is positive
  CHECK(largest_phi(d, 1, 1) == 0);
  check_close(largest_phi(d, 1, 2), coefficients(pi / 2, d, 1.0).phi, 1e-15);
}

TEST_CASE("an exact wave obeys its equation between the points where it was imposed", "[unit]") {
  const PlaneWave three{0.7, 1.3, {0.2, -0.05, 0.03}};
  check_close(three.profile(0.4), 0.2 * std::sin(0.4) - 0.05 * std::sin(0.8) + 0.03 * std::sin(1.2),
              1e-15);
  check_close(three.slope(0.4), 0.2 * std::cos(0.4) - 0.1 * std::cos(0.8) + 0.09 * std::cos(1.2),
              1e-15);
  check_close(three.relative(0.4), three.profile(1.1) - three.profile(0.4), 1e-15);
  for (double q : {0.6, 1.9})
    for (double s : {-0.2, 1.0}) {
      const PlaneWave wave = plane_wave(Quartic{s}, CompressedHertz{d}, q, 0.14, 24);
      CHECK(wave.b.size() == 24);
      CHECK(wave.b[0] == 0.14);
      const auto phi = [&](double x) {
        double sum = 0;
        for (int k = 1; k <= 24; ++k) sum += wave.b[std::size_t(k - 1)] * std::sin(k * x);
        return sum;
      };
      for (double x : {0.1, 1.7, 3.3, 5.9}) {
        double second = 0;
        for (int k = 1; k <= 24; ++k)
          second -= k * k * wave.b[std::size_t(k - 1)] * std::sin(k * x);
        const double y = phi(x);
        check_close(wave.omega * wave.omega * second + y + s * y * y * y,
                    bond(phi(x + q) - y) - bond(y - phi(x - q)), 1e-11);
      }
      const State<double> ring = on_ring(wave, 3);
      check_close(ring.y[1], phi(2 * q), 1e-15);
      check_close(ring.v[2], -wave.omega * (phi(3 * q + 1e-5) - phi(3 * q - 1e-5)) / 2e-5, 1e-9);
    }
  CHECK(plane_wave(Quartic{}, CompressedHertz{d}, 1, 0.1).b.size() == 12);
  // The largest wave is the one that opens a contact, wherever in the period that is
  for (double q : {0.2, 2.0}) {
    double low = 0, high = 4, top = 0;
    for (int k = 0; k < 12; ++k) {
      const double a = (low + high) / 2;
      const auto make = [&] { plane_wave(Quartic{}, CompressedHertz{d}, q, a, 8); };
      (refusal<std::runtime_error>(make).empty() ? low : high) = a;
    }
    const PlaneWave wave = plane_wave(Quartic{}, CompressedHertz{d}, q, low, 8);
    for (double x = 0; x < 2 * pi; x += 0.01) top = std::max(top, wave.relative(x));
    CAPTURE(q, low);
    check_close(top, d, 0, 2e-3);
  }
}

TEST_CASE("the growth rate is that of a disturbance that is followed for a period", "[unit]") {
  // Backscattering, on four sites and, beside it, modulations that grow with the NLS equation's help, on eight
  const auto compare_on = [](std::size_t n, double s, double a, int waves) {
    const PlaneWave wave =
        plane_wave(Quartic{s}, CompressedHertz{d}, 2 * pi * waves / double(n), a);
    std::vector<double> z = flat(on_ring(wave, n));
    z.resize(2 * n * (2 * n + 1), 0.0);
    for (std::size_t c = 0; c < 2 * n; ++c) z[2 * n * (c + 1) + c] = 1;
    const double period = 2 * pi / wave.omega;
    for (int k = 0; k < 200; ++k) z = stepped(z, period / 200, ring_rates(n, s, 2 * n));
    const auto size = Eigen::Index(2 * n);
    const Eigen::Map<const Eigen::MatrixXd> map(z.data() + size, size, size);
    double most = 0;
    for (const std::complex<double>& value : eigenvalues_of(Matrix<double>(map)))
      most = std::max(most, std::abs(value));
    // Modulations that differ by a wavenumber of the wave are the same
    double best = 0;
    for (int k = 0; k < waves; ++k)
      best =
          std::max(best, growth_rate(wave, Quartic{s}, CompressedHertz{d}, 2 * pi * k / double(n)));
    CAPTURE(n, s, a, best);
    check_close(best, std::log(most) / period, 2e-7);
    CHECK(best > 1e-3);
  };
  compare_on(4, 1, 0.12, 1);
  compare_on(4, 1, 0.16, 1);
  compare_on(8, 1, 0.12, 2);
}

TEST_CASE("growth is compared with the NLS equation at the right amplitudes", "[unit]") {
  const Estimate limit =
      at_zero_amplitude(0.5, [](double a) { return 3 + 5 * a * a + 7 * std::pow(a, 4); });
  check_close(limit.value, 3 - 7 * std::pow(0.5, 4) / 64, 1e-14);
  check_close(limit.error, 7 * std::pow(0.5, 4) * (1.0 / 4 - 1.0 / 64), 1e-14);
  const PhaseOfWave at{pi / 4, d, -1.0 / 6};
  const auto nls = at.nls();
  CHECK(nls.phi == coefficients(pi / 4, d, -1.0 / 6).phi);
  const auto grown = [&](double a, double Q, std::size_t harmonics) {
    const PlaneWave wave = plane_wave(Quartic{-1.0 / 6}, CompressedHertz{d}, pi / 4, a, harmonics);
    return growth_rate(wave, Quartic{-1.0 / 6}, CompressedHertz{d}, Q);
  };
  check_close(at.growth(0.3, 0.2), grown(0.3, 0.2, 12), 0);
  check_close(at.growth(0.3, 0.2, 4), grown(0.3, 0.2, 4), 0);
  const double unit = std::abs(nls.beta / nls.omega) * 0.3 * 0.3 / 4;
  check_close(growth_over_nls(at, 0.3, 0.2), grown(0.3, 0.2, 12) / unit, 1e-14);
  check_close(growth_over_nls(at, 0.3, 0.2, 4), grown(0.3, 0.2, 4) / unit, 1e-14);
  // Phi, measured: the fastest rate is |h| |A|^2 = Phi |A|^2 / (omega |omega_2|)
  const auto phi = [&](double a) {
    const double Q = a * std::sqrt(std::abs(nls.h() / (2 * nls.curvature)));
    return grown(a, Q, 12) * 4 / (a * a) * nls.omega * std::abs(nls.omega_2);
  };
  const double x = phi(0.1), y = phi(0.05), z = phi(0.025);
  const Estimate measured = at.phi_from_growth(0.1);
  check_close(measured.value, (4 * z - y) / 3, 1e-10);
  check_close(measured.error, std::abs(4 * z - 5 * y + x) / 3, 1e-10);
}

}  // namespace plane_waves_again
