// What leads to the waves of the kernel equation, step by step: the ascent, false position, tolerances of the flow.

#include <functional>

#include "check.hpp"
#include "lattice/gsl/random.hpp"
#include "sec5/quotient.hpp"
#include "sec5/travelling.hpp"
#include "sec5/wave_zeros.hpp"

namespace ascent_again {

using namespace lattice;

namespace {

const PowerContact hertz{1.5, 0}, square{2, 0};

Vector<double> sampled(const Vector<double>& t, const std::function<double(double)>& of) {
  Vector<double> values = t;
  for (double& x : values) x = of(x);
  return values;
}

/// A wave that dies out within the first shift, for tests of what is done with its state.
KernelWave toy() {
  const HalfLine line(1.5, {0, 0.75}, 1, Panel(4, 2));
  return {hertz, line, sampled(line.t(), [](double t) { return 0.5 - t / 15; })};
}

}  // namespace

TEST_CASE("a plain grid sums the kernel and corrects its kinks", "[unit][kernel]") {
  const double shift_time = 2 * pi<double>();
  const std::size_t per = 6;
  const PlainLine line(shift_time, 4, per);
  const double h = shift_time / 6;
  REQUIRE(line.t().size() == 24);
  check_close(line.length(), 4 * shift_time, 1e-13);
  CHECK((line.weight().size() == 24 && line.weight().isApproxToConstant(h, 1e-14)));
  for (int i = 0; i < 24; ++i) check_close(line.t()[i], h * i, 1e-13);
  const Vector<double> f =
      sampled(line.t(), [](double t) { return 1 + std::sin(0.37 * t * t + 1); });
  const Vector<double> d = line.convolve(f);
  for (int i = 0; i < 24; ++i) {
    double sum = 0;
    for (int j = std::max(0, i - 6); j <= std::min(23, i + 6); ++j)
      sum -= h * std::sin(h * std::abs(i - j)) * f[j];
    sum += h * h / 12 * ((i + 6 < 24 ? f[i + 6] : 0) - 2 * f[i] + (i >= 6 ? f[i - 6] : 0));
    CAPTURE(i);
    check_close(d[i], sum, 1e-12);
  }
  // The same random numbers on every grid of an interval, joined by straight lines
  const std::size_t pieces = 5;
  Random random(17);
  double values[6];
  for (double& x : values) x = random.uniform(0, 1);
  for (const PlainLine& grid : {line, PlainLine(2 * shift_time, 2, 7)}) {
    const Vector<double> u = random_start(grid, pieces, 17);
    for (Eigen::Index i = 0; i < u.size(); ++i) {
      const double place = double(i) / double(u.size()) * 5, left = std::floor(place);
      check_close(u[i],
                  (left + 1 - place) * values[int(left)] + (place - left) * values[int(left) + 1],
                  1e-14);
    }
  }
}

TEST_CASE("the ascent goes up step by step", "[unit][kernel]") {
  // A symmetric matrix instead of the convolution; its third place begins and stays at zero
  Matrix<double> k(3, 3);
  k << 0.2, 0.9, -4, 0.9, -0.7, 0.1, -4, 0.1, -3;
  const auto convolve = [&](const Vector<double>& f) { return Vector<double>(k * f); };
  const Vector<double> weight{{0.5, 2, 1}}, start{{0.3, 1.7, -1}};
  // The steps of the header, written once more; f = u^2, so that the norm of f is that of u^3
  const auto unit = [&](Vector<double> u) {
    u = u.cwiseMax(0);
    return Vector<double>(u / std::cbrt(weight.dot(Vector<double>(u.array().cube()))));
  };
  const auto quotient = [&](const Vector<double>& u) {
    const Vector<double> f = u.array().square();
    return weight.dot(f.cwiseProduct(k * f));
  };
  for (std::size_t most : {0, 1, 4, 40}) {
    Vector<double> u = unit(start);
    std::vector<double> quotients{quotient(u)};
    double mu = 1;
    std::size_t refused = 0;
    for (std::size_t i = 0; i < most; ++i) {
      const Vector<double> next = unit(k * Vector<double>(u.array().square()) + mu * u);
      if (quotient(next) > quotients.back()) {
        u = next, mu *= 0.8, quotients.push_back(quotient(u));
      } else {
        mu *= 2, ++refused;
      }
      if (mu >= 1e6) break;
    }
    const Ascent course = ascend(convolve, weight, square, start, -1, most);
    CAPTURE(most, refused);
    REQUIRE(course.quotients.size() == quotients.size());
    for (std::size_t i = 0; i < quotients.size(); ++i)
      check_close(course.quotients[i], quotients[i], 1e-11);
    check_close((course.u.cwiseMax(0) - u).norm(), 0, 1e-7);
    check_close((course.image - k * Vector<double>(course.u.cwiseMax(0).array().square())).norm(),
                0, 1e-12);
    check_close((course.wave(square) - course.image / std::pow(course.quotient(), 2)).norm(), 0,
                1e-12);
    if (most == 40) CHECK(refused > 3);
  }
}

TEST_CASE("an ascent rests when its last steps gain little", "[unit][kernel]") {
  const Ascent course{{}, {}, {1, 2, 3, 3.5, 4}};
  for (const auto& [gain, over, rests] : {std::tuple{0.13, 1, true},
                                          {0.125, 1, false},
                                          {0.12, 1, false},
                                          {0.13, 2, true},
                                          {0.124, 2, false},
                                          {0.19, 4, true},
                                          {0.18, 4, false},
                                          {10.0, 5, false},
                                          {10.0, 4, true}})
    CHECK(course.rests(gain, std::size_t(over)) == rests);
  const Ascent early{{}, Vector<double>{{1, 2}}, {0.2, 0.25}};
  for (const auto& [alpha, power] :
       {std::pair{1.5, 64.0}, {3.0, 8.0}})  // of 1/4 to alpha / (alpha - 1)
    CHECK(early.wave({alpha, 0}).isApprox(power * early.image, 1e-13));
  CHECK(early.rests(0.21, 1));
  CHECK_FALSE(early.rests(0.19, 1));
  // By default it is the last step alone
  const auto same = [](const Vector<double>& f) { return Vector<double>(f * 1.0); };
  const Vector<double> one{{1, 2}};
  CHECK(ascend(same, one, hertz, one, 10, 50).quotients.size() == 2);
  CHECK(ascend(same, one, hertz, one, 10, 50, 3).quotients.size() == 4);
  // Where nothing goes up, the share of the old is doubled until it is a million
  int tries = 0;
  const auto counted = [&](const Vector<double>& f) { return ++tries, Vector<double>(0 * f); };
  CHECK(ascend(counted, one, hertz, one, 1e-9, 400).quotients.size() == 1);
  CHECK(tries == 21);
}

TEST_CASE("a zero is found by false position that does not stay at one end", "[unit][kernel]") {
  std::vector<double> met;
  const auto seen = [&](auto of) {
    return [&met, of](double x) {
      met.push_back(x);
      return of(x);
    };
  };
  CHECK(std::isnan(zero_between(0.0, 1.0, [](double x) { return x + 1; })));
  CHECK(std::isnan(zero_between(0.0, 1.0, [](double x) { return x; })));
  CHECK(std::isnan(zero_between(0.0, 0.5, [](double x) { return x - 0.5; })));
  // Values of one sign whose product is less than one, and of two signs whose product is small
  CHECK(std::isnan(zero_between(0.0, 1.0, [](double x) { return 0.1 * (x + 1); })));
  check_close(zero_between(0.0, 1.0, [](double x) { return 1e-3 * (x - 0.25); }), 0.25, 1e-12);
  for (double sign : {1.0, -1.0})
    for (double at : {2.0, -2.0}) {
      // x^3 - 2 on (0, 2), from either side: the ends that stay twice count half
      met.clear();
      const auto cubic = [=](double x) { return sign * 0.1 * (std::pow(x * at / 2, 3) - 2); };
      const double low = at > 0 ? 0 : -2, high = at > 0 ? 2 : 0;
      const double found = zero_between(low, high, seen(cubic));
      check_close(found, at / 2 * std::cbrt(2.0), 1e-9);
      double a = low, b = high, f_a = cubic(a), f_b = cubic(b), x = a;
      std::vector<double> expected{a, b};
      for (int kept = 0;;) {
        const double old = x;
        x = a - f_a * (b - a) / (f_b - f_a);
        if (std::abs(x - old) < 1e-7) break;
        expected.push_back(x);
        const bool left = (cubic(x) > 0) == (f_a > 0);
        (left ? a : b) = x, (left ? f_a : f_b) = cubic(x);
        if (kept == (left ? 1 : -1)) (left ? f_b : f_a) *= 0.5;
        kept = left ? 1 : -1;
      }
      CHECK(expected.size() > 6);
      REQUIRE(met.size() == expected.size());
      for (std::size_t i = 0; i < met.size(); ++i) check_close(met[i], expected[i], 1e-8);
    }
  const Estimate apart = spacing({1.5, 0.01}, {1.2, 0.002});
  check_close(apart.value, 3, 1e-13);
  check_close(apart.error, 0.04 + 0.05, 1e-13);
}

TEST_CASE("kappa is that of the lattice's flow, with the first tolerance that it reaches",
          "[unit][kernel]") {
  const auto kappa = [](const KernelWave& w, double times) {
    Chain chain{18};
    chain.contact = w.law;
    EventTolerance<double> rule;
    rule.tolerance *= times;
    try {
      return phase_kappa(multipliers_of(shifted_map(chain, w.state(8), w.shift_time(), rule)));
    } catch (const NewtonFailed&) {
      return std::nan("");
    }
  };
  KernelWave w = toy();
  for (double alpha : {1.5, 2.0, 4. / 3}) {
    w.law.exponent = alpha;
    for (double times : {1e6, 1e4}) {
      const double expected = kappa(w, alpha < 1.4 ? 8 * times : times);
      CHECK(std::isfinite(expected));
      CHECK(kappa_of(w, times) == expected);
      CHECK(expected != kappa(w, alpha < 1.4 ? times : 8 * times));
    }
  }
  // Eight tolerances are tried, each eight times the one before
  w = toy();
  double first = 0x1p-15;
  while (first > 0x1p-60 && std::isfinite(kappa(w, first / 8))) first /= 8;
  const double expected = kappa(w, first);
  REQUIRE((first > 0x1p-60 && std::isfinite(expected)));
  CHECK(kappa_of(w, first * 0x1p-21) == expected);
  CHECK(std::isnan(kappa_of(w, first * 0x1p-24)));
}

}  // namespace ascent_again
