// Where breathers exchange their stability, those held in between, and breathers of the DpS equation that move: a
// second time, from formulas in plain numbers; and the criteria at both sides of their bounds.

#include "check.hpp"
#include "estimates.hpp"
#include "lattice/gsl/random.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "sec33/dps_motion.hpp"
#include "sec33/exchange.hpp"
#include "sec33/held.hpp"

namespace exchange_again {

using namespace lattice;

namespace {

using Numbers = std::vector<double>;
const double half_turn = std::acos(-1.0), never = std::numeric_limits<double>::infinity();

Course course(const Numbers& t, const Numbers& X) {
  Course out;
  out.t = t, out.X = X, out.sites = 3, out.most_sites = 4;
  return out;
}

}  // namespace

TEST_CASE("what spectra say, and their bounds", "[unit][exchange]") {
  CHECK((Spot{}.omega_b == 1.1 && Spot{}.s == 0 && Cut{}.along_s && Cut{}.fixed == 1.1));
  CHECK((Cut{}.at(0.3).omega_b == 1.1 && Cut{}.at(0.3).s == 0.3));
  CHECK((Cut{false, 0.2}.at(1.3).omega_b == 1.3 && Cut{false, 0.2}.at(1.3).s == 0.2));
  CHECK(problem_at(Centre::site, {1.2, 0.1}).chain.sites == 21);
  CHECK(problem_at(Centre::bond, {1.2, 0.1}, 4).chain.sites == 26);
  CHECK((Exchange{}.slope == 0 && Quadruplet{}.fourth == 0 && Quadruplet{}.fifth == 0 &&
         Quadruplet{}.others_stable && Quadruplet{}.at_edge == 0));
  const double omega = 1.3, sine = std::sin(half_turn / omega), edge = -sine * sine;
  const std::vector<Pair> pairs{
      {edge, 1e-12}, {edge + 0.9e-9, 1e-12}, {edge - 1.1e-9, 1e-12}, {0.0625, 1e-3}, {edge, 1e-12}};
  CHECK(at_edge(pairs, omega) == 4);  // the first one does not count
  CHECK(at_edge(pairs, omega, 0.5e-9) == 2);
  // |lambda - 1| = 2 |kappa|^(1/2) on the circle; at 1/16 it is 1/8 + sqrt(17)/8
  const double real = 0.125 + std::sqrt(17.) / 8;
  const Quadruplet q = quadruplet({{{-0.01, 1e-12}, {0.0625, 1e-3}, {edge, 1e-12}}, {}}, omega);
  check_close(q.fourth, 0.2, 1e-13);
  check_close(q.fifth, real, 1e-13);
  CHECK((!q.others_stable && q.at_edge == 2));
  CHECK(quadruplet({{{0.0625, 1e-3}, {-0.01, 1e-12}, {edge, 1e-12}}, {}}, omega).others_stable);
  const auto spread = [](double kappa, double error) {
    return 2 * error * (1 + std::abs(1 + 2 * kappa) / std::sqrt(std::abs(kappa * (1 + kappa))));
  };
  check_estimate(from_one(pairs[3]), real, spread(0.0625, 1e-3));
  const std::vector<Pair> some{
      {0.25, 1e-6}, {-0.5, 1e-6}, {0.0625, 1e-3}, {-1.0625, 1e-4}, {-0.3, 1e-6}};
  check_estimate(excess(some), 0.5 + std::sqrt(1.25) - 0, spread(0.25, 1e-6));
  check_estimate(excess(some, 1), real, spread(0.0625, 1e-3));
  check_estimate(excess(some, 3), real, spread(-1.0625, 1e-4));
  CHECK(excess(some, 4).value < 1e-15);

  const auto four = [](double fourth, double fifth, int added) {
    return four_near_one({fourth, fifth, true, 3}, {fourth, fifth, true, 3 + added});
  };
  bounded_by(0.01, true, "fourth", [&](double x) { return four(x, 1, 20); });
  bounded_by(0.1, false, "fifth", [&](double x) { return four(0, x, 20); });
  for (int added : {19, 21}) CHECK(failing(four(0, 1, added)) == "not_at_edge");
  for (const auto& [a, b] : {std::pair(true, false), {false, true}})
    CHECK(failing(four_near_one({0, 1, a, 0}, {0, 1, b, 20})) == "others_stable");
  const auto many = [](double a, double b, double c, int d) {
    return four_near_one_everywhere({a, 0}, {b, 0}, {c, 0}, d);
  };
  bounded_by(0.01, true, "fourth", [&](double x) { return many(x, 0, 0, 0); });
  bounded_by(0.1, true, "share_of_fifth", [&](double x) { return many(0, x, 0, 0); });
  bounded_by(1e-3, true, "others", [&](double x) { return many(0, 0, x, 0); });
  CHECK(failing(many(0, 0, 0, 1)) == "not_at_edge");
  bounded_by(1e-3, true, "largest", [](double x) { return small_instability({x, 0}); });
  const auto alone = [](double site, double bond) {
    return failing(bond_alone_stable({site, 1e-3}, {bond, 1e-3}, true));
  };
  CHECK(
      (alone(2e-3, -2e-3).empty() && alone(5e-4, -2e-3) == "site" && alone(2e-3, -5e-4) == "bond"));
  const std::array<Estimate, 2> usual{{{1, 0}, {-1, 0}}}, reversed{{{-1, 0}, {1, 0}}};
  CHECK(failing(depends_on_well(usual, reversed, usual, true)).empty());
  CHECK(failing(depends_on_well(reversed, reversed, usual, true)) == "weak_site weak_bond");
  CHECK(failing(depends_on_well(usual, usual, usual, true)) == "strong_site strong_bond");
  CHECK(failing(depends_on_well(usual, reversed, reversed, true)) == "opposite_site opposite_bond");
  CHECK(failing(depends_on_well({{{1, 0}, {1, 0}}}, {{{-1, 0}, {-1, 0}}}, {{{-1, 0}, {-1, 0}}},
                                true)) == "weak_bond strong_site opposite_site");
}

TEST_CASE("an exchange of stability, step by step", "[unit][exchange]") {
  const Cut cut{false, 0};
  const auto centre = Centre::site;
  const Orbit<double> near = find_breather(problem_at(centre, {1.07, 0}));
  const auto kappa = [&](double p) {
    Orbit<double> orbit = near;
    return quick_kappa(centre, cut.at(p), orbit);
  };
  // A spectrum has the error of a second tolerance
  const auto problem = problem_at(centre, {1.07, 0});
  const Spectrum all = spectrum<double>(problem, near);
  std::array<Pairs<double>, 2> twice;
  for (int coarser : {0, 1}) {
    Orbit<double> guess = near;
    if (coarser) guess.x *= 1 + 1e-6;
    const auto how = rule<double>(coarser);
    const Orbit<double> there = polish(problem, guess, how);
    twice[coarser] = floquet_pairs(problem.chain, there.start, there.period(), how.events);
  }
  const auto known = compare_pairs(twice[1], twice[0]);
  REQUIRE(all.pairs.size() == known.size());
  for (std::size_t k = 0; k < known.size(); ++k)
    CHECK((all.pairs[k].kappa == known[k].kappa && all.pairs[k].error == known[k].error));
  CHECK((all.kappa().value == known[0].kappa.real() && all.kappa().error == known[0].error));
  CHECK(all.mode == twice[0].mode);

  // Regula falsi: an end that stays counts half the next time
  double a = 1.06, b = 1.10, fa = kappa(a), fb = kappa(b), fend = fb, last = a, flast = fa,
         slope = (fb - fa) / (b - a), step = b - a;
  const Exchange found = exchange_between(centre, cut, {a, fa}, {b, fb}, near, 1e-4);
  for (int side = 0; step > 1e-4;) {
    const double p = (a * fb - b * fa) / (fb - fa), f = kappa(p);
    if (std::abs(p - last) > 1e-4) slope = (f - flast) / (p - last);
    const bool right = f * fend > 0;
    last = p, flast = f;
    if (right) {
      b = p, fb = f;
      if (side > 0) fa /= 2;
    } else {
      a = p, fa = f;
      if (side < 0) fb /= 2;
    }
    side = right ? 1 : -1;
    step = std::abs(f / slope);
  }
  check_close(found.place.value, last - flast / slope, 1e-7);
  check_close(found.place.error, step, 1e-7);
  check_close(found.slope, slope, 0, 1e-2);
  check_close(found.orbit.omega, last, 1e-7);

  // The last step of both kinds, from a place and a slope that are wrong
  Exchange start{{1.08, 0}, 1.3 * found.slope, near};
  const Exchange end = polish_zero<double>(centre, cut, start);
  const double there = 1.08 - kappa(1.08) / start.slope;
  Orbit<double> orbit = follow(problem_at(centre, {there, 0}), near);
  const Estimate rest = spectrum<double>(problem_at(centre, {there, 0}), orbit).kappa();
  check_close(end.place.value, there - rest.value / start.slope, 1e-7);
  check_close(end.place.error,
              std::abs(rest.error / start.slope) + 0.01 * std::abs(rest.value / start.slope), 0,
              0.03);
  start.slope = -2 * found.slope;  // a step the other way, and a positive error
  CHECK(polish_zero<double>(centre, cut, start).place.error > 1e-5);
  check_close(end.orbit.omega, there, 1e-9);
  const Exchange whole = exchange<double>(centre, cut, 1.07, 1.08, near);
  check_close(kappa(whole.place.value), 0, 1e-4 * std::abs(kappa(1.07)));
  CHECK_THROWS_AS(exchange<double>(centre, cut, 1.08, 1.09, near), NoBranch);
}

TEST_CASE("two exchanges between neighbouring wells are found", "[property][exchange]") {
  for (const auto& [centre, omega_b] :
       {std::pair{Centre::site, 1.3265}, {Centre::bond, 1.3265}, {Centre::site, 1.3263}}) {
    const auto kappa = [&, centre = centre, omega_b = omega_b](double s) {
      Orbit<double> orbit = find_breather(problem_at(centre, {omega_b, 0}));
      return quick_kappa(centre, {omega_b, s}, orbit);
    };
    const auto found = exchanges_in_wells(centre, omega_b);
    CAPTURE(omega_b);
    CHECK((found.from == -1 && found.to == 1));
    REQUIRE(found.places.size() == 2);
    CHECK(kappa(0) * kappa(0.05) > 0);  // at the neighbours nothing is seen
    for (const Estimate& e : found.places) {
      CHECK((e.value > 0 && e.value < 0.05));
      CHECK(kappa(e.value - 1e-5) * kappa(e.value + 1e-5) < 0);
    }
  }
  CHECK(exchanges_in_wells(Centre::bond, 1.1).places.size() == 1);
  // Whichever end of the bracket comes first; kappa, in extended precision, vanishes there
  const Orbit<double> linear = find_breather(problem_at(Centre::site, {1.5, 0}));
  for (const auto& [low, high] : {std::pair{-0.25, -0.2}, {-0.2, -0.25}}) {
    const Estimate place = exchange<double>(Centre::site, {true, 1.5}, low, high, linear).place;
    check_close(place.value, -0.202052324796, 3 * place.error);
    CHECK(place.error < 1e-6);
  }
}

TEST_CASE("a breather held at a centre: its equations and their derivative", "[unit][exchange]") {
  Shooting<double> problem = breather_problem(Centre::site, 1.3, 0.1, 7);
  const Orbit<double> orbit = find_breather(problem);
  problem.symmetry = even_in_time(7);
  const Held<double> held{problem, along_omega<double>(), 0.3};
  CHECK((Held<double>{}.centre == 0 && Held<double>{}.change == 1e-5));
  Vector<double> x(8);
  x << problem.reduce(orbit.start), 1.35;
  x[1] += 0.01, x[4] -= 0.02;
  const auto miss = [&](const Vector<double>& at) {
    State<double> z(7);
    for (std::size_t n = 0; n < 7; ++n) z.y[n] = at[Eigen::Index(n)];
    flow(problem.chain, z, half_turn / at[7]);
    Vector<double> out(8);
    double weight = 0, moment = 0;
    for (int n = 0; n < 7; ++n) {
      out[n] = z.v[n];
      const double w = at[n] * at[n] + z.y[n] * z.y[n];
      weight += w, moment += (n - 3) * w;
    }
    out[7] = moment / weight - 0.3;
    return out;
  };
  const Shot<double> shot = held.shoot(x, {});
  check_close((shot.miss - miss(x)).cwiseAbs().maxCoeff(), 0, 1e-12);
  CHECK(held.shoot(x, {}, false).jacobian.size() == 0);
  const double size = shot.jacobian.cwiseAbs().maxCoeff();
  for (Eigen::Index k = 0; k < 8; ++k) {
    const Vector<double> h = 2e-6 * Vector<double>::Unit(8, k);
    CAPTURE(k);
    check_close(((miss(x + h) - miss(x - h)) / 4e-6 - shot.jacobian.col(k)).cwiseAbs().maxCoeff(),
                0, 1e-6 * size);
  }
  const Sizes<double> inner = problem.sizes(x.head(7), true), sizes = held.sizes(x, true);
  for (int n = 0; n < 7; ++n)
    CHECK((sizes.unknown[n] == inner.unknown[n] && sizes.equation[n] == inner.equation[n]));
  CHECK((sizes.unknown[7] == 1 && sizes.equation[7] == 1 && sizes.unknown.size() == 8));
  // Moved to the centre, all equations hold but for a share of the gradient
  const Vector<double> there = moved_to_centre(held, x), rest = miss(there);
  CHECK(there[7] == 1.35);
  check_close(rest[7], 0, 1e-7);
  Vector<double> slope = Vector<double>::Zero(7);
  for (int n = 1; n < 6; ++n) slope[n] = there[n + 1] - there[n - 1];
  const Vector<double> left =
      rest.head(7) - slope * (slope.dot(rest.head(7)) / slope.squaredNorm());
  check_close(left.cwiseAbs().maxCoeff(), 0, 1e-6);
  CHECK(rest.head(7).cwiseAbs().maxCoeff() > 1e-5);
}

TEST_CASE("a breather of the DpS equation and its pendulum", "[unit][dps]") {
  const Field v{{1, 2}, {0, 1}, {-2, 0}, {0, 0.5}};
  // |v|^4 is 25, 1, 16 and 1/16, at the sites -1 to 2
  const double weight = 25 + 1 + 16 + 0.0625, moment = -25 + 16 + 0.125;
  check_close(quartic_centre(Centre::site, v), moment / weight, 1e-14);
  check_close(quartic_centre(Centre::bond, v), moment / weight - 0.5, 1e-14);
  for (Centre centre : both_centres) {
    const auto state = stationary<double>(centre, 2.5, centre == Centre::site ? 9 : 8);
    const PinnedBreather b(state);
    CHECK((b.centre == centre && b.mu == 2.5));
    CHECK(PinnedBreather(centre, 2.5, state.u.size()).pair.m == b.pair.m);
    // A small shift along the pair moves the centre by g, to larger n
    Field ahead = b.u, behind = b.u;
    b.pair.add(1e-5, ahead), b.pair.add(-1e-5, behind);
    const double g = (quartic_centre(centre, ahead) - quartic_centre(centre, behind)) / 2e-5;
    CHECK(g > 0);
    check_close(b.shift, g, 0, 1e-7);
    check_close(b.freeing_push(), b.pair.rate / half_turn / b.shift / (2.5 - b.pair.m), 0, 1e-13);
    // From the middle of a hill to half a site away
    const double speed = 2 * b.shift * b.pair.rate * 0.03;
    double time = 0;
    for (int k = 0; k < 400; ++k)
      time += 1 /
              std::hypot(speed, b.pair.rate / half_turn * std::sin(half_turn * (k + 0.5) / 800)) /
              800;
    for (double growing : {0.03, -0.03}) check_close(b.departure(growing), time, 0, 1e-10);
    CHECK(b.departure(0) == never);
  }
  const Noise shape{"", true, false, true, 0.1};
  const PinnedBreather site(Centre::site, 2.5, 9);
  for (int k = 0; k < 8; ++k) {
    const Noise noise{"", (k & 1) != 0, (k & 2) != 0, (k & 4) != 0, 0.3};
    Random random(7);
    const Field w = noise(site.u, 7);
    for (std::size_t n = 0; n < 9; ++n) {
      const double low = noise.positive ? 0 : -1, re = 0.3 * random.uniform(low, 1),
                   im = noise.imaginary ? 0.3 * random.uniform(low, 1) : 0;
      const auto expected = std::complex<double>(re, im) * (noise.relative ? site.u[n] : 1);
      check_close(std::abs(w[n] - expected), 0, 1e-15);
    }
  }
  for (bool pinned : {true, false}) {
    Trial trial{5};
    const Field w = perturbed(site, shape, pinned, trial), noise = shape(site.u, 5);
    std::complex<double> kick = 0;
    for (std::size_t n = 0; n < 9; ++n) kick += noise[n] * site.pair.V[Eigen::Index(n)];
    for (std::size_t n = 0; n < 9; ++n)
      check_close(std::abs(w[n] - site.u[n] - noise[n] +
                           (pinned ? 0 : kick * site.pair.V[Eigen::Index(n)])),
                  0, 1e-14);
    const double growing = (kick.real() + (2.5 - site.pair.m) / site.pair.rate * kick.imag()) / 2;
    check_close(std::abs(trial.kick - (pinned ? kick : 0)), 0, 1e-14);
    check_close(trial.growing, pinned ? std::abs(growing) : 0, 1e-14);
  }
  CHECK((Trial{}.growing == 0 && Trial{}.kick == 0.0));
}

TEST_CASE("a course is followed and measured", "[unit][dps]") {
  const Course there = course({0, 2, 4, 6}, {0, -0.4, -1.2, 0.9});
  CHECK((Course{}.norm_drift == 0 && Course{}.energy_drift == 0 && Course{}.sites == 0 &&
         Course{}.most_sites == 0));
  check_close(there.largest(), 1.2, 1e-15);
  check_close(there.reaches(1), 2 + 2 * 0.6 / 0.8, 1e-14);
  check_close(there.reaches(0.4), 2, 1e-14);
  CHECK(std::isnan(there.reaches(1.2)));
  CHECK((there.until(4).t == Numbers{0, 2, 4} && there.until(3.9).X == Numbers{0, -0.4}));
  check_close(there.spread(), 4 / 3.0, 1e-15);
  CHECK((moved(there) && moved(there, 3.51) && !moved(there, 3.49) &&
         !moved(course({0, 9}, {0, 1}))));

  const PinnedBreather site(Centre::site, 2.5, 9);
  Field start = site.u;
  start[4] += std::complex<double>(0.2, 0.1);
  Numbers t, X, filled;
  double norms = 0, energies = 0;
  const Course run = follow_breather(site, start, 2.1, {1e-4, 2}, [&](double now, const Field& w) {
    double squares = 0, fourth = 0, moment = 0;
    for (std::size_t n = 0; n < 9; ++n) {
      const double square = std::norm(w[n]);
      squares += square, fourth += square * square, moment += (double(n) - 4) * square * square;
    }
    t.push_back(now), X.push_back(moment / fourth), filled.push_back(squares * squares / fourth);
    norms = std::max(norms, std::abs(norm(w) / norm(start) - 1));
    energies = std::max(energies, std::abs(energy(w) / energy(start) - 1));
  });
  REQUIRE(run.t.size() == 6);  // 4.2 samples are five
  CHECK(run.t == t);
  for (std::size_t k = 0; k < 6; ++k) check_close(run.X[k], X[k], 1e-12);
  check_close(run.sites, filled[0], 1e-12);
  check_close(run.most_sites, *std::max_element(filled.begin(), filled.end()), 1e-12);
  CHECK(norms > 1e-12);
  check_close(run.norm_drift, norms, 1e-15, 1e-6);
  check_close(run.energy_drift, energies, 1e-15, 1e-6);
  // i dw/dt = mu w + ...: alone on its site a field turns with mu and nothing moves
  const Course still = follow_breather(site, site.u, 2, {1e-8, 1});
  CHECK(still.largest() < 1e-6);

  // The growth along the growing direction, and the push that frees
  const Accuracy rough{1e-6, 2};
  Field v = site.u;
  site.pair.add({1e-4, 1e-4 / site.pair.push}, v);
  Numbers time, share;
  follow_breather(site, v, 4 / site.pair.rate, rough, [&](double now, Field w) {
    double x = 0, y = 0;
    for (std::size_t n = 0; n < 9; ++n) {
      x += (w[n] - site.u[n]).real() * site.pair.V[Eigen::Index(n)];
      y += w[n].imag() * site.pair.V[Eigen::Index(n)];
    }
    time.push_back(now),
        share.push_back(std::log(std::abs(x + (2.5 - site.pair.m) / site.pair.rate * y) / 2));
  });
  check_close(measured_rate(site, 1e-4, rough), fit_line(time, share).slope, 0, 1e-8);
  const PinnedBreather bond(Centre::bond, 2.5, 12);
  const auto freed = [&](double push) {
    Field w = bond.u;
    for (std::size_t n = 0; n < 12; ++n)
      w[n] += std::complex<double>(0, push * bond.pair.V[Eigen::Index(n)]);
    return follow_breather(bond, w, 12 / bond.pair.rate, {1e-4, 1}).reaches(1) > 0;
  };
  double low = 0.8 * bond.freeing_push(), high = 1.2 * bond.freeing_push();
  for (int k = 0; k < 3; ++k) (freed((low + high) / 2) ? high : low) = (low + high) / 2;
  check_close(bisect_push(bond, {1e-4, 1}, 3), (low + high) / 2, 0, 1e-12);
}

TEST_CASE("trials are counted and judged", "[unit][dps]") {
  const auto trial = [](const Course& rough, const Course& good, std::complex<double> kick = 0,
                        double growing = 0) {
    Trial out;
    out.rough = rough, out.good = good, out.kick = kick, out.growing = growing;
    return out;
  };
  // Passes 0.5 at 2 and 1.5 at 4; passes 0.5 at 4 and 1 at 6; stays
  const Course far = course({0, 4, 8}, {0, 1, 3}), near = course({0, 8}, {0, 1.1}),
               stays = course({0, 8}, {0, 0.4});
  const std::vector<Trial> trials{trial(near, far, {9, 1.1}, 0.02),
                                  trial(near, near, {0, -1.1}, 0.01),
                                  trial(far, stays, {9, 0.9}, 0.3)};
  const Census all = tally(trials, &Trial::good), early = tally(trials, &Trial::good, 3.9),
               late = tally(trials, &Trial::good, 5);
  const double second = 8 * 0.5 / 1.1;
  CHECK((all.left == 2 && all.moved == 2 && all.speeds.size() == 1 &&
         all.departures.back() == never));
  check_close(all.departures[0], 2, 1e-14);
  check_close(all.departure(), second, 1e-14);
  check_close(all.speeds[0], 1 / 3.0, 1e-14);
  CHECK((early.left == 2 && early.moved == 0 && early.speeds.empty()));
  CHECK((late.moved == 1 && late.speeds.size() == 1));
  CHECK((tally(trials, &Trial::good, 2.5).departure() == never && Census{}.left == 0 &&
         Census{}.moved == 0));
  const PinnedBreather site(Centre::site, 2.5, 9);
  check_close(
      departure_difference({trials[0], trials[1]}, &Trial::good, site),
      std::max(std::abs(2 / site.departure(0.02) - 1), std::abs(second / site.departure(0.01) - 1)),
      1e-13);
  const PushCount good = count_pushes(trials, &Trial::good, 1),
                  rough = count_pushes(trials, &Trial::rough, 1);
  CHECK((good.over == 2 && good.told == 3 && rough.over == 2 && rough.told == 2 &&
         PushCount{}.over == 0 && PushCount{}.told == 0));
  auto drifting = trials;
  drifting[1].good.norm_drift = 3e-9, drifting[2].good.energy_drift = 2e-9,
  drifting[0].rough.energy_drift = 1;
  CHECK(largest_drift(drifting, &Trial::good) == 3e-9);
  drifting[2].good.energy_drift = 4e-9;
  CHECK(largest_drift(drifting, &Trial::good) == 4e-9);
  CHECK(surely_stable("x", {{-1.01, 0.01}, {}}).holds());
  CHECK_FALSE(surely_stable("x", {{-0.99, 0.01}, {}}).holds());
  bounded_by(1, false, "weakest", [](double x) { return linear_growth({x - 1, 0}, {0, 0}); });
  bounded_by(1e-8, true, "variation", [](double x) { return linear_growth({1, 0}, {x, 0}); });

  // Four breathers that pass the site at `when`, or never
  const auto passing = [&](const Numbers& when) {
    std::vector<Trial> out;
    for (double at : when)
      out.push_back(trial(course({0, at}, {0, 1 + 1e-9}), course({0, at}, {0, 1 + 1e-9})));
    return out;
  };
  const auto resting = [&](std::vector<Trial> of, std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) of[k].good.X = of[k].rough.X = {0, 0.9};
    return of;
  };
  const auto held = passing({20, 20, 20, 20});
  const auto verdict = [](const auto& a, const auto& b) {
    return failing(moved_by_instability(a, b));
  };
  CHECK(verdict(passing({1, 2, 3, 4}), held).empty());
  CHECK(verdict(resting(passing({1, 2, 3, 4}), 2, 4), held).empty());  // half of them are enough
  CHECK(verdict(resting(passing({1, 2, 3, 4}), 1, 4), held) == "trials");
  CHECK(verdict(passing({1, 2, 3, 4}), passing({0.5, 20, 20, 20})).empty());  // three of four later
  CHECK(verdict(passing({1, 2, 3, 4}), passing({1, 1.9, 20, 20})) == "later");
  CHECK(verdict(passing({1, 2, 3, 4}), resting(passing({5, 6, 6.03, 20}), 0, 4)).empty());
  CHECK(verdict(passing({1, 2, 3, 4}), resting(passing({5, 5.9, 5.97, 20}), 0, 4)) == "delay");
  auto torn = passing({1, 2, 3, 4});
  torn[0].rough.X = {0, 0.9};
  CHECK(failing(moved_by_instability(torn, held)).find("torn") != std::string::npos);
  const Criterion counts = moved_by_instability(torn, held);
  check_estimate(counts[0].value, 4, 1);
  check_close(counts[0].limit, 1.5, 1e-15);
  check_close(counts[1].limit, 2.5, 1e-15);
  check_estimate(counts[2].value, 20 / 3.0, 1e-15);
  check_estimate(moved_by_instability(passing({1, 2, 3, 4}), held)[1].value, 4, 0);

  auto spread = trials;
  spread[0].rough.most_sites = 6, spread[1].good.most_sites = 4.5, spread[2].good.most_sites = 3;
  check_estimate(largest_spread(spread), 1.5, 0.5);
  const auto robust = [&](std::size_t stay, std::size_t leave, double times) {
    std::vector<Trial> a(20, trial(stays, stays)), b(20, trial(stays, stays));
    for (std::size_t k = 0; k < stay; ++k) a[k] = trial(near, near);
    for (std::size_t k = 0; k < leave; ++k) b[k] = trial(near, near);
    return failing(structurally_robust(a, b, {times, 0}));
  };
  CHECK(robust(1, 19, 1.99).empty());
  CHECK(robust(2, 18, 2.01) == "left beside spread");
  auto doubtful = std::vector<Trial>(20, trial(near, stays));
  CHECK(failing(structurally_robust(doubtful, doubtful, {1, 0})) == "left beside");
}

}  // namespace exchange_again
