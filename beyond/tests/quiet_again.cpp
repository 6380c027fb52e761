// Quiet orbits of driven chains a second time: thresholds at both sides of their bounds, the equations, the curve of one
// and of two beads point by point, and one drive of the array in its units.

#include <Eigen/LU>
#include <numbers>

#include "check.hpp"
#include "lattice/model/dps.hpp"
#include "sec5/driven_array.hpp"

namespace quiet_again {

using namespace lattice;
using By = Drive::By;

namespace {

constexpr double turn = 2 * std::numbers::pi;

/// The state one period later less that at the start, for state and amplitude `x`.
Vector<double> miss_again(DrivenChain d, const Vector<double>& x, std::size_t steps) {
  const Eigen::Index n = x.size() / 2;
  State<double> s{std::size_t(n)};
  std::copy(x.data(), x.data() + n, s.y.begin());
  std::copy(x.data() + n, x.data() + 2 * n, s.v.begin());
  d.drive.amplitude = x[2 * n];
  run_driven(d, s, TimeGrid{turn / d.drive.omega, steps, 1},
             [](const State<double>&, const EnergyBudget&) { return true; });
  Vector<double> out(2 * n);
  for (Eigen::Index i = 0; i < n; ++i)
    out[i] = s.y[std::size_t(i)] - x[i], out[n + i] = s.v[std::size_t(i)] - x[n + i];
  return out;
}

/// Its derivative.
Matrix<double> slopes_again(const DrivenChain& d, const Vector<double>& x, std::size_t steps,
                            double change) {
  Matrix<double> out(x.size() - 1, x.size());
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    const Vector<double> e = change * Vector<double>::Unit(x.size(), k);
    out.col(k) = (miss_again(d, x + e, steps) - miss_again(d, x - e, steps)) / (2 * change);
  }
  return out;
}

/// The height of the parabola through three points.
double top_of(const double* s, const double* a) {
  Eigen::Matrix3d powers;
  for (int i = 0; i < 3; ++i) powers.row(i) << 1, s[i] - s[1], (s[i] - s[1]) * (s[i] - s[1]);
  const Eigen::Vector3d c = powers.inverse() * Eigen::Vector3d(a[0], a[1], a[2]);
  return c[0] - c[1] * c[1] / (4 * c[2]);
}

}  // namespace

TEST_CASE("bounds of rates, silences and thresholds", "[unit][driven]") {
  Emission e;
  e.passages = {10, 49, 50, 61, 70, 83};
  check_close(e.rate(100), 4.0 / 50, 1e-15);
  // Gaps of 11, 9 and 13: mean 11, square deviations 0, 4, 4
  check_close(e.spread(100), std::sqrt(8.0 / 3) / 11, 1e-15);
  CHECK(e.spread(102) == -1);
  CHECK(!e.lasts(100, 17));
  CHECK(e.lasts(100, 17.5));
  const Emission nothing;
  CHECK(nothing.power + nothing.response + nothing.far + nothing.loudest + nothing.budget == 0);
  // From 1/4..1 to 11/32..7/16, which is longer than a fifth of 7/16, and 25/64..7/16
  int asked = 0;
  const auto found = bisect_threshold(0.25, 1, 0.2, [&](double a) { return ++asked, a > 0.4; });
  check_close(found.value, 53.0 / 128, 1e-15);
  check_close(found.error, 3.0 / 128, 1e-15);
  CHECK(asked == 6);
  check_close(bisect_threshold(0.5, 1, 0.5, [](double a) { return a > 0.7; }).error, 0.25, 0);
  for (bool always : {false, true})
    CHECK_THROWS_AS(bisect_threshold(0.25, 1, 0.2, [&](double) { return always; }),
                    std::runtime_error);
  // Five amplitudes 1..5, and those that emit
  const auto among = [](std::vector<int> loud) {
    return threshold_among(3, 1, 2, [=](double a) {
      return std::find(loud.begin(), loud.end(), int(std::lround(a))) != loud.end();
    });
  };
  check_close(among({2, 5}).value, 3, 1e-15);
  check_close(among({2, 5}).error, 1, 1e-15);
  check_close(among({5}).value, 4.5, 1e-15);
  check_close(among({2, 3, 4, 5}).value, 1.5, 1e-15);
  check_close(among({2, 3, 4, 5}).error, 0.5, 1e-15);
  for (const std::vector<int>& loud : {std::vector<int>{1, 5}, {4}, {1, 3}, {}, {1, 2, 3, 4, 5}})
    CHECK_THROWS_AS(among(loud), std::runtime_error);
}

