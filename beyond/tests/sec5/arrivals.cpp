// Friction: the closed form of one bead and absorbing ends; the slow clock of the DpS field and of packets, and
// breathers that decay.

#include "sec5/driven_chain.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <numeric>

#include "lattice/cantilever/cantilever.hpp"
#include "lattice/diagnostics/path.hpp"
#include "lattice/diagnostics/pulse.hpp"
#include "lattice/dps/evolve.hpp"
#include "lattice/impact/impact.hpp"
#include "sec5/arrivals.hpp"
#include "sec5/decay.hpp"
#include "support/check.hpp"

using namespace lattice;

namespace {

/// The energy centre of a damped chain, averaged over about eight periods each time.
std::vector<double> centres(const Chain& chain, State<double> state, double nu, double duration) {
  std::vector<double> out;
  double sum = 0;
  std::size_t looks = 0;
  evolve({chain, {nu, 0}}, state, time_grid(duration, 0.2, 0.2),
         [&](const State<double>& now, const EnergyBudget&) {
           // A contact belongs to both of its beads
           auto e = energy_density(chain, now);
           for (std::size_t n = 1; n < e.size(); ++n) {
             const double half = contact_energy(chain, now.y.data(), n) / 2;
             e[n - 1] -= half, e[n] += half;
           }
           sum += energy_centre(e, 0, e.size());
           if (++looks % 256 == 0) out.push_back(sum / 256), sum = 0;
           return true;
         });
  return out;
}

}  // namespace

TEST_CASE("one damped bead follows the closed form", "[unit][damped]") {
  const double nu = 0.2, time = 10, omega = std::sqrt(1 - nu * nu / 4);
  const double decay = std::exp(-nu * time / 2), c = std::cos(omega * time);
  const double sine = std::sin(omega * time) / omega;
  const auto error = [&](double step) {
    State<double> s(1);
    s.y[0] = 1;
    evolve({Chain{1}, {nu, 0}}, s, time_grid(time, time, step));
    return std::max(std::abs(s.y[0] - decay * (c + nu / 2 * sine)),
                    std::abs(s.v[0] + decay * sine));
  };
  const double coarse = error(0.02), fine = error(0.01);
  CAPTURE(coarse, fine);
  CHECK(fine < 1e-5);
  check_close(std::log2(coarse / fine), 2, 0.01);
}

TEST_CASE("an end that absorbs lets little return", "[property][damped]") {
  const Chain chain{120, {}, CompressedHertz{0.5}};
  const TimeGrid grid = time_grid(2000, 1, 0.1);
  Losses growing;
  growing.of_site.assign(120, 0);
  for (std::size_t n = 60; n < 120; ++n)
    growing.of_site[n] = 0.5 * std::pow(double(n - 59) / 60, 2);
  State<double> open = struck(120, 0.05), absorbing = open;
  evolve({chain}, open, grid);
  const double budget = evolve({chain, growing}, absorbing, grid);
  CHECK(energy(chain, absorbing) < 0.1 * energy(chain, open));
  CHECK(budget < 1e-5);
  growing.of_site.pop_back();
  CHECK_THROWS_AS(evolve({chain, growing}, open, grid), std::invalid_argument);
}

TEST_CASE("equal rates of single sites are one rate", "[unit][damped]") {
  const Chain chain{30, Quartic{1}};
  State<double> a = struck(30, 1.9), b = a;
  const TimeGrid grid = time_grid(40, 1, 0.1);
  evolve({chain, {0.01, 0}}, a, grid);
  evolve({chain, {0, 0, std::vector<double>(30, 0.01)}}, b, grid);
  CHECK(a.y == b.y);
  CHECK(a.v == b.v);
  CHECK(energy(chain, a) < 0.75 * energy(chain, struck(30, 1.9)));
}

TEST_CASE("a DpS field with friction is one without at the slow clock", "[property][arrivals]") {
  const double nu = 0.1, t = 40;
  check_close(slow_clock(nu, t), 4 / nu * (1 - std::exp(-nu * t / 4)), 1e-13);
  check_close(true_time(nu, slow_clock(nu, t)), t, 1e-11);
  for (double none : {0.0, -1.0}) CHECK((slow_clock(none, t) == t && true_time(none, t) == t));
  CHECK(std::isinf(true_time(0.5, 8)));
  CHECK(std::isfinite(true_time(0.5, 7.999)));
  const Dps dps{16};
  const auto after = [&](double rate, double time) {
    Field field(16);
    field[0] = 1;
    const auto damped = [&](double tau, const double* a, double* da) {
      dps(tau, a, da);
      for (std::size_t k = 0; k < 32; ++k) da[k] -= rate / 2 * a[k];
    };
    evolve_dps(damped, field, time, 1, {1e-12}, [](double, const Field&) {});
    return field;
  };
  const Field lossy = after(nu, t);
  const auto apart = [&](double s) {
    const Field free = after(0, s);
    double most = 0;
    for (std::size_t n = 0; n < 16; ++n)
      most = std::max(most, std::abs(lossy[n] * std::exp(nu * t / 2) - free[n]));
    return most;
  };
  CHECK(apart(slow_clock(nu, t)) < 1e-8);
  CHECK(apart(1.001 * slow_clock(nu, t)) > 1e-4);
}

