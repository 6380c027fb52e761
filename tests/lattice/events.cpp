// The tangent map where sites do not sit in a well of curvature one: no well, the top of a hill,
// heavy and light beads, precompressed contacts.

#include "lattice/events/event_driven.hpp"

#include "support/check.hpp"

using namespace lattice;

namespace {

/// Two wells with a hill between them, on whose top the beads rest: W''(0) = -1.
struct Hill {
  template <class T>
  T energy(T y) const {
    return y * y * (y * y / T(2) - T(1)) / T(2);
  }
  template <class T>
  T force(T y) const {
    return y * (T(1) - y * y);
  }
  template <class T>
  T stiffness(T y) const {
    return T(3) * (y * y) - T(1);
  }
};

/// A few beads in the middle move, the others rest: those are outside the core.
template <class T>
State<T> stirred(std::size_t sites) {
  State<T> s(sites);
  s.v[sites / 2] = T(0.75);
  s.v[sites / 2 + 1] = T(-0.5);
  s.y[sites / 2 - 1] = T(0.25);
  return s;
}

template <class T>
Tangent<T> tangent_of(const Chain& chain, State<T> state, T time) {
  Tangent<T> tangent(chain.sites, 2 * chain.sites);
  const FlowReport<T> f = flow(chain, state, time, {}, &tangent);
  REQUIRE(double(f.error) < 1e-10);
  return tangent;
}

/// Against extended precision, whose core is another one, and against difference quotients. At a
/// contact that just touches these err by the square root of h.
void check_tangent(const Chain& chain, double time) {
  const std::size_t n = chain.sites;
  const auto fine = tangent_of(chain, stirred<long double>(n), (long double)time);
  const auto ours = tangent_of(chain, stirred<double>(n), time);
  double worst = 0;
  for (std::size_t i = 0; i < ours.entries.size(); ++i) {
    REQUIRE(std::isfinite(ours.entries[i]));
    worst = std::max(worst, std::abs(ours.entries[i] - double(fine.entries[i])));
  }
  CHECK(worst < 1e-9);

  for (std::size_t column : {std::size_t(0), n / 2, n, n + n / 2}) {
    const auto moved = [&](long double by) {
      State<long double> s = stirred<long double>(n);
      (column < n ? s.y[column] : s.v[column - n]) += by;
      flow(chain, s, (long double)time, {});
      s.y.insert(s.y.end(), s.v.begin(), s.v.end());
      return s.y;
    };
    const long double h = 1e-10L;
    const auto plus = moved(h), minus = moved(-h);
    for (std::size_t row = 0; row < 2 * n; ++row)
      check_close(ours(row, column), double((plus[row] - minus[row]) / (2 * h)), 5e-5);
  }
}

std::vector<double> uneven(std::size_t sites) {
  std::vector<double> mass(sites);
  for (std::size_t n = 0; n < sites; ++n) mass[n] = 1 + 0.5 * double(n % 3);
  return mass;
}

}  // namespace

TEST_CASE("the tangent of a chain without wells", "[property][tangent]") {
  Chain chain{10, None{}, Hertz{.floor = 0}};
  check_tangent(chain, 1.5);
  vary(chain, uneven(10), {});
  check_tangent(chain, 1.5);
}

TEST_CASE("the tangent on the top of a hill", "[property][tangent]") {
  Chain chain{10, Hill{}, Hertz{.floor = 0}};
  check_tangent(chain, 1.5);
  vary(chain, uneven(10), {});
  check_tangent(chain, 1.5);
}

TEST_CASE("the tangent of a precompressed chain, with and without wells", "[property][tangent]") {
  check_tangent(Chain{10, None{}, CompressedHertz{0.5}}, 1.5);
  check_tangent(Chain{10, {}, CompressedHertz{0.5}, Ends::periodic}, 1.5);
}

TEST_CASE("at rest the tangent is drift, rotation or growth, exactly", "[unit][tangent]") {
  const double time = 2.5;
  const auto check = [&](const auto& chain, double y_y, double y_v, double v_y) {
    const auto t = tangent_of(chain, State<double>(4), time);
    for (std::size_t i = 0; i < 8; ++i)
      for (std::size_t k = 0; k < 8; ++k) {
        const bool same = i % 4 == k % 4;
        const double entry = i < 4 ? (k < 4 ? y_y : y_v) : (k < 4 ? v_y : y_y);
        check_close(t(i, k), same ? entry : 0, 1e-13);
      }
  };
  check(Chain{4, None{}}, 1, time, 0);
  check(Chain{4}, std::cos(time), std::sin(time), -std::sin(time));
  Chain heavy{4};  // beads of mass 4 turn with the frequency 1/2
  vary(heavy, {4, 4, 4, 4}, {});
  check(heavy, std::cos(time / 2), 2 * std::sin(time / 2), -std::sin(time / 2) / 2);
  check(Chain{4, Hill{}}, std::cosh(time), std::sinh(time), std::sinh(time));
}

