// The integrals of cells once more: the rule and its remainder in plain numbers, and each bound from both sides.

#include <array>
#include <vector>

#include "check.hpp"
#include "sec5/cubic_line.hpp"

namespace cells_again {

using namespace lattice;

namespace {

using Number = Interval<double>;
using Long = long double;

const double ulp = 0x1p-52;
const Long pi_l = std::acos(Long(-1));

void check_ends(const Number& x, double lower, double upper) {
  CAPTURE(x.lower, x.upper, lower, upper);
  CHECK(x.lower == lower);
  CHECK(x.upper == upper);
}

/// Both ends of an interval, to a small part of its width and to roundings of numbers as large as `size`.
void check_enclosure(const Number& x, Long middle, Long bound, Long size) {
  CAPTURE(x.lower, x.upper, double(middle), double(bound), double(size));
  CHECK(std::abs(x.lower - (middle - bound)) <= 1e-6L * bound + 4e-15L * size);
  CHECK(std::abs(x.upper - (middle + bound)) <= 1e-6L * bound + 4e-15L * size);
  CHECK(x.lower <= middle - bound + 1e-18L * size);
  CHECK(x.upper >= middle + bound - 1e-18L * size);
}

/// The polynomial and its derivatives by x.
std::array<Long, 4> derivatives(const Cubic& c, Long x) {
  return {c[0] + c[1] * x + c[2] * x * x + c[3] * x * x * x, c[1] + 2 * c[2] * x + 3 * c[3] * x * x,
          2 * c[2] + 6 * c[3] * x, 6 * Long(c[3])};
}

/// The largest fourth derivative of d^p, or of d^p cos t, for a cubic whose coefficients behind the first
/// have one sign, so that everything is largest or least at an end.
Long fourth(const Cubic& c, Long from, Long to, Long n, Long p, bool with_cosine) {
  const auto a = derivatives(c, from), b = derivatives(c, to);
  const auto most = [&](std::size_t k) {
    return std::max(std::abs(a[k]), std::abs(b[k])) * std::pow(n, Long(k));
  };
  const Long d1 = most(1), d2 = most(2), d3 = most(3);
  Long of[5], factor = 1;
  for (int k = 0; k <= 4; factor *= p - k, ++k)
    of[k] = std::abs(factor) * std::pow(p > k ? std::max(a[0], b[0]) : std::min(a[0], b[0]), p - k);
  const Long f4 =
      of[4] * std::pow(d1, 4.0L) + 6 * of[3] * d1 * d1 * d2 + of[2] * (3 * d2 * d2 + 4 * d1 * d3);
  if (!with_cosine) return f4;
  const Long f1 = of[1] * d1, f2 = of[2] * d1 * d1 + of[1] * d2,
             f3 = of[3] * d1 * d1 * d1 + 3 * of[2] * d1 * d2 + of[1] * d3;
  return f4 + 4 * f3 + 6 * f2 + 4 * f1 + of[0];
}

/// Integrals with cosine, sine and d, and their remainders.
struct Sum {
  Long of[3] = {}, rest[3] = {};
  int pieces = 0;
};

/// The rule of the header, on a piece that is halved until the remainder is at most 2^-58.
Sum ruled(const CubicLine& line, std::size_t cell, Long from, Long to) {
  const Cubic& c = line.cell[cell];
  const Long h = 2 * pi_l / Long(line.per_turn), tau = h * (to - from),
             power = std::pow(tau, 5.0L) / 720;
  const Long rest = power * fourth(c, from, to, 1 / h, 1.5L, true);
  if (rest > 0x1p-58L) {
    Sum a = ruled(line, cell, from, (from + to) / 2);
    const Sum b = ruled(line, cell, (from + to) / 2, to);
    for (int k = 0; k < 3; ++k) a.of[k] += b.of[k], a.rest[k] += b.rest[k];
    a.pieces += b.pieces;
    return a;
  }
  Sum sum{{}, {rest, rest, power * fourth(c, from, to, 1 / h, 2.5L, false)}, 1};
  for (const Long x : {from, to}) {
    const Long t = h * (Long(cell) + x), sign = x == from ? 1 : -1;
    const auto d = derivatives(c, x);
    const Long f = std::pow(d[0], 1.5L), by_t = 1.5L * std::sqrt(d[0]) * d[1] / h;
    const Long other[] = {std::cos(t), std::sin(t), d[0]},
               slope[] = {-std::sin(t), std::cos(t), d[1] / h};
    for (int k = 0; k < 3; ++k)
      sum.of[k] +=
          tau / 2 * f * other[k] + sign * tau * tau / 12 * (by_t * other[k] + f * slope[k]);
  }
  return sum;
}

/// A cubic so small that its remainder on a cell is `share` of 2^-58.
Cubic scaled(Cubic c, std::size_t per_turn, Long share) {
  const Long h = 2 * pi_l / Long(per_turn),
             one = std::pow(h, 5.0L) / 720 * fourth(c, 0, 1, 1 / h, 1.5L, true);
  for (double& x : c) x *= double(std::pow(share * 0x1p-58L / one, 2 / 3.0L));
  return c;
}

const Cubic shapes[] = {
    {1, 0.5, 0.25, 0.125}, {2, -0.5, -0.25, -0.125}, {1, 0.25, 1, 0}, {3, 0, 0, -1}, {1, 0, 0, 0}};

}  // namespace

TEST_CASE("cells are enclosed by the corrected rule and its remainder", "[unit][kernel]") {
  // On both sides of the bound from which a cell is halved, in all eighths of two turns
  const std::size_t per_turn = 8;
  const Angles angles(per_turn);
  for (const auto& [share, pieces] :
       {std::pair{0.6, 1}, {0.999, 1}, {1.001, 2}, {20.0, 2}, {300.0, 0}})
    for (const Cubic& shape : shapes) {
      CubicLine line{per_turn, {}};
      for (int p = 0; p < 12; ++p) line.cell.push_back(scaled(shape, per_turn, share));
      for (std::size_t p = 0; p < line.cell.size(); ++p) {
        const CellIntegrals found = integrate(line, p, angles);
        const Sum sum = ruled(line, p, 0, 1);
        CAPTURE(share, p, shape[0], shape[1], sum.pieces);
        if (pieces == 1) CHECK(sum.pieces == 1);
        if (pieces == 2) CHECK(sum.pieces >= 2);
        const Long force =
            std::pow(derivatives(line.cell[p], shape[1] < 0 || shape[3] < 0 ? 0 : 1)[0], 1.5L);
        check_enclosure(found.cosine, sum.of[0], sum.rest[0], force);
        check_enclosure(found.sine, sum.of[1], sum.rest[1], force);
        check_enclosure(found.action, sum.of[2], sum.rest[2], sum.of[2]);
      }
    }
}

TEST_CASE("cosines at the ends of a cell are those of the table", "[unit][kernel]") {
  // A table of half the angles shows where it is used
  const double d = 4e-12, f = d * std::sqrt(d), h = double(pi_l) / 4;
  const CellIntegrals found = integrate({8, {{d, 0, 0, 0}, {d, 0, 0, 0}}}, 1, Angles(16));
  const auto rule = [&](auto of, auto slope) {
    return f * (h / 2 * (of(h / 2) + of(h)) + h * h / 12 * (slope(h / 2) - slope(h)));
  };
  const auto sine = [](double x) { return std::sin(x); };
  const auto cosine = [](double x) { return std::cos(x); };
  const auto minus = [](double x) { return -std::sin(x); };
  check_close(found.cosine.middle(), rule(cosine, minus), 1e-12 * f);
  check_close(found.sine.middle(), rule(sine, cosine), 1e-12 * f);
  // Sines are as narrow on one half of the circle as on the other
  CubicLine line{8, std::vector<Cubic>(6, Cubic{0.01, 0, 0, 0})};
  double least = 1, most = 0;
  for (std::size_t p = 0; p < 6; ++p) {
    const double radius = integrate(line, p, Angles(8)).sine.radius();
    least = std::min(least, radius), most = std::max(most, radius);
  }
  CHECK(most < 1.05 * least);
}

TEST_CASE("a force that counts as nothing, and a contact that is open", "[unit][kernel]") {
  const Angles angles(4);
  const double enough = 0x1p-58, tau = double(pi_l / 2);
  const auto constant = [&](double force) {
    return std::cbrt(force / tau) * std::cbrt(force / tau);
  };
  for (double share : {0.9999, 1.0001}) {
    const double d = constant(share * enough);
    const CellIntegrals found = integrate({4, {{d, 0, 0, 0}}}, 0, angles);
    if (share < 1) {
      check_enclosure(found.cosine, 0, share * enough, 0);
      check_enclosure(found.sine, 0, share * enough, 0);
      CHECK(found.action.lower == 0);
      check_close(found.action.upper, share * enough * d, 0, 1e-12);
    } else {
      CHECK(found.cosine.lower > 0);
      check_close(found.sine.middle(), enough / tau, 0.02 * enough);
    }
  }
  // The force that is nothing to the last bit: one that is scanned for
  int met = 0;
  for (std::size_t turn = 4; turn < 20; ++turn)
    for (double near = constant(enough * double(turn) / 4), d = near * (1 - 40 * ulp);
         d < near * (1 + 40 * ulp); d = above(d)) {
      const CubicLine line{turn, {{d, 0, 0, 0}}};
      const double top = value(line.cell[0], Number(0, 1)).upper;
      if ((line.step() * (Number(1) - Number(0)) * hertz(Number(top))).upper != enough) continue;
      ++met;
      check_ends(integrate(line, 0, angles).sine, -enough, enough);
    }
  CHECK(met > 0);
  // An upper bound of zero is open, and gives nothing at all
  for (int k = 1; k < 9; ++k) {
    const Cubic c{-5e-324 * k, 0, 0, 0};
    if (value(c, Number(0, 1)).upper > 0) continue;
    const CellIntegrals none = integrate({4, {c}}, 0, angles);
    for (const Number& x : {none.cosine, none.sine, none.action}) check_ends(x, 0, 0);
  }
  const CellIntegrals open = integrate({4, {{-1, 0.5, 0, 0}}}, 0, angles);
  check_ends(open.sine, 0, 0);
}

TEST_CASE("a contact that closes is halved forty times and no more", "[unit][kernel]") {
  // d = s x (1 - x / e) is closed on 0 < x < e = 2^-24. At both zeros the last piece and the one beside it count
  // with their whole force, here 2^7 times what counts as nothing, and 2^(3/2) times that
  const double e = 0x1p-24, h = double(pi_l / 2), enough = 0x1p-58, last = 0x1p7 * enough;
  const double s = std::pow(last / h * 0x1p40, 2.0 / 3) * 0x1p40;
  const Angles angles(4);
  const CellIntegrals found = integrate({4, {{0, s, -s / e, 0}}}, 0, angles);
  // The integral of x^p (1 - x)^p is a beta function
  const Long whole = std::pow(Long(s) * e, 1.5L) * h * e * std::beta(2.5L, 2.5L);
  CHECK(found.cosine.contains(double(whole)));
  CHECK(found.action.contains(double(std::pow(Long(s) * e, 2.5L) * h * e * std::beta(3.5L, 3.5L))));
  CAPTURE(found.cosine.radius() / enough);
  const double at_zeros = 2 * (1 + std::sqrt(8.0)) * last;
  CHECK(found.cosine.radius() > at_zeros);
  CHECK(found.cosine.radius() < at_zeros + 250 * enough);
}

namespace {

/// Seven cells of a quarter of a turn, and one that is behind the end.
CubicLine seven_cells() {
  CubicLine line{4, {}};
  line.cell.reserve(8);
  for (int p = 0; p < 8; ++p)
    line.cell.push_back(Cubic{1e-8 * (p + 1), 1e-8 * (p % 3), 2e-9 * (p % 2), 1e-9});
  line.cell.pop_back();
  return line;
}

}  // namespace

TEST_CASE("angles of half cells, and cubics at their ends", "[unit][kernel]") {
  const Angles angles(4);
  for (std::size_t j = 0; j < 19; ++j) {
    const Long angle = pi_l * Long(j) / 4;
    CHECK((angles.cosine(j).lower < std::cos(angle) && std::cos(angle) < angles.cosine(j).upper));
    CHECK((angles.sine(j).lower < std::sin(angle) && std::sin(angle) < angles.sine(j).upper));
    CHECK(angles.cosine(j).radius() < 1e-14);
  }
  const CubicLine line = seven_cells();
  check_close(line.step().middle(), double(pi_l / 2), 1e-15);
  for (std::size_t p = 0; p < 3; ++p) {
    const Cubic& c = line.cell[p];
    for (double x : {0.0, 0.5, 1.0}) {
      const auto d = derivatives(c, x);
      check_close(value(c, Number(x)).middle(), double(d[0]), 1e-20);
      check_close(slope(c, Number(x)).middle(), double(d[1]), 1e-20);
      check_close(bend(c, Number(x)).middle(), double(d[2]), 1e-20);
    }
  }
}

TEST_CASE("sums of cells and the convolution with the kernel", "[unit][kernel]") {
  const long turn = 4;
  const Angles angles(turn);
  const CubicLine line = seven_cells();
  const ForceIntegrals sums(line, angles);
  const long cells = long(line.cell.size());
  std::vector<CellIntegrals> all;
  double action = 0;
  for (long p = 0; p < cells; ++p) {
    all.push_back(integrate(line, std::size_t(p), angles));
    action += 2 * all.back().action.middle();
  }
  check_close(sums.action().middle(), action, 0, 1e-13);
  CHECK(sums.action().radius() < 1e-3 * action);
  // Integrals of f cos and f sin over cells from one node to another; f is even
  const auto between = [&](long from, long to) {
    std::array<double, 2> sum{};
    for (long p = from; p < to; ++p) {
      const long q = p < 0 ? -p - 1 : p;
      if (q >= cells) continue;
      sum[0] += all[std::size_t(q)].cosine.middle();
      sum[1] += (p < 0 ? -1 : 1) * all[std::size_t(q)].sine.middle();
    }
    return sum;
  };
  for (const auto& [from, to] : {std::pair{0, 3}, {2, 7}, {5, 5}, {4, 9}, {0, 0}}) {
    check_close(sums.cosine(std::size_t(from), std::size_t(to)).middle(), between(from, to)[0],
                1e-22);
    check_close(sums.sine(std::size_t(from), std::size_t(to)).middle(), between(from, to)[1],
                1e-22);
  }
  for (long i = 0; i < 14; ++i) {
    // K is -sin of the distance: behind t minus sin(t - s), ahead of it minus sin(s - t)
    const double t = double(pi_l) / 2 * double(i), c = std::cos(t), s = std::sin(t);
    const auto behind = between(i - turn, i), ahead = between(i, i + turn);
    CAPTURE(i);
    const Number image = sums.image(std::size_t(i)), slope_there = sums.image_slope(std::size_t(i));
    check_close(image.middle(), -s * (behind[0] - ahead[0]) + c * (behind[1] - ahead[1]), 1e-22);
    check_close(slope_there.middle(), -c * (behind[0] - ahead[0]) - s * (behind[1] - ahead[1]),
                1e-22);
    CHECK((image.radius() < 1e-15 && slope_there.radius() < 1e-15));
  }
}

}  // namespace cells_again
