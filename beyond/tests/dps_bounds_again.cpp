// The proof for the DpS breathers a second time, in plain numbers, from the formulas of its header.

#include <algorithm>
#include <map>

#include "check.hpp"
#include "lattice/standing/stationary.hpp"
#include "sec5/dps_enclosure.hpp"

namespace dps_bounds_again {

using namespace lattice;

namespace {

double phi(double x) {
  return x * std::sqrt(std::abs(x));
}

/// Both ends of a range.
struct Limits {
  double low = 0, high = 0;
  double size() const { return std::max(std::abs(low), std::abs(high)); }
};

/// A guess that is wrong by parts in a thousand, so that nothing cancels.
DpsGuess<double> wrong_guess(Centre centre) {
  auto guess = dps_guess<double>(centre);
  for (std::size_t n = 0; n < guess.r.size(); ++n) guess.r[n] *= 1 + 1e-3 * std::cos(double(3 * n));
  guess.r.back() = 2e-3;
  return guess;
}

/// How far x - A F(x) moves the guess, zero behind the window.
double eta(const DpsGuess<double>& g) {
  const std::size_t size = g.r.size();
  std::vector<double> f(size), moved(size);
  for (std::size_t n = 0; n < size; ++n) {
    const std::size_t left = n > 0 ? n - 1 : g.centre == Centre::bond ? 1 : 0;
    f[n] = g.r[n] - phi(g.r[left]) - 2 * phi(g.r[n]) - (n + 1 < size ? phi(g.r[n + 1]) : 0);
  }
  double most = phi(g.r.back());
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t n = 0; n < size; ++n) moved[i] += g.inverse[i][n] * f[n];
    most = std::max(most, std::abs(moved[i]));
  }
  return most;
}

/// The largest row sum of |1 - A DF| over a ball.
double q(const DpsGuess<double>& g, double radius) {
  const std::size_t size = g.r.size();
  const auto slope = [&](double c) {
    const double low = std::max(0.0, std::abs(c) - radius);
    return Limits{1.5 * std::sqrt(low), 1.5 * std::sqrt(std::abs(c) + radius)};
  };
  // DF by entries: minus the slope of the neighbours, one minus twice the own slope
  std::map<std::pair<std::size_t, std::size_t>, Limits> df;
  const auto add = [&](std::size_t row, std::size_t column, double one, double factor) {
    Limits& at = df[{row, column}];
    at.low += one - factor * slope(g.r[column]).high,
        at.high += one - factor * slope(g.r[column]).low;
  };
  for (std::size_t n = 0; n < size; ++n) {
    add(n, n, 1, 2);
    add(n, n > 0 ? n - 1 : g.centre == Centre::bond ? 1 : 0, 0, 1);
    if (n + 1 < size) add(n, n + 1, 0, 1);
  }
  const double tail = slope(0).high;
  double worst = std::max(slope(g.r.back()).high + 3 * tail, 4 * tail);
  for (std::size_t i = 0; i < size; ++i) {
    std::vector<Limits> row(size);
    row[i] = {1, 1};
    for (const auto& [place, d] : df) {
      const double a = g.inverse[i][place.first];
      row[place.second].low -= std::max(a * d.low, a * d.high);
      row[place.second].high -= std::min(a * d.low, a * d.high);
    }
    double sum = std::abs(g.inverse[i].back()) * tail;
    for (const Limits& x : row) sum += x.size();
    worst = std::max(worst, sum);
  }
  return worst;
}

/// The contact at which the profile of this r_0 first breaks the rules, followed in plain numbers; 0 if it does not.
std::size_t breaks_at(Centre centre, double r_0) {
  double r = r_0, before = 0;
  for (std::size_t n = 0; n < 30; ++n) {
    const double force = phi(r);
    double next = r - 2 * force - before;
    if (n == 0) next = centre == Centre::bond ? next / 2 : next - force;
    const double strain = next > 0 ? std::cbrt(next * next) : -1;
    if (!(strain >= force && strain <= r)) return n + 1;
    before = force, r = strain;
  }
  return 0;
}

