// Statements in words: each criterion holds for what the words describe and fails for what they do not.

#include "sec34/criteria.hpp"
#include "sec34/acceleration.hpp"

#include <complex>

#include "check.hpp"
#include "estimates.hpp"
#include "lattice/impact/impact.hpp"
#include "sec3/branches.hpp"
#include "sec33/dps_motion.hpp"
#include "sec33/exchange.hpp"
#include "sec36/scattering.hpp"
#include "sec4/instability.hpp"

using namespace lattice;

namespace {

/// A track whose packet starts at site 10 with the given speed, deceleration and loss of energy.
Track journey(double speed, double deceleration, double loss) {
  Track track;
  for (double t = 0; t < 300; t += 0.5) {
    track.t.push_back(t);
    track.centre.push_back(10 + speed * t - deceleration * t * t / 2 + 0.05 * std::sin(t));
    track.energy.push_back(1 - loss * t);
    track.peak.push_back(0.5);
  }
  return track;
}

bool lasts(const Track& track, double behind = 0.3) {
  const double change = energy_change(track);
  return holds(travelling_breather({speed_change(track), compare(change, change), {behind, 0.01}}));
}

/// The front of a linear wave: 2i A' = A_(n+1) - 2 A_n + A_(n-1), struck at its free end.
Track linear_front() {
  Field a = dps_impact(140);
  const auto rate = [](const Field& x) {
    Field f(x.size());
    for (std::size_t n = 0; n < x.size(); ++n) {
      const auto right = n + 1 < x.size() ? x[n + 1] - x[n] : 0;
      const auto left = n > 0 ? x[n] - x[n - 1] : 0;
      f[n] = std::complex<double>(0, -0.5) * (right - left);
    }
    return f;
  };
  const auto moved = [](const Field& x, double h, const Field& f) {
    Field y = x;
    for (std::size_t n = 0; n < x.size(); ++n) y[n] += h * f[n];
    return y;
  };
  Track track;
  const double h = 0.05;
  for (int k = 1; k <= 2000; ++k) {
    const Field f1 = rate(a), f2 = rate(moved(a, h / 2, f1)), f3 = rate(moved(a, h / 2, f2)),
                f4 = rate(moved(a, h, f3));
    for (std::size_t n = 0; n < a.size(); ++n)
      a[n] += h / 6 * (f1[n] + 2.0 * f2[n] + 2.0 * f3[n] + f4[n]);
    const auto d = density(a);
    if (const auto site = front_packet(d, 0.05)) track.add(h * k, d, *site);
  }
  return track;
}

/// A front whose amplitude is that of a compact packet of `width` sites, with a tail ahead.
Front compact(double width) {
  std::vector<double> e(40, 0.0);
  for (int k = -10; k <= 10; ++k) {
    const double x = 2 * k / (width + 1);
    const double a = std::abs(x) < 1 ? std::pow(std::cos(M_PI * x / 2), 2) : 0;
    e[std::size_t(20 + k)] = a * a + 1e-7;
  }
  Front front;
  front.add(e, 20);
  return front;
}

/// Breathers of three sites, of which the first `moving` pass a site, as both tolerances say.
std::vector<Trial> breathers(std::size_t count, std::size_t moving, double time = 4) {
  std::vector<Trial> list(count);
  for (std::size_t k = 0; k < count; ++k) {
    list[k].good.sites = list[k].good.most_sites = 3;
    list[k].good.t = {0, time};
    list[k].good.X = {0, k < moving ? 1.4 : 0.4};
    list[k].rough = list[k].good;
  }
  return list;
}

/// A spectrum on `sites` sites: the pair of `second` beside the pinning pair, all others at the edge.
Spectrum spectrum_with(std::size_t sites, std::complex<double> second) {
  const double edge = -std::pow(std::sin(M_PI / 1.1), 2);
  Spectrum all{{{1e-8, 1e-12}, {second, 1e-12}}, {}};
  while (all.pairs.size() + 1 < sites) all.pairs.push_back({edge, 1e-12});
  return all;
}

/// The worst that is wrong with the four multipliers near one of such a chain.
std::string wrong_with(std::complex<double> second, std::size_t longer = 41) {
  return failing(four_near_one(quadruplet(spectrum_with(31, second), 1.1),
                               quadruplet(spectrum_with(longer, second), 1.1)));
}

}  // namespace