TEST_CASE("the law of the threshold, and the equations of a quiet orbit", "[unit][driven]") {
  const double width = 2 * tau_0() * 0.07, piston = dps_threshold(By::piston).value;
  check_close(law_estimate(By::piston, 1.07).value, 2 * width * width * piston, 0, 1e-12);
  check_close(law_estimate(By::base, 1.07).value,
              4 * 0.07 * width * width * dps_threshold(By::base).value, 0, 1e-12);
  check_close(piston, 0.050414785, 1e-9);
  check_close(dps_threshold(By::base).value, 0.028116632, 1e-9);
  for (By by : {By::piston, By::base}) {
    const Estimate law = law_estimate(by, 1.07), top = dps_threshold(by);
    check_close(law.error / law.value, top.error / top.value, 0, 1e-12);
    CHECK(law.value == threshold_law(by, 1.07));
  }
  // Two beads: state and amplitude
  DrivenOrbit orbit{{Chain{2}, {0.1, 0.2}, {By::piston, 1.2, 7, 0, 0}}, 12};
  CHECK((DrivenOrbit{}.steps == 64 && orbit.length == 0 && orbit.scale == 1));
  orbit.scale = 0.3, orbit.length = 0.7;
  Vector<double> x(5);
  x << 0.2, -0.1, 0.3, 0.15, 0.5;
  orbit.from = 0.5 * x, orbit.along = Vector<double>::LinSpaced(5, 0.1, 0.6);
  const Vector<double> expected = miss_again(orbit.driven, x, 12);
  const Shot<double> shot = orbit.shoot(x, {}, true), bare = orbit.shoot(x, {}, false);
  CHECK(bare.jacobian.size() == 0);
  CHECK(bare.miss == shot.miss);
  double plane = -0.7 * 0.3;
  for (int i = 0; i < 5; ++i) plane += 0.5 * x[i] * orbit.along[i];
  for (int i = 0; i < 4; ++i) check_close(shot.miss[i], expected[i], 1e-12);
  check_close(shot.miss[4], plane, 1e-15);
  const Matrix<double> slopes = slopes_again(orbit.driven, x, 12, 1e-5);
  for (int k = 0; k < 5; ++k) {
    for (int i = 0; i < 4; ++i) check_close(shot.jacobian(i, k), slopes(i, k), 1e-7);
    check_close(shot.jacobian(4, k), orbit.along[k], 0);
    for (const Vector<double>& size :
         {orbit.sizes(x, false).unknown, orbit.sizes(x, true).equation})
      check_close(size[k], 0.3, 0);
  }
  CHECK(orbit.sizes(x, false).equation.size() == 5);
}

TEST_CASE("the curve of quiet orbits, point by point", "[unit][driven]") {
  // A bead on a base is linear: the state is the amplitude times a fixed one, and the curve a straight line
  for (double apart : {5.0, 3.0}) {
    const DrivenChain linear{Chain{1}, {0.3, 0}, {By::base, 1.2}};
    const QuietBranch line = quiet_branch(linear, 16, apart);
    REQUIRE(line.amplitude.size() == std::size_t(20 / apart));
    const auto slope = [&](int k) {
      const Vector<double> e = Vector<double>::Unit(3, k);
      return miss_again(linear, e, 16);
    };
    Eigen::Matrix2d map;
    map << slope(0), slope(1);
    const Eigen::Vector2d unit = -map.inverse() * slope(2);
    const double size = threshold_law(By::piston, 1.2);
    double a = 0.2 * threshold_law(By::base, 1.2);
    for (std::size_t k = 0; k < line.amplitude.size(); ++k) {
      check_close(line.amplitude[k], a, 0, 1e-8);
      check_close(line.response[k], a * unit.norm(), 0, 1e-8);
      a += apart * size / std::sqrt(1 + unit.squaredNorm());
    }
    CHECK(line.fold == 0);
  }
  // Two beads with a piston have a fold; the same points by Newton's method with a plain derivative
  const DrivenChain bent{Chain{2}, {0.02, 0}, {By::piston, 1.2}};
  const double size = threshold_law(By::piston, 1.2);
  for (const auto& [apart, beyond] : {std::pair{0.1, 0.8}, {0.16, 0.95}, {0.8, 0.9}}) {
    const QuietBranch branch =
        apart == 0.1 ? quiet_branch(bent, 16) : quiet_branch(bent, 16, apart, beyond);
    Vector<double> at = Vector<double>::Zero(5), along = Vector<double>::Unit(5, 4);
    std::vector<double> s{0}, a;
    for (std::size_t k = 0; k < branch.amplitude.size(); ++k) {
      const double far = size * (k == 0 ? 0.2 : apart);
      Vector<double> x = at + far * along;
      for (int i = 0; i < 8; ++i) {
        Matrix<double> slopes(5, 5);
        slopes << slopes_again(bent, x, 16, 1e-6 * size), along.transpose();
        Vector<double> miss(5);
        miss << miss_again(bent, x, 16), along.dot(x - at) - far;
        x -= slopes.partialPivLu().solve(miss);
      }
      s.push_back(s.back() + (x - at).norm() / size), a.push_back(x[4]);
      along = (x - at).normalized(), at = x;
      check_close(branch.amplitude[k], x[4], 0, 1e-8);
      check_close(branch.response[k], std::hypot(x[0], x[2]), 0, 1e-8);
    }
    // The parabola through the first three points the last of which is lower
    std::size_t m = 3;
    while (a.at(m) > a[m - 1]) ++m;
    check_close(branch.fold, top_of(&s[m - 1], &a[m - 2]), 0, 1e-9);
    CHECK(a.back() < beyond * branch.fold);
    CHECK(*(a.end() - 2) >= beyond * branch.fold);
  }
}

