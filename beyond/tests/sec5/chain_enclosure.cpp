// The proof for the chain's breathers with its constants: each against what it bounds and from its
// formula once more; it holds what Newton's method finds, and fails where something is wrong.

#include "sec5/chain_enclosure.hpp"
#include "sec3/article_chains.hpp"

#include <algorithm>

#include <Eigen/LU>

#include "lattice/algebra/dense.hpp"
#include "lattice/orbits/shooting.hpp"
#include "sec5/circle.hpp"
#include "support/check.hpp"

using namespace lattice;

namespace {

const double turn = pi<double>(), omega = 1.1;
const Interval<double> enclosed_omega = Interval<double>(11) / Interval<double>(10);

const double sine = std::sin(turn / omega), mean_g = 2 / sine - 1, most_g = turn / (omega * sine);

/// The kernel of the response of the wells, whose Fourier coefficients are 1 / (1 - omega^2 k^2).
double g(double theta) {
  return most_g * std::cos((turn - theta) / omega);
}

/// The same on even functions.
double g(double t, double s) {
  return (g(std::abs(t - s)) + g(t + s)) / 2;
}

double cosine_sum(const std::vector<double>& c, double theta) {
  double sum = 0;
  for (std::size_t k = 0; k < c.size(); ++k) sum += c[k] * std::cos(double(k) * theta);
  return sum;
}

/// The variation of the derivative of c_+^(3/2) over the circle, over 2 pi, from samples.
double sampled_variation(const std::vector<double>& c) {
  const int n = 20000;
  double sum = 0, before = 0;
  for (int i = 0; i <= n; ++i) {
    const double theta = 2 * turn * i / n;
    double slope = 0;
    for (std::size_t k = 0; k < c.size(); ++k)
      slope -= c[k] * double(k) * std::sin(double(k) * theta);
    const double now = 1.5 * std::sqrt(std::max(0.0, cosine_sum(c, theta))) * slope;
    if (i > 0) sum += std::abs(now - before);
    before = now;
  }
  return sum / (2 * turn);
}

}  // namespace

TEST_CASE("mean and maximum of the kernel of a well", "[unit]") {
  const int n = 200000;
  double mean = 0, most = 0, third = 0;
  for (int i = 0; i < n; ++i) {
    const double theta = 2 * turn * (i + 0.5) / n, value = g(theta);
    mean += std::abs(value) / n, third += value * std::cos(3 * theta) / n;
    most = std::max(most, std::abs(value));
  }
  check_close(third, 1 / (1 - 9 * omega * omega), 1e-8);
  check_close(mean_of_kernel(enclosed_omega).middle(), mean, 1e-8);
  check_close(largest_of_kernel(enclosed_omega).middle(), most, 1e-8);
  CHECK(mean_of_kernel(enclosed_omega).radius() < 1e-11);
}

TEST_CASE("the variation of the force", "[property]") {
  for (const std::vector<double>& c :
       {std::vector<double>{0, 1}, {0.2, 1, -0.3}, {-0.3, 1, 0.4, 0.1}, {1, 0, 0, 0, 0, 0.01}}) {
    const double bound = variation_of_force(c).lower, sampled = sampled_variation(c);
    CAPTURE(c.size(), bound, sampled);
    CHECK(sampled <= bound);
    CHECK(sampled > 0.08 * bound);
  }
}

TEST_CASE("coefficients that are folded back or left out", "[unit]") {
  // Those of a force decrease as the bound at least: folded back by few samples
  const std::vector<double> c{0.1, 1, 0.2};
  const auto coefficients = [&](std::size_t samples) {
    const CosineTable table(samples);
    std::vector<Interval<double>> f;
    for (double x : sample(c, table).value) f.push_back(hertz(Interval<double>(x)));
    return discrete_coefficients(f, 8, table);
  };
  const auto few = coefficients(32), many = coefficients(32768);
  const double bound = (variation_of_force(c) * folded_back(32, 8)).lower;
  for (std::size_t k = 0; k < 8; ++k) CHECK(std::abs(few[k].middle() - many[k].middle()) <= bound);
  // The sums themselves
  double folded = 0, left = 0;
  for (int j = 1; j < 100000; ++j)
    for (int sign : {1, -1}) folded += 2 / std::pow(32.0 * sign * j + 7, 2);
  for (int k = 8; k < 100000; ++k)
    left += 2 / (double(k) * k * (omega * omega * double(k) * k - 1));
  CHECK(folded <= folded_back(32, 8).lower);
  CHECK(folded > 0.5 * folded_back(32, 8).upper);
  CHECK(left <= left_out(enclosed_omega, 8).lower);
  CHECK(left > 0.5 * left_out(enclosed_omega, 8).upper);
}

