// The proof for the waves of the kernel equation: it holds what Newton's method finds, each of its bounds is held
// against what it bounds and against its formula, and it fails where something is wrong.

#include "sec5/wave_enclosure.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <random>

#include <Eigen/LU>

#include "lattice/algebra/dense.hpp"
#include "lattice/orbits/shooting.hpp"
#include "sec5/kernel_wave.hpp"
#include "support/check.hpp"

using namespace lattice;

namespace {

const double two_pi = 2 * pi<double>();

WaveFineness coarse() {
  WaveFineness fine;
  fine.per_turn = 2048;
  return fine;
}

/// One guess for all tests, and what follows from it.
struct Sample {
  WaveFineness fine = coarse();
  CubicLine guess = wave_guess(-1, fine);
  Angles angles{fine.per_turn};
  ForceIntegrals integrals{guess, angles};
  WaveProof proof{guess, fine};
};

const Sample& shared() {
  static const Sample one;
  return one;
}

double at(const CubicLine& d, double t) {
  const double x = std::abs(t) / two_pi * double(d.per_turn);
  const auto p = std::size_t(x);
  if (p >= d.cell.size()) return 0;
  const double u = x - double(p);
  const Cubic& c = d.cell[p];
  return c[0] + u * (c[1] + u * (c[2] + u * c[3]));
}

double force_of(double x) {
  return std::max(0.0, x) * std::sqrt(std::max(0.0, x));
}

double root_of(double x) {
  return 1.5 * std::sqrt(std::max(0.0, x));
}

double kernel(double sigma) {
  return std::abs(sigma) < two_pi ? -std::sin(std::abs(sigma)) : 0;
}

/// The integral of K(t - s) times a function over two shifts, by midpoints.
template <class Of>
double convolved(double t, Of of, int points = 400000) {
  double sum = 0;
  for (int i = 0; i < points; ++i) {
    const double s = t - two_pi + 2 * two_pi * (i + 0.5) / points;
    sum += kernel(t - s) * of(s);
  }
  return sum * 2 * two_pi / points;
}

/// Whether the lemma proves something with the residual of this guess, in some ball.
bool proved(const CubicLine& guess, const WaveProof& proof) {
  const auto residuals = wave_residuals(guess, ForceIntegrals(guess, Angles(guess.per_turn)));
  const double eta = proof.eta(residuals);
  bool any = false;
  for (double radius = 0x1p-14; radius > 1e-9; radius /= 8)
    any = any || Contraction{eta, proof.q(radius), radius}.holds();
  return any;
}

}  // namespace

TEST_CASE("integrals of cells in which a contact opens, against sums of midpoints",
          "[unit][kernel]") {
  const Sample& s = shared();
  const double h = two_pi / double(s.guess.per_turn);
  std::size_t crossing = 0;
  for (std::size_t p = 0; p < s.guess.cell.size(); ++p) {
    const Interval<double> range = value(s.guess.cell[p], Interval<double>(0, 1));
    if (range.lower >= 0 || range.upper <= 1e-6) continue;
    ++crossing;
    const CellIntegrals found = integrate(s.guess, p, s.angles);
    double c = 0, sine = 0, work = 0;
    const int n = 40000;
    for (int i = 0; i < n; ++i) {
      const double t = h * (double(p) + (i + 0.5) / n), f = force_of(at(s.guess, t));
      c += f * std::cos(t) * h / n, sine += f * std::sin(t) * h / n;
      work += f * at(s.guess, t) * h / n;
    }
    CAPTURE(p);
    check_close(found.cosine.middle(), c, 1e-13 + 1e-6 * h * h * h);
    check_close(found.sine.middle(), sine, 1e-13 + 1e-6 * h * h * h);
    check_close(found.action.middle(), work, 1e-13 + 1e-6 * h * h * h);
    CHECK(found.cosine.radius() < 1e-14);
  }
  CHECK(crossing > 5);
}

