// The proof for the breathers of the DpS equation: it holds what is known otherwise, each of its bounds follows from
// its formula, and it fails where something is wrong.

#include <algorithm>
#include <map>

#include "lattice/standing/spectrum.hpp"
#include "report/program.hpp"
#include "sec5/chain_enclosure.hpp"
#include "sec5/dps_enclosure.hpp"
#include "sec5/wave_enclosure.hpp"
#include "support/check.hpp"

// The chapter itself, so that what is tested is the proof that its page shows
#define main sec5_enclosures
#include "sec5_enclosures.cpp"
#undef main

using namespace lattice;
using namespace report;

namespace {

std::size_t number_of(const std::vector<Piece>& pieces, Decision fate) {
  return std::size_t(std::count_if(pieces.begin(), pieces.end(),
                                   [&](const Piece& p) { return p.decision == fate; }));
}

/// Whether the lemma proves something for a guess.
bool proved(const DpsGuess& guess) {
  try {
    dps_lemma(guess);
  } catch (const NotProved&) {
    return false;
  }
  return true;
}

}  // namespace

TEST_CASE("the DpS breathers lie where they are computed", "[unit][dps]") {
  for (Centre centre : both_centres) {
    const auto b = enclose_dps(centre);
    const auto state = stationary<long double>(centre, 1.0L, 32 - (centre == Centre::site));
    REQUIRE(b.exists.holds());
    REQUIRE(b.unique.holds());
    for (std::size_t n = 0; n < b.r.size(); ++n) {
      const long double r = std::abs(state.strain[n]);
      CHECK((b.r[n].lower <= r && r <= b.r[n].upper));
      CHECK(b.r[n].upper - b.r[n].lower < 1e-11 * b.r[n].lower);
    }
    CHECK((b.norm().lower <= state.norm() && state.norm() <= b.norm().upper));
    CHECK(contact_eigenvalue(b, 1).contains(1));
    const long double m = counted_eigenvalue(state, 2);
    CHECK((contact_eigenvalue(b, 2).lower <= m && m <= contact_eigenvalue(b, 2).upper));
  }
}

TEST_CASE("a wrong guess or a wrong inverse proves nothing", "[unit][dps]") {
  for (Centre centre : both_centres) {
    const auto guess = dps_guess(centre);
    CHECK(proved(guess));
    auto other = guess;
    other.r[0] *= 1.5;
    CHECK_FALSE(proved(other));
    other = guess;
    other.r[2] = 0;
    CHECK_FALSE(proved(other));
    other = guess;
    for (auto& row : other.inverse)
      for (double& x : row) x = -x;
    CHECK_FALSE(proved(other));
    other = guess;
    other.centre = centre == Centre::site ? Centre::bond : Centre::site;
    CHECK_FALSE(proved(other));
    // Beyond a sixteenth the derivative changes too much
    CHECK(dps_q(guess, 0.0625) > 1);
  }
}

TEST_CASE("no profile is left, and a smaller ball would leave some", "[unit][dps]") {
  for (Centre centre : both_centres) {
    auto b = enclose_dps(centre);
    const auto pieces = search_profiles(b);
    CHECK(number_of(pieces, Decision::open) == 0);
    CHECK(number_of(pieces, Decision::inside) > 0);
    // The pieces leave no gap, and the breather is in one of them
    CHECK(pieces.front().r_0.lower == 0.0625);
    CHECK(pieces.back().r_0.upper == 0.25);
    bool met = false;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (i > 0) CHECK(pieces[i].r_0.lower == pieces[i - 1].r_0.upper);
      const bool here = pieces[i].r_0.lower <= b.r[0].upper && b.r[0].lower <= pieces[i].r_0.upper;
      if (here) CHECK(pieces[i].decision == Decision::inside);
      met = met || here;
    }
    CHECK(met);
    b.unique.radius = 1e-9;
    CHECK(number_of(search_profiles(b, 12), Decision::open) > 0);
  }
}