TEST_CASE("a condition counts its error bar", "[unit][criteria]") {
  CHECK(above("x", {1.2, 0.1}, 1).holds());
  CHECK_FALSE(above("x", {1.05, 0.1}, 1).holds());
  CHECK(below("x", {0.8, 0.1}, 1).holds());
  CHECK_FALSE(below("x", {1.2, 0.1}, 1).holds());
  CHECK_FALSE(below("x", {std::nan(""), 0.1}, 1).holds());
  CHECK_FALSE(above("x", {2, std::nan("")}, 1).holds());
  CHECK_FALSE(holds(Criterion{}));
  CHECK_FALSE(holds({above("x", exact(2), 1), below("y", exact(2), 1)}));
  check_close(below("x", {0.8, 0.1}, 1).margin().value, 0.2, 1e-15);
}

TEST_CASE("the larger and the smaller of two count their error bars", "[unit][criteria]") {
  const Estimate wide{1.0, 0.3}, sharp{1.1, 0.05}, narrow{1.0, 0.05}, blurred{1.1, 0.3};
  CHECK(larger(wide, sharp).value == 1.0);
  CHECK(larger(sharp, narrow).value == 1.1);
  CHECK(smaller(narrow, blurred).value == 1.1);
  CHECK(smaller(narrow, sharp).value == 1.0);
}

TEST_CASE("a travelling breather lasts", "[unit][criteria]") {
  CHECK(lasts(journey(0.3, 0, 0)));
  CHECK(lasts(journey(0.3, 2e-5, 1e-4)));
  CHECK_FALSE(lasts(journey(0.3, 5e-4, 0)));      // slows down
  CHECK_FALSE(lasts(journey(0.3, 0, 2e-3)));      // loses its energy
  CHECK_FALSE(lasts(journey(0.3, 0, 0), 1.2));    // weaker than what it leaves behind
  CHECK_FALSE(lasts(journey(0.3, 0, 0), 0.995));  // or not surely stronger
}

TEST_CASE("the front of a linear wave is no travelling breather", "[property][criteria]") {
  const Track front = linear_front();
  CHECK(front.centre.back() > 80);
  CAPTURE(speed_change(front).value, energy_change(front));
  CHECK(std::abs(speed_change(front).value) < 0.05);
  CHECK(energy_change(front) < -0.1);
  CHECK_FALSE(lasts(front));
}

TEST_CASE("a packet's width is not any number", "[unit][criteria]") {
  for (std::size_t width : {3, 5, 7, 9}) {
    CAPTURE(width);
    const Front front = compact(double(width));
    for (std::size_t sites : {3, 5, 7, 9})
      CHECK(holds(supported_by(sites, front, front)) == (sites == width));
    CHECK(front.width() == width);
    check_close(front.tail(), std::sqrt(1e-7), 0, 1e-6);
  }
}

TEST_CASE("similar curves do not meet", "[unit][criteria]") {
  CHECK(holds(meet({{1e-4, 1e-5}, {1e-2, 1e-5}})));
  CHECK_FALSE(holds(meet({{0.02, 1e-5}, {0.2, 1e-5}})));   // too far apart
  CHECK_FALSE(holds(meet({{5e-3, 1e-5}, {5e-3, 1e-5}})));  // parallel
  CHECK_FALSE(holds(meet({{1e-4, 9e-3}, {1e-2, 9e-3}})));  // not known well enough
  CHECK_FALSE(holds(meet({{4e-3, 0}, {1e-2, 5e-3}})));     // nor is the far distance
}