TEST_CASE("the image of the guess is its convolution with the kernel", "[unit][kernel]") {
  const Sample& s = shared();
  for (std::size_t node :
       {std::size_t(0), std::size_t(700), std::size_t(2500), std::size_t(9000)}) {
    const double t = two_pi * double(node) / double(s.guess.per_turn);
    const auto f = [&](double u) { return force_of(at(s.guess, u)); };
    CAPTURE(node);
    check_close(s.integrals.image(node).middle(), convolved(t, f), 1e-9);
    check_close(s.integrals.image_slope(node).middle(),
                (s.integrals.image(node + 1).middle() -
                 s.integrals.image(node == 0 ? 1 : node - 1).middle()) *
                    double(s.guess.per_turn) / two_pi / 2,
                1e-5);
  }
}

TEST_CASE("wrong guesses prove nothing", "[unit][kernel]") {
  const Sample& s = shared();
  CHECK(proved(s.guess, s.proof));
  CubicLine wrong = s.guess;
  for (Cubic& c : wrong.cell)
    for (double& x : c) x *= 1.001;
  CHECK_FALSE(proved(wrong, s.proof));
  wrong = s.guess;
  for (double& x : wrong.cell[300]) x = 0;
  CHECK_FALSE(proved(wrong, s.proof));
  // One that is too short
  WaveFineness few = coarse();
  few.turns = 6, few.window = 4;
  const CubicLine cut = wave_guess(-1, few);
  CHECK_FALSE(proved(cut, WaveProof(cut, few)));
}

TEST_CASE("a fineness of the wave whose spacings do not agree is refused", "[unit][kernel]") {
  const WaveFineness usual;
  CHECK((usual.per_turn == 16384 && usual.turns == 9 && usual.nodes == 64 && usual.window == 6));
  // What is allowed, at its ends, and what is not any more
  for (const WaveFineness& good : {usual, WaveFineness{4, 1, 4, 1}, {1 << 24, 64, 1 << 24, 64}})
    CHECK_NOTHROW(good.check());
  const std::pair<WaveFineness, const char*> all[] = {
      {{2048, 9, 48, 6}, "nodes = 48: allowed is a power of two from 4 to 2048"},
      {{2048, 9, 2, 6}, "nodes = 2: "},
      {{2048, 9, 4096, 6}, "nodes = 4096: "},
      {{3000, 9, 64, 6}, "per_turn = 3000: "},
      {{2, 1, 2, 1}, "per_turn = 2: "},
      {{1 << 25, 1, 4, 1}, "per_turn = 33554432: "},
      {{2048, 9, 64, 10}, "window = 10: allowed is 1 to 9"},
      {{2048, 9, 64, 0}, "window = 0: "},
      {{4, 0, 4, 0}, "turns = 0: "},
      {{4, 65, 4, 1}, "turns = 65: "},
      // What agrees with itself but not with the guess
      {{4096, 9, 64, 6}, "per_turn = 4096: "},
      {{2048, 10, 64, 10}, "window = 10: "}};
  for (const auto& [fine, said] : all)
    CHECK(
        refusal<std::invalid_argument>([&] { WaveProof(shared().guess, fine); }).starts_with(said));
  CHECK_THROWS_AS(enclose_wave(1, all[0].first), std::invalid_argument);
}

TEST_CASE("the matrix holds the response of nodes to broken lines", "[property][kernel]") {
  const Sample& s = shared();
  const auto matrix = s.proof.response();
  const auto& a = s.proof.stiffness();
  const double apart = two_pi / double(s.fine.nodes), h = two_pi / double(s.fine.per_turn);
  std::mt19937 random(7);
  for (int i = 0; i < 300; ++i) {
    const std::size_t j = random() % matrix.size(),
                      l = i < 20 ? std::size_t(i) * 3 : random() % matrix.size();
    // The stiffness is constant on cells, where Simpson's rule is exact enough
    double sum = 0;
    const double t = apart * double(j), middle = apart * double(l);
    const std::size_t per = s.fine.per_turn / s.fine.nodes;
    for (std::size_t p = l == 0 ? 0 : (l - 1) * per;
         p < std::min((l + 1) * per, (matrix.size() - 1) * per); ++p) {
      const auto of = [&](double u) {
        return (kernel(t - u) + kernel(t + u)) * (1 - std::abs(u - middle) / apart);
      };
      const double from = h * double(p);
      sum += a[p] * h / 6 * (of(from) + 4 * of(from + h / 2) + of(from + h));
    }
    CAPTURE(j, l);
    CHECK(matrix[j][l].lower <= sum + 1e-13);
    CHECK(matrix[j][l].upper >= sum - 1e-13);
    CHECK(matrix[j][l].radius() < 1e-4);
  }
}

