// What is watched on a ring a second time: peaks and their paths by plain loops, random fields from the same numbers; and
// the travelling breathers of the DpS equation, their equations and their first guess.

#include <functional>

#include "check.hpp"
#include "lattice/gsl/random.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "lattice/standing/stationary.hpp"
#include "sec5/dps_tracks.hpp"
#include "sec5/dps_travelling.hpp"

namespace dps_tracks_again {

using namespace lattice;

namespace {

using std::numbers::pi;
using Complex = std::complex<double>;
using Numbers = std::vector<double>;

/// The way from a to b on a ring, the short way round.
double way(double a, double b, double sites) {
  const double d = b - a;
  return d - sites * std::floor(d / sites + 0.5);
}

struct Path {
  Numbers tau, centre;
  double norm = 0, energy = 0;
  std::size_t last = 0;  ///< sample
};

/// All paths of peaks: more than three times the mean norm on five sites to begin, twice to go on.
std::vector<Path> paths_again(const Numbers& tau, const std::vector<Field>& fields) {
  std::vector<Path> paths;
  for (std::size_t t = 0; t < tau.size(); ++t) {
    const int n = int(fields[t].size());
    const auto at = [&](int i) { return fields[t][std::size_t((i + 5 * n) % n)]; };
    const auto sum = [&](int i, const std::function<double(int)>& f, int from, int to) {
      double all = 0;
      for (int k = from; k <= to; ++k) all += f(i + k);
      return all;
    };
    const auto modulus = [&](int i) { return std::norm(at(i)); };
    const auto five = [&](int i) { return sum(i, modulus, -2, 2); };
    const double mean = 5 * sum(0, modulus, 0, n - 1) / n;
    for (int i = 0; i < n; ++i) {
      const double here = five(i), ahead = std::max(five(i + 1), five(i + 2)),
                   behind = std::max(five(i - 1), five(i - 2));
      if (!(here > 2 * mean && here >= ahead && here > behind)) continue;
      double centre = i;
      for (int k : {1, 2}) centre += k * (modulus(i + k) - modulus(i - k)) / here;
      Path* best = nullptr;
      for (Path& p : paths)
        if (p.last + 1 == t && std::abs(way(p.centre.back(), centre, n)) < 1.5 &&
            (!best || std::abs(way(p.centre.back(), centre, n)) <
                          std::abs(way(best->centre.back(), centre, n))))
          best = &p;
      if (!best && here <= 3 * mean) continue;
      if (!best) best = &paths.emplace_back();
      best->centre.push_back(
          best->tau.empty() ? centre : best->centre.back() + way(best->centre.back(), centre, n));
      best->tau.push_back(tau[t]), best->last = t, best->norm += here;
      best->energy += sum(
          i, [&](int k) { return 0.4 * std::pow(std::abs(at(k + 1) - at(k)), 2.5); }, -3, 2);
    }
  }
  return paths;
}

/// Peaks that come and go on a ring, each on its own way, above a sea.
std::vector<Field> sea(const Numbers& tau, std::size_t sites, double level) {
  std::vector<Field> out;
  for (double t : tau) {
    Field field(sites);
    for (std::size_t n = 0; n < sites; ++n) {
      Complex a = level * std::polar(1.0, 1.3 * double(n * n) + 0.4 * t);
      for (int k = 0; k < 5; ++k) {
        const double speed = std::array{0.1, -0.9, 1.42, 1.6, -0.4}[std::size_t(k)];
        const double d = way(8.0 * k + speed * t, double(n), double(sites));
        a += (1.2 + std::sin((0.3 + 0.1 * k) * t)) * std::exp(-d * d / 2) *
             std::polar(1.0, 2.0 * double(n) + k);
      }
      field[n] = a;
    }
    out.push_back(field);
  }
  return out;
}

}  // namespace

TEST_CASE("peaks on a ring and their paths, by plain loops", "[unit][dps_tracks]") {
  Numbers tau;
  for (int t = 0; t < 60; ++t) tau.push_back(0.5 + t);
  int count = 0, weak = 0;
  for (double level : {0.1, 0.3, 0.5})
    for (std::size_t sites : {37, 44})
      for (double least : {2.0, 3.0, 6.0}) {
        const std::vector<Field> fields = sea(tau, sites, level);
        BreatherWatch watch(least);
        for (std::size_t t = 0; t < tau.size(); ++t) watch.look(tau[t], fields[t]);
        const auto seen = watch.breathers();
        std::size_t k = 0;
        for (const Path& p : paths_again(tau, fields)) {
          const double lived = p.tau.back() - p.tau.front(), size = double(p.tau.size());
          if (lived < least) {
            ++weak;
            continue;
          }
          REQUIRE(k < seen.size());
          const BreatherTrack& b = seen[k++];
          CAPTURE(level, sites, k);
          check_close(b.born, p.tau.front(), 0);
          check_close(b.lived, lived, 0);
          check_close(b.norm, p.norm / size, 0, 1e-12);
          check_close(b.energy, p.energy / size, 0, 1e-12);
          check_close(b.speed, fit_line(p.tau, p.centre).slope, 1e-11);
          const auto [low, high] = std::minmax_element(p.centre.begin(), p.centre.end());
          check_close(b.strayed, *high - *low, 1e-11);
          ++count;
        }
        CHECK(k == seen.size());
      }
  CHECK(count > 50);
  CHECK(weak > 20);
  const BreatherTrack none;
  CHECK(none.born + none.lived + none.norm + none.energy + none.speed + none.strayed == 0);
}

TEST_CASE("random fields, shares and static breathers in plain numbers", "[unit][dps_tracks]") {
  Random random(5), other(9);
  Complex part = 0;
  double all = 0;
  Field noisy = noisy_wave(10, 3, 0.2, 5);
  noisy.push_back(100), noisy.pop_back();  // what lies behind the end does not count
  for (std::size_t n = 0; n < 10; ++n) {
    const double x = random.uniform(-0.2, 0.2), y = random.uniform(-0.2, 0.2);
    const Complex a = std::polar(1.0, 0.6 * pi * double(n)) * Complex(1 + x, y);
    check_close(std::abs(noisy[n] - a), 0, 1e-14);
    part += a * std::polar(1.0, -1.1 * double(n)), all += std::norm(a);
  }
  check_close(wave_share(noisy, 1.1), std::norm(part) / 10 / all, 1e-14);
  // Moduli whose squares decay exponentially, phases of a full turn
  Field drawn(10);
  double sum = 0;
  for (auto& a : drawn) {
    const double u = other.uniform(0, 1), turn = other.uniform(0, 1);
    a = std::polar(std::sqrt(std::log(1 / (1 - u))), 2 * pi * turn), sum += std::norm(a);
  }
  const Field field = random_field(10, 9);
  for (std::size_t n = 0; n < 10; ++n)
    check_close(std::abs(field[n] - drawn[n] / std::sqrt(sum / 10)), 0, 1e-13);
  double unit = 0;
  for (double u : stationary<double>(Centre::site, 1.0, 31).u) unit += u * u;
  for (double N : {0.02, 1.0, 20.0})
    check_close(static_energy(N), 0.4 * N * std::pow(N / unit, 0.25), 0, 1e-12);
  check_close(rate_below(0, 2), -std::log(0.05) / 2, 1e-13);
}

TEST_CASE("equations of a travelling breather of the DpS equation", "[unit][travelling]") {
  DpsTravelling problem;
  CHECK((problem.reach == 8 && problem.phase == 0 && DpsTravelling::shift_time == 2 * pi));
  CHECK(problem.tolerance == 1e-13);
  problem.reach = 3, problem.phase = 0.7;
  Vector<double> x(7);
  x << 0.5, -0.2, 0.3, 0.1, 0.05, -0.03, 0.02;
  const auto misses = [&](const Vector<double>& u) {
    // Sites -3 to 4; those on the left are the mirror images
    Field a{{-u[5], u[6]}, {-u[3], u[4]}, {-u[1], u[2]}, {0, u[0]},
            {u[1], u[2]},  {u[3], u[4]},  {u[5], u[6]},  0};
    evolve_dps(Dps{8}, a, pi, 1, 1e-13, [](double, const Field&) {});
    Vector<double> out(8);
    for (int n = 1; n <= 4; ++n) {
      const Complex w = std::polar(1.0, -0.35) * a[std::size_t(3 + n)],
                    v = std::polar(1.0, -0.35) * a[std::size_t(4 - n)];
      out[2 * n - 2] = (w + v).real(), out[2 * n - 1] = (w - v).imag();
    }
    return out;
  };
  const Vector<double> expected = misses(x), all = problem.misses(x);
  const Shot<double> shot = problem.shoot(x, {}), bare = problem.shoot(x, {}, false);
  for (int i = 0; i < 8; ++i) check_close(all[i], expected[i], 1e-11);
  CHECK((shot.miss == all.tail(7) && bare.miss == shot.miss && bare.jacobian.size() == 0));
  for (int k = 0; k < 7; ++k) {
    const Vector<double> e = 1e-5 * Vector<double>::Unit(7, k),
                         slope = (misses(x + e) - misses(x - e)) / 2e-5;
    for (int i = 0; i < 7; ++i) check_close(shot.jacobian(i, k), slope[i + 1], 2e-7);
    check_close(problem.sizes(x, false).unknown[k], 0.5, 0);
    check_close(problem.sizes(x, true).equation[k], 0.5, 0);
  }
}

TEST_CASE("a first guess is cut from the packet of an impact", "[unit][travelling]") {
  const double from = 7;
  const std::size_t reach = 3, sites = 16, samples = std::size_t(15 / 0.34 * 20);
  Field field(sites), best;
  field[0] = {0, -1};
  Numbers time, place;
  double least = 1e9;
  std::size_t peak = 0;
  evolve_dps(Dps{sites}, field, 15 / 0.34, samples, 1e-9, [&](double tau, const Field& now) {
    Numbers d;
    for (const Complex& a : now) d.push_back(std::norm(a));
    const auto c = front_packet(d);
    if (!c || *c + reach >= sites) return;
    double sum = 0, moment = 0;
    for (int n = std::max(0, int(*c) - 5); n <= std::min(int(sites) - 1, int(*c) + 5); ++n)
      sum += d[std::size_t(n)], moment += (n + 1) * d[std::size_t(n)];
    if (moment / sum < from) return;
    time.push_back(tau), place.push_back(moment / sum);
    const double skew = std::abs(d[*c + 1] - d[*c - 1]) / d[*c];
    if (skew < least) least = skew, best = now, peak = *c;
  });
  const double ratio = (time.back() - time[0]) / (place.back() - place[0]) / (2 * pi);
  const Vector<double> x = cut_dps_packet(from, reach);
  REQUIRE(x.size() == 7);
  for (std::size_t n = 0; n <= reach; ++n) {
    // The centre becomes -i times its modulus
    const Complex a =
        ratio * ratio * best[peak + n] * Complex(0, -1) / best[peak] * std::abs(best[peak]);
    if (n == 0) check_close(x[0], a.imag(), 1e-9);
    if (n > 0) check_close(x[2 * Eigen::Index(n) - 1], a.real(), 1e-9);
    if (n > 0) check_close(x[2 * Eigen::Index(n)], a.imag(), 1e-9);
  }
}

}  // namespace dps_tracks_again
