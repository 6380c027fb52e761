#include "sec5/dps_enclosure.hpp"

#include "lattice/algebra/dense.hpp"
#include "lattice/standing/stationary.hpp"
#include "sec5/counted.hpp"

namespace lattice {

namespace {

/// phi(x) = x |x|^(1/2), which increases.
template <class T>
Interval<T> phi(const Interval<T>& x) {
  return hertz(x) - hertz(-x);
}

/// phi'(x).
template <class T>
Interval<T> slope(const Interval<T>& x) {
  return Interval<T>(3) / Interval<T>(2) * root(abs(x));
}

/// Which contact of the half chain is the left neighbour of contact 0.
std::size_t mirror(Centre centre) {
  return centre == Centre::bond ? 1 : 0;
}

/// phi(r_(n-1)) + 2 phi(r_n) + phi(r_(n+1)), `after` being the strain behind the last.
template <class T>
Interval<T> pull(Centre centre, const std::vector<Interval<T>>& r, std::size_t n,
                 const Interval<T>& after) {
  const Interval<T>& left = r[n == 0 ? mirror(centre) : n - 1];
  const Interval<T>& right = n + 1 < r.size() ? r[n + 1] : after;
  return phi(left) + T(2) * phi(r[n]) + phi(right);
}

template <class T>
std::vector<Interval<T>> box(const DpsGuess<T>& guess, T radius) {
  std::vector<Interval<T>> r;
  for (const T& c : guess.r) r.push_back(Interval<T>(c) + Interval<T>(-radius, radius));
  return r;
}

/// DF on the window, from strains; the neighbour behind the window is left out.
template <class T>
std::vector<std::vector<Interval<T>>> derivative(Centre centre, const std::vector<Interval<T>>& r) {
  const std::size_t n = r.size();
  std::vector<std::vector<Interval<T>>> matrix(n, std::vector<Interval<T>>(n));
  for (std::size_t i = 0; i < n; ++i) {
    matrix[i][i] += Interval<T>(1) - T(2) * slope(r[i]);
    const std::size_t left = i == 0 ? mirror(centre) : i - 1;
    matrix[i][left] -= slope(r[left]);
    if (i + 1 < n) matrix[i][i + 1] -= slope(r[i + 1]);
  }
  return matrix;
}

/// The components of A F at strains that are enclosed; F of the window only.
template <class T>
std::vector<Interval<T>> step(const DpsGuess<T>& guess, const Interval<T>& after) {
  const std::vector<Interval<T>> c = box(guess, T(0));
  std::vector<Interval<T>> out(c.size());
  for (std::size_t j = 0; j < c.size(); ++j) {
    const Interval<T> residual = c[j] - pull(guess.centre, c, j, after);
    for (std::size_t i = 0; i < c.size(); ++i) out[i] += guess.inverse[i][j] * residual;
  }
  return out;
}

/// 1 - A DF over a box, in the window.
template <class T>
std::vector<std::vector<Interval<T>>> remainder(const DpsGuess<T>& guess,
                                                const std::vector<Interval<T>>& r) {
  const auto df = derivative(guess.centre, r);
  const std::size_t n = r.size();
  std::vector<std::vector<Interval<T>>> out(n, std::vector<Interval<T>>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      if (i == j) out[i][j] = Interval<T>(1);
      for (std::size_t k = 0; k < n; ++k) out[i][j] -= guess.inverse[i][k] * df[k][j];
    }
  return out;
}

}  // namespace

template <class T>
DpsGuess<T> dps_guess(Centre centre) {
  const auto state = stationary<T>(centre, T(1), centre == Centre::site ? 31 : 32);
  DpsGuess<T> guess{centre, {}, {}};
  for (std::size_t n = 0; n < dps_contacts; ++n) guess.r.push_back(std::abs(state.strain[n]));
  const auto df = derivative(centre, box(guess, T(0)));
  Matrix<T> matrix(dps_contacts, dps_contacts);
  for (std::size_t i = 0; i < dps_contacts; ++i)
    for (std::size_t j = 0; j < dps_contacts; ++j) matrix(i, j) = df[i][j].middle();
  guess.inverse.assign(dps_contacts, std::vector<T>(dps_contacts));
  for (std::size_t j = 0; j < dps_contacts; ++j) {
    const Vector<T> column = solve_square<T>(matrix, Vector<T>::Unit(dps_contacts, j));
    for (std::size_t i = 0; i < dps_contacts; ++i) guess.inverse[i][j] = column[i];
  }
  return guess;
}

template <class T>
T dps_eta(const DpsGuess<T>& guess) {
  // Behind the window the guess is zero, and only the first contact there is pulled
  T eta = phi(Interval<T>(guess.r.back())).upper;
  for (const Interval<T>& x : step(guess, Interval<T>(0))) eta = std::max(eta, magnitude(x));
  return eta;
}

template <class T>
T dps_q(const DpsGuess<T>& guess, T radius) {
  const std::vector<Interval<T>> r = box(guess, radius);
  const Interval<T> behind{-radius, radius};
  const auto matrix = remainder(guess, r);
  // The contacts behind the window: the first sees the last of the window, the others only the tail
  Interval<T> q = slope(abs(r.back())) + T(3) * slope(behind);
  q = hull(q, T(4) * slope(behind));
  T worst = magnitude(q);
  for (std::size_t i = 0; i < r.size(); ++i) {
    // The last contact of the window is pulled by the first behind it
    Interval<T> sum = abs(Interval<T>(guess.inverse[i].back())) * slope(behind);
    for (const Interval<T>& entry : matrix[i]) sum += abs(entry);
    worst = std::max(worst, sum.upper);
  }
  return worst;
}

namespace {

/// The strains of the solution in the ball, each as narrow as repeated images under K make them.
template <class T>
void tighten(const DpsGuess<T>& guess, DpsBreather<T>& b) {
  std::vector<Interval<T>>& r = b.r;
  for (int round = 0; round < 20; ++round) {
    const auto shift = step(guess, b.tail);
    // The mean value is taken on the segment from the guess to the solution
    std::vector<Interval<T>> segment;
    for (std::size_t i = 0; i < r.size(); ++i)
      segment.push_back(hull(r[i], Interval<T>(guess.r[i])));
    const auto matrix = remainder(guess, segment);
    std::vector<Interval<T>> image(r.size());
    for (std::size_t i = 0; i < r.size(); ++i) {
      image[i] = Interval<T>(guess.r[i]) - shift[i];
      for (std::size_t j = 0; j < r.size(); ++j)
        image[i] += matrix[i][j] * (r[j] - Interval<T>(guess.r[j]));
    }
    for (std::size_t i = 0; i < r.size(); ++i) r[i] = common(r[i], image[i]);
    // From outside inwards the equation itself is sharper where strains are small
    for (std::size_t i = r.size(); i-- > 1;) r[i] = common(r[i], pull(b.centre, r, i, b.tail));
    b.tail = common(b.tail, Interval<T>(T(0), (phi(r.back()) + T(3) * phi(b.tail)).upper));
  }
}

}  // namespace

// Find the last strain that may exceed 1/16: all up to it must be positive, and what lies behind is clipped
template <class T>
void demand_no_negative(DpsBreather<T>& b) {
  T largest = magnitude(b.tail);
  std::size_t m = b.r.size();
  while (m > 0 && magnitude(b.r[m - 1]) < T(0.0625))
    largest = std::max(largest, magnitude(b.r[--m]));
  if (!(largest < T(0.0625))) throw NotProved("the strains cannot be shown to be small");
  for (std::size_t n = 0; n < std::max<std::size_t>(m, 1); ++n)
    if (!(b.r[n].lower > 0)) throw NotProved("the central strains cannot be shown to be positive");
  for (Interval<T>& r : b.r) r = positive_part(r);
  b.tail = positive_part(b.tail);
}

template <class T>
void demand_decrease(const DpsBreather<T>& b) {
  for (std::size_t i = 0; i < b.r.size(); ++i) {
    const Interval<T>& next = i + 1 < b.r.size() ? b.r[i + 1] : b.tail;
    if (empty(b.r[i]) || !(b.r[i] > Interval<T>(0)) || !(next < b.r[i]))
      throw NotProved("the strains cannot be shown to decrease");
  }
  if (!(b.tail.upper < T(0.01))) throw NotProved("the tail cannot be shown to be small");
}

// The lemma first, then the signs, the digits, and that strains decrease
template <class T>
DpsBreather<T> enclose_dps(Centre centre) {
  const DpsGuess<T> guess = dps_guess<T>(centre);
  const auto [unique, exists] =
      two_balls(dps_eta(guess), T(0.0625), [&](T radius) { return dps_q(guess, radius); });
  DpsBreather<T> b{
      centre, unique, exists, box(guess, exists.radius), {-exists.radius, exists.radius}};
  demand_no_negative(b);
  tighten(guess, b);
  demand_decrease(b);
  return b;
}

template <class T>
Interval<T> DpsBreather<T>::largest() const {
  return phi(r[0]) + phi(r[mirror(centre)]);
}

template <class T>
Interval<T> DpsBreather<T>::norm() const {
  Interval<T> sum =
      T(2) * Interval<T>(T(0), (tail * phi(tail)).upper);  // each less than half the last
  for (std::size_t i = r.size(); i-- > 1;) sum += r[i] * phi(r[i]);
  const Interval<T> middle = r[0] * phi(r[0]);
  return centre == Centre::bond ? middle + T(2) * sum : T(2) * (middle + sum);
}

template <class T>
Interval<T> contact_eigenvalue(const DpsBreather<T>& b, std::size_t k) {
  // The contacts of the whole window, from the left to the right
  std::vector<Interval<T>> s;
  for (std::size_t i = b.r.size(); i-- > mirror(b.centre);) s.push_back(root(b.r[i]));
  for (const Interval<T>& r : b.r) s.push_back(root(r));
  std::vector<Interval<T>> diagonal(s.size() + 1);
  for (std::size_t i = 0; i < s.size(); ++i) diagonal[i] += s[i], diagonal[i + 1] += s[i];
  const Interval<T> m = enclosed_eigenvalue(diagonal, s, k, T(0.125), T(2));
  return m + Interval<T>(T(0), (T(4) * root(b.tail)).upper);
}

template <class T>
Interval<T> square_of_exponent(const Interval<T>& m) {
  const Interval<T> three_halves = Interval<T>(3) / Interval<T>(2);
  return (Interval<T>(1) - m) * (three_halves * m - Interval<T>(1));
}

template <class T>
DpsBarrier<T> dps_barrier(const DpsBreather<T>& site, const DpsBreather<T>& bond) {
  const Interval<T> two_fifths = Interval<T>(2) / Interval<T>(5), s = site.norm(), b = bond.norm();
  // (b/s)^(1/4) - 1 = (b - s) / s / [(q + 1)(q^2 + 1)] with q^4 = b/s keeps the digits of b - s
  const Interval<T> q = root(root(b / s)), one(1);
  const Interval<T> rise = (b - s) / s / ((q + one) * (q * q + one));
  return {two_fifths * (s - b), two_fifths * b * rise};
}

// Follow the deviations from the constant profile until they certainly rise, or may have left it
template <class T>
bool turns_back(Centre centre, const Interval<T>& r_0) {
  const Interval<T> constant = Interval<T>(1) / Interval<T>(64),
                    two_thirds = Interval<T>(2) / Interval<T>(3);
  const Interval<T> largest = phi(r_0) - constant, one(1);
  // All y_n are sought as multiples z_n of y_0, and those met here must not exceed 2 in modulus
  const Interval<T> range = constant + hull(largest, -largest) * T(2);
  if (!(range.lower > 0)) return false;
  const Interval<T> factor = two_thirds / cube_root(range) - T(2);
  Interval<T> before = one, z = factor - one;
  if (centre == Centre::bond) z = factor / Interval<T>(2);
  for (int n = 0; n < 6; ++n) {
    if (magnitude(z) > 2) return false;
    if (z > before) return true;
    const Interval<T> next = factor * z - before;
    before = z, z = next;
  }
  return false;
}

namespace {

/// The profiles of this r_0, outwards.
template <class T>
Piece<T> follow_profiles(const DpsBreather<T>& b, const Interval<T>& r_0) {
  const T radius = b.unique.radius;
  const auto in_ball = [&](const Interval<T>& x, std::size_t n) {
    const Interval<T> c = n < b.r.size() ? b.r[n] : b.tail;
    // The ball is centred at the guess, which is at most the radius of existence from the solution
    return (abs(x - c) + b.exists.radius).upper <= radius;
  };
  if (turns_back(b.centre, r_0)) return {r_0, Decision::discarded, 0};
  Interval<T> r = r_0, force_before{}, force = phi(r);
  bool inside = in_ball(r, 0);
  for (std::size_t n = 0; n < b.r.size(); ++n) {
    Interval<T> next = r - T(2) * force - force_before;
    if (n == 0)
      next = b.centre == Centre::bond ? (r - T(2) * force) / Interval<T>(2) : r - T(3) * force;
    const Interval<T> narrow = cube_root(next), allowed{force.lower, r.upper};
    const Interval<T> strain = common(narrow * narrow, allowed);
    if (next.upper < 0 || empty(strain)) return {r_0, Decision::discarded, n + 1};
    force_before = force, r = strain, force = common(phi(strain), next);
    if (empty(force)) return {r_0, Decision::discarded, n + 1};
    inside = inside && in_ball(r, n + 1);
    // From here on all strains lie between zero and this one, and so do those of the guess
    const T most = std::max(r.upper, n + 1 < b.r.size() ? b.r[n + 1].upper : b.tail.upper);
    if (inside && (Interval<T>(most) + b.exists.radius).upper <= radius)
      return {r_0, Decision::inside, n + 1};
  }
  return {r_0, Decision::open, b.r.size()};
}

}  // namespace

template <class T>
std::vector<Piece<T>> search_profiles(const DpsBreather<T>& breather, int depth) {
  std::vector<Piece<T>> pieces;
  const auto look = [&](auto&& self, T from, T to, int left) -> void {
    const Piece<T> piece = follow_profiles(breather, Interval<T>(from, to));
    if (piece.decision != Decision::open || left == 0) {
      pieces.push_back(piece);
      return;
    }
    const T middle = from + (to - from) / 2;
    self(self, from, middle, left - 1);
    self(self, middle, to, left - 1);
  };
  look(look, T(0.0625), T(0.25), depth);
  return pieces;
}

#define LATTICE_ENCLOSURE(T)                                                        \
  template void demand_no_negative(DpsBreather<T>&);                                \
  template void demand_decrease(const DpsBreather<T>&);                             \
  template DpsGuess<T> dps_guess(Centre);                                           \
  template T dps_eta(const DpsGuess<T>&);                                           \
  template T dps_q(const DpsGuess<T>&, T);                                          \
  template struct DpsBreather<T>;                                                   \
  template DpsBreather<T> enclose_dps(Centre);                                      \
  template Interval<T> contact_eigenvalue(const DpsBreather<T>&, std::size_t);      \
  template Interval<T> square_of_exponent(const Interval<T>&);                      \
  template DpsBarrier<T> dps_barrier(const DpsBreather<T>&, const DpsBreather<T>&); \
  template bool turns_back(Centre, const Interval<T>&);                             \
  template std::vector<Piece<T>> search_profiles(const DpsBreather<T>&, int);
LATTICE_ENCLOSURE(double)
LATTICE_ENCLOSURE(long double)
#undef LATTICE_ENCLOSURE

}  // namespace lattice
