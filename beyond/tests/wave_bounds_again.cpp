// The bounds of the proof for the waves of the kernel equation a second time, in plain numbers, from the formulas of
// its header: to eight digits both must be the same.

#include <algorithm>
#include <functional>

#include <Eigen/LU>

#include "check.hpp"
#include "lattice/algebra/dense.hpp"
#include "lattice/orbits/shooting.hpp"
#include "sec5/kernel_wave.hpp"
#include "sec5/wave_enclosure.hpp"

namespace wave_bounds_again {

using namespace lattice;

namespace {

const double two_pi = 2 * pi<double>();

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
double root_of(double x) {
  return 1.5 * std::sqrt(std::max(0.0, x));
}
double force_of(double x) {
  return std::max(0.0, x) * std::sqrt(std::max(0.0, x));
}
double size_of(const Limits& e) {
  return std::max(std::abs(e.low), std::abs(e.high));
}
double kernel(double sigma) {
  return std::abs(sigma) < two_pi ? -std::sin(std::abs(sigma)) : 0;
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
  double norm = 0, epsilon = 0, delta = 0, kappa = 0;

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
      delta = std::max(delta, defect), kappa = std::max(kappa, sum);
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
    return std::max((1 + kappa) * (epsilon + widest(change, 0, behind)) + delta * norm,
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
  check_close(proof.epsilon(), again.epsilon, 0, 1e-9);
  check_close(proof.delta(), again.delta, 0, 1e-6);
  CHECK(proof.kappa() >= again.kappa * (1 - 1e-9));  // the tangent is bounded by a fraction
  CHECK(proof.kappa() <= again.kappa * (1 + x * x / 4));
  again.kappa = proof.kappa(), again.delta = proof.delta();
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
  check_close(proof.eta(r), 2 * (1 + proof.kappa()), 0, 1e-12);
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

}  // namespace wave_bounds_again
