// Integrators that know the contact: the impulse of a contact that switches, orders, agreement with other families,
// exactness of the window, symmetry, stiff contacts.

#include "lattice/integrators/event_corrected.hpp"

#include "lattice/events/event_driven.hpp"
#include "lattice/gsl/reference.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/integrators/impulse.hpp"
#include "lattice/integrators/refinement.hpp"
#include "support/check.hpp"
#include "support/states.hpp"

using namespace lattice;

namespace {

State<double> event_driven(const Chain& chain, State<double> s, double time) {
  flow(chain, s, time);
  return s;
}

/// Root mean square over several impacts of the error of the end state.
template <class Make>
double impact_error(double h, Make make) {
  const Chain chain{60, Quartic{1}};
  static const auto exact = [&] {
    std::vector<State<double>> ends;
    for (int k = 3; k < 10; ++k)
      ends.push_back(after(EventCorrected{0.004}, chain, struck(60, 1 + 0.1 * k), 20));
    return ends;
  }();
  double squares = 0;
  for (int k = 3; k < 10; ++k)
    squares +=
        std::pow(distance(after(make(h), chain, struck(60, 1 + 0.1 * k), 20), exact[k - 3]), 2);
  return std::sqrt(squares / 7);
}

EventCorrected corrected(double h) {
  return {h};
}
EventCorrected uncorrected(double h) {
  return {h, dormand_prince_6(), 1e300};
}

}  // namespace

TEST_CASE("the exact impulse by hand", "[unit][formulas]") {
  for (double alpha : {1.5, 2.0, 1.25}) {
    CAPTURE(alpha);
    const double a = alpha + 1, b = alpha + 2, c = alpha + 3;
    const bool fourth = alpha == 1.25;
    const auto impulse = [&](const Quintic& x) {
      const auto push = [&](double s) { return std::pow(std::max(x(s), 0.0), alpha); };
      return exact_impulse(x, push, fourth);
    };
    // A contact that closes at s = 0.3: F = u^alpha with u = s - 0.3 up to w = 0.7.
    const auto closes = impulse({-0.3, 1, 0, 0.7, 1, 0});
    const double w = 0.7;
    check_close(closes.velocity, std::pow(w, a) / a, 1e-9);
    check_close(closes.position, std::pow(w, b) / (a * b), 1e-9);
    check_close(closes.shift, std::pow(w, c) / (a * b * c), 1e-9);
    // One that opens there: F = u^alpha with u = 0.3 - s, hence 1 - s = 0.7 + u.
    const auto opens = impulse({0.3, -1, 0, -0.7, -1, 0});
    const double p = std::pow(0.3, a) / a, q = std::pow(0.3, b) / b, r = std::pow(0.3, c) / c;
    check_close(opens.velocity, p, 1e-9);
    check_close(opens.position, 0.7 * p + q, 1e-9);
    check_close(opens.shift, (0.49 * p + 1.4 * q + r) / 2, 1e-9);
  }
}

TEST_CASE("a contact that closes or opens within a step", "[unit][formulas]") {
  // x = +-(p - (s - c)^2), with sqrt(p) mostly smaller than the distance of the points at which it is looked at
  for (double c : {0.11, 0.25, 0.38, 0.5, 0.75, 0.88})
    for (double p : {1e-2, 1e-3, 1e-6}) {
      CAPTURE(c, p);
      const auto impulse = [&](double side) {
        const Quintic x{side * (p - c * c), side * 2 * c, -side, side * (p - (1 - c) * (1 - c)),
                        side * 2 * (c - 1), -side};
        const auto push = [&](double s) { return Hertz{0}.force(-x(s)); };
        return exact_impulse(x, push, false);
      };
      const double all = 3 * std::acos(-1.0) / 8 * p * p;
      const auto closed = impulse(1), open = impulse(-1);
      check_close(closed.velocity, all, 1e-8 * all);
      check_close(closed.position, (1 - c) * all, 1e-8 * all);
      check_close(closed.reach, p, 1e-8 * p);
      // The integral of (u^2 - p)^(3/2) from u = sqrt(p) to a
      const auto side = [&](double a) {
        const double r = std::sqrt(a * a - p);
        return a * r * (2 * a * a - 5 * p) / 8 + 3 * p * p / 8 * std::log((a + r) / std::sqrt(p));
      };
      check_close(open.velocity, side(c) + side(1 - c), 1e-9);
    }
}

TEST_CASE("the correction restores the order across switching contacts", "[convergence][contact]") {
  const auto slope = [](double h, double k, auto make) {
    return std::log(impact_error(h, make) / impact_error(k, make)) / std::log(h / k);
  };
  const double order = slope(0.1, 0.0125, corrected), stalled = slope(0.05, 0.0125, uncorrected);
  CAPTURE(order, stalled);
  CHECK(order > 4.2);
  CHECK(stalled < 3.2);
  // Without knowledge of the contacts every splitting is held near 2.5
  for (const Scheme& scheme : {blanes_moan_4(), blanes_moan_6()})
    check_close(slope(0.08, 0.01, [&](double h) { return Splitting{scheme, h}; }), 2.6, 0.6);
  check_close(slope(0.02, 0.005, [](double h) { return Splitting{verlet(), h}; }), 2, 0.3);
  CHECK(impact_error(0.05, corrected) < 1e-3 * impact_error(0.05, uncorrected));
}

TEST_CASE("any exponent is corrected", "[property][contact]") {
  for (double alpha : {1.25, 1.4, 2.0, 2.5}) {
    const Chain chain{20, Quartic{0.5}, PowerContact{alpha, 0}};
    const auto exact = after(EventCorrected{0.004}, chain, struck(20, 1.5), 15);
    const double with = distance(after(corrected(0.05), chain, struck(20, 1.5), 15), exact);
    const double without = distance(after(uncorrected(0.05), chain, struck(20, 1.5), 15), exact);
    CAPTURE(alpha, with, without);
    CHECK(with < 2e-6);
    CHECK(with < without / 50);
  }
}

