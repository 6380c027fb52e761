#include "sec5/cubic_line.hpp"

namespace lattice {

namespace {

using Number = Interval<double>;
using Wide = Interval<long double>;

const Number two(2);

Wide widened(const Number& x) {
  return {x.lower, x.upper};
}

Number narrowed(const Wide& x) {
  return {below(double(x.lower)), above(double(x.upper))};
}

}  // namespace

Number value(const Cubic& c, const Number& x) {
  return c[0] + x * (c[1] + x * (c[2] + x * c[3]));
}

Number first_derivative(const Cubic& c, const Number& x) {
  return c[1] + x * (2 * c[2] + x * (Number(3) * c[3]));
}

Number second_derivative(const Cubic& c, const Number& x) {
  return 2 * c[2] + x * (Number(6) * c[3]);
}

Number CubicLine::step() const {
  return two * enclosed_pi() / double(per_turn);
}

Number Angles::cosine(std::size_t j) const {
  return Number(table_.cosine[j % table_.count()]) + Number(-table_.error, table_.error);
}

namespace {

/// Largest moduli on a piece: of the derivatives of d by t, and of those of a power of d by d.
using Moduli = std::array<Number, 5>;

/// Those of d_+^(3/2) and of d_+^(5/2) for d between two positive numbers.
Moduli force_moduli(const Number& d) {
  const Number low(d.lower), high(d.upper), root_low = root(low), root_high = root(high);
  return {high * root_high, 1.5 * root_high, 0.75 / root_low, 0.375 / (low * root_low),
          0.5625 / (low * low * root_low)};
}

Moduli action_moduli(const Number& d) {
  const Number low(d.lower), high(d.upper), root_low = root(low), root_high = root(high);
  return {high * high * root_high, 2.5 * high * root_high, 3.75 * root_high, 1.875 / root_low,
          0.9375 / (low * root_low)};
}

/// The derivatives of a power of d by t, by the chain rule; d[0] is not used.
Moduli chain_rule(const Moduli& power, const Moduli& d) {
  const Number square = d[1] * d[1];
  return {power[0], power[1] * d[1], power[2] * square + power[1] * d[2],
          power[3] * square * d[1] + Number(3) * power[2] * d[1] * d[2] + power[1] * d[3],
          power[4] * square * square + Number(6) * power[3] * square * d[2] +
              power[2] * (Number(3) * d[2] * d[2] + Number(4) * d[1] * d[3])};
}

/// A bound of the fourth derivative of f cos t or f sin t.
Number with_cosine(const Moduli& f) {
  return f[4] + Number(4) * f[3] + Number(6) * f[2] + Number(4) * f[1] + f[0];
}

/// One cell while it is divided: a piece [from, to] of 0 <= x <= 1.
struct DividedCell {
  const CubicLine& d;
  std::size_t cell;
  const Angles& angles;
  Number step = d.step();

  const Cubic& cubic() const { return d.cell[cell]; }

  /// cos t and sin t at x; the ends of the cell are in the table.
  std::array<Number, 2> cosine_and_sine(double x) const {
    if (x == 0 || x == 1) {
      const std::size_t j = 2 * (cell + std::size_t(x));
      return {angles.cosine(j), angles.sine(j)};
    }
    // cos t = -cos(t - pi) and sin t = cos(t - pi/2) = -cos(t - 3 pi/2), whichever is near zero
    const Number t = step * (double(cell % d.per_turn) + Number(x)), pi = enclosed_pi();
    const Number quarter = pi / two;
    const Number sine = cell % d.per_turn < d.per_turn / 2 ? enclosed_cosine(t - quarter)
                                                           : -enclosed_cosine(t - pi - quarter);
    return {-enclosed_cosine(t - pi), sine};
  }

  /// The corrected trapezoidal rule without its remainder.
  CellIntegrals rule(double from, double to) const {
    const Number tau = step * (Number(to) - from);
    CellIntegrals sum;
    for (double x : {from, to}) {
      const Number at = value(cubic(), Number(x)),
                   by_t = first_derivative(cubic(), Number(x)) / step;
      const Number f = hertz(at), f_t = 1.5 * root(at) * by_t;
      const auto [c, s] = cosine_and_sine(x);
      const Number half = tau / two, twelfth = (x == from ? tau : -tau) * tau / Number(12);
      sum.cosine += half * f * c + twelfth * (f_t * c - f * s);
      sum.sine += half * f * s + twelfth * (f_t * s + f * c);
      sum.action += half * f * at + twelfth * (2.5 * f * by_t);
    }
    return sum;
  }