TEST_CASE("the norm of the inverse is that of a finer discretization, or more",
          "[convergence][kernel]") {
  const Sample& s = shared();
  const long per = 64, m = per * long(s.fine.window);
  const double step = two_pi / double(per);
  Matrix<double> one_minus_b = Matrix<double>::Identity(m, m);
  for (long i = 0; i < m; ++i)
    for (long l = 0; l < m; ++l) {
      const double t = step * (double(i) + 0.5), u = step * (double(l) + 0.5);
      one_minus_b(i, l) -= step * (kernel(t - u) + kernel(t + u)) * root_of(at(s.guess, u));
    }
  const Matrix<double> inverse = one_minus_b.inverse();
  const double norm = inverse.cwiseAbs().rowwise().sum().maxCoeff();
  CAPTURE(norm, s.proof.inverse().beta);
  CHECK(s.proof.inverse().beta > 0.99 * (norm - 1));
  CHECK(s.proof.inverse().beta < 1.2 * norm);
}

TEST_CASE("what broken lines miss of the operator", "[property][kernel]") {
  // The response to the sign that bends it most, between two nodes
  const Sample& s = shared();
  const auto& a = s.proof.stiffness();
  const double h = two_pi / double(s.fine.per_turn), apart = two_pi / double(s.fine.nodes);
  double largest = 0;
  for (std::size_t l = 0; l < 4 * s.fine.nodes; ++l) {
    const auto response = [&](double t) {
      double sum = 0;
      for (std::size_t p = 0; p < a.size(); p += 4) {
        if (a[p] == 0) continue;
        const double u = h * (double(p) + 2), from = apart * double(l), to = from + apart;
        const auto near = [&](double shift) { return u > from + shift && u < to + shift; };
        const double sign = near(0) ? -1 : near(two_pi) || near(-two_pi) ? 1 : 0;
        if (sign != 0) sum += 4 * h * sign * a[p] * (kernel(t - u) + kernel(t + u));
      }
      return sum;
    };
    const double from = apart * double(l);
    largest = std::max(largest, std::abs(response(from + apart / 2) -
                                         (response(from) + response(from + apart)) / 2));
  }
  CAPTURE(largest, s.proof.inverse().epsilon);
  CHECK(largest <= s.proof.inverse().epsilon);
  CHECK(largest > 0.1 * s.proof.inverse().epsilon);
}

TEST_CASE("the derivative changes no more in the ball than the bound says", "[property][kernel]") {
  const Sample& s = shared();
  const double radius = 1e-3, q = s.proof.q(radius), q_0 = s.proof.q(1e-13);
  // |B_d - B_c| for d = c + radius, with the best of all functions, times the norm of the inverse
  double largest = 0, behind = 0;
  const auto whole = [&](double u) { return root_of(at(s.guess, u) + radius); };
  const auto change = [&](double u) { return whole(u) - root_of(at(s.guess, u)); };
  const auto moduli = [&](double t, const auto& of) {
    return convolved(
        t, [&](double u) { return (kernel(t - u) > 0 ? 1 : -1) * of(u); }, 4000);
  };
  for (int i = 0; i < 60; ++i) {
    largest = std::max(largest, moduli(two_pi * double(s.fine.window) * i / 60, change));
    behind = std::max(behind, moduli(two_pi * double(s.fine.window) + 0.1 * i, whole));
  }
  const double bound = (1 + s.proof.inverse().beta) * largest;
  CAPTURE(bound, q, q_0, behind);
  CHECK(q - q_0 >= 0.9 * bound);
  CHECK(q - q_0 <= 4 * bound);
  CHECK(q >= behind);
  CHECK(q_0 < 0.5);
}