TEST_CASE("energy is trapped where more stays than leaves", "[unit][criteria]") {
  CHECK(holds(trapped({0.8, 1e-3}, {0.07, 1e-3})));
  CHECK_FALSE(holds(trapped({0.1, 1e-3}, {0.44, 1e-3})));
  CHECK_FALSE(holds(trapped({0.3, 0.01}, {0.3, 0.01})));
}

TEST_CASE("only what rises above the waves between is visible", "[property][criteria]") {
  std::vector<double> v(100, 0.0);
  v[1] = 1, v[50] = 0.2, v[80] = -0.3;
  check_close(prominence(v, 80), 1.5, 1e-14);
  v[50] = -0.4;
  CHECK(prominence(v, 80) < 1);
  v[50] = 0.2, v[1] = 0.1;
  CHECK(prominence(v, 80) < 1);
  // The same impact on linear wells leaves no surface mode, on soft ones it does.
  const auto shot = [](double s) {
    const ImpactRun out =
        strike(ContactAware{0.1}, endless({1.87, {.well = Quartic{s}}, 400, 400}));
    return prominence(out.end.v, *front_packet(out.density));
  };
  CHECK(shot(-1.0 / 6) > 1);
  CHECK(shot(0) < 1);
}

TEST_CASE("a transition needs both sides, in order, and few doubts", "[unit][criteria]") {
  CHECK(holds(transition({100, 80, 4.6, 4.7, 0.01})));
  CHECK_FALSE(holds(transition({0, 80, std::nan(""), 4.7, 0.01})));
  CHECK_FALSE(holds(transition({100, 0, 4.6, std::nan(""), 0.01})));
  CHECK_FALSE(holds(transition({100, 80, 4.8, 4.7, 0.01})));
  CHECK_FALSE(holds(transition({100, 80, 4.6, 4.7, 0.2})));
}

TEST_CASE("a struck soft well blows up, a pendulum does not", "[property][criteria]") {
  const auto bounded = [](const Well& well, double velocity, double time) {
    const Impact impact{velocity, {20, well}, time, 0.2, may_move, false};
    return no_blowup(confinement(impact, stepper_for(1e-4, 0.1), stepper_for(1e-4, 0.1, 1)));
  };
  CHECK(holds(bounded(Pendulum{}, 6, 200)));  // beads leave at both ends
  const Impact leaving{6, {20, Pendulum{}}, 200, 0.2, may_move, false};
  CHECK(confinement(leaving, stepper_for(1e-4, 0.1), stepper_for(1e-4, 0.1, 1)).furthest.value >
        100);
  CHECK(holds(bounded(Quartic{-1.0 / 6}, 1.5, 200)));
  CHECK_FALSE(holds(bounded(Quartic{-1.0 / 6}, 2.5, 200)));
  Confinement cut{{1, 0}, {0.5, 0}, {1e-9, 0}, 0.9, {1, 0}};
  CHECK(failing(no_blowup(cut)) == "lasted");
  cut.lasted = 1, cut.speed = {1.1, 0};
  CHECK(failing(no_blowup(cut)) == "speed");
}

TEST_CASE("a stable sign must be safe, and growth linear", "[unit][criteria]") {
  CHECK(surely_stable("x", {{-5e-6, 1e-9}, {}}).holds());
  CHECK_FALSE(surely_stable("x", {{-5e-6, 1e-7}, {}}).holds());  // a sign within a hundred errors
  const Margin site = margin_of<long double>(Centre::site, 1, 25),
               bond = margin_of<long double>(Centre::bond, 1, 24);
  CHECK(surely_stable("x", bond).holds());
  CHECK_FALSE(surely_stable("x", site).holds());
  CHECK(holds(linear_growth(site.safe(), {1e-12, 1e-12})));
  CHECK(failing(linear_growth(bond.safe(), {1e-12, 1e-12})) == "weakest");
  const Estimate root = relative_distance({std::sqrt(1.0001), 0}, 1);  // lambda ~ sqrt(mu)
  CHECK(failing(linear_growth(site.safe(), root)) == "variation");
}