TEST_CASE("one drive of the array, in its units", "[unit][driven]") {
  DrivenArray array;
  CHECK((array.frequency == 7000 && array.amplitude == 5 && array.duration == 60));
  CHECK((array.lifetime == 10 && array.by == By::piston && DrivenArray::step == 0.02));
  CHECK((DrivenArray::sites == 300 && DrivenArray::drawn == 60 && DrivenArray::detector == 20));
  const Scales u = CantileverArray{}.scales();
  const DrivenChain plain = ArraySetup{}.driven(By::base, 1.1, 2, 3, 4), d = array.driven();
  CHECK((plain.chain.sites == 120 && d.chain.sites == 300 && plain.losses.contact == 0));
  CHECK((plain.drive.by == By::base && plain.drive.omega == 1.1 && plain.drive.amplitude == 2));
  CHECK((plain.drive.from == 3 && plain.drive.ramp == 4 && d.drive.from == 0));
  check_close(d.losses.rate, u.tau_c() / 10e-3, 0, 1e-12);
  check_close(d.drive.amplitude, 5e-6 / u.xi(), 0, 1e-12);
  check_close(d.drive.ramp, 10e-3 / u.tau_c(), 0, 1e-12);
  check_close(array.horizon(), 60e-3 / u.tau_c(), 0, 1e-12);
  check_close(array.law(1.1).value, threshold_law(By::piston, 1.1) * u.xi() * 1e6, 0, 1e-12);
  check_close(array.law(1.1).error, law_estimate(By::piston, 1.1).error * u.xi() * 1e6, 0, 1e-12);
  // A short and strong drive, once with each step; below the frequency of a beam there is no law
  array.duration = 5, array.amplitude = 300;
  const double long_time = array.horizon();
  Emission two[2];
  for (int fine : {0, 1})
    two[fine] = drive_chain(array.driven(), long_time, 20, fine ? 0.02 : 0.04);
  const auto all = array.quantities();
  REQUIRE(all.size() == 6);
  REQUIRE(two[1].passages.size() > 0);
  CHECK((all[0].value.value == 1 && all[0].value.is_exact));
  const double energy = u.k * u.xi() * u.xi();
  const auto same = [&](std::size_t i, double unit,
                        const std::function<double(const Emission&)>& of) {
    CAPTURE(i);
    check_close(all[i].value.value, of(two[1]) * unit, 0, 1e-12);
    check_close(all[i].value.error, std::abs(of(two[1]) - of(two[0])) * unit,
                1e-15 * std::abs(of(two[1]) * unit), 1e-6);
  };
  same(1, 1 / u.tau_c(), [&](const Emission& e) { return e.rate(long_time); });
  same(2, energy / u.tau_c(), [](const Emission& e) { return e.power; });
  same(3, u.xi() * 1e6, [](const Emission& e) { return e.response; });
  same(4, 1, [](const Emission& e) { return e.budget; });
  check_close(all[5].value.value, array.law(u.omega(7000)).value, 0);
  array.duration = 0.1, array.frequency = u.hertz(0.99);
  CHECK(array.quantities().size() == 5);
  CHECK(array.quantities()[0].value.value == 0);
}

TEST_CASE("an array whose far end moves is too short for its drive", "[unit][driven]") {
  for (const auto& [amplitude, lifetime] :
       {std::pair{100.0, 10.0}, {200.0, 1000.0}, {60.0, 1000.0}}) {
    DrivenArray array;
    array.duration = 20, array.amplitude = amplitude, array.lifetime = lifetime;
    const auto whole = array.quantities();
    array.beads = 25;
    CHECK(array.run(0.04).far > 1e-9);
    const auto lengthened = array.quantities();
    for (std::size_t i = 0; i < 4; ++i)
      check_close(lengthened[i].value.value, whole[i].value.value, 1e-12, 1e-9);
    array.amplitude = 0.001, array.beads = 25;
    CHECK(array.run(0.04).far < 1e-9);
  }
}

}  // namespace quiet_again
