// The proof for the waves of the kernel equation: it holds what Newton's method finds, each of its bounds is held
// against what it bounds, and it fails where something is wrong.

#include "sec5/wave_enclosure.hpp"

#include <algorithm>
#include <random>

#include <Eigen/LU>

#include "check.hpp"
#include "lattice/algebra/dense.hpp"
#include "lattice/orbits/shooting.hpp"

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

double force(const CubicLine& d, double t) {
  const double x = std::max(0.0, at(d, t));
  return x * std::sqrt(x);
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
    any = any || Contraction<double>{eta, proof.q(radius), radius}.holds();
  return any;
}

}  // namespace

TEST_CASE("integrals of cells against Simpson's rule", "[unit][kernel]") {
  const Sample& s = shared();
  const double h = two_pi / double(s.guess.per_turn);
  std::size_t crossing = 0, first_crossing = 0;
  for (std::size_t p = 0; p < s.guess.cell.size(); p += 1) {
    const Interval<double> range = value(s.guess.cell[p], Interval<double>(0, 1));
    const bool zero = range.lower < 0 && range.upper > 1e-6;
    if (zero && crossing++ == 0) first_crossing = p;
    if (!zero && p % 97) continue;
    const CellIntegrals found = integrate(s.guess, p, s.angles);
    double c = 0, sine = 0, work = 0;
    const int n = zero ? 40000 : 400;
    for (int i = 0; i < n; ++i) {
      const double t = h * (double(p) + (i + 0.5) / n), f = force(s.guess, t);
      c += f * std::cos(t) * h / n, sine += f * std::sin(t) * h / n;
      work += f * at(s.guess, t) * h / n;
    }
    CAPTURE(p, zero);
    check_close(found.cosine.middle(), c, 1e-13 + 1e-6 * h * h * h);
    check_close(found.sine.middle(), sine, 1e-13 + 1e-6 * h * h * h);
    check_close(found.action.middle(), work, 1e-13 + 1e-6 * h * h * h);
    CHECK(found.cosine.radius() < 1e-14);
  }
  CHECK(crossing > 5);
  CHECK(first_crossing > 0);
}

TEST_CASE("a cell of few pieces is held by its integral", "[property][kernel]") {
  // Long cells on which the remainder of the rule matters: (1 + x^2)^(3/2) cos t on a quarter turn
  CubicLine line{4, {{0.01, 1, 0.5, 0.1}, {0.3, -0.2, 0, 0}, {1, 0.5, 1, 0}}};
  const Angles angles(line.per_turn);
  for (std::size_t p = 0; p < line.cell.size(); ++p) {
    const CellIntegrals found = integrate(line, p, angles);
    double c = 0, sine = 0;
    const int n = 2000000;
    for (int i = 0; i < n; ++i) {
      const double t = two_pi / 4 * (double(p) + (i + 0.5) / n), f = force(line, t);
      c += f * std::cos(t), sine += f * std::sin(t);
    }
    check_close(found.cosine.middle(), c * two_pi / 4 / n, 1e-11);
    check_close(found.sine.middle(), sine * two_pi / 4 / n, 1e-11);
    CHECK(found.cosine.radius() < 1e-12);
  }
}

TEST_CASE("the image of the guess is its convolution with the kernel", "[unit][kernel]") {
  const Sample& s = shared();
  for (std::size_t node :
       {std::size_t(0), std::size_t(700), std::size_t(2500), std::size_t(9000)}) {
    const double t = two_pi * double(node) / double(s.guess.per_turn);
    const auto f = [&](double u) { return force(s.guess, u); };
    CAPTURE(node);
    check_close(s.integrals.image(node).middle(), convolved(t, f), 1e-9);
    check_close(s.integrals.image_slope(node).middle(),
                (s.integrals.image(node + 1).middle() -
                 s.integrals.image(node == 0 ? 1 : node - 1).middle()) *
                    double(s.guess.per_turn) / two_pi / 2,
                1e-5);
  }
}

TEST_CASE("the residual between two nodes is bounded", "[property][kernel]") {
  // A guess that is wrong by a bump of a quarter of a cell: the nodes do not see it
  const Sample& s = shared();
  CubicLine wrong = s.guess;
  const std::size_t p = 1500;
  wrong.cell[p][1] += 1e-6, wrong.cell[p][2] -= 1e-6;
  const auto right_bounds = wave_residuals(s.guess, s.integrals);
  const auto bounds = wave_residuals(wrong, ForceIntegrals(wrong, s.angles));
  CHECK(right_bounds[p] < 1e-8);
  CHECK(bounds[p] > 0.25e-6);
  CHECK(bounds[p] < 1e-6);
  // A guess from another exponent or too short has a large one
  WaveFineness few = coarse();
  few.turns = 6, few.window = 4;
  const CubicLine cut = wave_guess(-1, few);
  CHECK_FALSE(proved(cut, WaveProof(cut, few)));
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
}

