// Intervals and what is made of them once more: every end is computed a second time.

#include <array>
#include <vector>

#include "check.hpp"
#include "sec5/circle.hpp"
#include "sec5/contraction.hpp"
#include "sec5/counted.hpp"

namespace circle_again {

using namespace lattice;

namespace {

using Number = Interval<double>;
using Long = long double;

const double largest = std::numeric_limits<double>::max(), infinite = HUGE_VAL, ulp = 0x1p-52;
const Long pi_l = std::acos(Long(-1));

void check_ends(const Number& x, double lower, double upper) {
  CAPTURE(x.lower, x.upper, lower, upper);
  CHECK(x.lower == lower);
  CHECK(x.upper == upper);
}
void check_all(const Number& x) {
  check_ends(x, -infinite, infinite);
}

}  // namespace

TEST_CASE("the ends of an operation are those of its corners, moved by one number", "[unit]") {
  const Number some[] = {{2, 3},   {-3, -2}, {-2, 3},     {5, 7},
                         {-7, -5}, {-7, 5},  {0.25, 0.5}, {-0.5, -0.25}};
  for (const Number& a : some)
    for (const Number& b : some) {
      check_ends(a + b, below(a.lower + b.lower), above(a.upper + b.upper));
      check_ends(a - b, below(a.lower - b.upper), above(a.upper - b.lower));
      const auto corners = [&](auto of) {
        return std::array{of(a.lower, b.lower), of(a.lower, b.upper), of(a.upper, b.lower),
                          of(a.upper, b.upper)};
      };
      const auto least = [](const auto& c) { return below(*std::min_element(c.begin(), c.end())); };
      const auto most = [](const auto& c) { return above(*std::max_element(c.begin(), c.end())); };
      const auto products = corners([](double x, double y) { return x * y; });
      check_ends(a * b, least(products), most(products));
      if (b.contains(0.0)) continue;
      const auto quotients = corners([](double x, double y) { return x / y; });
      check_ends(a / b, least(quotients), most(quotients));
    }
  CHECK(below(1.0) == 1 - ulp / 2);
  CHECK(above(1.0) == 1 + ulp);
  Number sum(1, 2);
  check_ends(sum -= Number(3, 5), below(-4.0), above(-1.0));
  check_ends(-Number(1, 2), -2, -1);
  check_ends(Number(), 0, 0);
}

TEST_CASE("what is no number gives all numbers", "[unit]") {
  check_all(Number::all());
  for (const Number& zero :
       {Number(0, 1), Number(-1, 0), Number(-1, 0.5), Number(-0.5, 1), Number(0)})
    for (const Number& a : {Number(1, 2), Number(0), Number(-1, 0)}) check_all(a / zero);
  // Zero times infinity, at each place and from both sides
  for (const Number& wide : {Number(1, infinite), Number(-infinite, 1), Number::all()})
    check_all(wide * Number(0)), check_all(Number(0) * wide);
  CHECK(Number(-largest, largest).finite());
  CHECK_FALSE(Number(-infinite, 1).finite());
  CHECK_FALSE(Number(1, infinite).finite());
}

TEST_CASE("questions about intervals are answered at their ends", "[unit]") {
  const Number a(1, 2);
  CHECK((a.contains(1.0) && a.contains(2.0) && a.contains(a)));
  CHECK_FALSE(
      (a.contains(0.5) || a.contains(3.0) || a.contains(Number(0, 2)) || a.contains(Number(1, 3))));
  CHECK_FALSE((a < Number(2, 3) || Number(2, 3) > a || a > Number(2, 3)));
  CHECK((a <= Number(2, 3) && Number(2, 3) >= a && a < Number(3, 4) && Number(3, 4) > a));
  CHECK_FALSE((a <= Number(1, 3) || a >= Number(1, 3)));
  CHECK(Number(1, 3).middle() == 2);
  CHECK(Number(1, 3).radius() == above(above(1.0)));
  CHECK(Number(1, 1 + ulp).radius() == above(above(ulp)));  // the middle is rounded to one end
  CHECK(Number(1 + ulp, 1 + 2 * ulp).radius() == above(above(ulp)));  // and to the other
  CHECK(magnitude(Number(-3, 2)) == 3);
  CHECK(magnitude(Number(-3, 4)) == 4);
  check_ends(abs(Number(0.25, 2)), 0.25, 2);
  check_ends(abs(Number(-2, -0.25)), 0.25, 2);
  check_ends(abs(Number(-2, 0.5)), 0, 2);
  check_ends(hull(Number(1, 4), Number(2, 3)), 1, 4);
  check_ends(hull(Number(2, 3), Number(1, 4)), 1, 4);
  check_ends(common(Number(1, 3), Number(2, 4)), 2, 3);
  check_ends(common(Number(1, 4), Number(2, 3)), 2, 3);
  CHECK(empty(common(Number(1, 2), Number(3, 4))));
  CHECK_FALSE(empty(Number(1)));
  check_ends(positive_part(Number(-2, -1)), 0, 0);
  check_ends(positive_part(Number(-2, 0.5)), 0, 0.5);
  check_ends(positive_part(Number(0.25, 0.5)), 0.25, 0.5);
}

TEST_CASE("a root is verified, however it was guessed", "[unit]") {
  const auto rounded = [](const Number& s) { return s * s; };
  const auto exact = [](const Number& s) { return Number(s.lower * s.lower, s.upper * s.upper); };
  // Bounds that are right as they are need no other ones
  check_ends(verified_root(Number(4), above(2.0), below(2.0), exact), 2, 2);
  // The distances from wrong guesses are 1, 3, 9, ... numbers
  check_ends(verified_root(Number(4), 2 + 5 * 2 * ulp, 2 - 5 * ulp, rounded), 2 - 4 * 2 * ulp,
             2 + 4 * ulp);
  check_ends(verified_root(Number(0.25), 0.5 + 5 * ulp / 2, 0.5 - 5 * ulp / 4, rounded),
             0.5 - 4 * ulp / 2, 0.5 + 4 * ulp / 4);
  CHECK(verified_root(Number(0, largest), 0.0, below(largest), rounded).upper == infinite);
  check_ends(root(Number(0)), 0, 0);
  check_ends(root(Number(-2, -1)), 0, 0);
  CHECK(root(Number(0, 4)).lower == 0);
  for (const auto& [found, low, high] : {std::tuple{root(Number(4, 9)), 2.0, 3.0},
                                         {root(Number(1)), 1.0, 1.0},
                                         {cube_root(Number(8, 27)), 2.0, 3.0},
                                         {cube_root(Number(1)), 1.0, 1.0},
                                         {hertz(Number(4, 9)), 8.0, 27.0},
                                         {hertz(Number(0.25)), 0.125, 0.125}}) {
    CHECK((low * (1 - 4 * ulp) <= found.lower && found.lower < low));
    CHECK((high < found.upper && found.upper <= high * (1 + 4 * ulp)));
  }
  CHECK(hertz(Number(-1, 1)).lower == 0);
  check_all(root(Number(1, infinite)));
  check_all(cube_root(Number(1, infinite)));
}

TEST_CASE("the lemma holds up to its bounds and no further", "[unit]") {
  using C = Contraction<double>;
  CHECK(C{}.radius == 0);
  CHECK_FALSE(C{0, 0.5}.holds());
  CHECK(C{0, 0, 0.5}.holds());
  CHECK_FALSE(C{0, -0.5, 1}.contracts());
  CHECK_FALSE(C{2, 0.5, 1}.holds());  // contracts, but leaves the ball
  CHECK_FALSE(C{0, 0.5, 0}.stays_inside());
  // eta + q r, rounded upwards three times, is the radius itself, and one number more
  CHECK(C{0.5 - ulp, 0.5, 1}.stays_inside());
  CHECK_FALSE(C{0.5 - ulp / 2, 0.5, 1}.stays_inside());
  CHECK(C{0, 0.5, 0.25}.stays_inside());
  // The ball may be halved sixty times
  const auto small = [](double radius) {
    return [=](double r) { return r <= radius ? 0.5 : 2.0; };
  };
  const auto balls = two_balls(0x1p-62, 1.0, small(0x1p-60));
  CHECK(balls.first.radius == 0x1p-60);
  CHECK_THROWS_AS(two_balls(0x1p-63, 1.0, small(0x1p-61)), NotProved);
  // The small ball: three times eta / (1 - q), enlarged by 1/1024
  const auto q = [](double r) { return 0.5 + r; };
  const auto [unique, exists] = two_balls(0.01, 0.25, q);
  CHECK(unique.radius == 0.25);
  double radius = 0.25;
  for (int i = 0; i < 3; ++i) radius = 0.01 * (1 + 1.0 / 1024) / (1 - q(radius));
  check_close(exists.radius, radius, 0, 1e-14);
  CHECK(exists.q == q(exists.radius));
  // A ball that would have to be larger stays as it is, and is refused if the map leaves it
  CHECK(two_balls(0.4999, 1.0, [](double) { return 0.5; }).second.radius == 1);
  int calls = 0;
  CHECK_THROWS_AS(two_balls(0.1, 1.0, [&](double) { return ++calls < 2 ? 0.5 : 0.999; }),
                  NotProved);
}

TEST_CASE("eigenvalues are counted up to the last number that has an answer", "[unit]") {
  // 5 and 5 +- sqrt(0.09 + 0.0625): tridiagonal with different numbers everywhere
  std::vector<Number> diagonal{Number(5), Number(5), Number(5), Number(100)},
      beside{Number(0.3), Number(0.25), Number(9)};
  diagonal.pop_back(), beside.pop_back();  // what stays behind the ends does not count
  const double far = std::sqrt(0.3 * 0.3 + 0.25 * 0.25);
  for (const auto& [x, count] :
       {std::pair{4.5, 3u}, {4.7, 2u}, {4.9, 2u}, {5.1, 1u}, {5.3, 1u}, {5.5, 0u}})
    CHECK(counted_above(diagonal, beside, x) == count);
  const double exact[] = {5 + far, 5, 5 - far};
  for (std::size_t k = 1; k <= 3; ++k) {
    const Number found = enclosed_eigenvalue(diagonal, beside, k, 1.0, 8.0);
    check_close(found.lower, exact[k - 1], 1e-14);
    check_close(found.upper, exact[k - 1], 1e-14);
    CHECK(counted_above(diagonal, beside, found.lower).value_or(0) == k);
    CHECK(counted_above(diagonal, beside, above(found.lower)).value_or(0) < k);
    CHECK(counted_above(diagonal, beside, found.upper).value_or(k) == k - 1);
    CHECK(counted_above(diagonal, beside, below(found.upper)).value_or(k) >= k);
  }
  // What cannot be answered, or is answered in the negative, leaves all numbers
  const std::vector<Number> one{Number(1)}, none;
  for (double end : {5e-324, -5e-324})  // one end of the pivot is zero
    CHECK_FALSE(counted_above(std::vector<Number>{Number(end)}, none, 0.0).has_value());
  CHECK(counted_above(std::vector<Number>{Number(1e-323)}, none, 0.0) == 1);
  CHECK(counted_above(std::vector<Number>{Number(-1e-323)}, none, 0.0) == 0);
  CHECK_FALSE(counted_above(std::vector<Number>{Number(-0.5, 0.5)}, none, 0.0).has_value());
  check_all(enclosed_eigenvalue(one, none, 1, 1.0, 2.0));
  check_all(enclosed_eigenvalue(one, none, 1, 0.0, 1.0));
  check_all(enclosed_eigenvalue(one, none, 1, 2.0, 3.0));
  check_all(enclosed_eigenvalue(one, none, 1, -1.0, 0.0));
  check_close(enclosed_eigenvalue(one, none, 1, 0.0, 2.0).middle(), 1, 1e-15);
}

TEST_CASE("cosines are enclosed by a series of twenty terms", "[unit]") {
  check_ends(enclosed_cosine(Number(0)), 1 - 21 * ulp / 2,
             1);  // twenty terms and the rest, each rounded
  for (double x : {-4.0, -3.14159, -1.0, 0.5, 2.0, 3.14159, 4.0}) {
    const Number found = enclosed_cosine(Number(x));
    CHECK((found.lower <= std::cos(Long(x)) && std::cos(Long(x)) <= found.upper));
    CHECK(found.radius() < 1e-13);
  }
  CHECK(enclosed_cosine(Number(3.1415926)).lower == -1);
  check_ends(enclosed_cosine(Number(-4.0000001, 1)), -1, 1);
  check_ends(enclosed_cosine(Number(4.5)), -1, 1);
  CHECK((enclosed_pi().lower < pi_l && pi_l < enclosed_pi().upper));
  CHECK(enclosed_pi().upper == above(enclosed_pi().lower));
  CHECK(enclosed_cosine(Number(2)).contains(enclosed_cosine(Number(2)).middle()));
}

TEST_CASE("the error of a table is its largest radius", "[unit]") {
  const std::size_t n = 24;
  const CosineTable table(n);
  double radius = 0;
  for (std::size_t j = 0; j <= n / 4; ++j) {
    const Number c = enclosed_cosine(Number(2) * enclosed_pi() * double(j) / double(n));
    radius = std::max(radius, c.radius());
    CHECK(table.cosine[j] == c.middle());
  }
  CHECK(table.error == radius);
  for (std::size_t j = 0; j < n; ++j) {
    CHECK(std::abs(table.cosine[j] - std::cos(2 * pi_l * Long(j) / n)) <= table.error);
    // Its symmetries are exact
    CHECK(table.cosine[j] == table.cosine[(n - j) % n]);
    if (j % (n / 4)) CHECK(table.cosine[j] == -table.cosine[(n + n / 2 - j) % n]);
  }
}

TEST_CASE("sums of cosines and their errors", "[unit]") {
  const auto gamma = [](std::size_t n) { return Long(n) * 0x1p-53L / (1 - Long(n) * 0x1p-53L); };
  for (std::size_t n : {1, 5, 1000000}) {
    CHECK(rounding_of_sum(n) >= gamma(n));
    check_close(rounding_of_sum(n), double(gamma(n)), 0, 1e-15);
  }
  check_close(rounding_of_sum(std::size_t(1) << 51), 1.0 / 3, 1e-15);
  const CosineTable table(16);
  std::vector<double> c{0.5, -0.25, 0.75, 1, -2, 0.125, 3, 0.375, 0.0625, -1.5, 40};
  c.pop_back();  // 40 stays behind the end
  const Sampled samples = sample(c, table);
  REQUIRE(samples.value.size() == 9);
  Long size = 0;
  for (double x : c) size += std::abs(x);
  for (std::size_t j = 0; j <= 8; ++j) {
    Long sum = 0;
    for (std::size_t k = 0; k < c.size(); ++k) sum += c[k] * std::cos(2 * pi_l * Long(j * k) / 16);
    check_close(samples.value[j], double(sum), 1e-14);
  }
  const double expected = double(size * (table.error + gamma(c.size() + 1)));
  check_close(samples.error, expected, 0, 1e-14);
  CHECK(samples.error >= expected);
  // What underflows is not forgotten
  CHECK(underflow == 0x1p-1022);
  const double none = sample({0}, table).error;
  CHECK((none >= underflow && none < 1.001 * underflow));
}

TEST_CASE("discrete coefficients and their errors", "[unit]") {
  const std::size_t m = 16;
  const auto gamma = [](std::size_t n) { return Long(n) * 0x1p-53L / (1 - Long(n) * 0x1p-53L); };
  const CosineTable table(m);
  // Alternating samples have no part that is asked for, so that roundings of the result do not hide the error
  for (const auto& [width, alternating] : {std::pair{0x1p-20, 0.0}, {0.0, 1000.0}}) {
    std::vector<Number> half;
    Long radius = 0, size = 0;
    for (std::size_t j = 0; j <= m / 2; ++j) {
      const double f = alternating > 0 ? (j % 2 ? -alternating : alternating)
                                       : 1 + 0.375 * double(j) - 0.25 * double(j % 3) * double(j);
      half.push_back(Number(f - width, f + width));
      radius += half.back().radius(), size += std::abs(f);
    }
    const auto out = discrete_coefficients(half, 8, table);
    REQUIRE(out.size() == 8);
    const Long error = 4.0L / m * (radius + size * (table.error + gamma(half.size() + 2)));
    for (std::size_t k = 0; k < 8; ++k) {
      // The mean of all m samples times the cosine; twice that, but for the constant
      Long sum = 0;
      for (std::size_t j = 0; j < m; ++j)
        sum += half[std::min(j, m - j)].middle() * std::cos(2 * pi_l * Long(j * k) / m) / m;
      const Long share = k == 0 ? 1 : 2, bound = share / 2 * error;
      CAPTURE(k, width);
      CHECK((out[k].lower < share * sum && share * sum < out[k].upper));
      check_close(out[k].upper - out[k].lower, double(2 * bound), 0, 1e-8);
      check_close(out[k].middle(), double(share * sum), alternating > 0 ? 1e-12 : 1e-14);
    }
  }
}

}  // namespace circle_again