  CellIntegrals piece(double from, double to, int halvings) const {
    // How far an integral over a piece may be uncertain, and how often pieces are halved
    constexpr double enough = 0x1p-58;
    constexpr int most = 40;
    const Number x(from, to), at = value(cubic(), x), tau = step * (Number(to) - from);
    if (at.upper <= 0) return {};
    const double force = (tau * hertz(Number(at.upper))).upper;
    if (force <= enough || halvings == most) {
      const Number work = Number(force) * at.upper;
      return {Number(-force, force), Number(-force, force), Number(0, work.upper)};
    }
    // Where the contact is closed the rule has a remainder that is bounded
    if (at.lower > 0) {
      const Number n = Number(double(d.per_turn)) / (two * enclosed_pi());
      const Moduli by_t{Number(0), Number(magnitude(first_derivative(cubic(), x))) * n,
                        Number(magnitude(second_derivative(cubic(), x))) * n * n,
                        Number(6) * std::abs(cubic()[3]) * n * n * n, Number(0)};
      const Number power = tau * tau * tau * tau * tau / Number(720);
      const double rest = (power * with_cosine(chain_rule(force_moduli(at), by_t))).upper;
      if (rest <= enough) {
        const double rest_action = (power * chain_rule(action_moduli(at), by_t)[4]).upper;
        CellIntegrals all = rule(from, to);
        all.cosine += Number(-rest, rest), all.sine += Number(-rest, rest);
        all.action += Number(-rest_action, rest_action);
        return all;
      }
    }
    // Elsewhere, or where that is not enough, both halves
    const double middle = from + (to - from) / 2;
    CellIntegrals all = piece(from, middle, halvings + 1);
    const CellIntegrals rest = piece(middle, to, halvings + 1);
    all.cosine += rest.cosine, all.sine += rest.sine, all.action += rest.action;
    return all;
  }
};

}  // namespace

CellIntegrals integrate(const CubicLine& d, std::size_t cell, const Angles& angles) {
  return DividedCell{d, cell, angles}.piece(0, 1, 0);
}

ForceIntegrals::ForceIntegrals(const CubicLine& d, const Angles& angles)
    : per_turn_(d.per_turn), angles_(angles) {
  Wide cosine, sine, action;
  for (std::size_t p = 0; p < d.cell.size(); ++p) {
    cosine_.push_back(cosine), sine_.push_back(sine);
    const CellIntegrals here = integrate(d, p, angles);
    cosine += widened(here.cosine), sine += widened(here.sine), action += widened(here.action);
  }
  cosine_.push_back(cosine), sine_.push_back(sine), action_ = action;
}

/// The integral from 0 to a node, which is even or odd in the node and constant where f is zero.
ForceIntegrals::Wide ForceIntegrals::at(const std::vector<Wide>& sums, long node, long sign) const {
  const std::size_t i = std::min(std::size_t(std::abs(node)), sums.size() - 1);
  return node < 0 && sign < 0 ? -sums[i] : sums[i];
}

/// 2 C(t) - C(t - T) - C(t + T); C is odd and S is even.
Number ForceIntegrals::around(const std::vector<Wide>& sums, std::size_t node, long sign) const {
  const long i = long(node), turn = long(per_turn_);
  const Wide here = at(sums, i, sign);
  return narrowed((here - at(sums, i - turn, sign)) - (at(sums, i + turn, sign) - here));
}

Number ForceIntegrals::cosine(std::size_t from, std::size_t to) const {
  return narrowed(at(cosine_, long(to), -1) - at(cosine_, long(from), -1));
}

Number ForceIntegrals::sine(std::size_t from, std::size_t to) const {
  return narrowed(at(sine_, long(to), 1) - at(sine_, long(from), 1));
}

Number ForceIntegrals::action() const {
  return two * narrowed(action_);
}

Number ForceIntegrals::image(std::size_t node) const {
  return angles_.cosine(2 * node) * around(sine_, node, 1) -
         angles_.sine(2 * node) * around(cosine_, node, -1);
}

Number ForceIntegrals::image_slope(std::size_t node) const {
  return -(angles_.cosine(2 * node) * around(cosine_, node, -1)) -
         angles_.sine(2 * node) * around(sine_, node, 1);
}

}  // namespace lattice
