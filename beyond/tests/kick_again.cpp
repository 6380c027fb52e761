// Kicked breathers a second time: directions, means, slow planes, thresholds, and maps of fixed steps, each from a
// second formula.

#include "check.hpp"
#include "estimates.hpp"
#include "lattice/algebra/eigenvalues.hpp"
#include "lattice/orbits/floquet.hpp"
#include "sec33/fixed_step.hpp"
#include "sec33/kick_threshold.hpp"

namespace kick_again {

using namespace lattice;

namespace {

using Numbers = std::vector<double>;
const double half_turn = std::acos(-1.0), never = std::numeric_limits<double>::infinity();

void check_matrix(const Matrix<double>& found, const Matrix<double>& expected, double absolute) {
  REQUIRE((found.rows() == expected.rows() && found.cols() == expected.cols()));
  check_close((found - expected).cwiseAbs().maxCoeff(), 0, absolute);
}
Creep path_with(const Numbers& t, const Numbers& X) {
  Creep path;
  path.t = t, path.X = X;
  return path;
}

/// A small chain that moves, and a state of it.
State<double> some_state(std::size_t sites) {
  State<double> state(sites);
  for (std::size_t n = 0; n < sites; ++n)
    state.y[n] = std::sin(1.7 * double(n * n) + 0.4), state.v[n] = std::cos(2.3 * double(n) + 1);
  return state;
}

}  // namespace

TEST_CASE("a kick and the path after it by hand", "[unit][kick]") {
  const Numbers g = kick_direction({1, 4, 2, -3});
  const double norm = std::sqrt(16. + 1 + 49 + 4);
  for (const auto& [n, x] :
       std::vector<std::pair<std::size_t, double>>{{0, 4}, {1, 1}, {2, -7}, {3, -2}})
    check_close(g[n], x / norm, 1e-14);
  State<double> state(4);
  state.y = {1, 4, 2, -3}, state.v = {1, 1, 1, 1};
  check_close(kicked(state, -2).v[2], 1 + 14 / norm, 1e-14);
  CHECK(kicked(state, -2).y == state.y);
  check_close(creep_sample(3), 3 * 0.1236067977499789696, 1e-14);
  check_close(breather_place({0, 1, 5, 2}), (2 + 15 + 8) / 8.0 - 2.5, 1e-14);
  CHECK(Creep{}.share == 1);
  CHECK(Creep{}.travelled() == 0);

  Creep path = path_with({0, 1, 2, 4, 5}, {3, 3.5, 2, 1.2, 1.6});
  check_close(path.farthest(), 1.8, 1e-14);
  check_close(path.travelled(), -1.4, 1e-14);
  check_close(path.speed(1, 4).value,
              ((1 - 7 / 3.0) * 3.5 + (2 - 7 / 3.0) * 2 + (4 - 7 / 3.0) * 1.2) / (14 / 3.0), 1e-13);
  check_close(path.mean_speed(1.4), 1.4 / (2 + 2 * 0.4 / 0.8), 1e-14);
  check_close(path.mean_speed(0.5), 0.5 / 1, 1e-14);
  check_close(path.mean_speed(2, 1), 2 / (2 + 2 * 0.5 / 0.8 - 1), 1e-14);
  CHECK_THROWS_AS(path.mean_speed(1.81), std::runtime_error);
  path.run.energy_drift = 1e-8;
  check_close(path.drift_margin(3, 5), 9 / 10.0 / 1e-8, 0, 1e-13);
}

TEST_CASE("a creeping breather is looked at in samples, and means are taken", "[unit][kick]") {
  const Chain chain{14};
  State<double> start = some_state(14);
  start.t = 5;
  const double sample = 0.05;
  Numbers t, X;
  State<double> now = start;
  double sum = 0, share = 1;
  for (int k = 1; k <= 178; ++k) {
    evolve(ContactAware{0.03}, chain, now, TimeGrid{sample, 1, 2}, Unobserved{});
    const Numbers e = energy_density(chain, now);
    std::size_t top = 0;
    for (std::size_t n = 0; n < 14; ++n)
      if (e[n] > e[top]) top = n;
    double weight = 0, moment = 0, all = 0;
    for (std::size_t n = 0; n < 14; ++n) {
      all += e[n];
      if (n + 5 >= top && n <= top + 5) weight += e[n], moment += (double(n) - 6.5) * e[n];
    }
    sum += moment / weight, share = std::min(share, weight / all);
    if (k % 89 == 0) t.push_back(5 + sample * (k - 44)), X.push_back(sum / 89), sum = 0;
  }
  const Creep path = creep(ContactAware{0.03}, chain, start, sample, 1.51 * 89 * sample);
  REQUIRE(path.X.size() == 2);
  CHECK(path.run.steps == 2 * 178);
  for (std::size_t k : {0U, 1U})
    check_close(path.t[k], t[k], 1e-10), check_close(path.X[k], X[k], 1e-7);
  check_close(path.share, share, 1e-7);
  check_close(path.end.y[3], now.y[3], 1e-7);
  CHECK(creep(ContactAware{0.05}, chain, start, sample, 1.49 * 89 * sample).run.steps == 89);
  int seen = 0;
  creep(ContactAware{0.05}, chain, start, sample, 20,
        [&](const Creep& so_far, const auto&, const auto&) {
          CHECK(so_far.X.size() == std::size_t(++seen));
          return seen < 2;
        });
  CHECK(seen == 2);
}

TEST_CASE("free, pinned, and how fast on the hill", "[unit][kick]") {
  for (double sign : {1.0, -1.0}) {
    const auto fate = [&](double far, double end) {
      return mobility_of(path_with({0, 1, 2}, {1, 1 + sign * far, 1 + sign * end}));
    };
    CHECK(fate(0.601, 0.5) == Mobility::free);
    CHECK(fate(0.599, 0.5792) == Mobility::undecided);
    CHECK(fate(0.599, 0.5788) == Mobility::pinned);
    // No cubic: the fit sees which means are near, 0.05 by default, and in which units time counts
    Numbers t, X;
    for (int k = 0; k < 60; ++k) {
      const double u = 2 * k - 57.3, moved = 0.5 + 8e-4 * u + 4e-6 * u * u + 2e-7 * u * u * u +
                                             2e-3 * std::sin(u / 14);
      t.push_back(70 + 2 * k), X.push_back(k == 0 ? 0.3 : 0.3 + sign * moved);
    }
    const Creep path = path_with(t, X);
    for (const auto& [hill, reach] :
         std::vector<std::pair<double, double>>{{0.5, 0.05}, {0.5, 0.03}, {0.47, 0.04}}) {
      std::vector<std::size_t> near;
      for (std::size_t k = 0; k < 60; ++k)
        if (std::abs(std::abs(X[k] - 0.3) - hill) <= reach) near.push_back(k);
      Matrix<double> powers(Eigen::Index(near.size()), 4);
      Vector<double> place(powers.rows());
      for (Eigen::Index i = 0; i < powers.rows(); ++i) {
        const double u = (t[near[std::size_t(i)]] - 130) / 30;
        for (int k = 0; k < 4; ++k) powers(i, k) = std::pow(u, k);
        place[i] = std::abs(X[near[std::size_t(i)]] - 0.3);
      }
      const Vector<double> a = least_squares(powers, place);
      REQUIRE(a[3] > 0);
      check_close(hill_speed(path, hill, reach), (a[1] - a[2] * a[2] / 3 / a[3]) / 30, 0, 1e-8);
    }
    CHECK(hill_speed(path) == hill_speed(path, 0.5, 0.05));
  }
  // Without a least slope the one in the middle counts; eight means are enough
  Numbers t{0}, X{0};
  for (int k = 0; k < 8; ++k) {
    const double u = k - 3.5;
    t.push_back(10 + k), X.push_back(0.5 + 2e-3 * u + 1e-4 * u * u - 1e-5 * u * u * u);
  }
  check_close(hill_speed(path_with(t, X)), 2e-3, 1e-13);
  t.pop_back(), X.pop_back();
  CHECK_THROWS_AS(hill_speed(path_with(t, X)), std::invalid_argument);
  check_close(threshold_from(2, 3, 3, 5), std::sqrt((4. * 25 - 9 * 9) / (25 - 9)), 1e-14);
  CHECK_THROWS_AS(threshold_from(1, 1, 2, 2), std::invalid_argument);
  check_close(freeing_kick(-3, {1, 0.5}), std::sqrt(12), 1e-14);
  // A pendulum from its top: the inverse of the mean of the inverse speed
  double sum = 0;
  for (int k = 0; k < 64; ++k)
    sum += 1 / std::hypot(0.1, 0.7 / half_turn * std::sin(half_turn * (k + 0.5) / 64)) / 64;
  check_close(pendulum_speed(0.1, 0.7, true), 1 / sum, 1e-12);
  CHECK(pendulum_speed(0.5, 0.5 * half_turn, false) == 0);
}

TEST_CASE("the slow plane of a breather from its monodromy matrix", "[unit][kick]") {
  for (Centre centre : both_centres) {
    const bool site = centre == Centre::site;
    const std::size_t sites = site ? 9 : 8;
    const auto problem = breather_problem(centre, 1.4, 0, sites);
    const Orbit<double> orbit = find_breather(problem);
    const double period = orbit.period();
    const auto n = Eigen::Index(sites);
    const Matrix<double> map = monodromy(problem.chain, orbit.start, site ? period / 2 : period);
    Matrix<double> A = map.topLeftCorner(n, n), B = map.topRightCorner(n, n),
                   basis = Matrix<double>::Identity(n, n);
    if (site) A = -A.colwise().reverse().eval(), B = -B.colwise().reverse().eval();
    const PeriodMap got = period_map(problem.chain, centre, orbit.start, period, {});
    check_matrix(got.A, A, 1e-10);
    check_matrix(got.B, B, 1e-10);
    if (!site) {
      basis = Matrix<double>::Zero(n, n / 2);
      for (Eigen::Index i = 0; i < n / 2; ++i) basis(i, i) = basis(n - 1 - i, i) = std::sqrt(0.5);
    }
    check_matrix(got.basis, basis, 1e-14);
    // The eigenvector next to one, or to minus one
    const Matrix<double> a = basis.transpose() * A * basis, b = basis.transpose() * B * basis;
    const auto nearest = [&](const Matrix<double>& m) {
      double best = 10;
      for (const std::complex<double>& value : eigenvalues_of(m))
        if (std::abs(value - (site ? -1.0 : 1.0)) < std::abs(best - (site ? -1.0 : 1.0)))
          best = value.real();
      return std::pair<double, Vector<double>>(best, eigenvector_of(m, best));
    };
    const auto [alpha, x] = nearest(a);
    const Vector<double> z = nearest(a.transpose()).second;
    const Numbers kick = kick_direction(orbit.start.y);
    const double part = x.dot(basis.transpose() * Eigen::Map<const Vector<double>>(kick.data(), n));
    const double share = z.dot(b * z) / z.dot(x) * part * part / (period * x.dot(z));
    const Pinning p = pinning_of(problem.chain, centre, orbit.start, period);
    // Half a period turns by half of the angle
    const double cosine = site ? 2 * alpha * alpha - 1 : alpha;
    check_close(p.frequency2, 2 * (1 - cosine) / (period * period), 1e-11, 1e-6);
    check_close(p.share, site ? 2 * alpha * share : share, 0, 1e-6);
  }
  CHECK((Pinning{}.frequency2 == 0 && Pinning{}.share == 0));
  Matrix<double> m(3, 3);
  m << 1, 0, 1, 0, 2, 0, 0, 0, 4;
  check_matrix(eigenvector_near(m, 4, Vector<double>::Ones(3)).cwiseAbs(),
               Eigen::Vector3d(1, 0, 3) / std::sqrt(10.), 1e-12);
  check_matrix(eigenvector_near(m, 1, Vector<double>::Ones(3)).cwiseAbs(), Eigen::Vector3d(1, 0, 0),
               1e-12);
}

TEST_CASE("a threshold is predicted, extrapolated and confirmed", "[unit][kick]") {
  CHECK((RestingBreather{}.centre == Centre::bond && RestingBreather{}.period == 0 &&
         RestingBreather{}.energy == 0));
  CHECK_FALSE(Prediction{}.exists());
  CHECK(std::isinf(FreeingKick{}.margin));
  for (const auto& [centre, asked, sites] :
       std::vector<std::tuple<Centre, std::size_t, std::size_t>>{{Centre::site, 22, 23},
                                                                 {Centre::site, 21, 21},
                                                                 {Centre::bond, 22, 22},
                                                                 {Centre::bond, 0, 22}})
    CHECK(resting_breather(centre, Phase::compressed, 1.3, asked).chain.sites == sites);
  const RestingBreather first = resting_breather(Centre::bond, Phase::stretched, 1.6, 0);
  CHECK(first.centre == Centre::bond);
  CHECK(first.rest.y[first.chain.sites / 2] > first.rest.y[first.chain.sites / 2 - 1]);
  check_close(first.period, 2 * half_turn / 1.6, 1e-14);
  check_close(first.energy, energy(first.chain, first.rest), 0, 1e-13);
  // In hard wells a breather around a site swings in some 360 of its periods, which saves time
  const auto site = breather_problem(Centre::site, 1.3, 1, 13),
             bond = breather_problem(Centre::bond, 1.3, 1, 14);
  const Orbit<double> orbit = find_breather(site);
  const RestingBreather at{Centre::site, Chain{13, Quartic{1}}, orbit.start, orbit.period(),
                           orbit.energy};
  const double gap = barrier(site, orbit, find_breather(bond)).equal_area;

  const Prediction p = predict_threshold(at, {gap, 0.01 * std::abs(gap)});
  EventTolerance<double> loose;
  loose.tolerance *= 16;
  const Pinning rough = pinning_of(at.chain, Centre::site, at.rest, at.period, loose),
                fine = pinning_of(at.chain, Centre::site, at.rest, at.period);
  const auto kick = [&](const Pinning& of) { return std::sqrt(2 * std::abs(gap / of.share)); };
  check_estimate(p.share, fine.share, std::abs(fine.share - rough.share));
  check_estimate(p.frequency, std::sqrt(fine.frequency2),
                 std::abs(std::sqrt(fine.frequency2) - std::sqrt(rough.frequency2)));
  check_estimate(p.threshold, kick(fine), std::abs(kick(fine) - kick(rough)) + 0.005 * kick(fine));
  check_estimate(p.barrier, gap, 0.01 * std::abs(gap));
  CHECK(p.share.error < 0.1 * std::abs(p.share.value));

  // Three kicks above the prediction, with two schemes, and what their speeds extrapolate to
  const ContactAware step{0.4}, rough_step{0.4, nystrom(blanes_moan_4())};
  const auto follow = [&](double c, const ContactAware& stepper) {
    return at.after(c, stepper, 10 / p.frequency.value,
                    [](const Creep& path, const auto&, const auto&) {
                      return mobility_of(path) == Mobility::undecided;
                    });
  };
  double margin = never;
  const auto extrapolated = [&](const ContactAware& stepper) {
    std::array<double, 3> c{}, v{};
    margin = never;
    for (std::size_t i = 0; i < 3; ++i) {
      c[i] = std::array{1.05, 1.2, 1.4}[i] * p.threshold.value;
      const Creep path = follow(c[i], stepper);
      v[i] = hill_speed(path), margin = std::min(margin, path.drift_margin(c[i], at.energy));
    }
    const auto from = [&](std::size_t i, std::size_t k) {
      return threshold_from(c[i], v[i], c[k], v[k]);
    };
    const double best = from(0, 1);
    return Estimate{best, std::max(std::abs(from(0, 2) - best), std::abs(from(1, 2) - best))};
  };
  const Estimate best = extrapolated(step);
  check_close(best.value, p.threshold.value, 0, 0.05);
  std::vector<FreeingKick> found = freeing_kicks({at}, {p}, rough_step, step);
  REQUIRE(found.size() == 1);
  check_close(found[0].value.value, best.value, 0, 1e-7);
  CHECK(found[0].value.error > best.error);  // both schemes differ
  CHECK(found[0].value.error < best.error + 1e-3 * best.value);
  check_close(found[0].margin, margin, 0, 1e-6);
  // A per cent below is pinned, a per cent above is free
  found[0].margin = never;
  confirm(at, p, step, found[0]);
  CHECK((found[0].margin > 0 && found[0].margin < 3 * margin));
  for (double wrong : {0.7, 1.3}) {
    FreeingKick off{{wrong * best.value, 0}, never};
    CHECK_THROWS_AS(confirm(at, p, step, off), std::runtime_error);
  }
  CHECK_THROWS_AS(decided_path(at, best.value, step, 2 / p.frequency.value), std::runtime_error);
}

TEST_CASE("maps of fixed steps by hand", "[unit][kick]") {
  const FixedStep map{Chain{5, Quartic{0.6}}, nystrom(blanes_moan_4()), 4, 2.5};
  CHECK((FixedStep{}.steps == 0 && FixedStep{}.period == 0));
  // The splitting itself
  const State<double> start = some_state(5);
  const auto pushed = [](State<double> z, int periods) {
    const Scheme scheme = blanes_moan_4();
    const double h = 2.5 / 4;
    for (int k = 0; k < 4 * periods; ++k)
      for (std::size_t j = 0; j < scheme.kick.size(); ++j) {
        Numbers a(5);
        const auto root = [](double x) { return x > 0 ? x * std::sqrt(x) : 0; };
        for (int n = 0; n < 5; ++n)
          a[n] = -z.y[n] - 0.6 * std::pow(z.y[n], 3) + (n > 0 ? root(z.y[n - 1] - z.y[n]) : 0) -
                 (n < 4 ? root(z.y[n] - z.y[n + 1]) : 0);
        for (int n = 0; n < 5; ++n)
          z.v[n] += scheme.kick[j] * h * a[n], z.y[n] += scheme.drift[j] * h * z.v[n];
      }
    z.t += 2.5 * periods;
    return z;
  };
  for (int periods : {1, 3}) {
    State<double> end = start;
    carry(map, end, std::size_t(periods));
    const State<double> again = pushed(start, periods);
    for (std::size_t i = 0; i < 10; ++i) check_close(entry(end, i), entry(again, i), 1e-11);
    check_close(end.t, again.t, 1e-14);
  }
  // Its derivative: one-sided quotients to rounding, and exactly
  Matrix<double> quotient(10, 7), exact(10, 7);
  double size = 0;
  for (std::size_t i = 0; i < 10; ++i) size = std::max(size, std::abs(entry(start, i)));
  for (std::size_t c = 0; c < 7; ++c) {
    State<double> up = start, more = start, less = start;
    entry(up, c) += 1e-3 * size, entry(more, c) += 1e-6, entry(less, c) -= 1e-6;
    const State<double> here = pushed(start, 1), there = pushed(up, 1), a = pushed(more, 1),
                        b = pushed(less, 1);
    for (std::size_t i = 0; i < 10; ++i) {
      quotient(i, c) = (entry(there, i) - entry(here, i)) / (1e-3 * size);
      exact(i, c) = (entry(a, i) - entry(b, i)) / 2e-6;
    }
  }
  check_matrix(derivative(map, start, 7, 1e-3), quotient, 1e-9);
  check_matrix(derivative(map, start, 7, 0), exact, 1e-6);

  // Two steps of Gauss and Newton from a state at rest
  State<double> guess = start, at = start;
  std::fill(guess.v.begin(), guess.v.end(), 0.0), at = guess;
  double last = 0, residual = 0;
  for (int k = 0; k <= 2; ++k) {
    const State<double> end = pushed(at, 1);
    Vector<double> miss(10);
    double big = 0;
    for (std::size_t i = 0; i < 10; ++i)
      miss[i] = entry(end, i) - entry(at, i), big = std::max(big, std::abs(entry(at, i)));
    residual = miss.cwiseAbs().maxCoeff() / big;
    if (k == 2) break;
    Matrix<double> J = derivative(map, at, 5, 0);
    J.topRows(5) -= Matrix<double>::Identity(5, 5);
    const Vector<double> change = least_squares(J, miss);
    for (std::size_t n = 0; n < 5; ++n) at.y[n] -= change[n];
    last = change.cwiseAbs().maxCoeff() / big;
  }
  const MapBreather found = find_breather(map, guess, {2});
  for (std::size_t n = 0; n < 5; ++n) check_close(found.start.y[n], at.y[n], 1e-8);
  check_close(found.residual, residual, 0, 1e-7);
  check_close(found.variation, last, 0, 1e-7);
  CHECK(find_breather(map, guess, {0}).variation == 0);
  const GaussNewton usual;
  CHECK((usual.iterations == 5 && usual.increment == 0 && usual.rank == 0));
  CHECK(MapBreather{}.residual == 0);

  // Zeros of parabolas: both roots inside, one at either end, a double one
  const auto zero = [](double a, double b, double scale) {
    const auto of = [&](double s) { return scale * (s - a) * (s - b); };
    return zero_in_wells({of(-1), of(0), of(1)});
  };
  check_close(zero(0.25, -0.5, 2), 0.25, 1e-14);
  check_close(zero(-0.25, 0.75, -3), -0.25, 1e-14);
  check_close(zero(1, 3, 1), 1, 1e-14);
  CHECK(std::isnan(zero(1.01, 3, 1)));
  check_close(zero(-1, 3, 1), -1, 1e-14);
  check_close(zero(0.5, 0.5, 1), 0.5, 1e-14);

  // Looks at a path, and when it stops
  const auto looks = [&](std::size_t periods, std::size_t every, std::size_t most) {
    return path_of(map, start, periods, every,
                   [&](const Creep& path) { return path.t.size() >= most; });
  };
  const Creep path = looks(6, 3, 99);
  REQUIRE(path.X.size() == 3);
  State<double> now = start;
  for (std::size_t k = 0; k < 3; ++k) {
    check_close(path.t[k], 7.5 * double(k), 1e-13);
    check_close(path.X[k], breather_place(energy_density(map.chain, now)), 1e-9);
    now = pushed(now, 3);
  }
  CHECK(looks(8, 3, 99).X.size() == 3);
  CHECK(looks(9, 3, 2).X.size() == 2);
  const Creep away = path_with({0, 1, 2, 3}, {1, 1.2, -0.5, -1.5});
  CHECK(stays_away(away, 2, 2));  // 1.5 and 2.5 sites
  CHECK(stays_away(away, 2, 3));
  CHECK_FALSE(stays_away(away, 2, 1));
  CHECK_FALSE(stays_away(away, 2, 3.1));
  CHECK_FALSE(stays_away(away, 1.99, 2));
  CHECK_FALSE(stays_away(away, 2.01, 2));
}

TEST_CASE("a kick frees a breather of the map or not, as looks at every sixteenth period say",
          "[unit][kick]") {
  const auto problem = breather_problem(Centre::bond, 1.5, 0, 14);
  const FixedStep map{problem.chain, nystrom(verlet()), 30, problem.period()};
  const State<double> start = find_breather(problem, Phase::stretched).start;
  // How many periods it takes: one look less decides nothing
  State<double> now = kicked(start, 0.1);
  Creep path = path_with({0}, {breather_place(energy_density(map.chain, now))});
  std::size_t periods = 0;
  while (mobility_of(path) == Mobility::undecided && periods < 2000) {
    carry(map, now, 16), periods += 16;
    path.t.push_back(now.t), path.X.push_back(breather_place(energy_density(map.chain, now)));
  }
  REQUIRE(mobility_of(path) == Mobility::free);
  CHECK(frees(map, start, 0.1, periods));
  CHECK_FALSE(frees(map, start, 0.1, periods - 1));
}

}  // namespace kick_again