TEST_CASE("ranges of a cosine sum on cells", "[unit]") {
  // An extremum in the middle of a cell, as far above its ends as the bound allows
  std::vector<double> c(8);
  c[7] = 1;
  const auto cells = ranges(c, 64);
  double above = 0;
  for (std::size_t p = 0; p < cells.size(); ++p) {
    const auto at = [&](double x) {
      return cosine_sum(c, turn * (double(p) + x) / double(cells.size()));
    };
    for (int i = 0; i <= 40; ++i) CHECK(cells[p].contains(at(i / 40.0)));
    above = std::max(above, at(0.5) - std::max(at(0), at(1)));
  }
  const double allowed = cells[0].upper - 1;
  CHECK(above > 0.7 * allowed);
}

TEST_CASE("the norm of the inverse is that of a finer discretization", "[convergence]") {
  // 1 - B with rectangles instead of broken lines, around a bond; its inverse has the norm 1 + beta or less
  Fineness fine;
  fine.samples = 4096, fine.harmonics = 64;
  const ChainGuess guess = chain_guess(Centre::bond, 11, 10, fine);
  const ChainProof proof(guess, fine);
  const long m = 64, window = long(guess.c.size());
  Matrix<double> one_minus_b = Matrix<double>::Identity(m * window, m * window);
  for (long n = 0; n < window; ++n)
    for (long i = 0; i < m; ++i)
      for (long l = 0; l < m; ++l) {
        const double t = turn * (double(i) + 0.5) / double(m),
                     s = turn * (double(l) + 0.5) / double(m);
        const double both = g(t, s) / double(m);
        const auto act = [&](long contact, double factor) {
          const double d = cosine_sum(guess.c[std::size_t(contact)], s);
          one_minus_b(n * m + i, contact * m + l) -=
              factor * both * 1.5 * std::sqrt(std::max(0.0, d));
        };
        act(n, -2);
        if (n + 1 < window) act(n + 1, 1);
        act(n > 0 ? n - 1 : 1, 1);
      }
  const Matrix<double> inverse = one_minus_b.inverse();
  const double norm = inverse.cwiseAbs().rowwise().sum().maxCoeff();
  CAPTURE(norm, proof.inverse().beta);
  CHECK(proof.inverse().beta > 0.97 * (norm - 1));
  CHECK(proof.inverse().beta < 1.1 * norm);
  // What broken lines miss: between two nodes the response bends
  CHECK(proof.inverse().delta < 1e-2);
  CHECK(proof.inverse().epsilon > 1e-4);
}

namespace {

/// Both ends of a range, and what the root makes of it.
struct Limits {
  double low = 0, high = 0;
};

double root_of(double x) {
  return 1.5 * std::sqrt(std::max(0.0, x));
}

double force_of(double x) {
  return std::max(0.0, x) * std::sqrt(std::max(0.0, x));
}

double moduli(const std::vector<double>& c, int power) {
  double sum = 0;
  for (std::size_t k = 0; k < c.size(); ++k) sum += std::abs(c[k]) * std::pow(double(k), power);
  return sum;
}

/// Contact `of` acts on contact n with this factor, at the same phase or half a period later.
struct Acts {
  std::size_t of;
  double factor;
  bool later;
};

std::vector<Acts> on(Centre centre, std::size_t n) {
  const Acts left = n > 0 ? Acts{n - 1, 1, false}
                          : Acts{centre == Centre::bond ? 1U : 0U, 1, centre == Centre::site};
  return {{n, -2, false}, {n + 1, 1, false}, left};
}

/// The whole proof once more; sums over the contacts that act are `row`.
struct Again {
  ChainGuess guess;
  Fineness fine;
  std::size_t window = guess.c.size(), m = fine.nodes, cells = fine.cells, per = cells / m;
  std::vector<std::vector<Limits>> range{};
  std::vector<std::vector<double>> stiff{};  ///< the middle of the root's range on every cell
  double epsilon = 0, norm = 0, beta = 0, delta = 0;

