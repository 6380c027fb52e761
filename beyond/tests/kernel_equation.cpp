// The kernel equation: its convolution against a direct integral, its waves against the lattice, and the ascent
// of the quotient.

#include "check.hpp"
#include "report/table.hpp"
#include "sec5/kernel_wave.hpp"
#include "sec5/quotient.hpp"
#include "sec5/travelling.hpp"

using namespace lattice;

namespace {

const double two_pi = 2 * pi<double>();
const PowerContact hertz{1.5, 0};

/// The integral of K(t - s) (1 - s^2 / 4)_+^(3/2), by Simpson's rule in s = 2 sin(x).
double direct(double t, double shift_time) {
  const int n = 200000;
  double sum = 0;
  for (int i = 0; i <= n; ++i) {
    const double x = pi<double>() * (double(i) / n - 0.5), c = std::cos(x);
    const double apart = std::abs(t - 2 * std::sin(x));
    const double value = apart < shift_time ? -std::sin(apart) * c * c * c * 2 * c : 0;
    sum += value * (i == 0 || i == n ? 1 : i % 2 ? 4 : 2);
  }
  return sum * pi<double>() / n / 3;
}

/// (1 - t^2 / 4)_+^(3/2) on a grid that is cut at its end.
Vector<double> bump(const HalfLine& line) {
  Vector<double> f = line.t();
  for (double& t : f) {
    const double x = std::max(0.0, 1 - t * t / 4);
    t = x * std::sqrt(x);
  }
  return f;
}

const KernelWave& wave_of(int sign) {
  static const KernelWave plus = wave_of_type_one(1, 1, hertz),
                          minus = wave_of_type_one(1, -1, hertz);
  return sign > 0 ? plus : minus;
}

}  // namespace

TEST_CASE("a panel integrates powers that its map makes analytic", "[unit][kernel]") {
  // The integral of t^a (1 - t)^a over (0, 1) is the beta function of a + 1
  for (std::size_t order : {2, 3}) {
    const double power = order == 2 ? 3. / 2 : 4. / 3;
    const Panel panel(20, order);
    double sum = 0;
    for (Eigen::Index i = 0; i < panel.x.size(); ++i) {
      const double t = panel.map(panel.x[i]);
      sum += panel.weight[i] * panel.slope(panel.x[i]) * std::pow(t * (1 - t), power);
    }
    check_close(sum, std::beta(power + 1, power + 1), 1e-14);
    for (double u : {1e-9, 0.2, 0.5, 0.97}) check_close(panel.map(panel.inverse(u)), u, 1e-14);
    // From zero to each node, and a polynomial between them
    Vector<double> cubes = panel.x.array().cube();
    for (Eigen::Index i = 0; i < panel.x.size(); ++i)
      check_close(panel.integral.row(i).dot(cubes), std::pow(panel.x[i], 4) / 4, 1e-14);
    check_close(panel.interpolate(cubes.data(), 0.3), 0.027, 1e-14);
  }
}

TEST_CASE("the convolution with the kernel is the integral that defines it", "[unit][kernel]") {
  const HalfLine line(two_pi, {0, 1, 2, two_pi / 2}, 2, Panel(24, 2));
  const Vector<double> d = line.convolve(bump(line));
  for (Eigen::Index i :
       {Eigen::Index(3), line.size() / 4, line.size() / 2 - 5, line.size() / 2 + 9}) {
    CAPTURE(line.t()[i]);
    check_close(d[i], direct(line.t()[i], two_pi), 1e-9);
  }
  // Its mean is zero
  check_close(line.integral(d), 0, 1e-12);
  // A plain grid says the same, to the second power of its step and better
  double worst[2];
  for (int fine : {0, 1}) {
    const std::size_t points = fine ? 256 : 128;
    const PlainLine plain(two_pi, 4, points);
    Vector<double> f = plain.t();
    for (double& t : f) {
      const double x = std::max(0.0, 1 - (t - 2 * two_pi) * (t - 2 * two_pi) / 4);
      t = x * std::sqrt(x);
    }
    const Vector<double> there = plain.convolve(f);
    worst[fine] = 0;
    for (Eigen::Index i = 0; i < there.size(); ++i)
      worst[fine] =
          std::max(worst[fine], std::abs(there[i] - line.at(d, plain.t()[i] - 2 * two_pi)));
  }
  CHECK(worst[1] < 1e-5);
  CHECK(worst[1] < worst[0] / 4);
}

TEST_CASE("for other shift times the lattice's equation is solved where V = 0",
          "[property][kernel]") {
  // d'' + d = f(t + T) - 2 f(t) + f(t - T) away from t = 0, whatever T and V are
  const double time = 5.5;
  const HalfLine line(time, {0, 1, 2, time / 2}, 3, Panel(24, 2));
  const Vector<double> f = bump(line), d = line.convolve(f);
  const double h = 1e-3;
  for (double t : {0.3, 1.5, 2.6, 4.0, 6.1, 8.0}) {
    CAPTURE(t);
    const double second =
        (line.at(d, t + h) - 2 * line.at(d, t) + line.at(d, t - h)) / (h * h) + line.at(d, t);
    check_close(second, line.at(f, t + time) - 2 * line.at(f, t) + line.at(f, t - time), 1e-5);
  }
  CHECK(std::abs(line.at(d, time + 2.5)) < 1e-14);
}

