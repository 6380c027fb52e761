// Decaying breathers a second time: members of a branch by another formula, the growth of a shift by a Runge-Kutta method
// for any equation, what is read from a bead by way of a record.

#include "sec5/decay.hpp"

#include <array>
#include <numbers>

#include "check.hpp"
#include "lattice/integrators/driven_chain.hpp"

namespace decay_again {

using namespace lattice;

namespace {

constexpr double turn = 2 * std::numbers::pi;
using Numbers = std::vector<double>;

/// A line through two points, or its continuation.
double on_line(double x, double x0, double y0, double x1, double y1) {
  return (y0 * (x1 - x) + y1 * (x - x0)) / (x1 - x0);
}

/// The square of the growth rate at ln area = a: between members, or between the limit and the first of them.
double square_again(const std::vector<Member>& members, double limit, double a) {
  Numbers area, excess, scaled;
  for (const Member& m : members) {
    // cosh(sigma T) = 1 + 2 kappa
    const double sigma = std::acosh(1 + 2 * std::abs(m.kappa)) * m.omega / turn;
    area.push_back(std::log(m.area)), excess.push_back(std::log(m.omega - 1));
    scaled.push_back(std::copysign(sigma * sigma, m.kappa) / (m.omega - 1) / (m.omega - 1));
  }
  if (a <= area[0]) {
    const double first = std::exp(excess[0]), low = first * std::exp((a - area[0]) / 4);
    return on_line(low, 0, limit * limit, first, scaled[0]) * low * low;
  }
  std::size_t i = 1;
  while (i + 1 < area.size() && area[i] < a) ++i;
  const auto along = [&](const Numbers& y) {
    return on_line(a, area[i - 1], y[i - 1], area[i], y[i]);
  };
  return along(scaled) * std::pow(std::exp(along(excess)), 2);
}

/// The largest |X| in a thousand classical Runge-Kutta steps, for X'' + nu X' / 4 = sigma^2 X.
double shift_again(const std::vector<Member>& members, double limit, double nu) {
  using Pair = std::array<double, 2>;
  const double h = std::log(100) / 1000 / nu, start = std::log(members.back().area);
  const auto f = [&](double t, const Pair& x) {
    return Pair{x[1], square_again(members, limit, start - nu * t) * x[0] - nu / 4 * x[1]};
  };
  const auto plus = [](const Pair& x, double w, const Pair& k) {
    return Pair{x[0] + w * k[0], x[1] + w * k[1]};
  };
  Pair x{1, 0};
  double most = 1;
  for (int i = 0; i < 1000; ++i) {
    const double t = i * h;
    const Pair a = f(t, x), b = f(t + h / 2, plus(x, h / 2, a)),
               c = f(t + h / 2, plus(x, h / 2, b)), d = f(t + h, plus(x, h, c));
    for (int k : {0, 1}) x[k] += h * (a[k] / 6 + b[k] / 3 + c[k] / 3 + d[k] / 6);
    most = std::max(most, std::abs(x[0]));
  }
  return most;
}

/// Members whose growth is that of kappa, with signs.
std::vector<Member> branch(const Numbers& kappa) {
  std::vector<Member> out;
  for (std::size_t i = 0; i < kappa.size(); ++i) {
    const double omega = 1.03 + 0.02 * double(i * i), area = std::pow(4.0, double(i)) + 0.3;
    const double sigma = std::acosh(1 + 2 * std::max(0.0, kappa[i])) * omega / turn;
    out.push_back({omega, area, kappa[i], sigma});
  }
  return out;
}

}  // namespace

TEST_CASE("a member of a branch and its pair", "[unit][decay]") {
  const double omega = 1.05;
  const Orbit<double> orbit = breather_at(Centre::site, omega);
  CHECK(orbit.start.y.size() == 21);
  CHECK(breather_at(Centre::bond, omega).start.y.size() == 22);
  const auto problem = breather_problem<double>(Centre::site, omega, 0.0, 21);
  EventTolerance<double> rule;
  for (bool fine : {true, false}) {
    const Member m = member_at(Centre::site, omega, 0, fine);
    if (!fine) rule.tolerance = rule.tolerance * 1000;
    const double kappa =
        floquet_pairs(problem.chain, orbit.start, turn / omega, rule).kappa[0].real();
    check_close(m.kappa, kappa, 0, 1e-12);
    check_close(m.area, orbit.area, 0);
    CHECK(m.omega == omega);
    const double growth = kappa > 0 ? std::acosh(1 + 2 * kappa) * omega / turn : 0;
    check_close(m.growth, growth, 0, 1e-6);
  }
  CHECK(member_at(Centre::site, omega, 0).kappa == member_at(Centre::site, omega, 0, true).kappa);
  // The one is unstable, the other is not
  const Member up = member_at(Centre::site, omega, 0), down = member_at(Centre::bond, omega, 0);
  CAPTURE(up.kappa, down.kappa);
  CHECK(up.kappa * down.kappa < 0);
  const Member& loud = up.kappa > 0 ? up : down;
  check_close(loud.growth, std::acosh(1 + 2 * loud.kappa) * omega / turn, 0, 1e-6);
  CHECK(loud.growth > 0);
  CHECK((up.kappa > 0 ? down : up).growth == 0);
  Member simple;
  CHECK(simple.omega + simple.area + simple.kappa + simple.growth == 0);
  simple.omega = 1.25, simple.growth = 0.3;
  check_close(simple.multiplier(), std::exp(0.3 * turn / 1.25), 0, 1e-14);
}

TEST_CASE("the growth of a shift along a branch of both signs", "[unit][decay]") {
  // Above the last member there is nothing, below the first one the limit
  for (const Numbers& kappa : {Numbers{0.02, 0.05, 0.01},
                               {0.03, -0.04, 0.02},
                               {-0.02, 0.06, -0.03},
                               {0.05, -0.06, -0.01},
                               {0.001, 0.002, 0.003}})
    for (double limit : {0.0, 0.7, 2.0})
      for (double nu : {0.01, 0.03, 0.1}) {
        CAPTURE(kappa, limit, nu);
        const double value = largest_shift(branch(kappa), limit, nu);
        check_close(value, shift_again(branch(kappa), limit, nu), 0, 1e-9);
      }
}

TEST_CASE("the shortest lifetime for a growth", "[unit][decay]") {
  const auto members = branch({0.02, 0.05, 0.01});
  const double most = members[1].growth > members[2].growth ? members[1].growth : members[2].growth;
  // Any growth is more than none: then it is the first step, a tenth of the time of the fastest growth
  check_close(lifetime_of_growth(members, 0.7, 1), 0.1 / most / 1.1, 0, 1e-9);
  for (double factor : {1.5, 4.0, 90.0}) {
    const double life = lifetime_of_growth(members, 0.7, factor);
    check_close(largest_shift(members, 0.7, 1 / life), factor, 0, 1e-8);
    for (double less : {0.99, 0.9, 0.5})
      CHECK(largest_shift(members, 0.7, 1 / life / less) < factor);
  }
}

TEST_CASE("a decay is read from a record of the run", "[unit][decay]") {
  for (Ends ends : {Ends::free, Ends::fixed}) {
    Chain chain{5};
    chain.ends = ends;
    Orbit<double> orbit;
    orbit.start = State<double>(5);
    orbit.start.y = {0.1, -0.6, 0.3, 0.6, -0.1}, orbit.start.v = {0, 0.1, 0, -0.2, 0};
    const double nu = 0.004, h = 0.1;
    Numbers t, y, e, place;
    State<double> state = orbit.start;
    run_driven({chain, {nu, 0}}, state, time_grid(75, h, h),
               [&](const State<double>& now, const auto&) {
                 const Numbers density = energy_density(chain, now);
                 double sum = 0, moment = 0;
                 for (std::size_t n = 0; n < 5; ++n)
                   sum += density[n], moment += double(n + 1) * density[n];
                 // Half of a contact's energy belongs to the bead on its right
                 for (std::size_t n = 0; n < 4; ++n)
                   moment += 0.2 * std::pow(std::max(0.0, now.y[n] - now.y[n + 1]), 2.5);
                 t.push_back(now.t), y.push_back(now.y[1]), e.push_back(sum),
                     place.push_back(moment / sum);
                 return true;
               });
    Numbers up;
    std::vector<std::size_t> after;
    for (std::size_t i = 1; i < t.size(); ++i)
      if (y[i - 1] < 0 && y[i] >= 0)
        up.push_back((t[i - 1] * y[i] - t[i] * y[i - 1]) / (y[i] - y[i - 1])), after.push_back(i);
    const Decay decay = let_decay(orbit, chain, nu, 75, h);
    CHECK(up.size() > 10);
    REQUIRE(decay.size() == up.size() - 8);
    for (std::size_t k = 0; k + 8 < up.size(); ++k) {
      double energy = 0, centre = 0;
      for (std::size_t i = after[k]; i < after[k + 8]; ++i) energy += e[i], centre += place[i];
      const double count = double(after[k + 8] - after[k]);
      const DecayMoment& m = decay[k];
      check_close(m.t, 0.5 * (up[k] + up[k + 8]), 1e-11);
      check_close(m.omega, 8 * turn / (up[k + 8] - up[k]), 0, 1e-12);
      check_close(m.energy, energy / count, 0, 1e-11);
      check_close(m.centre, centre / count, 0, 1e-11);
    }
  }
}

}  // namespace decay_again
