#include "sec5/dps_enclosure.hpp"

#include "lattice/algebra/dense.hpp"
#include "lattice/standing/stationary.hpp"
#include "sec5/counted.hpp"

namespace lattice {

namespace {

using Number = Interval<double>;
using Numbers = std::vector<Number>;
using Rows = std::vector<Numbers>;

/// Which contact of the half chain is the left neighbour of contact 0.
std::size_t mirror(Centre centre) {
  return centre == Centre::bond ? 1 : 0;
}

}  // namespace

Numbers ball(const DpsGuess& guess, double radius) {
  Numbers r;
  for (double c : guess.r) r.push_back(Number(c) + Number(-radius, radius));
  return r;
}

Number phi(const Number& x) {
  return hertz(x) - hertz(-x);
}

Number phi_slope(const Number& x) {
  return hertz_slope(abs(x));
}

Number pull(Centre centre, const Numbers& r, std::size_t n, const Number& after) {
  const Number& left = r[n == 0 ? mirror(centre) : n - 1];
  const Number& right = n + 1 < r.size() ? r[n + 1] : after;
  return phi(left) + 2.0 * phi(r[n]) + phi(right);
}

Rows dps_derivative(Centre centre, const Numbers& r) {
  const std::size_t n = r.size();
  Rows matrix(n, Numbers(n));
  for (std::size_t i = 0; i < n; ++i) {
    matrix[i][i] += Number(1) - 2.0 * phi_slope(r[i]);
    const std::size_t left = i == 0 ? mirror(centre) : i - 1;
    matrix[i][left] -= phi_slope(r[left]);
    if (i + 1 < n) matrix[i][i + 1] -= phi_slope(r[i + 1]);
  }
  return matrix;
}

// Newton's method in plain numbers, and an inverse from the middles of intervals
DpsGuess dps_guess(Centre centre) {
  const auto state = stationary<double>(centre, 1.0, centre == Centre::site ? 31 : 32);
  DpsGuess guess{centre, {}, {}};
  for (std::size_t n = 0; n < dps_contacts; ++n) guess.r.push_back(std::abs(state.strain[n]));
  const auto df = dps_derivative(centre, ball(guess, 0));
  Matrix<double> matrix(dps_contacts, dps_contacts);
  for (std::size_t i = 0; i < dps_contacts; ++i)
    for (std::size_t j = 0; j < dps_contacts; ++j) matrix(i, j) = df[i][j].middle();
  guess.inverse.assign(dps_contacts, std::vector<double>(dps_contacts));
  for (std::size_t j = 0; j < dps_contacts; ++j) {
    const Vector<double> column =
        solve_square<double>(matrix, Vector<double>::Unit(dps_contacts, j));
    for (std::size_t i = 0; i < dps_contacts; ++i) guess.inverse[i][j] = column[i];
  }
  return guess;
}

Number DpsBreather::largest() const {
  return phi(r[0]) + phi(r[mirror(centre)]);
}

Number DpsBreather::norm() const {
  Number sum = 2.0 * Number(0.0, (tail * phi(tail)).upper);  // each less than half the last
  for (std::size_t i = r.size(); i-- > 1;) sum += r[i] * phi(r[i]);
  const Number middle = r[0] * phi(r[0]);
  return centre == Centre::bond ? middle + 2.0 * sum : 2.0 * (middle + sum);
}

// Stability and energies

Number contact_eigenvalue(const DpsBreather& b, std::size_t k) {
  // The contacts of the whole window, from the left to the right
  Numbers s;
  for (std::size_t i = b.r.size(); i-- > mirror(b.centre);) s.push_back(root(b.r[i]));
  for (const Number& r : b.r) s.push_back(root(r));
  Numbers diagonal(s.size() + 1);
  for (std::size_t i = 0; i < s.size(); ++i) diagonal[i] += s[i], diagonal[i + 1] += s[i];
  const Number m = enclosed_eigenvalue(diagonal, s, k, 0.125, 2.0);
  return m + Number(0.0, (4.0 * root(b.tail)).upper);
}

Number square_of_exponent(const Number& m) {
  const Number three_halves = Number(3) / Number(2);
  return (Number(1) - m) * (three_halves * m - Number(1));
}

DpsBarrier dps_barrier(const DpsBreather& site, const DpsBreather& bond) {
  const Number two_fifths = Number(2) / Number(5), s = site.norm(), b = bond.norm();
  // (b/s)^(1/4) - 1 = (b - s) / s / [(q + 1)(q^2 + 1)] with q^4 = b/s keeps the digits of b - s
  const Number q = root(root(b / s)), one(1);
  const Number rise = (b - s) / s / ((q + one) * (q * q + one));
  return {two_fifths * (s - b), two_fifths * b * rise};
}

// Follow the deviations from the constant profile until they certainly rise, or may have left it
bool turns_back(Centre centre, const Number& r_0) {
  const Number constant = Number(1) / Number(64), two_thirds = Number(2) / Number(3);
  const Number largest = phi(r_0) - constant, one(1);
  // All y_n are sought as multiples z_n of y_0, and those met here must not exceed 2 in modulus
  const Number range = constant + hull(largest, -largest) * 2.0;
  if (!(range.lower > 0)) return false;
  const Number factor = two_thirds / cube_root(range) - 2.0;
  Number before = one, z = factor - one;
  if (centre == Centre::bond) z = factor / Number(2);
  for (int n = 0; n < 6; ++n) {
    if (magnitude(z) > 2) return false;
    if (z > before) return true;
    const Number next = factor * z - before;
    before = z, z = next;
  }
  return false;
}

namespace {

/// The profiles of this r_0, outwards.
Piece follow_profiles(const DpsBreather& b, const Number& r_0) {
  const double radius = b.unique.radius;
  const auto in_ball = [&](const Number& x, std::size_t n) {
    const Number c = n < b.r.size() ? b.r[n] : b.tail;
    // The ball is centred at the guess, which is at most the radius of existence from the solution
    return (abs(x - c) + b.exists.radius).upper <= radius;
  };
  if (turns_back(b.centre, r_0)) return {r_0, Decision::discarded, 0};
  Number r = r_0, force_before{}, force = phi(r);
  bool inside = in_ball(r, 0);
  for (std::size_t n = 0; n < b.r.size(); ++n) {
    Number next = r - 2.0 * force - force_before;
    if (n == 0) next = b.centre == Centre::bond ? (r - 2.0 * force) / Number(2) : r - 3.0 * force;
    const Number narrow = cube_root(next), allowed{force.lower, r.upper};
    const Number strain = common(narrow * narrow, allowed);
    if (next.upper < 0 || empty(strain)) return {r_0, Decision::discarded, n + 1};
    force_before = force, r = strain, force = common(phi(strain), next);
    if (empty(force)) return {r_0, Decision::discarded, n + 1};
    inside = inside && in_ball(r, n + 1);
    // From here on all strains lie between zero and this one, and so do those of the guess
    const double most = std::max(r.upper, n + 1 < b.r.size() ? b.r[n + 1].upper : b.tail.upper);
    if (inside && (Number(most) + b.exists.radius).upper <= radius)
      return {r_0, Decision::inside, n + 1};
  }
  return {r_0, Decision::open, b.r.size()};
}

}  // namespace

std::vector<Piece> search_profiles(const DpsBreather& breather, int depth) {
  std::vector<Piece> pieces;
  const auto look = [&](auto&& self, double from, double to, int left) -> void {
    const Piece piece = follow_profiles(breather, Number(from, to));
    if (piece.decision != Decision::open || left == 0) {
      pieces.push_back(piece);
      return;
    }
    const double middle = from + (to - from) / 2;
    self(self, from, middle, left - 1);
    self(self, middle, to, left - 1);
  };
  look(look, 0.0625, 0.25, depth);
  return pieces;
}

}  // namespace lattice