TEST_CASE("the linearized equation is solved", "[unit][kernel]") {
  const KernelWave& w = wave_of(1);
  Vector<double> stiffness = w.d;
  for (double& x : stiffness) x = hertz.stiffness(-x);
  // K * f'(d) d = 3/2 d, so that x = -2 d solves it with d on the right
  const Vector<double> x = solve_linearized(w.line, stiffness, w.d);
  check_close((x + 2 * w.d).cwiseAbs().maxCoeff(), 0, 1e-9);
}

TEST_CASE("waves of the kernel equation are orbits of the lattice", "[property][kernel]") {
  for (int sign : {1, -1}) {
    const KernelWave& w = wave_of(sign);
    CHECK(w.residual() < 1e-14);
    CHECK(w.central_velocity() * sign > 0);
    CHECK(w.contacts() == (sign > 0 ? 18 : 17));
    // The orbit from this state repeats itself, one site further on, after T
    const State<double> start = w.state(usual_reach);
    Chain chain{start.y.size()};
    chain.contact = hertz;
    State<double> end = start;
    flow(chain, end, two_pi);
    double miss = 0;
    for (std::size_t i = 0; i + 1 < start.y.size(); ++i)
      miss = std::max(miss, std::hypot(end.y[i + 1] - start.y[i], end.v[i + 1] - start.v[i]));
    CHECK(miss < 1e-11);
    check_close(w.energy(), energy(chain, start), 1e-13);
    // The mean over a shift is the same: T E = 1/2 f * L * f + 2/5 A, here by the lattice's states in time
    double mean = 0;
    State<double> now = start;
    for (int i = 0; i < 8; ++i) {
      flow(chain, now, two_pi / 8);
      mean += energy(chain, now) / 8;
    }
    check_close(mean, w.energy(), 1e-12);
  }
}

TEST_CASE("energies agree with those of the shift map", "[published][kernel]") {
  const std::string folder = DATA_DIR;
  const Table kernel = read(folder + "/sec5_kernel_equation/waves.ecsv"),
              lattice = read(folder + "/sec5_travelling_families/orbits.ecsv");
  const auto k = kernel.numbers("k"), sign = kernel.numbers("sign"), e = kernel.numbers("energy"),
             error = kernel.numbers("energy_error");
  const auto type = lattice.numbers("type"), there_k = lattice.numbers("k"),
             there_sign = lattice.numbers("sign"), there = lattice.numbers("energy");
  std::size_t met = 0;
  for (std::size_t i = 0; i < k.size(); ++i)
    for (std::size_t j = 0; j < there.size(); ++j)
      if (type[j] == 1 && there_k[j] == k[i] && there_sign[j] == sign[i]) {
        CAPTURE(k[i], sign[i]);
        ++met;
        check_close(e[i], there[j], 1e-10, 1e-10);
        check_close(e[i], there[j], 1e-11 + error[i]);
      }
  CHECK(met == 12);
}

TEST_CASE("what the theorem says of every wave holds for those computed", "[property][kernel]") {
  for (int sign : {1, -1}) {
    const KernelWave& w = wave_of(sign);
    CHECK(w.peak() > std::pow(4.0, -2.0));
    check_close(w.line.integral(w.d), 0, 1e-13);
    // The norm of K_+ in L^(5/4) bounds the quotient, and Q(f) = A^(-1/5)
    CHECK(w.quotient() < 2.0);
    const Vector<double> f = w.force();
    const double q = w.line.integral(f.cwiseProduct(w.line.convolve(f)));
    double mass = 0;
    for (Eigen::Index i = 0; i < f.size(); ++i)
      mass += 2 * w.line.weight()[i] * std::pow(f[i], 5. / 3);
    check_close(q / std::pow(mass, 1.2), w.quotient(), 1e-13);
    // M(t + T) <= 4 M(t)^(3/2) from the second contact on
    const auto closed = w.closed(0);
    for (std::size_t i = 1; i < closed.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (closed[i].from > closed[j].from + two_pi)
          CHECK(closed[i].most <= 4 * std::pow(closed[j].most, 1.5));
  }
}

TEST_CASE("the ascent never goes down and ends at the wave", "[convergence][kernel]") {
  const PlainLine line(two_pi, 10, 64);
  Vector<double> u = line.t();
  for (double& t : u) t = 1 + std::sin(3.1 * t) * std::cos(0.7 * t);
  const auto convolve = [&](const Vector<double>& f) { return line.convolve(f); };
  const Ascent course = ascend(convolve, line.weight(), hertz, u, 1e-9, 3000);
  CHECK(std::is_sorted(course.quotients.begin(), course.quotients.end()));
  CHECK(course.quotients.size() > 20);
  check_close(course.quotient(), wave_of(1).quotient(), 2e-3);
}

TEST_CASE("the wave of type II is the orbit of the lattice", "[convergence][kernel]") {
  const KernelWave w = wave_of_type_two(wave_of(1), 0.89 * two_pi, 0.01 * two_pi);
  check_close(w.shift_time() / two_pi, 0.89740655032, 1e-10);
  check_close(w.energy(), 1.31383222, 1e-7);
  CHECK(std::abs(w.component()) < 1e-12);
  CHECK_THROWS_AS(wave_of_type_two(wave_of(1), 0.985 * two_pi, 0.01 * two_pi), std::runtime_error);
}