TEST_CASE("a fineness of the wave whose spacings do not agree is refused", "[unit][kernel]") {
  WaveFineness fine = coarse();
  const auto complaint = [&] {
    return refusal<std::invalid_argument>([&] { WaveProof(shared().guess, fine); });
  };
  const struct {
    std::size_t WaveFineness::*of, value;
    const char* said;
  } all[] = {{&WaveFineness::nodes, 48, "nodes = 48: allowed is a power of two from 4 to 2048"},
             {&WaveFineness::nodes, 24, "nodes = 24: "},
             {&WaveFineness::nodes, 2, "nodes = 2: "},
             {&WaveFineness::nodes, 4096, "nodes = 4096: "},
             {&WaveFineness::per_turn, 3000, "per_turn = 3000: "},
             {&WaveFineness::window, 10, "window = 10: allowed is 1 to 9"},
             {&WaveFineness::window, 0, "window = 0: "},
             // What agrees with itself but not with the guess
             {&WaveFineness::per_turn, 4096, "per_turn = 4096: "}};
  for (const auto& [of, value, said] : all) {
    fine = coarse();
    fine.*of = value;
    CHECK(complaint().starts_with(said));
  }
  const WaveFineness usual;
  CHECK((usual.per_turn == 16384 && usual.turns == 9 && usual.nodes == 64 && usual.window == 6));
  for (const WaveFineness& good : {usual, WaveFineness{4, 1, 4, 1}, {1 << 24, 64, 1 << 24, 64}})
    CHECK_NOTHROW(good.check());
  for (const WaveFineness& bad :
       {WaveFineness{2, 1, 2, 1}, {1 << 25, 1, 4, 1}, {4, 0, 4, 0}, {4, 65, 4, 1}, {4, 2, 4, 3}})
    CHECK_THROWS_AS(bad.check(), std::invalid_argument);
  fine = coarse();
  fine.turns = fine.window = 10;
  CHECK(complaint().starts_with("window = 10: "));
  fine.per_turn = 4096, fine.nodes = 48;
  CHECK_THROWS_AS(enclose_wave(1, fine), std::invalid_argument);
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
      one_minus_b(i, l) -=
          step * (kernel(t - u) + kernel(t + u)) * 1.5 * std::sqrt(std::max(0.0, at(s.guess, u)));
    }
  const Matrix<double> inverse = one_minus_b.inverse();
  const double norm = inverse.cwiseAbs().rowwise().sum().maxCoeff();
  CAPTURE(norm, s.proof.kappa());
  CHECK(s.proof.kappa() > 0.99 * (norm - 1));
  CHECK(s.proof.kappa() < 1.2 * norm);
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
  CAPTURE(largest, s.proof.epsilon());
  CHECK(largest <= s.proof.epsilon());
  CHECK(largest > 0.1 * s.proof.epsilon());
}

TEST_CASE("the derivative changes no more in the ball than the bound says", "[property][kernel]") {
  const Sample& s = shared();
  const double radius = 1e-3, q = s.proof.q(radius), q_0 = s.proof.q(1e-13);
  // |B_d - B_c| for d = c + radius, with the best of all functions, times the norm of the inverse
  double largest = 0, behind = 0;
  const auto change = [&](double u) {
    const double d = at(s.guess, u);
    return 1.5 * (std::sqrt(std::max(0.0, d + radius)) - std::sqrt(std::max(0.0, d)));
  };
  const auto whole = [&](double u) {
    return 1.5 * std::sqrt(std::max(0.0, at(s.guess, u) + radius));
  };
  const auto moduli = [&](double t, const auto& of) {
    return convolved(
        t, [&](double u) { return (kernel(t - u) > 0 ? 1 : -1) * of(u); }, 4000);
  };
  for (int i = 0; i < 60; ++i) {
    largest = std::max(largest, moduli(two_pi * double(s.fine.window) * i / 60, change));
    behind = std::max(behind, moduli(two_pi * double(s.fine.window) + 0.1 * i, whole));
  }
  const double bound = (1 + s.proof.kappa()) * largest;
  CAPTURE(bound, q, q_0, behind);
  CHECK(q - q_0 >= 0.9 * bound);
  CHECK(q - q_0 <= 4 * bound);
  CHECK(q >= behind);
  // In a ball of no size what is left is the stiffness that is not constant on cells, here about t = 0
  const auto& a = s.proof.stiffness();
  const double h = two_pi / double(s.fine.per_turn);
  double uneven = 0;
  for (std::size_t p = 0; p < s.fine.per_turn; ++p)
    for (double part : {0.1, 0.3, 0.5, 0.7, 0.9})
      uneven +=
          std::abs(1.5 * std::sqrt(std::max(0.0, at(s.guess, h * (double(p) + part)))) - a[p]) * 2 *
          h / 5;
  const auto inside = [&](double share) {
    return (1 + s.proof.kappa()) * (s.proof.epsilon() + share * uneven);
  };
  CAPTURE(uneven, s.proof.epsilon(), s.proof.kappa());
  CHECK(q_0 >= inside(1));
  CHECK(q_0 <= inside(4));
  CHECK(q_0 < 0.5);
}

TEST_CASE("products of large matrices are cut in the same way on every processor",
          "[unit][dense]") {
  // Eigen would ask the processor for its caches, and would sum in another order where they are larger
#if defined(__x86_64__)
  CHECK(Eigen::l1CacheSize() == 32 << 10);
  CHECK(Eigen::l2CacheSize() == 256 << 10);
  CHECK(Eigen::l3CacheSize() == 2 << 20);
#endif
}