TEST_CASE("an instability moves many, and not what it does not reach", "[unit][criteria]") {
  const auto moves = [](const auto& trials, const auto& controls) {
    return failing(moved_by_instability(trials, controls));
  };
  CHECK(moves(breathers(16, 16, 1), breathers(16, 0)).empty());
  CHECK(moves(breathers(16, 9, 1), breathers(16, 0)).empty());
  CHECK(moves(breathers(16, 7, 1), breathers(16, 0, 9)) == "trials");
  CHECK(moves(breathers(16, 16, 1), breathers(16, 16, 4)).empty());           // all, but later
  CHECK(moves(breathers(16, 16, 1), breathers(16, 16, 1)) == "later delay");  // not later
  CHECK(moves(breathers(16, 16, 1), breathers(16, 16, 1.5)) == "delay");
  auto some = breathers(16, 16, 4);
  for (std::size_t k = 0; k < 5; ++k) some[k].good.t[1] = some[k].rough.t[1] = 1;
  CHECK(moves(breathers(16, 16, 1), some) == "later");
  auto torn = breathers(16, 16, 1);
  torn[3].rough.X = {0, 0.9};
  CHECK(moves(torn, breathers(16, 0)) == "torn");
}

TEST_CASE("a robust breather stays where others leave, and whole", "[unit][criteria]") {
  const auto wrong = [](std::vector<Trial> stable, std::vector<Trial> unstable) {
    const Estimate spread = largest_spread(stable);
    return failing(structurally_robust(stable, unstable, spread));
  };
  CHECK(wrong(breathers(16, 1), breathers(16, 15)).empty());
  CHECK(wrong(breathers(16, 2), breathers(16, 16)) == "left");
  CHECK(wrong(breathers(16, 0), breathers(16, 14)) == "beside");       // noise too weak to tell
  CHECK(wrong(breathers(16, 16), breathers(16, 0)) == "left beside");  // the wrong one is stable
  auto wide = breathers(16, 0);
  wide[2].good.most_sites = 7;
  CHECK(wrong(wide, breathers(16, 16)) == "spread");
}

TEST_CASE("four multipliers near one, no more and no fewer", "[unit][criteria]") {
  CHECK(wrong_with(-0.013).empty());
  CHECK(wrong_with(-1e-4) == "fifth");
  CHECK(wrong_with(0.013) == "others_stable");
  CHECK(wrong_with({-0.5, 0.1}) == "others_stable");
  CHECK(wrong_with(-0.013, 40) == "not_at_edge");
  CHECK(wrong_with(-1.013) == "others_stable");  // beyond -1
  CHECK(holds(small_instability({6e-4, 1e-6})));
  CHECK_FALSE(holds(small_instability({2e-3, 1e-6})));
  CHECK(holds(bond_alone_stable({1e-8, 1e-15}, {-1e-8, 1e-15}, true)));
  CHECK(failing(bond_alone_stable({1e-8, 1e-15}, {1e-8, 1e-15}, true)) == "bond");
  CHECK(failing(bond_alone_stable({1e-8, 1e-7}, {-1e-8, 1e-7}, true)) == "site bond");
  CHECK(failing(bond_alone_stable({1e-8, 1e-15}, {-1e-8, 1e-15}, false)) == "others_stable");
}

TEST_CASE("stability depends on a well that exchanges it", "[unit][criteria]") {
  const std::array<Estimate, 2> same{{{1e-8, 1e-12}, {-1e-8, 1e-12}}},
      reversed{{{-1e-8, 1e-12}, {1e-8, 1e-12}}};
  CHECK(holds(depends_on_well(same, reversed, same, true)));
  CHECK_FALSE(holds(depends_on_well(same, same, same, true)));          // no exchange at all
  CHECK_FALSE(holds(depends_on_well(same, reversed, reversed, true)));  // the sign does not matter
  CHECK_FALSE(holds(depends_on_well(reversed, reversed, same, true)));  // nor the strength
  CHECK_FALSE(holds(depends_on_well(same, reversed, same, false)));     // another pair is off
}