namespace {

using Long = long double;

const Long pi_l = std::acos(Long(-1));

/// Both ends of an interval, to a small part of its width and to roundings of numbers as large as `size`.
void check_enclosure(const Interval<double>& x, Long middle, Long bound, Long size) {
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

TEST_CASE("angles of half cells are enclosed", "[unit][kernel]") {
  const Angles angles(4);
  for (std::size_t j = 0; j < 19; ++j) {
    const Long angle = pi_l * Long(j) / 4;
    CHECK((angles.cosine(j).lower < std::cos(angle) && std::cos(angle) < angles.cosine(j).upper));
    CHECK((angles.sine(j).lower < std::sin(angle) && std::sin(angle) < angles.sine(j).upper));
    CHECK(angles.cosine(j).radius() < 1e-14);
  }
}

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

namespace {

struct Limits {
  double low = 0, high = 0;
};

Limits operator+(double x, const Limits& e) {
  return {x + e.low, x + e.high};
}

/// The numbers between 0 and 1 times those between the ends.
Limits part(const Limits& e) {
  return {std::min(0.0, e.low), std::max(0.0, e.high)};
}

/// A cubic and its slope by t between both ends of a cell, by Horner's scheme.
Limits range_of(const Cubic& c) {
  return c[0] + part(c[1] + part(c[2] + part({c[3], c[3]})));
}

Limits slope_of(const Cubic& c, double h) {
  const Limits e = c[1] + part(2 * c[2] + part({3 * c[3], 3 * c[3]}));
  return {e.low / h, e.high / h};
}

double size_of(const Limits& e) {
  return std::max(std::abs(e.low), std::abs(e.high));
}

/// The whole proof once more.
struct Again {
  CubicLine guess;
  WaveFineness fine;
  double h = two_pi / double(fine.per_turn);
  long turn = long(fine.per_turn), cells = long(guess.cell.size()),
       inside = long(fine.window) * turn;
  std::vector<Limits> range{};
  std::vector<double> stiff{};
  double norm = 0, epsilon = 0, delta = 0, beta = 0;

  /// The largest sum over two turns around any cell of an even function of the cells, constant behind them.
  double widest(const std::function<double(long)>& of, long first, double behind) const {
    const auto at = [&](long i) { return i >= cells ? behind : of(i); };
    const auto even = [&](long i) { return at(i < 0 ? -1 - i : i); };
    double sum = 0, most = 0;
    for (long i = first - turn; i <= first + turn; ++i) sum += even(i);
    for (long p = first; p <= cells + turn; ++p) {
      most = std::max(most, sum);
      sum += even(p + turn + 1) - even(p - turn);
    }
    return most;
  }

  void operator_bounds() {
    for (long p = 0; p < cells; ++p) {
      range.push_back(range_of(guess.cell[std::size_t(p)]));
      stiff.push_back(p < inside ? (root_of(range.back().low) + root_of(range.back().high)) / 2
                                 : 0);
    }
    norm = widest([&](long p) { return h * stiff[std::size_t(p)]; }, 0, 0);
    const double most = *std::max_element(stiff.begin(), stiff.end()),
                 apart = two_pi / double(fine.nodes);
    epsilon = apart * apart / 8 * (norm + 4 * most);
  }

  void inverse_bounds() {
    const long per = turn / long(fine.nodes), m = long(fine.window * fine.nodes), size = m + 1;
    const double apart = h * double(per), missed = h * h / 24 * (1 + 2 / apart);
    Matrix<double> one_minus = Matrix<double>::Identity(size, size), kernels(size, size);
    std::vector<double> wrong(std::size_t(size), 0);  // of each row
    for (long j = 0; j < size; ++j) {
      const double t = apart * double(j),
                   error = missed * (std::abs(std::sin(t)) + std::abs(std::cos(t)));
      for (long p = 0; p < inside; ++p) {
        const double s = h * (double(p) + 0.5), x = s / apart, a = h * stiff[std::size_t(p)];
        const double both = kernel(t - s) + kernel(t + s);
        for (long l : {p / per, p / per + 1})
          one_minus(j, l) -= a * both * (1 - std::abs(x - double(l)));
        // Two halves of a broken line, and the mirror image where that is near enough
        const bool seen = std::abs(s - t) < two_pi, mirrored = s + t < two_pi;
        wrong[std::size_t(j)] += 2 * a * error * (seen + mirrored);
      }
      for (long l = 0; l < size; ++l)
        kernels(j, l) = kernel(apart * double(j - l)) + kernel(apart * double(j + l));
    }
    const Matrix<double> c = one_minus.inverse(), row = (c * kernels).cwiseAbs();
    const double tangent = std::tan(apart / 2);
    for (long i = 0; i < size; ++i) {
      double defect = 0, sum = 0;
      for (long j = 0; j < size; ++j) defect += std::abs(c(i, j)) * wrong[std::size_t(j)];
      for (long l = 0; l + 1 < size; ++l)
        sum += *std::max_element(stiff.begin() + l * per, stiff.begin() + (l + 1) * per) * tangent *
               (row(i, l) + row(i, l + 1));
      delta = std::max(delta, defect), beta = std::max(beta, sum);
    }
  }

  double q(double r) const {
    const double behind = h * root_of(r);
    const auto change = [&](long p) {
      const auto i = std::size_t(p);
      return h *
             size_of({root_of(range[i].low - r) - stiff[i], root_of(range[i].high + r) - stiff[i]});
    };
    const auto whole = [&](long p) { return h * root_of(range[std::size_t(p)].high + r); };
    return std::max((1 + beta) * (epsilon + widest(change, 0, behind)) + delta * norm,
                    widest(whole, inside, behind));
  }

  std::vector<double> residuals(const ForceIntegrals& integrals) const {
    const auto cubic = [&](long i) { return guess.cell[std::size_t(i < 0 ? -1 - i : i)]; };
    const auto none = [&](long i) { return (i < 0 ? -1 - i : i) >= cells; };
    // The force at the beginning of a cell and its slope on it; mirrored cells run backwards
    const auto start = [&](long i) {
      const Cubic c = none(i) ? Cubic{} : cubic(i);
      return force_of(i < 0 ? c[0] + c[1] + c[2] + c[3] : c[0]);
    };
    const auto change = [&](long i) {
      if (none(i)) return Limits{};
      const Limits d = range_of(cubic(i)), by_t = slope_of(cubic(i), h);
      const double low = root_of(d.low), high = root_of(d.high);
      const Limits e{std::min(by_t.low * low, by_t.low * high),
                     std::max(by_t.high * low, by_t.high * high)};
      return i < 0 ? Limits{-e.high, -e.low} : e;
    };
    double most = 0, behind = 0;
    for (const Limits& e : range) most = std::max(most, force_of(e.high));
    std::vector<double> out;
    for (long i = 0; i < cells; ++i) {
      const Cubic c = cubic(i);
      const auto n = std::size_t(i);
      const double image = integrals.image(n).middle();
      const double left = c[0] - image,
                   right = c[0] + c[1] + c[2] + c[3] - integrals.image(n + 1).middle();
      const double second =
          2 * c[2] / (h * h) + image - start(i + turn) + 2 * start(i) - start(i - turn);
      const Limits before = change(i - turn), here = change(i), after = change(i + turn);
      const double slope = 6 * c[3] / (h * h * h) + integrals.image_slope(n).middle(),
                   bent = 12 * h * most;
      const Limits third{slope - bent - after.high + 2 * here.low - before.high,
                         slope + bent - after.low + 2 * here.high - before.low};
      out.push_back(std::max(std::abs(left), std::abs(right)) +
                    h * h / 8 * (std::abs(second) + h * size_of(third)));
    }
    for (long i = cells - turn; i < cells; ++i) behind += h * force_of(range[std::size_t(i)].high);
    out.push_back(behind);
    return out;
  }
};

}  // namespace

TEST_CASE("each bound of the proof for the waves follows from its formula", "[unit][kernel]") {
  const WaveFineness fine{.per_turn = 256, .turns = 5, .nodes = 16, .window = 3};
  Again again{wave_guess(-1, fine), fine};
  again.operator_bounds(), again.inverse_bounds();
  const WaveProof proof(again.guess, fine);
  const double x = pi<double>() / double(fine.nodes);
  check_close(proof.inverse().epsilon, again.epsilon, 0, 1e-9);
  check_close(proof.inverse().delta, again.delta, 0, 1e-6);
  CHECK(proof.inverse().beta >= again.beta * (1 - 1e-9));  // the tangent is bounded by a fraction
  CHECK(proof.inverse().beta <= again.beta * (1 + x * x / 4));
  again.beta = proof.inverse().beta, again.delta = proof.inverse().delta;
  for (double radius : {1e-6, 1e-3, 0.3}) check_close(proof.q(radius), again.q(radius), 0, 1e-8);
  // The residual on every cell and behind them
  const Angles angles(fine.per_turn);
  const ForceIntegrals integrals(again.guess, angles);
  const auto residuals = wave_residuals(again.guess, integrals), plain = again.residuals(integrals);
  REQUIRE(residuals.size() == plain.size());
  for (std::size_t n = 0; n < plain.size(); ++n) check_close(residuals[n], plain[n], 1e-10, 1e-8);
  // What A makes of it: inside the window and behind
  std::vector<double> r(residuals.size(), 1e-3);
  r[std::size_t(again.inside) - 1] = 2;
  check_close(proof.eta(r), 2 * (1 + proof.inverse().beta), 0, 1e-12);
  r[std::size_t(again.inside)] = 40;
  check_close(proof.eta(r), 40, 0, 0);
  r[std::size_t(again.inside)] = 1e-3, r.back() = 50;
  check_close(proof.eta(r), 50, 0, 0);
}

TEST_CASE("both waves lie where Newton's method finds them, as certain as their balls make them",
          "[unit][kernel]") {
  const WaveFineness fine{.per_turn = 8192};
  Limits highest;  // of the wave with positive sign, and of the other
  for (int sign : {1, -1}) {
    const EnclosedWave w = enclose_wave(sign, fine);
    const CubicLine guess = wave_guess(sign, fine);
    const Angles angles(fine.per_turn);
    const ForceIntegrals integrals(guess, angles);
    const double r = w.exists.radius, h = two_pi / double(fine.per_turn);
    double energy = 0, width = 0, mass = 0, both = 0, peak = 0, stiffness = 0;
    for (std::size_t n = 0; n < fine.turns; ++n) {
      double here = 0;
      for (std::size_t p = n * fine.per_turn; p < (n + 1) * fine.per_turn; ++p) {
        const Limits e = range_of(guess.cell[p]);
        here += h * root_of(e.high + r), mass += h * force_of(e.high);
        peak = std::max(peak, guess.cell[p][0]);
      }
      const double c = integrals.cosine(n * fine.per_turn, (n + 1) * fine.per_turn).middle(),
                   s = integrals.sine(n * fine.per_turn, (n + 1) * fine.per_turn).middle();
      const double d = guess.cell[n * fine.per_turn][0], twice = n == 0 ? 1 : 2;
      energy += c * c + s * s + twice * 0.4 * force_of(d) * std::max(0.0, d);
      width += 2 * (std::abs(c) + std::abs(s)) * r * here + twice * force_of(d) * r;
      stiffness += here;
    }
    width += two_pi * two_pi * r * r * r + r * r * std::sqrt(r);  // half of what the tail may add
    both = 2 * stiffness + 6 * two_pi * std::sqrt(r);
    const double wrong = 10 * w.residual * mass + 10 * r * r * both * (1.5 + both / 2);
    CAPTURE(sign, r);
    check_close(w.energy.middle(), energy, 1e-2 * width);
    check_close(w.energy.radius(), width, 0, 1e-2);
    check_close(w.action.middle(), integrals.action().middle(), 1e-2 * wrong);
    check_close(w.action.radius(), wrong, 0, 1e-2);
    CHECK(w.peak.upper >= peak + r);
    check_close(w.peak.upper, peak + r, 1e-3 * r + 1e-7);
    check_close(w.peak.lower, peak - r, 1e-3 * r + 1e-7);
    CHECK(16 * std::sqrt(r) < 1);
    const KernelWave there = wave_of_type_one(1, sign, {1.5, 0});
    CHECK((w.exists.holds() && w.unique.holds()));
    CHECK((w.energy.contains(there.energy()) && w.peak.contains(there.peak()) &&
           w.action.contains(there.action())));
    CHECK((w.energy.radius() < 1e-9 && w.action.radius() < 1e-9 && w.peak.radius() < 1e-10));
    (sign > 0 ? highest.low : highest.high) = w.peak.middle();
  }
  CHECK(highest.low < highest.high);
}