TEST_CASE("three families agree on the same problems", "[property][contact]") {
  const auto compare = [](const Chain& chain, const State<double>& start, double time,
                          double step = 0.005) {
    const auto aware = after(EventCorrected{step}, chain, start, time);
    auto theirs = start, ours = event_driven(chain, start, time);
    evolve_reference(chain, theirs, time, 1e-13);
    ours.t = theirs.t = aware.t;
    check_close(distance(aware, ours), 0, 2e-11);
    check_close(distance(theirs, ours), 0, 2e-11);
    check_close(distance(after(Splitting{blanes_moan_6(), 5e-4}, chain, start, time), ours), 0,
                1e-8);
  };
  compare({30, Quartic{1}}, struck(30, 1.9), 15);
  compare({12, Quartic{-0.1}, CompressedHertz{0.3}, Ends::fixed}, random_state(12, 0.6, 5), 10);
  compare({12, Pendulum{}, {}, Ends::periodic}, random_state(12, 1, 7), 10);
  // At this step the run errs by 5e-12. With a wrong sign in the correction of the positions or of the
  // stages' shift it errs by 3e-9 or 1e-10.
  for (double d : {0.0, 0.3}) {
    CAPTURE(d);
    Chain varied{6, Quartic{1}, CompressedHertz{d}, Ends::fixed};
    vary(varied, {1, 2, 1, 1, 1.5, 1}, {1, 0.6, 1.4, 1, 1, 0.8, 1});
    compare(varied, struck(6, 1.5), 8, 0.02);
  }
}

TEST_CASE("a windowed run has the bits of the full run", "[property][window]") {
  const auto same = [](const Chain& chain, const State<double>& start) {
    for (const Method& method :
         {Method(EventCorrected{0.05}), {Splitting{blanes_moan_6(), 0.05}}}) {
      auto windowed = start, full = start;
      Window some = waking(chain, windowed), all{0, chain.sites};
      method.on(chain)(chain, windowed, some, 0.05, 2000);
      method.on(chain)(chain, full, all, 0.05, 2000);
      CHECK(some.last - some.first < chain.sites);
      CHECK(windowed.y == full.y);
      CHECK(windowed.v == full.v);
    }
  };
  same({120, Quartic{1}}, struck(120, 1.9));
  State<double> middle(160);
  middle.v[80] = 1;
  same({160}, middle);
  same({400, Quartic{1}, CompressedHertz{0.5}}, struck(400, 1.9));
}

TEST_CASE("contact-aware runs are symmetric", "[property][contact]") {
  const Chain chain{31, Quartic{1}};
  const auto start = random_state(31, 0.8, 11);
  State<double> mirrored(31);
  for (std::size_t n = 0; n < 31; ++n) {
    mirrored.y[n] = -start.y[30 - n];
    mirrored.v[n] = -start.v[30 - n];
  }
  const auto a = after(EventCorrected{0.05}, chain, start, 30),
             b = after(EventCorrected{0.05}, chain, mirrored, 30);
  for (std::size_t n = 0; n < 31; ++n) CHECK(b.y[n] == -a.y[30 - n]);
}

namespace {

/// Two beads with a stiff contact.
struct Stiff {
  Chain chain{2};
  State<double> start{2};
  double time;

  Stiff(std::vector<double> mass, double eta, std::vector<double> y, std::vector<double> v,
        double until)
      : time(until) {
    vary(chain, mass, {0, eta, 0});
    start.y = y, start.v = v;
  }
};

/// A light bead that swings from the phase `f` on and meets a heavy one near its turning point, where the overlap
/// reaches less than A - 1, for a time of less than 2 sqrt(2 (A - 1)).
Stiff swing(double eta, double A, double f) {
  return {{1, 1e6}, eta, {A * std::cos(f), 1}, {-A * std::sin(f), 0}, 6};
}

}  // namespace

TEST_CASE("contacts that are shorter than a step are not missed", "[property][contact]") {
  // Position and velocity of the first bead at the end are from DOP853 between the zeros of the overlap
  const struct {
    Stiff two;
    double y, v;
  } known[] = {{swing(1e5, 1.000048, 3.29614), -0.991841245840, -0.127855183591},
               {swing(100, 1.00005, 2.17), -0.310800649504, -0.950527726462},
               {swing(1e4, 1.00002, 2.2), -0.339174205137, -0.940744842706},
               {swing(1e6, 1.00002, 2.2), -0.340227272429, -0.940364510573},
               {{{1e-3, 1}, 1e3, {-0.3, 0.5}, {2, 0.1}, 3}, -0.416068070829, 10.707525283},
               {{{1e-2, 5}, 1e5, {-0.3, 0.2}, {1, 0.1}, 3}, -0.061614768036, 2.8950477276}};
  for (const auto& [two, y, v] : known) {
    CAPTURE(two.chain.eta_of(1), two.chain.mass_of(0));
    auto s = two.start;
    const Run run = evolve(Converged{1e-8}, two.chain, s, two.time);
    CHECK(run.error <= 1e-8);
    const double scale = std::max(1.0, std::abs(v));
    check_close(s.y[0], y, 3 * run.error * scale);
    check_close(s.v[0], v, 3 * run.error * scale);
    const auto exact = event_driven(two.chain, two.start, two.time);
    check_close(exact.y[0], y, 1e-10);
    check_close(exact.v[0], v, 1e-9);
  }
}
