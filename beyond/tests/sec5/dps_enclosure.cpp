// The proofs of section 5: they hold what is known otherwise, and they fail where something is wrong.

#include <algorithm>
#include <map>

#include "lattice/orbits/breather_pairs.hpp"
#include "lattice/standing/spectrum.hpp"
#include "sec5/chain_enclosure.hpp"
#include "sec5/dps_enclosure.hpp"
#include "support/check.hpp"

using namespace lattice;

namespace {

std::size_t number_of(const std::vector<Piece<double>>& pieces, Decision fate) {
  return std::size_t(std::count_if(pieces.begin(), pieces.end(),
                                   [&](const Piece<double>& p) { return p.decision == fate; }));
}

/// Whether the lemma proves something for a guess.
bool proved(const DpsGuess<double>& guess) {
  try {
    two_balls(dps_eta(guess), 0.0625, [&](double radius) { return dps_q(guess, radius); });
  } catch (const NotProved&) {
    return false;
  }
  return true;
}

}  // namespace

TEST_CASE("the lemma needs a contraction", "[unit]") {
  // The identity moves nothing and contracts nothing: all its points are fixed
  CHECK_FALSE(Contraction<double>{0, 1, 1}.contracts());
  CHECK_FALSE(Contraction<double>{0, 1, 1}.holds());
  CHECK_FALSE(Contraction<double>{0, 1.5, 1}.holds());
  CHECK(Contraction<double>{0, 0.5, 1}.holds());
  CHECK_THROWS_AS(two_balls(0.0, 1.0, [](double) { return 1.0; }), NotProved);
}

TEST_CASE("the lemma needs to know how far the centre moves", "[unit]") {
  // x -> x / 2 + 10 has its fixed point at 20, and none in the unit ball
  CHECK(Contraction<double>{10, 0.5, 1}.contracts());
  CHECK_FALSE(Contraction<double>{10, 0.5, 1}.stays_inside());
  CHECK_FALSE(Contraction<double>{10, 0.5, 19.9}.holds());
  CHECK(Contraction<double>{10, 0.5, 20.5}.holds());
  CHECK_THROWS_AS(two_balls(10.0, 1.0, [](double) { return 0.5; }), NotProved);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(Contraction<double>{nan, 0.5, 1}.holds());
  CHECK_FALSE(Contraction<double>{0, nan, 1}.holds());
  CHECK_FALSE(Contraction<double>{-1, 0.5, 1}.holds());
}