  double row(const std::vector<double>& of, std::size_t n) const {
    double sum = 0;
    for (const Acts& a : on(guess.centre, n))
      sum += a.of < of.size() ? std::abs(a.factor) * of[a.of] : 0;
    return sum;
  }

  /// What changes of the operator in one contact: its mean times the largest |g|, or its maximum times the mean |g|.
  template <class Of>
  double changed(std::size_t n, Of of) const {
    double mean = 0, most = 0;
    for (std::size_t p = 0; p < cells; ++p)
      mean += of(p) / double(cells), most = std::max(most, of(p));
    return n < window ? std::min(most_g * mean, mean_g * most) : 0;
  }

  void operator_bounds() {
    std::vector<double> response, largest;
    for (const auto& c : guess.c) {
      range.emplace_back(), stiff.emplace_back();
      const double bend = std::pow(turn / double(cells), 2) / 8 * moduli(c, 2);
      for (std::size_t p = 0; p < cells; ++p) {
        const double a = cosine_sum(c, turn * double(p) / double(cells)),
                     b = cosine_sum(c, turn * double(p + 1) / double(cells));
        const Limits e{std::min(a, b) - bend, std::max(a, b) + bend};
        range.back().push_back(e), stiff.back().push_back((root_of(e.low) + root_of(e.high)) / 2);
      }
      const std::size_t n = stiff.size() - 1;
      response.push_back(changed(n, [&](std::size_t p) { return stiff[n][p]; }));
      largest.push_back(*std::max_element(stiff[n].begin(), stiff[n].end()));
    }
    double source = 0;
    for (std::size_t n = 0; n < window; ++n)
      norm = std::max(norm, row(response, n)), source = std::max(source, row(largest, n));
    epsilon = std::pow(turn / double(m), 2) / 8 * (source + norm) / (omega * omega);
  }

  void inverse_bounds() {
    const long block = long(m) + 1, size = block * long(window);
    // The response of nodes to broken lines by the rule of midpoints, and by how much that may be wrong
    std::vector<Matrix<double>> part, wrong;
    const double h = turn / double(cells), w = 1 / omega;
    const double missed = h * h / 24 * most_g * (w * w + 2 * double(m) / turn * w);
    for (std::size_t n = 0; n < window; ++n) {
      part.push_back(Matrix<double>::Zero(block, block)), wrong.push_back(part.back());
      for (long j = 0; j < block; ++j)
        for (std::size_t p = 0; p < cells; ++p) {
          const double s = h * (double(p) + 0.5), x = s / turn * double(m);
          for (long l : {long(x), long(x) + 1}) {
            const double a = stiff[n][p] / double(cells);
            part[n](j, l) += a * g(turn * double(j) / double(m), s) * (1 - std::abs(x - double(l)));
            wrong[n](j, l) += a * missed;
          }
        }
    }
    Matrix<double> one_minus = Matrix<double>::Identity(size, size),
                   radius = Matrix<double>::Zero(size, size);
    const auto every_link = [&](auto use) {
      for (long n = 0; n < long(window); ++n)
        for (const Acts& a : on(guess.centre, std::size_t(n)))
          for (long j = 0; j < block && a.of < window; ++j)
            use(n * block + j, long(a.of), a.factor, a.later ? block - 1 - j : j);
    };
    every_link([&](long row, long of, double factor, long j) {
      one_minus.block(row, of * block, 1, block) -= factor * part[std::size_t(of)].row(j);
      radius.block(row, of * block, 1, block) += std::abs(factor) * wrong[std::size_t(of)].row(j);
    });
    const Matrix<double> c = one_minus.inverse();
    delta = (c.cwiseAbs() * radius).rowwise().sum().maxCoeff();
    // CNB as combinations of g, and the integral of their moduli: two sines between two nodes
    Matrix<double> weight = Matrix<double>::Zero(size, size), values(block, block);
    every_link([&](long row, long of, double factor, long j) {
      weight.col(of * block + j) += factor * c.col(row);
    });
    for (long j = 0; j < block; ++j)
      for (long l = 0; l < block; ++l)
        values(j, l) = g(turn * double(j) / double(m), turn * double(l) / double(m));
    const double tangent = omega * std::tan(turn / double(m) / (2 * omega)) / turn;
    for (long i = 0; i < size; ++i) {
      double sum = 0;
      for (long n = 0; n < long(window); ++n) {
        const Matrix<double> v = (weight.block(i, n * block, 1, block) * values).cwiseAbs();
        for (long l = 1; l < block; ++l) {
          const auto a = stiff[std::size_t(n)].begin() + (l - 1) * long(per);
          sum += *std::max_element(a, a + long(per)) * (v(0, l - 1) + v(0, l)) * tangent;
        }
      }
      beta = std::max(beta, sum);
    }
  }

