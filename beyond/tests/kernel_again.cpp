// The kernel equation once more: panels, grids and waves against closed forms.

#include <functional>

#include <Eigen/LU>

#include "check.hpp"
#include "lattice/orbits/shooting.hpp"
#include "sec5/kernel_wave.hpp"

namespace kernel_again {

using namespace lattice;

namespace {

const double time_5 = 5;  ///< a shift time that is not one of the wells
const PowerContact hertz{1.5, 0}, square{2, 0};

Vector<double> sampled(const Vector<double>& t, const std::function<double(double)>& of) {
  Vector<double> values = t;
  for (double& x : values) x = of(x);
  return values;
}

/// Two shifts with panels of three lengths.
HalfLine small_line(std::size_t order = 2) {
  return {time_5, {0, 0.5, 1.5, 2.5}, 2, Panel(24, order)};
}

/// What a force g(t) = (a + b t)^2 that ends at t = 10 does: X and its derivative.
struct Parabola {
  double a = 0.3, b = 0.07, end = 10;
  double d(double t) const { return a + b * t; }
  double g(double t) const { return d(t) * d(t); }
  double slope(double t) const { return 2 * b * d(t); }
  double x(double t) const {
    if (t >= end) return 0;
    const double c = std::cos(end - t), s = std::sin(end - t);
    return g(t) - g(end) * c + slope(end) * s + 2 * b * b * (c - 1);
  }
  double v(double t) const {
    if (t >= end) return 0;
    const double c = std::cos(end - t), s = std::sin(end - t);
    return slope(t) - g(end) * s - slope(end) * c + 2 * b * b * s;
  }
  /// Twice the integral of g cos t.
  double component() const {
    return 2 * (g(end) * std::sin(end) + slope(end) * std::cos(end) - 2 * b * b * std::sin(end) -
                slope(0));
  }
};

}  // namespace

TEST_CASE("a panel of three nodes is that of the textbook", "[unit][kernel]") {
  const double root = std::sqrt(0.6);
  for (std::size_t order : {2, 3}) {
    const Panel panel(3, order);
    for (int i = 0; i < 3; ++i) {
      check_close(panel.x[i], (1 + (i - 1) * root) / 2, 1e-15);
      check_close(panel.weight[i], i == 1 ? 4. / 9 : 5. / 18, 1e-15);
      for (int k = 0; k < 3; ++k)
        check_close(panel.integral.row(i).dot(Vector<double>(panel.x.array().pow(k))),
                    std::pow(panel.x[i], k + 1) / (k + 1), 1e-15);
    }
    check_close(panel.lagrange[1] / panel.lagrange[0], -2, 1e-14);  // the nodes are equally spaced
    check_close(panel.lagrange[2] / panel.lagrange[0], 1, 1e-14);
    const double values[] = {3, -1, 4, 0};
    for (int i = 0; i < 3; ++i) CHECK(panel.interpolate(values, panel.x[i]) == values[i]);
    for (double z : {-1.7, -1.0, 0.3, 1.0})  // the parabola through (-1, 3), (0, -1), (1, 4)
      check_close(panel.interpolate(values, (1 + z * root) / 2), -1 + z / 2 + 4.5 * z * z, 1e-14);
    for (double s : {0.1, 0.4, 0.5, 0.8, 0.95}) {
      // The map from its derivative, which has zeros of that order less one at both ends
      const double c = order == 2 ? 6 : 30,
                   w = order == 2 ? s * s / 2 - s * s * s / 3
                                  : std::pow(s, 3) / 3 - std::pow(s, 4) / 2 + std::pow(s, 5) / 5;
      check_close(panel.map(s), c * w, 1e-14);
      check_close(panel.slope(s), c * std::pow(s * (1 - s), double(order) - 1), 1e-15);
      check_close(panel.inverse(c * w), s, 1e-13);
    }
    CHECK(panel.inverse(-0.1) == 0);
    CHECK(panel.inverse(0) == 0);
    CHECK(panel.inverse(1) == 1);
  }
}

TEST_CASE("the response to a parabola is known", "[unit][kernel]") {
  const Parabola p;
  for (std::size_t order : {2, 3}) {
    const HalfLine line = small_line(order);
    const Vector<double> f = sampled(line.t(), [&](double t) { return p.g(t); });
    CHECK(line.size() == 2 * 6 * 24);
    CHECK(line.periods() == 2);
    CHECK(line.shift_time() == 5);
    // Panels begin at 0, 0.5, 1.5, 2.5, 3.5, 4.5, and again after a shift
    const double starts[] = {0, 0.5, 1.5, 2.5, 3.5, 4.5, 5, 5.5, 6.5, 7.5, 8.5, 9.5, 10};
    for (int i = 0; i < 12; ++i) {
      const Panel panel(24, order);
      check_close(line.t()[24 * i], starts[i] + (starts[i + 1] - starts[i]) * panel.map(panel.x[0]),
                  1e-14);
      check_close(line.t()[24 * i + 23],
                  starts[i] + (starts[i + 1] - starts[i]) * panel.map(panel.x[23]), 1e-14);
    }
    check_close(line.integral(f), 2 * (std::pow(p.d(10), 3) - std::pow(p.d(0), 3)) / (3 * p.b),
                1e-11);
    for (double t : {0.0, -0.3, 0.5, 1.7, 4.6, 5.0, -7.2, 9.99, 10.0})
      check_close(line.at(f, t), p.g(std::abs(t)), 1e-11);
    CHECK(line.at(f, 10.0001) == 0);
    CHECK(line.at(f, -10.9) == 0);
    const HalfLine other(time_5, {0, 1, 2.5}, 1, Panel(9, 2));
    const Vector<double> there = line.onto(other, f);
    REQUIRE(there.size() == other.size());
    for (Eigen::Index i = 0; i < there.size(); ++i) check_close(there[i], p.g(other.t()[i]), 1e-11);
    const auto r = line.respond(f);
    const Vector<double> d = line.convolve(f);
    check_close(r.component, p.component(), 1e-11);
    REQUIRE((r.half.size() == 2 && r.half_v.size() == 2));
    for (std::size_t j = 0; j < 2; ++j) {
      check_close(r.half[j], p.x(2.5 + 5 * double(j)), 1e-11);
      check_close(r.half_v[j], p.v(2.5 + 5 * double(j)), 1e-11);
    }
    for (Eigen::Index i = 0; i < line.size(); ++i) {
      const double t = line.t()[i];
      check_close(r.x[i], p.x(t), 1e-11);
      check_close(d[i],
                  p.x(t + 5) - 2 * p.x(t) + p.x(std::abs(t - 5)) +
                      (t < 5 ? p.component() * std::sin(5 - t) : 0),
                  1e-11);
    }
  }
}

TEST_CASE("what is said of a wave follows from its compressions", "[unit][kernel]") {
  const Parabola p;
  const HalfLine line = small_line();
  const KernelWave w{square, line, sampled(line.t(), [&](double t) { return p.d(t); })};
  const double action = (std::pow(p.d(10), 4) - std::pow(p.d(0), 4)) / (2 * p.b);
  check_close(w.action(), action, 1e-12);
  check_close(w.quotient(), 1 / std::cbrt(action), 1e-11);
  check_close(w.component(), p.component(), 1e-11);
  check_close(w.central_velocity(), 2 * p.v(2.5) + std::cos(2.5) * p.component(), 1e-11);
  double miss = 0;
  for (double t : Vector<double>(line.t()))
    miss = std::max(miss, std::abs(p.x(t + 5) - 2 * p.x(t) + p.x(std::abs(t - 5)) +
                                   (t < 5 ? p.component() * std::sin(5 - t) : 0) - p.d(t)));
  check_close(w.residual(), miss / w.d.maxCoeff(), 0, 1e-11);
  // Sites -L, ..., L + 1, for lattices that are shorter and longer than the wave
  double energy = 0;
  for (std::size_t reach : {0, 1, 2, 3}) {
    const State<double> z = w.state(reach);
    REQUIRE((z.y.size() == 2 * reach + 2 && z.v.size() == z.y.size()));
    energy = 0;
    for (int i = 0; i < int(z.y.size()); ++i) {
      const int n = i - int(reach), j = std::abs(n);
      const double near = 5 * (j - 0.5), far = near + 5, sign = n > 0 ? -1 : 1;
      const double y = n == 0 ? 0 : sign * (p.x(far) - p.x(near)),
                   v = n == 0 ? w.central_velocity() : p.v(far) - p.v(near);
      CAPTURE(reach, n);
      check_close(z.y[std::size_t(i)], y, 1e-11);
      check_close(z.v[std::size_t(i)], v, 1e-11);
      if (reach == 2) energy += (y * y + v * v) / 2;
    }
    if (reach != 2) continue;
    for (double t : {2.5, 7.5}) energy += 2 * std::pow(p.d(t), 3) / 3;
    check_close(w.energy(), energy, 1e-12);
  }
  // Forces where the contact is closed, however little
  const HalfLine two(time_5, {0, 2.5}, 1, Panel(2, 2));
  KernelWave few{hertz, two, Vector<double>(4)};
  few.d << 0.25, -0.25, 0, 4;
  const Vector<double> f = few.force();
  CHECK((f[0] == 0.125 && f[1] == 0 && f[2] == 0 && f[3] == 8));
  check_close(few.action(), two.integral(Vector<double>{{0.03125, 0, 0, 32}}), 1e-11);
}

TEST_CASE("the peak lies between nodes", "[unit][kernel]") {
  const HalfLine line(time_5, {0, 1, 2, 2.5}, 1, Panel(20, 2));
  for (double top : {0.0, 0.4, 2.0, 3.3}) {
    const KernelWave w{
        hertz, line, sampled(line.t(), [&](double t) { return 0.5 * std::cos(0.7 * (t - top)); })};
    check_close(w.peak(), 0.5, 1e-11);
  }
}

TEST_CASE("contacts are closed from one zero to the next", "[unit][kernel]") {
  const HalfLine line = small_line();
  const double quarter = pi<double>() / 4;
  for (double sign : {1.0, -1.0}) {
    const auto of = [&](double t) { return sign * 0.8 * std::exp(-0.3 * t) * std::cos(2 * t); };
    const KernelWave w{hertz, line, sampled(line.t(), of)};
    const auto closed = w.closed(0.01);
    // Zeros are odd multiples of pi/4, and the last contact is closed to the end for one sign
    std::vector<double> from, to;
    for (double t = sign > 0 ? -quarter : quarter; t < 10; t += 4 * quarter)
      from.push_back(std::max(0.0, t)), to.push_back(std::min(10.0, t + 2 * quarter));
    REQUIRE(closed.size() == from.size());
    for (std::size_t i = 0; i < closed.size(); ++i) {
      check_close(closed[i].from, from[i], 1e-12);
      check_close(closed[i].to, to[i], 1e-12);
      double most = 0;
      for (Eigen::Index k = 0; k < line.size(); ++k)
        if (line.t()[k] >= from[i] && line.t()[k] <= to[i]) most = std::max(most, w.d[k]);
      CHECK(closed[i].most == most);
    }
    CHECK(w.contacts() == 2 * closed.size() - (sign > 0));
    // Half of the largest one is exceeded by the first or two; all of it by none
    CHECK(w.closed(0.5).size() == 1);
    CHECK(w.closed(1).empty());
  }
  // Zeros of the values themselves, at both ends, and a sign that changes at the last node only
  const HalfLine two(time_5, {0, 2.5}, 1, Panel(3, 2));
  const auto contacts = [&](std::vector<double> d) {
    const KernelWave w{hertz, two, Vector<double>(Eigen::Map<const Vector<double>>(d.data(), 6))};
    return std::pair{w.closed(0.01), w.contacts()};
  };
  const auto [first, number] = contacts({0, 0.5, 0.5, 0.5, -0.5, -0.5});
  CHECK(number == 2);
  REQUIRE(first.size() == 1);
  CHECK(first[0].from > 0);
  CHECK(first[0].most == 0.5);
  const auto ended = contacts({0.5, 0.5, 0.25, -0.5, 0, 0});
  CHECK((ended.first.size() == 1 && ended.second == 1 && ended.first[0].from == 0 &&
         ended.first[0].to < 5));
  CHECK(contacts({0.5, 0.5, 0, -0.5, -0.5, -0.5}).second == 1);
  const auto late = contacts({0.5, 0.5, 0.5, 0.5, 0.5, -0.5});
  CHECK((late.first.size() == 1 && late.second == 1 && late.first[0].to < 5));
  const auto at_last = contacts({0.5, -0.5, -0.5, -0.5, -0.5, 0.25});
  CHECK((at_last.second == 1));
  CHECK(contacts({-0.5, -0.5, 0.001, 0.25, 0.5, 0.25}).second == 2);
  CHECK(contacts({-0.5, 0.5, -0.5, -0.5, -0.5, -0.5}).second == 2);
}

TEST_CASE("the linearized equation is the linear system of the grid", "[unit][kernel]") {
  const HalfLine line(time_5, {0, 1, 2.5}, 2, Panel(6, 2));
  const auto n = line.size();
  const Vector<double> stiffness =
                           sampled(line.t(), [](double t) { return 1 + std::cos(1.3 * t); }),
                       right = sampled(line.t(), [](double t) { return std::exp(-t) - 0.2; });
  Matrix<double> matrix = Matrix<double>::Identity(n, n);
  for (Eigen::Index j = 0; j < n; ++j)
    matrix.col(j) -= line.convolve(stiffness[j] * Vector<double>::Unit(n, j));
  const Vector<double> exact = matrix.partialPivLu().solve(right);
  check_close((solve_linearized(line, stiffness, right) - exact).norm() / exact.norm(), 0, 1e-9);
  // The residual is as small as it was asked for, and hardly smaller
  std::vector<double> left;
  for (double enough : {1e-2, 1e-4, 1e-6}) {
    const Vector<double> x = solve_linearized(line, stiffness, right, enough);
    left.push_back((matrix * x - right).norm() / right.norm());
    CHECK(left.back() <= enough * (1 + 1e-8));
    CHECK(solve_linearized(line, stiffness, 100 * right, enough).isApprox(100 * x, 1e-9));
  }
  CHECK((left[0] > 1e-4 && left[1] > 1e-6 && left[2] > 1e-9));
  check_line(refusal<std::runtime_error>([&] { solve_linearized(line, stiffness, right, 0); }),
             "not solved");
}

}  // namespace kernel_again