TEST_CASE("a centre between two looks is on a straight line", "[unit][arrivals]") {
  Arrivals j;
  j.centres = {{1, 4}, {2, 5}, {4, 9}};
  check_close(centre_after(j, 2.5), 6, 1e-14);
  for (double outside : {0.9, 4.1}) CHECK_THROWS_AS(centre_after(j, outside), std::out_of_range);
}

TEST_CASE("the shift of a decaying breather grows and swings back", "[property][decay]") {
  std::vector<BranchMember> members;
  for (int k = 22; k <= 32; ++k)
    members.push_back(member_at(Centre::site, 1 + 0.01 * std::pow(10, k / 32.0)));
  // The unstable stretches of the whole branch together have the factor e with this rate
  const double nu = 9.7e-5, duration = std::log(100) / nu;
  const auto problem = breather_problem<double>(Centre::site, members.back().omega, 0.0, 21);
  const State<double> start = find_breather(problem).start;
  State<double> shifted = start;
  for (std::size_t n = 1; n + 1 < start.y.size(); ++n)
    shifted.y[n] -= 0.005 * (start.y[n + 1] - start.y[n - 1]);
  const auto base = centres(problem.chain, start, nu, duration),
             moved = centres(problem.chain, shifted, nu, duration);
  double most = 0, last = 0;
  for (std::size_t i = 0; i < base.size(); ++i) {
    last = (moved[i] - base[i]) / (moved[0] - base[0]);
    most = std::max(most, last);
  }
  CAPTURE(most, last);
  const double limit = 1.55770760446738e-3;  // Lambda of the DpS breather
  check_close(largest_shift(members, limit, nu) - 1, most - 1, 0, 0.15);
  CHECK(last < 0.97);
}