  double q(double r) const {
    const double slack = mean_g * root_of(r);
    std::vector<double> change;
    for (std::size_t n = 0; n < window; ++n)
      change.push_back(changed(n, [&](std::size_t p) {
        return std::max(root_of(range[n][p].high + r) - stiff[n][p],
                        stiff[n][p] - root_of(range[n][p].low - r));
      }));
    change.push_back(slack);
    double worst = 0, last = 0;
    for (std::size_t n = 0; n < window; ++n) worst = std::max(worst, row(change, n));
    for (const Limits& e : range.back()) last = std::max(last, root_of(e.high + r));
    return std::max(
        {(1 + beta) * (epsilon + worst) + delta * norm, mean_g * last + 3 * slack, 4 * slack});
  }

  std::vector<double> residuals() const {
    const std::size_t samples = fine.samples;
    std::vector<std::vector<double>> f;
    double response = 0;
    for (std::size_t k = 0; k < fine.harmonics; ++k)
      response += std::abs(1 / (1 - omega * omega * double(k * k)));
    for (const auto& c : guess.c) {
      std::vector<double> at;
      for (std::size_t j = 0; j <= samples / 2; ++j)
        at.push_back(force_of(cosine_sum(c, 2 * turn * double(j) / double(samples))));
      f.emplace_back();
      for (std::size_t k = 0; k < fine.harmonics; ++k) {
        double sum = 0;
        for (std::size_t j = 0; j < samples; ++j)
          sum += at[std::min(j, samples - j)] *
                 std::cos(2 * turn * double(k * j % samples) / double(samples));
        f.back().push_back(sum * (k ? 2 : 1) / double(samples));
      }
    }
    const double gap = double(samples - fine.harmonics), last = double(fine.harmonics - 1);
    const double per_variation = response * 2 * turn * turn / 3 / (gap * gap) +
                                 2 / (3 * (omega * omega - 1 / (last * last)) * last * last * last);
    std::vector<double> out;
    for (std::size_t n = 0; n <= window; ++n) {
      double sum = 0, varied = 0;
      for (std::size_t k = 0; k < fine.harmonics; ++k) {
        double pull = 0;
        for (const Acts& a : on(guess.centre, n))
          if (a.of < window) pull += f[a.of][k] * a.factor * (a.later && k % 2 ? -1 : 1);
        sum +=
            std::abs((n < window ? guess.c[n][k] : 0) - pull / (1 - omega * omega * double(k * k)));
      }
      for (const Acts& a : on(guess.centre, n))
        if (a.of < window)
          varied += std::abs(a.factor) * 3 * std::sqrt(moduli(guess.c[a.of], 0)) *
                    moduli(guess.c[a.of], 2);
      out.push_back(sum + varied * per_variation);
    }
    return out;
  }
};

Fineness small() {
  return {.contacts = 4, .harmonics = 32, .samples = 256, .nodes = 16, .cells = 128};
}

}  // namespace