TEST_CASE("the DpS breathers lie where they are computed", "[unit][dps]") {
  for (Centre centre : both_centres) {
    const auto b = enclose_dps<double>(centre);
    const auto wide = enclose_dps<long double>(centre);
    const auto state = stationary<long double>(centre, 1.0L, 32 - (centre == Centre::site));
    REQUIRE(b.exists.holds());
    REQUIRE(b.unique.holds());
    for (std::size_t n = 0; n < b.r.size(); ++n) {
      CHECK((double(wide.r[n].lower) >= b.r[n].lower && double(wide.r[n].upper) <= b.r[n].upper));
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

TEST_CASE("both verdicts on stability and barrier are certain", "[unit][dps]") {
  const auto site = enclose_dps<double>(Centre::site), bond = enclose_dps<double>(Centre::bond);
  const Interval<double> edge = Interval<double>(2) / Interval<double>(3);
  CHECK(contact_eigenvalue(site, 2) > edge);
  CHECK(contact_eigenvalue(site, 3) < edge);
  CHECK(contact_eigenvalue(bond, 2) < edge);
  const auto barrier = dps_barrier(site, bond);
  CHECK(barrier.equal_mu > Interval<double>(0));
  CHECK(barrier.equal_norm < Interval<double>(0));
}

TEST_CASE("a wrong guess or a wrong inverse proves nothing", "[unit][dps]") {
  for (Centre centre : both_centres) {
    const auto guess = dps_guess<double>(centre);
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

TEST_CASE("the bound of the derivative bounds the map", "[property][dps]") {
  // K(x) - K(x') for random points of the ball, in the window
  const auto guess = dps_guess<double>(Centre::bond);
  const double radius = 1e-3, q = dps_q(guess, radius);
  const auto map = [&](const std::vector<double>& r) {
    const std::size_t n = r.size();
    std::vector<double> f(n), out = r;
    const auto phi = [&](double x) { return x * std::sqrt(std::abs(x)); };
    for (std::size_t i = 0; i < n; ++i)
      f[i] = r[i] - phi(r[i == 0 ? 1 : i - 1]) - 2 * phi(r[i]) - (i + 1 < n ? phi(r[i + 1]) : 0);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) out[i] -= guess.inverse[i][j] * f[j];
    return out;
  };
  double largest = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    std::vector<double> a = guess.r, b = guess.r;
    double apart = 0, moved = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      a[i] += radius * std::cos(1.7 * seed + i), b[i] += radius * std::cos(2.3 * seed + 5.0 * i);
      apart = std::max(apart, std::abs(a[i] - b[i]));
    }
    const auto x = map(a), y = map(b);
    for (std::size_t i = 0; i < x.size(); ++i) moved = std::max(moved, std::abs(x[i] - y[i]));
    largest = std::max(largest, moved / apart);
  }
  CHECK(largest <= q);
  CHECK(largest > 0.01 * q);
}

TEST_CASE("no profile is left, and a smaller ball would leave some", "[unit][dps]") {
  for (Centre centre : both_centres) {
    auto b = enclose_dps<double>(centre);
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

TEST_CASE("a wrong compression or frequency has a residual that proves nothing", "[unit]") {
  Fineness fine;
  fine.samples = 4096, fine.harmonics = 64;
  const ChainGuess guess = chain_guess(Centre::bond, 11, 10, fine);
  const auto residual = [&](const ChainGuess& g) {
    const auto all = chain_residuals(g, fine);
    return *std::max_element(all.begin(), all.end());
  };
  const double right = residual(guess);
  CHECK(right < 1e-6);
  ChainGuess wrong = guess;
  wrong.c[0][1] *= 1 + 1e-3;
  CHECK(residual(wrong) > 20 * right);
  wrong = guess;
  wrong.omega = Interval<double>(1.11);
  CHECK(residual(wrong) > 100 * right);
  wrong = guess;
  wrong.centre = Centre::site;
  CHECK(residual(wrong) > 100 * right);
  const ChainProof proof(guess, fine);
  CHECK_THROWS_AS(two_balls(proof.eta(chain_residuals(wrong, fine)), 0x1p-10,
                            [&](double radius) { return proof.q(radius); }),
                  NotProved);
}

TEST_CASE("a fineness whose spacings do not agree is refused in one line", "[unit]") {
  const auto complaint = [](const Fineness& fine, int numerator = 11, int denominator = 10) {
    return refusal<std::invalid_argument>(
        [&] { enclose_chain(Centre::bond, numerator, denominator, fine); });
  };
  const struct {
    std::size_t Fineness::*of;
    const char* name;
    std::vector<std::size_t> wrong;
  } all[] = {{&Fineness::nodes, "nodes", {0, 48, 4096, 24}},
             {&Fineness::cells, "cells", {1000}},
             {&Fineness::samples, "samples", {60000, 512}},
             {&Fineness::harmonics, "harmonics", {1025}},
             {&Fineness::contacts, "contacts", {1, 16}}};
  for (const auto& [of, name, wrong] : all)
    for (std::size_t value : wrong) {
      Fineness fine;
      fine.*of = value;
      CHECK(complaint(fine).starts_with(name + (" = " + std::to_string(value)) + ": "));
    }
  Fineness odd;
  odd.nodes = 24;
  CHECK(complaint(odd) == "nodes = 24: allowed is a power of two from 2 to 2048");
  for (const auto& [p, q] : {std::pair{1, 1}, {2, 1}, {9, 10}, {21, 10}, {11, 0}, {-11, -10}})
    CHECK(
        complaint({}, p, q).starts_with("omega = " + std::to_string(p) + "/" + std::to_string(q)));
  // What is allowed, at its ends
  const Fineness usual;
  CHECK((usual.contacts == 7 && usual.harmonics == 320 && usual.samples == 65536 &&
         usual.nodes == 32 && usual.cells == 2048));
  for (const Fineness& good :
       {usual, Fineness{2, 2, 4, 2, 2}, {15, 1024, 1 << 24, 1 << 20, 1 << 20}})
    CHECK_NOTHROW(good.check());
  for (const Fineness& bad : {Fineness{16, 2, 4, 2, 2},
                              {1, 2, 4, 2, 2},
                              {2, 1, 4, 2, 2},
                              {2, 2, 2, 2, 2},
                              {2, 2, 1 << 25, 2, 2},
                              {2, 2, 4, 1, 2},
                              {2, 2, 4, 2, 1},
                              {2, 2, 4, 2, 1 << 21}})
    CHECK_THROWS_AS(bad.check(), std::invalid_argument);
  Fineness few;
  few.samples = 4096, few.harmonics = 64;
  ChainGuess guess{Centre::bond, Interval<double>(2.5), {{0.01, 0}}};
  CHECK(refusal<std::invalid_argument>([&] { ChainProof(guess, few); }).starts_with("omega = 2.5"));
}

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
    for (double radius : {0.3, 0.5}) check_close(dps_q(last, radius), q(last, radius), 0, 1e-10);
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
