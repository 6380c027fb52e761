// Journeys a second time: what a run shows of a packet, from its record; ways, centres, the slow clock and the sensor of
// journeys that are written down by hand.

#include "sec5/journey.hpp"

#include <numbers>

#include "check.hpp"
#include "lattice/impact/impact.hpp"

namespace journey_again {

using namespace lattice;

namespace {

constexpr double turn = 2 * std::numbers::pi;
using Numbers = std::vector<double>;

/// The tops of parabolas through three samples, at distances `h`; before the index `woken` there is no motion.
std::vector<Peak> tops(const Numbers& x, double h, std::size_t woken, std::size_t count) {
  std::vector<Peak> out;
  for (std::size_t i = woken + 1; i + 1 < count; ++i) {
    if (!(x[i - 1] < x[i] && x[i + 1] <= x[i])) continue;
    const double up = x[i] - x[i - 1], down = x[i] - x[i + 1];
    const double at = 0.5 * (up - down) / (up + down);
    out.push_back({h * (double(i) + at), x[i] + at * at * (up + down) / 2});
  }
  return out;
}
std::size_t highest(const std::vector<Peak>& all) {
  std::size_t top = 0;
  for (std::size_t i = 1; i < all.size(); ++i)
    if (all[i].height > all[top].height) top = i;
  return top;
}
double period_of(const std::vector<Peak>& all, std::size_t i) {
  return i == 0 || i + 1 >= all.size() ? 0 : (all[i + 1].t - all[i - 1].t) / 2;
}
/// Whether each contact is reached: it has a period, and its push is later than all before.
void mark(Journey& j) {
  double latest = 0;
  for (Passing& p : j.contacts) {
    p.reached = p.period > 0 && p.t > latest;
    latest = std::max(latest, p.t);
  }
}

/// The journey from the record of a run of full length.
Journey journey_again(const DrivenChain& d, double velocity, double duration, std::size_t last,
                      double step) {
  const TimeGrid grid = time_grid(duration, step, step);
  const std::size_t sites = d.chain.sites, contacts = std::min(last, sites - 1);
  std::vector<Numbers> push(contacts), speed(contacts);
  std::vector<std::size_t> woken(contacts, 0);
  Numbers centre, time, open;
  State<double> state = struck(sites, velocity);
  run_driven(d, state, grid, [&](const State<double>& now, const EnergyBudget&) {
    const Numbers e = energy_density(d.chain, now);
    double sum = 0, all = 0;
    for (std::size_t n = 0; n < sites; ++n) sum += double(n + 1) * e[n], all += e[n];
    time.push_back(now.t), centre.push_back(sum / all);
    open.push_back(now.y[contacts] - now.y[contacts - 1]);
    for (std::size_t n = 0; n < contacts; ++n) {
      push[n].push_back(std::pow(std::max(0.0, now.y[n] - now.y[n + 1]), 1.5));
      speed[n].push_back(std::abs(now.v[n]));
      if (now.v[n] == 0) woken[n] = time.size();
    }
    return true;
  });
  // The run ends when the last contact is open, 60 after its strongest push
  std::size_t end = 1;
  for (; end < time.size(); ++end) {
    const auto all = tops(push.back(), grid.step(), woken.back(), end);
    const std::size_t top = highest(all);
    if (period_of(all, top) > 0 && open[end - 1] > 0 && all[top].height > 1e-12 &&
        time[end - 1] > all[top].t + 60)
      break;
  }
  Journey out;
  for (std::size_t i = 0; i < end; ++i) out.centres.push_back({time[i], centre[i]});
  for (std::size_t n = 0; n < contacts; ++n) {
    Passing p;
    p.pushes = tops(push[n], grid.step(), woken[n], end),
    p.speeds = tops(speed[n], grid.step(), woken[n], end);
    if (n == 0) p.speeds.insert(p.speeds.begin(), {0, velocity});
    const std::size_t top = highest(p.pushes);
    if (!p.pushes.empty()) p.t = p.pushes[top].t, p.force = p.pushes[top].height;
    if (!p.speeds.empty()) p.velocity = p.speeds[highest(p.speeds)].height;
    p.period = period_of(p.pushes, top);
    out.contacts.push_back(p);
  }
  mark(out);
  return out;
}

void same_peaks(const std::vector<Peak>& value, const std::vector<Peak>& expected) {
  REQUIRE(value.size() == expected.size());
  for (std::size_t i = 0; i < value.size(); ++i) {
    check_close(value[i].t, expected[i].t, 1e-9);
    check_close(value[i].height, expected[i].height, 1e-11);
  }
}
void same_journey(const Journey& value, const Journey& expected) {
  REQUIRE(value.contacts.size() == expected.contacts.size());
  for (std::size_t n = 0; n < value.contacts.size(); ++n) {
    const Passing &a = value.contacts[n], &b = expected.contacts[n];
    CAPTURE(n);
    check_close(a.t, b.t, 1e-9);
    check_close(a.force, b.force, 1e-11);
    check_close(a.period, b.period, 1e-9);
    check_close(a.velocity, b.velocity, 1e-11);
    CHECK(a.reached == b.reached);
    same_peaks(a.pushes, b.pushes);
    same_peaks(a.speeds, b.speeds);
  }
  same_peaks(value.centres, expected.centres);
}

/// Seven contacts: all maxima of a push and of a speed, with what a law of the slow clock meets.
Journey by_hand() {
  Journey j;
  j.contacts.resize(7);
  j.contacts[0].pushes = {{0.1, 0.2}, {0.5, 0.9}, {0.8, 0.4}};
  j.contacts[0].speeds = {{0, 0.6}, {1.2, 0.5}};
  j.contacts[1].pushes = {{2, 0.2}, {3, 0.5}, {4.5, 0.7}, {5.5, 0.75}, {7, 0.1}};
  j.contacts[1].speeds = {{3, 0.4}, {4.2, 0.7}, {9, 40}};
  j.contacts[2].pushes = {{4, 0}, {5, 0.8}, {6.2, 0.5}};
  j.contacts[3].pushes = {{6, 0.5}, {7, 0.9}, {8, 0.4}, {8.5, 0.3}, {9, 90}};
  j.contacts[3].speeds = {{6.5, 0.3}};
  j.contacts[4].pushes = {{3, 0.5}, {3.8, 0.6}, {4.3, 0}, {7, 0.1}};
  j.contacts[5].pushes = {{1, 0.9}, {4, 0.5}, {7, 0.4}};
  j.contacts[6].pushes = {{7, 0.1}, {7.5, 0.2}, {8.1, 0.1}};
  j.centres = {{0, 1}, {3, 2}, {7.9, 4}, {8, 5}, {9, 6}};
  return j;
}

/// What the law makes of such a journey: 1 - nu s / 4 to the power of three, or of two for speeds.
Journey slowed_again(const Journey& from, double nu) {
  Journey out;
  const auto weight = [&](double s) { return 1 - nu * s / 4; };
  const auto best = [&](const std::vector<Peak>& all, double power) {
    std::size_t k = 0;
    double most = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (weight(all[i].t) > 0 && all[i].height * std::pow(weight(all[i].t), power) > most)
        most = all[i].height * std::pow(weight(all[i].t), power), k = i;
    return k;
  };
  for (const Passing& p : from.contacts) {
    Passing q;
    const std::size_t i = best(p.pushes, 3), k = best(p.speeds, 2);
    if (period_of(p.pushes, i) > 0) {
      double s = p.pushes[i].t;
      const Peak *a = &p.pushes[i - 1], *b = a + 1, *c = a + 2;
      if (weight(c->t) > 0 && a->height > 0 && c->height > 0) {
        // Where the derivative of Lagrange's polynomial vanishes
        double top = 0, bottom = 0;
        for (const Peak* x : {a, b, c}) {
          double others = a->t + b->t + c->t - x->t, apart = 1;
          for (const Peak* y : {a, b, c})
            if (y != x) apart *= x->t - y->t;
          const double f = std::log(x->height * std::pow(weight(x->t), 3)) / apart;
          top += f * others, bottom += 2 * f;
        }
        s = top / bottom;
      }
      q.t = -4 / nu * std::log(weight(s)), q.force = b->height * std::pow(weight(s), 3);
      q.period = turn / (1 + (turn / period_of(p.pushes, i) - 1) * weight(s));
    }
    if (!p.speeds.empty() && weight(p.speeds[k].t) > 0)
      q.velocity = p.speeds[k].height * std::pow(weight(p.speeds[k].t), 2);
    out.contacts.push_back(q);
  }
  mark(out);
  for (const Peak& c : from.centres)
    if (weight(c.t) > 0) out.centres.push_back({-4 / nu * std::log(weight(c.t)), c.height});
  return out;
}

}  // namespace

TEST_CASE("a journey is what the record of the run shows", "[unit][journey]") {
  struct Case {
    Chain chain;
    double nu, velocity, duration, step;
    std::size_t last;
  };
  int back = 0, fast = 0;
  for (const Case& c : {Case{Chain{9}, 0.01, 0.5, 110, 0.3, 3},
                        {Chain{5}, 0.05, 1, 100, 1.3, 20},
                        {Chain{6}, 0.002, 0.2, 120, 1.1, 2},
                        {Chain{4}, 0, 3, 40, 0.2, 3},
                        {Chain{7}, 0, 0.7, 9, 0.5, 6},
                        {Chain{6, Quartic{1}}, 0, 2000, 1.3, 0.0035, 4},
                        {Chain{12}, 0.01, 1.2, 100, 1.2, 5},
                        {Chain{12}, 0.01, 2, 100, 1.05, 4},
                        {Chain{3}, 0.02, 0.3, 90, 1.01, 1},
                        {Chain{12}, 0.01, 0.9, 100, 1.15, 6}}) {
    CAPTURE(c.chain.sites, c.velocity);
    const DrivenChain d{c.chain, {c.nu, 0}};
    const Journey expected = journey_again(d, c.velocity, c.duration, c.last, c.step);
    same_journey(follow_packet(d, c.velocity, c.duration, c.last, c.step), expected);
    for (const Passing& p : expected.contacts)
      back += p.period > 0 && !p.reached, fast += p.reached && p.period < 1 && p.t < 1;
  }
  CHECK(back > 0);
  CHECK(fast > 0);
  // The deviation is that of the run
  const DrivenChain d{Chain{5}, {0.1, 0}};
  State<double> state = struck(5, 1);
  const double budget = run_driven(d, state, time_grid(9, 0.3, 0.3),
                                   [](const State<double>&, const auto&) { return true; });
  CHECK(follow_packet(d, 1, 9, 4, 0.3).budget == budget);
}

TEST_CASE("the slow clock and back", "[unit][journey]") {
  for (double t : {0.5, 3.0, 40.0}) {
    check_close(slow_clock(0.3, t), 4 / 0.3 * (1 - std::exp(-0.3 * t / 4)), 1e-13);
    check_close(true_time(0.3, slow_clock(0.3, t)), t, 1e-11);
    for (double nu : {0.0, -1.0}) CHECK((slow_clock(nu, t) == t && true_time(nu, t) == t));
  }
  CHECK(std::isinf(true_time(0.5, 8)));
  CHECK(std::isfinite(true_time(0.5, 7.999)));
}

TEST_CASE("the way of a packet between contacts", "[unit][journey]") {
  // Contact 3 is not reached; the first contact does not count
  const Numbers at{9, 2, 3, 2.5, 5, 5.5, 8, 9, 9.5, 12},
      period{1, 0.5, 3, 7, 2, 0.25, 4, 5, 6, 0.8};
  Journey j;
  for (std::size_t n = 0; n < at.size(); ++n)
    j.contacts.push_back({at[n], 1, period[n], 1, n != 3});
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
    const Progressed p = way_after(j, t);
    CAPTURE(t);
    check_close(p.sites, sites, 1e-12);
    check_close(p.oscillations, turns, 1e-12);
    check_close(p.period, last, 0);
    check_close(p.speed, stopped || k == 1 ? 0 : (site - places[back]) / (from - times[back]),
                1e-12);
  }
  const Progressed nowhere = way_after(Journey{{{1, 1, 1, 1, true}}, {}, 0}, 5);
  CHECK(nowhere.sites + nowhere.oscillations + nowhere.speed + nowhere.period == 0);
}