TEST_CASE("each bound of the proof for the chain follows from its formula", "[unit]") {
  for (Centre centre : both_centres) {
    Again again{chain_guess(centre, 11, 10, small()), small()};
    again.operator_bounds(), again.inverse_bounds();
    const ChainProof proof(again.guess, again.fine);
    const double x = turn / double(again.m) / (2 * omega);
    CAPTURE(centre == Centre::bond);
    check_close(proof.inverse().epsilon, again.epsilon, 0, 1e-9);
    check_close(proof.inverse().delta, again.delta, 1e-11, 1e-8);
    // The tangent is bounded by a fraction
    CHECK(proof.inverse().beta >= again.beta * (1 - 1e-9));
    CHECK(proof.inverse().beta <= again.beta * (1 + x * x / 4));
    again.beta = proof.inverse().beta;
    for (double radius : {1e-6, 1e-3, 0.3}) check_close(proof.q(radius), again.q(radius), 0, 1e-8);
    // The residual, in the window and of the first contact behind it
    const auto residuals = chain_residuals(again.guess, again.fine), plain = again.residuals();
    REQUIRE(residuals.size() == plain.size());
    for (std::size_t n = 0; n < plain.size(); ++n) check_close(residuals[n], plain[n], 1e-10, 1e-8);
    check_close(proof.eta({1, 5, 2, 3, 4}), (1 + again.beta) * 5, 0, 1e-12);
    check_close(proof.eta({1e-3, 1e-3, 1e-3, 1e-3, 40}), 40, 0, 0);
  }
}

TEST_CASE("where a cosine is small its rounding widens the range", "[unit]") {
  const std::size_t many = std::size_t(1) << 17;
  const Sampled values = sample({0, 1}, CosineTable(2 * many));
  const double h = turn / double(many), wide = h * h / 8 + values.error;
  const Interval<double> middle = ranges({0, 1}, many)[many / 2];
  CHECK(values.error > 1e-6 * h * h / 8);
  check_close(middle.upper - std::max(values.value[many / 2], values.value[many / 2 + 1]), wide, 0,
              1e-7);
  check_close(std::min(values.value[many / 2], values.value[many / 2 + 1]) - middle.lower, wide, 0,
              1e-7);
}

TEST_CASE(
    "the breathers of the chain lie where Newton's method finds them, as certain as their balls "
    "make them",
    "[unit]") {
  Fineness fine;
  fine.samples = 16384, fine.harmonics = 96;
  for (Centre centre : both_centres) {
    const ChainBreather b = enclose_chain(centre, 11, 10, fine);
    const ChainGuess guess = chain_guess(centre, 11, 10, fine);
    const double r = b.exists.radius;
    // Compressions at rest, on the right and on the left
    std::array<std::vector<double>, 2> d, y;
    for (bool left : {false, true}) {
      for (const auto& c : guess.c)
        d[left].push_back(cosine_sum(c, left && centre == Centre::site ? turn : 0));
      const std::size_t n = d[left].size();
      y[left].resize(n);
      for (std::size_t i = n; i-- > 0;) y[left][i] = d[left][i] + (i + 1 < n ? y[left][i + 1] : 0);
    }
    // Bead 0 moves with all contacts behind it, or, around a bond, with half of the central one
    const auto contacts = double(fine.contacts);
    double energy = 0, width = 0, most = 0, most_width = 0;
    for (bool left : {false, true})
      for (std::size_t n = 0; n < fine.contacts; ++n) {
        const bool central = centre == Centre::bond && n == 0;
        energy += 0.4 * force_of(d[left][n]) * std::max(0.0, d[left][n]) * (central ? 0.5 : 1);
        width += force_of(d[left][n]) * r * (central ? 0.5 : 1);
        const double half = d[left][0] / 2,
                     own = centre == Centre::bond && n < 2 ? (n ? -half : half) : y[left][n];
        const double wide =
            centre == Centre::bond && n < 2 ? r / 2 : (contacts - double(n) + 2) * r;
        if (!(left && n == 0) && std::abs(own) > most) most = std::abs(own), most_width = wide;
        const bool counts = n > 0 || (centre == Centre::site && !left);
        energy += counts ? own * own / 2 : 0, width += counts ? std::abs(own) * wide : 0;
      }
    width += (8 * r + 2 * std::sqrt(r)) * r * r / 2;  // the tail adds on one side only
    CAPTURE(centre == Centre::bond, r);
    check_close(b.amplitude.middle(), most, 1e-12);
    check_close(b.amplitude.radius(), most_width, 0, 1e-3);
    check_close(b.energy.middle(), energy, 1e-3 * width);
    check_close(b.energy.radius(), width, 0, 2e-2);
    const Orbit<double> orbit = find_breather(problem_of(centre, 1.1));
    CHECK((b.exists.holds() && b.unique.holds()));
    CHECK(
        (b.amplitude.contains(double(orbit.amplitude)) && b.energy.contains(double(orbit.energy))));
    CHECK(b.amplitude.radius() < 1e-3 * b.amplitude.lower);
    // The tail must fall: six times the mean of |g| times the root of the radius below one
    CHECK(6 * mean_g * std::sqrt(r) < 1);
  }
}