/// Whether the deviations z_n y_0 from the constant profile certainly rise while they are at most twice y_0.
bool rises(Centre centre, double r_0) {
  const double y = std::abs(phi(r_0) - 1.0 / 64);
  if (!(1.0 / 64 - 2 * y > 0)) return false;
  const auto slope = [](double force) { return 2.0 / 3 / std::cbrt(force) - 2; };
  const Limits g{slope(1.0 / 64 + 2 * y), slope(1.0 / 64 - 2 * y)};
  Limits before{1, 1}, z{g.low - 1, g.high - 1};
  if (centre == Centre::bond) z = {g.low / 2, g.high / 2};
  for (int n = 0; n < 6 && z.size() <= 2; ++n) {
    if (z.low > before.high) return true;
    const auto [least, most] =
        std::minmax({g.low * z.low, g.low * z.high, g.high * z.low, g.high * z.high});
    const Limits next{least - before.high, most - before.low};
    before = z, z = next;
  }
  return false;
}

}  // namespace

TEST_CASE("both numbers of the lemma follow from their formulas", "[unit][dps]") {
  for (Centre centre : both_centres) {
    const auto guess = wrong_guess(centre);
    CAPTURE(centre == Centre::bond);
    check_close(dps_eta(guess), eta(guess), 0, 1e-10);
    for (double radius : {1e-9, 1e-4, 0.01, 0.5})
      check_close(dps_q(guess, radius), q(guess, radius), 0, 1e-10);
    // Where the last strain alone is wrong, or pulls the first contact behind the window most
    auto last = dps_guess<double>(centre);
    last.r.back() = 0.04;
    check_close(dps_eta(last), eta(last), 0, 1e-10);
    for (auto& row : last.inverse) row.assign(row.size(), 0);
    check_close(dps_eta(last), 0.008, 0, 1e-12);
    CHECK(dps_guess<double>(centre).r.size() == 12);
  }
}

TEST_CASE("norm, peak, exponents and barriers follow from the strains", "[unit][dps]") {
  const auto bond = enclose_dps<double>(Centre::bond), site = enclose_dps<double>(Centre::site);
  for (const auto* b : {&bond, &site}) {
    const auto state = stationary<long double>(b->centre, 1.0L, b == &site ? 31 : 32);
    double norm = 0, top = 0;
    for (std::size_t n = 0; n < state.strain.size(); ++n) {
      const double r = std::abs(double(state.strain[n]));  // of the half chain, outwards
      norm += (n == 0 && b == &bond ? 1 : 2) * r * phi(r);
    }
    for (auto u : state.u) top = std::max(top, std::abs(double(u)));
    check_close(b->norm().middle(), norm, 0, 1e-13);
    check_close(b->largest().middle(), top, 0, 1e-13);
    CHECK(b->norm().radius() < 1e-14);
    // The tail, from what is before it; the ball of existence holds what is off
    const double last = phi(b->r.back().upper);
    CHECK(b->tail.lower == 0);
    check_close(b->tail.upper, last / (1 - 3 * std::sqrt(last)), 0, 1e-2);
    CHECK(b->exists.radius < 1e-9);
    CHECK(b->unique.radius > 1e-3);
  }
  check_close(square_of_exponent(Interval<double>(0.3)).middle(), -0.7 * 0.55, 1e-15);
  check_close(square_of_exponent(Interval<double>(0.9)).middle(), 0.1 * 0.35, 1e-15);
  const double s = site.norm().middle(), b = bond.norm().middle();
  const auto barrier = dps_barrier(site, bond);
  check_close(barrier.equal_mu.middle(), 0.4 * (s - b), 1e-17);
  check_close(barrier.equal_norm.middle(), 0.4 * b * (std::pow(b / s, 0.25) - 1), 1e-17);
  CHECK(barrier.equal_norm.radius() < 1e-3 * std::abs(barrier.equal_norm.middle()));
  // The tail adds to an eigenvalue four times its root at most
  auto longer = bond;
  longer.tail = {0, 1e-4};
  check_close(contact_eigenvalue(longer, 2).upper - contact_eigenvalue(bond, 2).lower, 0.04, 1e-9);
}

TEST_CASE("what the search discards breaks the rules, and nothing is looked at in vain",
          "[unit][dps]") {
  for (Centre centre : both_centres) {
    const auto b = enclose_dps<double>(centre);
    const auto pieces = search_profiles(b);
    for (const Piece<double>& p : pieces) {
      const double middle = p.r_0.middle();
      if (p.decision != Decision::discarded) continue;
      const std::size_t breaks = breaks_at(centre, middle);
      CAPTURE(centre == Centre::bond, middle, p.contact, breaks);
      CHECK(breaks > 0);
      if (p.contact > 0) CHECK(breaks <= p.contact);
      // Without following it only about the constant profile, which turns by seventy degrees a contact
      if (p.contact == 0) CHECK(std::abs(middle - 0.0625) < 5e-3);
    }
  }
}