namespace {

constexpr double turn = 2 * std::numbers::pi;

using Numbers = std::vector<double>;

/// A line through two points, or its continuation.
double on_line(double x, double x0, double y0, double x1, double y1) {
  return (y0 * (x1 - x) + y1 * (x - x0)) / (x1 - x0);
}

/// The square of the growth rate at ln area = a: between members, or between the limit and the first of them.
double square_by_hand(const std::vector<BranchMember>& members, double limit, double a) {
  Numbers area, excess, scaled;
  for (const BranchMember& m : members) {
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
double shift_by_hand(const std::vector<BranchMember>& members, double limit, double nu) {
  using Pair = std::array<double, 2>;
  const double h = std::log(100) / 1000 / nu, start = std::log(members.back().area);
  const auto f = [&](double t, const Pair& x) {
    return Pair{x[1], square_by_hand(members, limit, start - nu * t) * x[0] - nu / 4 * x[1]};
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
std::vector<BranchMember> branch(const Numbers& kappa) {
  std::vector<BranchMember> out;
  for (std::size_t i = 0; i < kappa.size(); ++i) {
    const double omega = 1.03 + 0.02 * double(i * i), area = std::pow(4.0, double(i)) + 0.3;
    const double sigma = std::acosh(1 + 2 * std::max(0.0, kappa[i])) * omega / turn;
    out.push_back({omega, area, kappa[i], sigma});
  }
  return out;
}

}  // namespace

TEST_CASE("a decaying breather stays on its branch", "[property][decay]") {
  const double nu = CantileverArray{}.scales().rate(10), h = 0.1;
  for (Centre centre : both_centres) {
    const auto problem = [&](double omega) {
      return breather_problem<double>(centre, omega, 0.0, centre == Centre::bond ? 22 : 21);
    };
    const Chain chain = problem(1.1).chain;
    const Orbit<double> start = find_breather(problem(1.1));
    const auto smaller = [](double a, double b) { return std::abs(a) < std::abs(b); };
    const auto& y0 = start.start.y;
    const auto most = std::size_t(std::max_element(y0.begin(), y0.end(), smaller) - y0.begin());
    State<double> state = start.start;
    std::vector<double> t, y, e;
    evolve({chain, {nu, 0}}, state, time_grid(2 / nu, h, h),
           [&](const State<double>& now, const EnergyBudget&) {
             t.push_back(now.t), y.push_back(now.y[most]), e.push_back(energy(chain, now));
             return true;
           });
    // Frequency and energy are means over eight periods, early and late
    const auto up = upward_crossings(t, y);
    for (std::size_t k : {std::size_t(1), up.size() / 2, up.size() - 9}) {
      const auto at = [&](double when) {
        return std::lower_bound(t.begin(), t.end(), when) - t.begin();
      };
      const auto from = e.begin() + at(up[k]), to = e.begin() + at(up[k + 8]);
      const double omega = turn * 8 / (up[k + 8] - up[k]), middle = (up[k] + up[k + 8]) / 2;
      const Orbit<double> same = find_breather(problem(omega));
      CAPTURE(omega, middle);
      check_close(std::accumulate(from, to, 0.0) / double(to - from), same.energy, 0, 5e-3);
      check_close(same.action_integral, start.action_integral * std::exp(-nu * middle), 0, 5e-3);
    }
    CHECK(energy(chain, state) < 0.2 * start.energy);
  }
}

TEST_CASE("one centre of a pair of breathers grows, by the rate of its multiplier",
          "[unit][decay]") {
  // cosh(sigma T) = 1 + 2 kappa
  const double omega = 1.05;
  const BranchMember up = member_at(Centre::site, omega), down = member_at(Centre::bond, omega);
  CAPTURE(up.kappa, down.kappa);
  CHECK(up.kappa * down.kappa < 0);
  const BranchMember& loud = up.kappa > 0 ? up : down;
  check_close(loud.growth, std::acosh(1 + 2 * loud.kappa) * omega / turn, 0, 1e-6);
  check_close(loud.multiplier(), std::exp(loud.growth * turn / omega), 0, 1e-12);
  CHECK((up.kappa > 0 ? down : up).growth == 0);
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
        check_close(value, shift_by_hand(branch(kappa), limit, nu), 0, 1e-9);
      }
  // The lifetime is that which gives the factor; nothing grows on a stable branch
  const auto members = branch({0.02, 0.05, 0.01}), stable = branch({-0.02, -0.05, -0.01});
  check_close(lifetime_of_growth(members, 0.7, largest_shift(members, 0.7, 0.03)), 1 / 0.03, 0,
              1e-6);
  CHECK(largest_shift(stable, 0, 0.03) == 1);
  CHECK_THROWS_AS(lifetime_of_growth(stable, 0, 2), std::invalid_argument);
}

TEST_CASE("the way of a packet between contacts", "[unit][arrivals]") {
  // Contact 3 is not reached; the first contact does not count
  const Numbers at{9, 2, 3, 2.5, 5, 5.5, 8, 9, 9.5, 12},
      period{1, 0.5, 3, 7, 2, 0.25, 4, 5, 6, 0.8};
  Arrivals j;
  for (std::size_t n = 0; n < at.size(); ++n) j.contacts.push_back({at[n], period[n], n != 3});
  std::vector<std::size_t> order{1, 2, 4, 5, 6, 7, 8, 9};
  for (double t : {0.0, 1.0, 2.0, 2.2, 3.0, 4.4, 5.0, 5.2, 7.0, 8.0, 8.9, 9.5, 10.0, 12.0, 13.0}) {
    double from = 0, site = 0, sites = 0, turns = 0, last = 0;
    Numbers times{0}, places{0};
    for (std::size_t n : order) {
      if (t <= from) break;
      const double share = std::min(1.0, (t - from) / (at[n] - from));
      sites += share * (double(n) - site), turns += share * (at[n] - from) / period[n];
      from = at[n], site = double(n), last = period[n], times.push_back(from),
      places.push_back(site);
    }
    const std::size_t k = times.size(), back = k > 6 ? k - 6 : 0;
    const bool stopped = t > 12;
    if (stopped) turns += (t - 12) / 0.8;
    const Travelled p = travelled_after(j, t);
    CAPTURE(t);
    check_close(p.sites, sites, 1e-12);
    check_close(p.oscillations, turns, 1e-12);
    check_close(p.period, last, 0);
    check_close(p.speed, stopped || k == 1 ? 0 : (site - places[back]) / (from - times[back]),
                1e-12);
  }
  const Travelled nowhere = travelled_after(Arrivals{{{1, 1, true}}, {}, 0}, 5);
  CHECK(nowhere.sites + nowhere.oscillations + nowhere.speed + nowhere.period == 0);
}

TEST_CASE("the slow clock weighs a push by a cube", "[unit][arrivals]") {
  // Weighted, the pushes are symmetric about the second one
  const double nu = 0.3;
  const auto weight = [&](double s) { return 1 - nu * s / 4; };
  Arrivals j;
  j.contacts.resize(1);
  for (const auto& [s, height] : {std::pair{1.0, 0.5}, {2.0, 0.9}, {3.0, 0.5}})
    j.contacts[0].pushes.push_back({s, height / std::pow(weight(s), 3)});
  const Arrival p = slowed(j, nu).contacts.at(0);
  check_close(p.t, -4 / nu * std::log(weight(2)), 1e-12);
  check_close(p.period, turn / (1 + (turn - 1) * weight(2)), 1e-12);
  // Which push is the strongest is decided by the weight, too
  j.contacts[0].pushes = {{0.5, 0.1}, {1, 1}, {2, 1.23}, {3, 0.1}};
  CHECK(slowed(j, nu).contacts.at(0).period < 1);
}