TEST_CASE("the worst of many spectra decides", "[unit][criteria]") {
  const auto wrong = [](double fourth, double share, double others, int missing) {
    return failing(
        four_near_one_everywhere({fourth, 1e-9}, {share, 1e-9}, {others, 1e-9}, missing));
  };
  CHECK(wrong(2e-4, 1e-3, 1e-8, 0).empty());
  CHECK(wrong(0.02, 1e-3, 1e-8, 0) == "fourth");
  CHECK(wrong(5e-3, 0.2, 1e-8, 0) == "share_of_fifth");
  CHECK(wrong(2e-4, 1e-3, 0.1, 0) == "others");
  CHECK(wrong(2e-4, 1e-3, 1e-8, 2) == "not_at_edge");
  // The larger multiplier counts, beyond +1 as beyond -1 and off the axis
  const std::vector<Pair> pairs{{0.25, 1e-12}, {-1.25, 1e-12}, {{-0.5, 0.1}, 1e-12}, {-0.5, 1e-12}};
  check_close(excess(pairs).value, 0.5 + std::sqrt(1.25), 1e-14);
  check_close(excess({pairs[0]}).value, 0.5 + std::sqrt(1.25), 1e-14);
  check_close(excess(pairs, 1).value, 0.5 + std::sqrt(1.25), 1e-14);
  CHECK(excess(pairs, 2).value > 0.1);
  CHECK(excess(pairs, 3).value < 1e-15);
  check_close(from_one(pairs[0]).value, 0.5 + std::sqrt(1.25), 1e-14);
}

TEST_CASE("breathers are symmetric, steep, and worse approximated when large", "[unit][criteria]") {
  CHECK(holds(symmetric_by_nature(5e-11, 2e-14)));
  CHECK(failing(symmetric_by_nature(1e-3, 1e-3)) == "broken share_of_double");
  CHECK(failing(symmetric_by_nature(5e-11, 4e-11)) == "share_of_double");
  // The exponents of the tails |y_n| = exp(-2^n), exp(-1.5^n) and exp(-n) at n = 20.
  CHECK(holds(super_exponential(1.5, 1.5)));
  CHECK_FALSE(holds(super_exponential(2, 2)));
  CHECK_FALSE(holds(super_exponential(20.0 / 19, 21.0 / 20)));
  CHECK(holds(worse_when_large({0.05, 1e-12}, {0.12, 1e-12})));
  CHECK_FALSE(holds(worse_when_large({0.12, 1e-12}, {0.05, 1e-12})));
  CHECK_FALSE(holds(worse_when_large({0.05, 0.04}, {0.12, 0.04})));
}

TEST_CASE("what increases does so at every step, beyond its errors", "[unit][criteria]") {
  CHECK(holds(increasing({{1, 1e-3}, {2, 1e-3}, {2.1, 1e-3}})));
  CHECK_FALSE(holds(increasing({{1, 1e-3}, {3, 1e-3}, {2, 1e-3}, {4, 1e-3}})));
  CHECK_FALSE(holds(increasing({{1, 0.05}, {1.01, 0.05}})));
  CHECK_FALSE(holds(increasing({{1, 0}, {std::nan(""), 0}, {3, 0}})));
  CHECK_FALSE(holds(increasing({{1, 0}})));
  // A barrier that vanishes between two of its values, although its modulus grows from each to the next.
  CHECK(holds(increasing({{-1, 1e-3}, {-3, 1e-3}, {-9, 1e-3}})));
  CHECK_FALSE(holds(increasing({{-1, 1e-3}, {3, 1e-3}, {9, 1e-3}})));
}