namespace {

double force_of(double x) {
  return x * std::sqrt(std::abs(x));
}

/// Both ends of a range.
struct Limits {
  double low = 0, high = 0;
  double size() const { return std::max(std::abs(low), std::abs(high)); }
};

/// A guess that is wrong by parts in a thousand, so that nothing cancels.
DpsGuess wrong_guess(Centre centre) {
  auto guess = dps_guess(centre);
  for (std::size_t n = 0; n < guess.r.size(); ++n) guess.r[n] *= 1 + 1e-3 * std::cos(double(3 * n));
  guess.r.back() = 2e-3;
  return guess;
}

double apart(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

/// r - A F(r), zero behind the window.
std::vector<double> image(const DpsGuess& g, const std::vector<double>& r) {
  const std::size_t size = r.size();
  std::vector<double> out = r;
  for (std::size_t n = 0; n < size; ++n) {
    const std::size_t left = n > 0 ? n - 1 : g.centre == Centre::bond ? 1 : 0;
    const double f =
        r[n] - force_of(r[left]) - 2 * force_of(r[n]) - (n + 1 < size ? force_of(r[n + 1]) : 0);
    for (std::size_t i = 0; i < size; ++i) out[i] -= g.inverse[i][n] * f;
  }
  return out;
}

/// How far that is from the guess, in the window and in the first contact behind it.
double eta(const DpsGuess& g) {
  return std::max(force_of(g.r.back()), apart(image(g, g.r), g.r));
}

/// The largest row sum of |1 - A DF| over a ball.
double q(const DpsGuess& g, double radius) {
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
    const double force = force_of(r);
    double next = r - 2 * force - before;
    if (n == 0) next = centre == Centre::bond ? next / 2 : next - force;
    const double strain = next > 0 ? std::cbrt(next * next) : -1;
    if (!(strain >= force && strain <= r)) return n + 1;
    before = force, r = strain;
  }
  return 0;
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
    auto last = dps_guess(centre);
    last.r.back() = 0.04;
    check_close(dps_eta(last), eta(last), 0, 1e-10);
    for (auto& row : last.inverse) row.assign(row.size(), 0);
    check_close(dps_eta(last), 0.008, 0, 1e-12);
    for (double radius : {0.3, 0.5}) check_close(dps_q(last, radius), q(last, radius), 0, 1e-10);
    CHECK(dps_guess(centre).r.size() == 12);
  }
}

TEST_CASE("the bound of the derivative bounds the map", "[property][dps]") {
  const auto guess = dps_guess(Centre::bond);
  const double radius = 1e-3, bound = dps_q(guess, radius);
  double largest = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    std::vector<double> a = guess.r, b = guess.r;
    for (std::size_t i = 0; i < a.size(); ++i)
      a[i] += radius * std::cos(1.7 * seed + i), b[i] += radius * std::cos(2.3 * seed + 5.0 * i);
    largest = std::max(largest, apart(image(guess, a), image(guess, b)) / apart(a, b));
  }
  CHECK(largest <= bound);
  CHECK(largest > 0.01 * bound);
}

TEST_CASE("norm, peak, exponents and barriers follow from the strains", "[unit][dps]") {
  const auto bond = enclose_dps(Centre::bond), site = enclose_dps(Centre::site);
  for (const auto* b : {&bond, &site}) {
    const auto state = stationary<long double>(b->centre, 1.0L, b == &site ? 31 : 32);
    double norm = 0, top = 0;
    for (std::size_t n = 0; n < state.strain.size(); ++n) {
      const double r = std::abs(double(state.strain[n]));  // of the half chain, outwards
      norm += (n == 0 && b == &bond ? 1 : 2) * r * force_of(r);
    }
    for (auto u : state.u) top = std::max(top, std::abs(double(u)));
    check_close(b->norm().middle(), norm, 0, 1e-13);
    check_close(b->largest().middle(), top, 0, 1e-13);
    CHECK(b->norm().radius() < 1e-14);
    // The tail, from what is before it; the ball of existence holds what is off
    const double last = force_of(b->r.back().upper);
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
    const auto b = enclose_dps(centre);
    const auto pieces = search_profiles(b);
    for (const Piece& p : pieces) {
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