TEST_CASE("a centre between two samples, and what a sensor sees", "[unit][journey]") {
  Journey j;
  j.centres = {{1, 3}, {2, 5}, {4, 6}};
  check_close(centre_after(j, 1.25), 3.5, 1e-15);
  check_close(centre_after(j, 2), 5, 1e-15);
  check_close(centre_after(j, 3), 5.5, 1e-15);
  check_close(centre_after(j, 4), 6, 1e-15);
  for (double t : {0.5, 1.0, 4.01}) CHECK_THROWS_AS(centre_after(j, t), std::out_of_range);
  for (double v : {0.8, 0.4, 0.05, 0.5, 0.0}) j.contacts.push_back({1, 1, 1, v, true});
  check_close(seen_until(j, 0.1), 2 + std::log(0.4 / 0.1) / std::log(0.4 / 0.05), 1e-13);
  check_close(seen_until(j, 0.4), 2, 1e-15);
  check_close(seen_until(j, 0.01), 4 + std::log(0.5 / 0.01) / std::log(0.5 / 1e-300), 1e-13);
  CHECK(seen_until(j, 0.9) == 0);
  const Journey empty;
  CHECK((empty.budget == 0 && seen_until(empty, 0.9) == 0));
  const Passing p;
  CHECK((p.t == 0 && p.force == 0 && p.period == 0 && p.velocity == 0 && !p.reached));
}

TEST_CASE("the slow clock moves every maximum", "[unit][journey]") {
  // The last times are beyond 4 / nu for the largest rate, or at it
  for (double nu : {0.05, 0.2, 0.4, 0.5, 0.6}) {
    CAPTURE(nu);
    same_journey(slowed(by_hand(), nu), slowed_again(by_hand(), nu));
  }
  for (double nu : {0.0, -0.1}) same_journey(slowed(by_hand(), nu), by_hand());
}

}  // namespace journey_again