TEST_CASE("a bead light enough to feel a faint contact belongs to the core", "[unit][tangent]") {
  Chain chain{3, {}, Hertz{.floor = 0}};
  StepRecord<double> record;
  const std::vector<double> wells_and_links{1, 1, 1, 0, 1e-18, 0, 0};
  std::copy(wells_and_links.begin(), wells_and_links.end(), record.nodes.add(3, 0, 0));
  CHECK(core_of(chain, record, 1e-16) == Window{3, 3});
  vary(chain, {1, 1e-6, 1}, {});
  CHECK(core_of(chain, record, 1e-16) == Window{0, 2});
}

TEST_CASE("masses that are all one change no bit of a flow, of its tangent and of its energies",
          "[unit][tangent]") {
  constexpr std::size_t n = 12;
  for (const Ends ends : {Ends::free, Ends::fixed, Ends::periodic}) {
    CAPTURE(int(ends));
    Chain plain{n, Quartic{0.5}, {}, ends}, varied = plain;
    vary(varied, std::vector<double>(n, 1), std::vector<double>(n + 1, 1));
    const auto carried = [&](const Chain& chain) {
      State<double> state = stirred<double>(n);
      Tangent<double> tangent(n, 2 * n);
      const FlowReport<double> report = flow(chain, state, 3.0, {}, &tangent);
      CHECK(report.error < 1e-11);
      return std::tuple{state.y,      state.v,     tangent.entries, energy_density(chain, state),
                        report.error, report.steps};
    };
    CHECK(carried(plain) == carried(varied));
  }
}

TEST_CASE("a mirrored flow has the mirrored errors", "[unit][tangent]") {
  constexpr std::size_t n = 5;
  Chain chain{n, Quartic{0.5}};
  vary(chain, {}, std::vector<double>(n + 1, 0));
  State<double> state = stirred<double>(n), mirrored = state;
  for (std::size_t i = 0; i < n; ++i) mirrored.y[i] = -state.y[i], mirrored.v[i] = -state.v[i];
  const FlowReport<double> one = flow(chain, state, 3.0), other = flow(chain, mirrored, 3.0);
  CHECK(one.error > 0);
  CHECK(one.error == other.error);
}

namespace {

/// Positions, velocities and area after one step, from those in `z`.
std::vector<double> stepped(const Chain& chain, std::vector<double> z, double dt) {
  Leapfrog<double>(chain, false).step(z, dt);
  return z;
}

}  // namespace

TEST_CASE("the tangent vector is the derivative of a step, on every site of every kind of chain",
          "[unit][tangent]") {
  for (Ends ends : {Ends::free, Ends::fixed, Ends::periodic})
    for (std::size_t n : {1U, 2U, 3U, 6U})
      for (bool heavy : {false, true}) {
        if (ends == Ends::periodic && n < 3) continue;
        Chain chain{.sites = n, .well = Quartic{0.7}, .ends = ends};
        std::vector<double> mass(n), z;
        for (std::size_t i = 0; i < n; ++i) mass[i] = 1 + 0.3 * double(i);
        if (heavy) vary(chain, mass, {});
        for (std::size_t i = 0; i < 2 * n; ++i) z.push_back(std::sin(3.0 * double(i) + 0.4));
        z.push_back(0);
        // The tangent vector, and the step from two neighbours along it
        std::vector<double> with = z, ahead = z, behind = z;
        const double change = 1e-6, dt = 0.1;
        for (std::size_t i = 0; i < 2 * n; ++i) {
          const double u = std::cos(2.0 * double(i) + 0.1);
          with.push_back(u), ahead[i] += change * u, behind[i] -= change * u;
        }
        Leapfrog<double>(chain, true).step(with, dt);
        const auto more = stepped(chain, ahead, dt), less = stepped(chain, behind, dt);
        CAPTURE(n, int(ends), heavy);
        for (std::size_t i = 0; i < 2 * n; ++i)
          check_close(with[2 * n + 1 + i], (more[i] - less[i]) / (2 * change), 1e-8);
      }
}
