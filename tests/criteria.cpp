// Statements in words: each criterion holds for what the words describe and fails for what they do not.

#include "lattice/measure/criteria.hpp"

#include <complex>

#include "check.hpp"
#include "lattice/dps/impact.hpp"
#include "lattice/measure/impact.hpp"

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
  }
}

TEST_CASE("similar curves do not meet", "[unit][criteria]") {
  CHECK(holds(meet({{1e-4, 1e-5}, {1e-2, 1e-5}})));
  CHECK_FALSE(holds(meet({{0.02, 1e-5}, {0.2, 1e-5}})));   // too far apart
  CHECK_FALSE(holds(meet({{5e-3, 1e-5}, {5e-3, 1e-5}})));  // parallel
  CHECK_FALSE(holds(meet({{1e-4, 9e-3}, {1e-2, 9e-3}})));  // not known well enough
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
    const Outcome out =
        follow(ContactAware{0.1}, {1.87, s, 400, 130}, far_away, 400.0, Unwatched{});
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