TEST_CASE("a curve increases as a whole if its arches do", "[unit][criteria]") {
  const auto whole = [](std::vector<double> values) {
    std::vector<Estimate> curve;
    for (double v : values) curve.push_back({v, 1e-3});
    return failing(increasing_on_the_whole(curve));
  };
  CHECK(whole({1, 2, -3, -5, -2, 4, 8, 6, -9, -20}).empty());
  CHECK(whole({1, 2, 3}).empty());
  CHECK(whole({1, 3, 2}) == "least_ratio");  // one arch, not growing
  CHECK(whole({20, 9, -6, -8, 4}) == "arches_least_ratio end_over_highest_before");  // reversed
  CHECK(whole({1, 2, -5, -4, 3, 6, -4, -7, 5}) == "arches_least_ratio end_over_highest_before");
  CHECK(whole({1, 2, -3, -9, -4}) == "end_over_highest_before");  // falls at the end
  CHECK(whole({1, -1.0005, 3, 4}) == "arches_least_ratio");       // within the errors
}

TEST_CASE("one curve is smaller than another as a whole by its mean", "[unit][criteria]") {
  const std::vector<Estimate> dips{{1, 0}, {2, 0}, {1e-6, 0}, {3, 0}, {4, 0}, {2, 0}},
      flat{{0.5, 0}, {0.4, 0}, {-0.5, 0}, {0.6, 0}, {0.5, 0}, {0.4, 0}};
  CHECK(smaller_on_the_whole("x", flat, dips)
            .holds());  // although the other one is smaller at a zero
  CHECK_FALSE(smaller_on_the_whole("x", dips, flat).holds());
  CHECK_FALSE(smaller_on_the_whole("x", flat, flat).holds());
  CHECK_FALSE(smaller_on_the_whole("x", {{1, 1}, {1, 1}}, {{1.5, 0}, {1.5, 0}}).holds());
}

TEST_CASE("a family begins at rest only with the square of the detuning", "[unit][criteria]") {
  const auto at = [](double omega, double power, double rest) {
    Orbit<double> orbit;
    orbit.omega = omega;
    orbit.amplitude = rest + std::pow(omega - 1, power);
    return orbit;
  };
  const auto begins = [&](double power, double rest) {
    const auto exponent = [&](double omega) {
      return growth_exponent(at(omega, power, rest), at(1 + 2 * (omega - 1), power, rest));
    };
    return begins_at_rest(compare(exponent(1.001), exponent(1.0005))).holds();
  };
  CHECK(begins(2, 0));
  CHECK_FALSE(begins(0.5, 0));
  CHECK_FALSE(begins(2, 1e-3));
}

TEST_CASE("a packet is reversed, slowed or erratic only by evidence", "[unit][criteria]") {
  const Estimate pulled{-6e-4, 1e-5}, never{std::nan(""), std::nan("")};
  CHECK(holds(reversed_packet({400, 1}, pulled, pulled, {900, 2})));
  CHECK(failing(reversed_packet(never, pulled, pulled, {900, 2})) == "apex_time");
  CHECK(failing(reversed_packet({400, 1}, {6e-4, 1e-5}, pulled, {900, 2})) == "force_out");
  CHECK(failing(reversed_packet({400, 1}, pulled, {-1e-5, 2e-5}, {900, 2})) == "force_back");
  CHECK(failing(reversed_packet({400, 1}, pulled, pulled, never)) == "return_time_error");
  CHECK(holds(slowed_packet(true, {-1e-4, 1e-5}, pulled)));
  CHECK(failing(slowed_packet(false, {-1e-4, 1e-5}, pulled)) == "slows");
  CHECK(failing(slowed_packet(true, {-5e-4, 1e-5}, pulled)) == "force_over_190");
  CHECK(failing(slowed_packet(true, {-1e-4, 1e-5}, {-6e-4, 2e-3})) == "force_over_190");
  CHECK(holds(erratic_packets({0.1, 0.01}, {6, 0.5})));
  CHECK(failing(erratic_packets({6, 0.5}, {6, 0.5})) == "spread_until_return");
  CHECK(failing(erratic_packets({0.1, 0.01}, {0.2, 0.01})) == "spread_late");
}

