// Kicking a breather: the kick itself, the breather that drifts, and what linear theory says of both.

#include "sec33/kick_threshold.hpp"

#include <algorithm>
#include <numbers>

#include "lattice/algebra/eigenvalues.hpp"
#include "lattice/orbits/floquet.hpp"
#include "support/check.hpp"
#include "support/run.hpp"

using namespace lattice;

namespace {

struct Resting {
  Chain chain;
  State<double> state;
  double period;
};

Resting breather(Centre centre, double omega, Phase phase = Phase::compressed) {
  const Fitted found =
      fit_chain(centre, omega, Quartic{0}, 0, centre == Centre::site ? 21 : 20, 1e-16, phase);
  return {{found.problem.chain.sites}, found.orbit.start, found.problem.period()};
}

KickedPath follow(const Resting& at, double c, double time, double step = 0.1) {
  return follow_kicked(EventCorrected{step}, at.chain, kicked(at.state, c),
                       sample_of_mean(at.period), time,
                       [](const KickedPath& path, const State<double>&, const auto&) {
                         return mobility_of(path) == Mobility::undecided;
                       });
}

/// A path through given places.
KickedPath path_of(std::vector<double> X) {
  KickedPath path;
  path.t.resize(X.size());
  path.centre = std::move(X);
  return path;
}

}  // namespace

TEST_CASE("a kick brings the energy c^2/2", "[unit][kick]") {
  const Resting at = breather(Centre::bond, 1.1);
  const double c = 1e-3;
  check_close(energy(at.chain, kicked(at.state, c)) - energy(at.chain, at.state), c * c / 2, 1e-18);
  CHECK_THROWS_AS(kick_direction(std::vector<double>(5, 0.0)), std::invalid_argument);
}

TEST_CASE("the samples of a mean are spread over eleven periods", "[unit][kick]") {
  const double period = 5.7, sample = sample_of_mean(period);
  check_close(5 * sample / period, 0.618033988749894848, 1e-15);  // the golden ratio
  check_close(samples_of_a_mean * sample, 11 * period, 0, 1e-4);
  // The mean of a place that swings with the breather is its middle, at the middle of the samples
  const Resting at = breather(Centre::bond, 1.1);
  const double apart = sample_of_mean(at.period);
  const KickedPath path =
      follow_kicked(EventCorrected{0.1}, at.chain, at.state, apart, 23 * at.period);
  REQUIRE(path.centre.size() == 2);
  check_close(path.centre[0], path.centre[1], 1e-4);
  check_close(path.t[0], 45 * apart, 0, 1e-12);
  check_close(path.t[1], (45 + 89) * apart, 0, 1e-12);
}

TEST_CASE("free and pinned are told from the path", "[unit][kick]") {
  CHECK(mobility_of(path_of({0.1, 0.2, 0.4})) == Mobility::undecided);
  CHECK(mobility_of(path_of({0.1, 0.4, 0.35})) == Mobility::pinned);
  CHECK(mobility_of(path_of({0.1, 0.4, 0.69})) == Mobility::undecided);  // 0.59 from its start
  CHECK(mobility_of(path_of({0.1, 0.4, 0.72})) == Mobility::free);
  CHECK(mobility_of(path_of({0.1, -0.4, -0.72})) == Mobility::free);
  CHECK(mobility_of(path_of({})) == Mobility::undecided);
}

TEST_CASE("a breather that is not kicked stays, and opposite kicks are mirror images",
          "[property][kick]") {
  const Resting at = breather(Centre::bond, 1.1);
  const KickedPath rest = follow(at, 0, 1000), right = follow(at, 1e-4, 1000),
                   left = follow(at, -1e-4, 1000);
  CHECK(std::abs(right.travelled()) > 0.2);
  CHECK(std::abs(rest.travelled()) < 1e-5 * std::abs(right.travelled()));
  check_close(right.travelled(), -left.travelled(), 2e-3);
  CHECK(right.travelled() < 0);  // against the kick: the mass is negative
}

TEST_CASE("the share of a kick tends to that of the DpS equation", "[convergence][kick]") {
  double last = 1;
  for (const double omega : {1.04, 1.02, 1.01}) {
    const Resting at = breather(Centre::bond, omega);
    const Pinning p = pinning_of(at.chain, Centre::bond, at.state, at.period);
    const double miss = std::abs(-3 * p.share / (omega - 1) - 1);
    CAPTURE(omega, p.share);
    CHECK(miss < 0.7 * last);
    last = miss;
  }
  CHECK(last < 0.05);
}

TEST_CASE("hill and trough have opposite curvatures of one size", "[property][kick]") {
  const Resting site = breather(Centre::site, 1.1), bond = breather(Centre::bond, 1.1),
                other = breather(Centre::bond, 1.1, Phase::stretched);
  const double hill = pinning_of(site.chain, Centre::site, site.state, site.period).frequency2;
  const double trough = pinning_of(bond.chain, Centre::bond, bond.state, bond.period).frequency2;
  const double later = pinning_of(other.chain, Centre::bond, other.state, other.period).frequency2;
  CHECK(trough > 0);
  check_close(trough, -hill, 0, 1e-4);
  check_close(trough, later, 0, 1e-5);  // both phases belong to one orbit
}

TEST_CASE("a breather swings at the frequency of linear theory", "[published][kick]") {
  const Resting at = breather(Centre::bond, 1.1);
  const double omega =
      std::sqrt(pinning_of(at.chain, Centre::bond, at.state, at.period).frequency2);
  const KickedPath path = follow(at, 2e-6, 8 / omega, 0.15);
  REQUIRE(mobility_of(path) == Mobility::pinned);
  std::size_t top = 0;
  for (std::size_t k = 0; k < path.centre.size(); ++k)
    if (std::abs(path.moved(k)) > std::abs(path.moved(top))) top = k;
  // A quarter of a period, a little longer than that of small swings.
  check_close(path.t[top] * omega, 1.571, 0.2);
}