TEST_CASE("a wrong compression, frequency or centre has a residual that proves nothing", "[unit]") {
  Fineness fine;
  fine.samples = 4096, fine.harmonics = 64;
  const ChainGuess guess = chain_guess(Centre::bond, 11, 10, fine);
  const ChainProof proof(guess, fine);
  const auto eta = [&](const ChainGuess& g) { return proof.eta(chain_residuals(g, fine)); };
  const double right = eta(guess);
  ChainGuess wrong = guess;
  wrong.c[0][1] *= 1 + 1e-3;
  CHECK(eta(wrong) > 20 * right);
  wrong = guess;
  wrong.omega = Interval<double>(1.11);
  CHECK(eta(wrong) > 100 * right);
  wrong = guess;
  wrong.centre = Centre::site;
  CHECK(eta(wrong) > 100 * right);
  CHECK_THROWS_AS(two_balls(eta(wrong), 0x1p-10, [&](double radius) { return proof.q(radius); }),
                  NotProved);
}

TEST_CASE("a fineness whose spacings do not agree is refused in one line", "[unit]") {
  const Fineness usual;
  CHECK((usual.contacts == 7 && usual.harmonics == 320 && usual.samples == 65536 &&
         usual.nodes == 32 && usual.cells == 2048));
  // What is allowed, at its ends, and what is not any more
  for (const Fineness& good :
       {usual, Fineness{2, 2, 4, 2, 2}, {15, 1024, 1 << 24, 1 << 20, 1 << 20}})
    CHECK_NOTHROW(good.check());
  const std::pair<Fineness, const char*> all[] = {
      {{7, 320, 65536, 24, 2048}, "nodes = 24: allowed is a power of two from 2 to 2048"},
      {{7, 320, 65536, 4096, 2048}, "nodes = 4096: "},
      {{2, 2, 4, 1, 2}, "nodes = 1: "},
      {{7, 320, 65536, 32, 1000}, "cells = 1000: "},
      {{2, 2, 4, 2, 1}, "cells = 1: "},
      {{2, 2, 4, 2, 1 << 21}, "cells = 2097152: "},
      {{7, 320, 60000, 32, 2048}, "samples = 60000: "},
      {{2, 2, 2, 2, 2}, "samples = 2: "},
      {{2, 2, 1 << 25, 2, 2}, "samples = 33554432: "},
      {{7, 1025, 65536, 32, 2048}, "harmonics = 1025: "},
      {{2, 1, 4, 2, 2}, "harmonics = 1: "},
      {{1, 2, 4, 2, 2}, "contacts = 1: "},
      {{16, 2, 4, 2, 2}, "contacts = 16: "}};
  for (const auto& [fine, said] : all)
    CHECK(refusal<std::invalid_argument>([&] { fine.check(); }).starts_with(said));
  const auto complaint = [&](int p, int q, const Fineness& fine) {
    return refusal<std::invalid_argument>([&] { enclose_chain(Centre::bond, p, q, fine); });
  };
  CHECK(complaint(11, 10, all[0].first) == all[0].second);
  for (const auto& [p, q] : {std::pair{1, 1}, {2, 1}, {9, 10}, {21, 10}, {11, 0}, {-11, -10}})
    CHECK(complaint(p, q, usual)
              .starts_with("omega = " + std::to_string(p) + "/" + std::to_string(q)));
  Fineness few;
  few.samples = 4096, few.harmonics = 64;
  const ChainGuess guess{Centre::bond, Interval<double>(2.5), {{0.01, 0}}};
  CHECK(refusal<std::invalid_argument>([&] { ChainProof(guess, few); }).starts_with("omega = 2.5"));
}