TEST_CASE("a reflection is total, partial or neither", "[unit][criteria]") {
  CHECK(holds(almost_total({0.99, 1e-3})));
  CHECK_FALSE(holds(almost_total({0.9, 1e-3})));
  CHECK_FALSE(holds(almost_total({1.01, 1e-3})));  // more than what arrives
  const std::vector<Estimate> every{{0.96, 1e-3}, {0.99, 1e-3}};
  CHECK(holds(almost_total(every)));
  CHECK(failing(almost_total({{0.96, 1e-3}, {0.94, 1e-3}, {0.99, 1e-3}})) == "least");
  CHECK_FALSE(holds(almost_total(std::vector<Estimate>{})));
  CHECK(holds(partial({0.3, 1e-3})));
  CHECK(failing(partial({0.05, 1e-3})) == "least");
  CHECK(failing(partial({0.95, 1e-3})) == "most");
}

TEST_CASE("the instability of phonons is tested where it can fail", "[property][criteria]") {
  const double d = 0.5, v1 = contact_series(d).v1, threshold = -16 * contact_series(d).v3;
  CHECK(holds(sign_changes_at(inflection(v1), d, {-1.0 / 6, 0, 1})));
  CHECK_FALSE(holds(sign_changes_at(1.000001 * inflection(v1), d, {-1.0 / 6, 0, 1})));
  CHECK(holds(opens_at_edges(d, threshold)));
  CHECK(failing(opens_at_edges(d, threshold + 0.1)) == "formula stable_side");
  CHECK(failing(opens_at_edges(d, threshold - 0.1)) == "formula growth");
  const auto largest = [&](double s) {
    return std::array{largest_phi(d, -1.0 / 6, 400), largest_phi(d, s, 400),
                      largest_phi(d, 1, 400)};
  };
  CHECK(holds(small_in_linear_wells(largest(0), largest(0))));
  CHECK(failing(small_in_linear_wells(largest(0.3), largest(0.3))) == "ratio_s_0");
  const double beta = coefficients(1.0, d, 1.0).beta;
  const auto off = [&](double by) { return relative_distance({beta * by, 1e-6}, beta); };
  CHECK(holds(confirmed_beta(off(1.0001), off(0.9999))));
  CHECK(failing(confirmed_beta(off(1.01), off(1))) == "shift");
  CHECK(failing(confirmed_beta(off(1), off(0.99))) == "growth");
}

TEST_CASE("forces rise though two of them are alike", "[unit][criteria]") {
  CHECK(holds(rises({{-1, 0.1}, {-0.95, 0.1}, {-2, 0.1}, {-3, 0.2}})));
  CHECK_FALSE(holds(rises({{-1, 0.1}, {-3, 0.1}, {-2, 0.1}, {-4, 0.1}})));
  CHECK_FALSE(holds(rises({{-1, 0.1}, {-1.05, 0.1}, {-1.1, 0.1}})));
  CHECK_FALSE(holds(rises({{-3, 0.1}, {-2, 0.1}, {-1, 0.1}})));
}

TEST_CASE("a packet's energy changes from the mean of one half of its way to that of the other",
          "[unit][criteria]") {
  Track track;
  double first = 0, second = 0;  // of seven samples, three and four
  for (int k = 0; k < 7; ++k) {
    track.t.push_back(k), track.centre.push_back(fit_from + k), track.peak.push_back(1);
    track.energy.push_back(3 + std::cos(k));
    (k < 3 ? first : second) += track.energy.back() / (k < 3 ? 3 : 4);
  }
  check_close(energy_change(track), second / first - 1, 1e-13);
}