TEST_CASE("the speed on the hill is that of the slowest place", "[unit][kick]") {
  const double V = 2e-6, Omega = 4e-5;
  KickedPath path;
  for (int k = 0; k < 2000; ++k) {
    const double t = 60 * k;
    if (k == 0 || t > 3e4) {
      path.t.push_back(t);
      path.centre.push_back(k == 0 ? 0.3
                                   : 0.3 - (0.5 + V / Omega * std::sinh(Omega * (t - 7.1e4))));
    }
    if (path.moved(path.centre.size() - 1) < -0.7) break;
  }
  check_close(hill_speed(path), V, 0, 2e-3);
  check_close(hill_speed(path, 0.52), V, 0, 1e-2);  // the top need not be in the middle
  CHECK(hill_speed(path, 0.6) > 1.2 * V);           // it is faster beyond the top
  CHECK_THROWS_AS(hill_speed(path, 0.9), std::invalid_argument);
}

TEST_CASE("a mean speed does not depend on where it begins", "[unit][kick]") {
  KickedPath path;
  for (int k = 0; k < 200; ++k) {
    path.t.push_back(10 * k);
    path.centre.push_back(0.2 - 0.01 * k - 0.1 * std::sin(0.02 * std::numbers::pi * k) / 2);
  }
  check_close(path.mean_speed(1), 1e-3, 1e-15);
  check_close(path.mean_speed(1, 7), 1e-3, 1e-8);  // a straight line between two means
  CHECK_THROWS_AS(path.mean_speed(3), std::runtime_error);
}

TEST_CASE("two speeds on the hill lead to the threshold", "[unit][kick]") {
  const auto speed = [](double c) { return 3 * std::sqrt(c * c - 4); };
  check_close(threshold_from(2.1, speed(2.1), 2.4, speed(2.4)), 2, 1e-14);
  CHECK_THROWS_AS(threshold_from(2.1, 3, 2.4, 3.1), std::invalid_argument);  // too flat
}

TEST_CASE("three free breathers know the kick that frees", "[published][kick]") {
  const RestingBreather at = resting_breather(Centre::bond, Phase::stretched, 1.1, 22);
  const Prediction p = predict_threshold(at, {-2.3522916e-13, 1e-17});
  check_close(p.threshold.value, 4.4516e-6, 0, 1e-4);
  const Estimate c = freeing_kick_of(at, p, EventCorrected{0.3});
  CHECK(c.error < 1e-3 * c.value);
  check_close(c.value, p.threshold.value, 0, 1e-3);
  const RestingBreather hill = resting_breather(Centre::site, Phase::compressed, 1.1, 22);
  CHECK_FALSE(predict_threshold(hill, {-2.3522916e-13, 1e-17}).exists());
}

TEST_CASE("what a strong kick sheds and the ends send back is in the error", "[cli][kick]") {
  // From chains of 212 sites, from whose ends nothing has come back by then
  const std::pair<std::string, double> far[] = {
      {"--omega 2 --c 0.2", -3.2342346594},
      {"--omega 2 --c 0.5", -8.0950373096},
      {"--omega 1.8 --c 0.2 --centre site", -7.0425377916}};
  for (const auto& [kick, way] : far) {
    const Result r = call("sec33_mobility kick --time 1000 " + kick);
    CAPTURE(kick, r.output);
    check_close(quantity(r, "sites_travelled"), way, quantity(r, "sites_travelled", "error"));
  }
}

namespace {

using Numbers = std::vector<double>;

void check_matrix(const Matrix<double>& found, const Matrix<double>& expected, double absolute) {
  REQUIRE((found.rows() == expected.rows() && found.cols() == expected.cols()));
  check_close((found - expected).cwiseAbs().maxCoeff(), 0, absolute);
}

KickedPath path_with(const Numbers& t, const Numbers& X) {
  KickedPath path;
  path.t = t, path.centre = X;
  return path;
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
  check_close(sample_of_mean(3), 3 * 0.1236067977499789696, 1e-14);
  check_close(breather_place({0, 1, 5, 2}), (2 + 15 + 8) / 8.0 - 2.5, 1e-14);
  CHECK(KickedPath{}.share == 1);
  CHECK(KickedPath{}.travelled() == 0);

  KickedPath path = path_with({0, 1, 2, 4, 5}, {3, 3.5, 2, 1.2, 1.6});
  check_close(path.farthest(), 1.8, 1e-14);
  check_close(path.travelled(), -1.4, 1e-14);
  check_close(path.speed_during(1, 4).value,
              ((1 - 7 / 3.0) * 3.5 + (2 - 7 / 3.0) * 2 + (4 - 7 / 3.0) * 1.2) / (14 / 3.0), 1e-13);
  check_close(path.mean_speed(1.4), 1.4 / (2 + 2 * 0.4 / 0.8), 1e-14);
  check_close(path.mean_speed(0.5), 0.5 / 1, 1e-14);
  check_close(path.mean_speed(2, 1), 2 / (2 + 2 * 0.5 / 0.8 - 1), 1e-14);
  CHECK_THROWS_AS(path.mean_speed(1.81), std::runtime_error);
  path.run.energy_drift = 1e-8;
  check_close(path.drift_margin(3, 5), 9 / 10.0 / 1e-8, 0, 1e-13);
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