TEST_CASE("profiles about the constant one turn back", "[unit][dps]") {
  for (Centre centre : both_centres) {
    int yes = 0, no = 0;
    for (double r_0 = 0.0625; r_0 < 0.25; r_0 += r_0 < 0.075 ? 1e-6 : 1e-3) {
      const bool rise = rises(centre, r_0);
      if (turns_back(centre, Interval<double>(r_0)) != rise) FAIL("r_0 = " << r_0);
      ++(rise ? yes : no);
    }
    CHECK(yes > 4000);
    CHECK(no > 4000);
  }
}

TEST_CASE("strains that need not be positive or decreasing prove nothing", "[unit][dps]") {
  using Range = Interval<double>;
  const auto with = [](std::vector<Range> r, Range tail) {
    return DpsBreather<double>{Centre::bond, {}, {}, std::move(r), tail};
  };
  const auto clipped = [&](std::vector<Range> r, Range tail) {
    auto b = with(std::move(r), tail);
    demand_no_negative(b);
    return b;
  };
  // Behind the last strain that may exceed 1/16 everything is clipped; before it all must be positive
  const Range small(-0.01, 0.02), large(0.05, 0.08), doubtful(-0.01, 0.08);
  const auto b = clipped({large, small, small}, {-0.03, 0.03});
  CHECK(b.r[0].lower == 0.05);
  CHECK(b.r[1].lower == 0);
  CHECK(b.r[2].lower == 0);
  CHECK(b.tail.lower == 0);
  CHECK(b.tail.upper == 0.03);
  CHECK(clipped({large, large, small}, small).r[1].lower == 0.05);
  for (const auto& [r, tail] : {std::pair{std::vector{doubtful, small, small}, small},
                                {{large, doubtful, small}, small},
                                {{doubtful, large, small}, small},
                                {{large, small, doubtful}, small},
                                {{small, small, small}, small},
                                {{large, small, small}, Range(-0.01, 0.0625)},
                                {{large, small, small}, Range(-0.0625, 0.01)}})
    CHECK_THROWS_AS(clipped(r, tail), NotProved);

  // Each strain certainly above the next, the tail included, and all certainly positive
  const auto falls = [&](std::vector<Range> r, Range tail) {
    return refusal<NotProved>([&] { demand_decrease(with(std::move(r), tail)); }).empty();
  };
  const Range high(0.3, 0.31), middle(0.1, 0.2), low(0.02, 0.03);
  CHECK(falls({high, middle, low}, {0, 0.0099}));
  CHECK_FALSE(falls({high, middle, low}, {0, 0.01}));
  CHECK_FALSE(falls({high, middle, low}, {0, 0.025}));
  CHECK_FALSE(falls({high, middle, {0, 0.03}}, {-0.1, -0.05}));
  CHECK_FALSE(falls({middle, middle, low}, {0, 0.001}));
  CHECK_FALSE(falls({high, {0.1, 0.3}, low}, {0, 0.001}));
  CHECK_FALSE(falls({high, middle, {0.02, 0.1}}, {0, 0.001}));
  CHECK_FALSE(falls({{0.3, 0.2}, middle, low}, {0, 0.001}));
  CHECK_FALSE(falls({high, {0.2, 0.1}, low}, {0, 0.001}));
  CHECK_FALSE(falls({high, middle, {0.03, 0.02}}, {0, 0.001}));
}

TEST_CASE("the search halves, as often as it is told", "[unit][dps]") {
  auto b = enclose_dps<double>(Centre::bond);
  b.unique.radius = 1e-9;
  for (int depth : {0, 1, 2, 5}) {
    const auto pieces = search_profiles(b, depth);
    double shortest = 1;
    for (const auto& p : pieces) {
      const double halvings = std::log2(0.1875 / (p.r_0.upper - p.r_0.lower));
      check_close(halvings, std::round(halvings), 1e-9);
      shortest = std::min(shortest, p.r_0.upper - p.r_0.lower);
      if (p.decision == Decision::open) check_close(halvings, depth, 1e-9);
    }
    check_close(shortest, 0.1875 * std::pow(0.5, depth), 1e-12);
    CHECK((depth > 1 || pieces.size() == std::size_t(depth + 1)));
  }
  // Thirty times if it is not told
  double shortest = 1;
  for (const auto& p : search_profiles(b)) shortest = std::min(shortest, p.r_0.upper - p.r_0.lower);
  check_close(shortest, 0.1875 * std::pow(0.5, 30), 0, 1e-6);
}

}  // namespace dps_bounds_again
