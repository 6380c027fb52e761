// Formulas against numbers worked out by hand: where a sign, an exponent, a factor or an index of the
// library is wrong, one of these says so at once. `make mutants` puts such errors in and asks.

#include <complex>

#include "lattice/algebra/dense.hpp"
#include "lattice/events/event_driven.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/integrators/schemes.hpp"
#include "lattice/model/dps.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "support/check.hpp"

using namespace lattice;

namespace {

template <class Potential>
void check_values(const Potential& p, double x, double energy, double force, double stiffness) {
  CAPTURE(x);
  check_close(p.energy(x), energy, 1e-14, 1e-14);
  check_close(p.force(x), force, 1e-14, 1e-14);
  check_close(p.stiffness(x), stiffness, 1e-14, 1e-14);
}

/// Three beads of masses 2, 3, 5 with stiffnesses 2, 3, 4, 2, the ends' first and last.
Chain three_beads(Ends ends) {
  Chain chain{3, {}, {}, ends};
  vary(chain, {2, 3, 5}, {2, 3, 4, 2});
  return chain;
}

template <class Values>
void check_all(const Values& values, const std::vector<double>& expected) {
  REQUIRE(values.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CAPTURE(i);
    check_close(values[i], expected[i], 1e-13, 1e-13);
  }
}

}  // namespace

TEST_CASE("potentials by hand", "[unit][formulas]") {
  check_values(Harmonic{}, -3, 4.5, 3, 1);
  check_values(Quartic{-0.5}, 2, 0, 2, -5);
  check_values(Quartic{2}, -1, 1, 3, 7);
  check_values(Pendulum{}, M_PI / 2, 1, -1, 0);
  check_values(Pendulum{}, -M_PI / 6, 1 - std::sqrt(0.75), 0.5, std::sqrt(0.75));
  check_values(Hertz{}, -4, 12.8, 8, 3);
  check_values(Hertz{}, 4, 0, 0, 0);
  check_values(CompressedHertz{4}, -5, 44.4, 19, 4.5);
  check_values(CompressedHertz{4}, 5, 0.4 * -32 + 40, -8, 0);
  check_values(PowerContact{2, 1}, -2, 26.0 / 3 - 2, 8, 6);
  check_values(PowerContact{2, 1}, 3, -1.0 / 3 + 3, -1, 0);
  CHECK(Hertz{}.opening() == 0);
  CHECK(CompressedHertz{0.5}.opening() == 0.5);
  CHECK(PowerContact{2, 0.5}.opening() == 0.5);
}

TEST_CASE("accelerations by hand", "[unit][formulas]") {
  // Overlaps: 1 with the left wall, 1 and none between the beads, 4 with the right wall.
  const std::vector<double> y{-1, -2, 4};
  check_all(accelerations(three_beads(Ends::free), y), {(1 - 3) / 2.0, (2 + 3) / 3.0, -4 / 5.0});
  check_all(accelerations(three_beads(Ends::fixed), y),
            {(1 + 2 - 3) / 2.0, (2 + 3) / 3.0, (-4 - 2 * 8) / 5.0});
  // On a ring the last bead overlaps with the first by 5.
  const double ring = 2 * 5 * std::sqrt(5);
  check_all(accelerations(three_beads(Ends::periodic), y),
            {(1 + ring - 3) / 2, (2 + 3) / 3.0, (-4 - ring) / 5});
  // Overlaps 1 and 4 between the beads.
  check_all(accelerations(three_beads(Ends::free), std::vector<double>{0, -1, -5}),
            {-3 / 2.0, (1 + 3 - 32) / 3.0, (5 + 32) / 5.0});
}

TEST_CASE("a kick and a drift by hand", "[unit][formulas]") {
  const auto chain = three_beads(Ends::fixed);
  State<double> s(3);
  s.y = {-1, -2, 4};
  s.v = {1, 0, -1};
  Window all{0, 3};
  kick_drift(chain, s, all, 0.5, 2.0);
  const double v1 = 0.5 * 5 / 3;
  check_all(s.v, {1, v1, -1 + 0.5 * -4});
  check_all(s.y, {-1 + 2 * 1, -2 + 2 * v1, 4 + 2 * -3});
}

TEST_CASE("the energy density by hand", "[unit][formulas]") {
  State<double> s(3);
  s.y = {-1, -2, 4};
  s.v = {1, 2, -3};
  // Kinetic 1, 6, 22.5; wells 0.5, 2, 8; contacts to the right 3 * 0.4, 0, and at the ends.
  check_all(energy_density(three_beads(Ends::free), s), {1.5 + 1.2, 8, 30.5});
  check_all(energy_density(three_beads(Ends::fixed), s), {1.5 + 1.2 + 0.8, 8, 30.5 + 25.6});
  const double ring = 2 * 0.4 * 25 * std::sqrt(5);
  check_all(energy_density(three_beads(Ends::periodic), s), {1.5 + 1.2, 8, 30.5 + ring});
  check_close(energy(three_beads(Ends::fixed), s), 3.5 + 8 + 56.1, 0, 1e-14);
  check_all(contact_forces(three_beads(Ends::fixed), s.y), {3, 0, 16});
}

TEST_CASE("the linearisation by hand", "[unit][formulas]") {
  const std::vector<double> y{-1, -2, 4};
  const auto free = linearise(three_beads(Ends::free), y);
  check_all(free.diagonal, {1 + 4.5, 1 + 4.5, 1});
  check_all(free.off, {-4.5, 0, 0});
  check_all(linearise(three_beads(Ends::fixed), y).diagonal, {1 + 3 + 4.5, 1 + 4.5, 1 + 6});
  const auto ring = linearise(three_beads(Ends::periodic), y);
  const double k = 2 * 1.5 * std::sqrt(5);
  check_all(ring.diagonal, {1 + k + 4.5, 1 + 4.5, 1 + k});
  check_all(ring.off, {-4.5, 0, -k});
}

TEST_CASE("coefficients of the schemes satisfy their order conditions", "[unit][formulas]") {
  for (const Scheme& scheme : {verlet(), blanes_moan_4(), blanes_moan_6(), blanes_moan_6_14()}) {
    CAPTURE(scheme.name);
    double kicks = 0, drifts = 0;
    for (double k : scheme.kick) kicks += k;
    for (double d : scheme.drift) drifts += d;
    check_close(kicks, 1, 1e-14);
    check_close(drifts, 1, 1e-14);
    const std::size_t last = scheme.kick.size() - 1;
    for (std::size_t i = 0; i <= last; ++i)
      check_close(scheme.kick[i], scheme.kick[last - i], 1e-15);
  }
  // Quadrature of t^k by the velocity weights and, with a second integral, by the position weights;
  // and the two conditions that couple the stages up to order five.
  for (const Nystrom& base : {dormand_prince_6(), nystrom(blanes_moan_4()),
                              nystrom(blanes_moan_6()), nystrom(blanes_moan_6_14())}) {
    CAPTURE(base.name);
    for (int k = 0; k < base.order; ++k) {
      CAPTURE(k);
      double velocity = 0, position = 0;
      for (std::size_t i = 0; i < base.b.size(); ++i) {
        velocity += base.b[i] * std::pow(base.c[i], k);
        if (i < base.last()) position += base.a[base.last()][i] * std::pow(base.c[i], k);
      }
      check_close(velocity, 1.0 / (k + 1), 2e-13);
      if (k + 1 < base.order) check_close(position, 1.0 / (k + 1) / (k + 2), 2e-13);
    }
    for (int k = 0; k < 3 && k + 3 <= base.order; ++k) {
      CAPTURE(k);
      double sum = 0;
      for (std::size_t i = 0; i < base.b.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          sum += base.b[i] * base.a[i][j] * std::pow(base.c[j], k);
      check_close(sum, 1.0 / (k + 1) / (k + 2) / (k + 3), 2e-13);
    }
  }
  const Nystrom base = dormand_prince_6();
  for (std::size_t i = 1; i < base.c.size(); ++i) {
    double sum = 0;
    for (double a : base.a[i]) sum += a;
    check_close(sum, base.c[i] * base.c[i] / 2, 1e-15);
  }
}

TEST_CASE("merged stages are the whole scheme", "[unit][formulas]") {
  const Scheme scheme = blanes_moan_4();
  double kicks = 0, drifts = 0;
  for (std::size_t k = 0; k < stage_count(scheme, 3); ++k) {
    const auto stage = stage_at<double>(scheme, 0.5, 3, k);
    kicks += stage.kick;
    drifts += stage.drift;
  }
  check_close(kicks, 1.5, 1e-14);
  check_close(drifts, 1.5, 1e-14);
}

TEST_CASE("the quintic has the values at both ends", "[unit][formulas]") {
  // x = 1 + 2 s - s^2 + 3 s^3 - 2 s^4 + s^5 and its derivatives.
  const Quintic x{1, 2, -1, 4, 6, 6};
  for (double s : {0.0, 0.3, 0.7, 1.0}) {
    check_close(x(s), 1 + s * (2 + s * (-1 + s * (3 + s * (-2 + s)))), 1e-13);
    check_close(x.slope(s), 2 + s * (-2 + s * (9 + s * (-8 + s * 5))), 1e-13);
  }
}

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

TEST_CASE("a contact that closes and opens within a step", "[unit][formulas]") {
  // F = (0.01 - (s - c)^2)^(3/2), about c between two points at which the overlap is looked at
  for (double c : {0.25, 0.5, 0.75}) {
    CAPTURE(c);
    const auto overlap = [c](double s) { return 0.01 - (s - c) * (s - c); };
    const Quintic x{overlap(0), 2 * c, -1, overlap(1), 2 * c - 2, -1};
    const auto push = [&](double s) { return Hertz{0}.force(-x(s)); };
    const auto impulse = exact_impulse(x, push, false);
    const double all = 3 * std::acos(-1.0) / 8 * 1e-4;
    check_close(impulse.velocity, all, 1e-12);
    check_close(impulse.position, (1 - c) * all, 1e-12);
  }
}

TEST_CASE("a contact that closes or opens between two looks", "[unit][formulas]") {
  // x = +-(p - (s - c)^2), with sqrt(p) much smaller than the distance of the points at which it is looked at
  for (double c : {0.11, 0.38, 0.6, 0.9})
    for (double p : {1e-3, 1e-6}) {
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

TEST_CASE("the look-out's parabola and cubic by hand", "[unit][formulas]") {
  // 3 - 4 t + t^2 leaves the positive side at t = 1, its mirror image the negative one.
  check_close(Overlap<double>{3, -4, 2}.leaves(1), 1, 1e-14);
  check_close(Overlap<double>{-3, 4, -2}.leaves(-1), 1, 1e-14);
  check_close(Overlap<double>{3, -4, 2}.turns(), 2, 1e-14);
  // 3 + 2 t - t^2 first rises and leaves at t = 3.
  check_close(Overlap<double>{3, 2, -2}.leaves(1), 3, 1e-14);
  CHECK(std::isinf(Overlap<double>{3, -1, 2}.leaves(1)));
  // 1 - t + 2 t^2 - t^3 on an interval of length 2.
  const Arc<double> arc{1, -1, -1, -5, 2};
  for (double s : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    const double t = 2 * s;
    check_close(arc.value(s), 1 - t + 2 * t * t - t * t * t, 1e-14);
    check_close(arc.slope(s), -1 + 4 * t - 3 * t * t, 1e-13);
  }
}

TEST_CASE("the map of an interval and the extrapolation by hand", "[unit][formulas]") {
  check_close(span(0.0, 1.0), 1, 1e-15);
  check_close(span(0.2, 0.6), 0.648 - 0.104, 1e-15);
  for (std::size_t levels : {2, 5, 9}) {
    // Weights reproduce constants and remove the powers of 1 / j^2.
    for (std::size_t power = 0; power < levels; ++power) {
      double sum = 0;
      for (std::size_t j = 1; j <= levels; ++j)
        sum += extrapolation_weight<double>(j, levels) * std::pow(double(j), -2.0 * double(power));
      check_close(sum, power == 0 ? 1 : 0, 1e-9);
    }
  }
}

TEST_CASE("the tangent by difference quotients, inside the core and outside", "[unit][formulas]") {
  constexpr std::size_t sites = 16, last = sites - 1;
  Chain chain{sites, Quartic{0.5}};
  std::vector<double> mass(sites, 1), eta(sites + 1, 1);
  mass[1] = 2, mass[last] = 4;
  eta[1] = 0.7, eta[2] = 1.3;
  vary(chain, mass, eta);
  const double time = 3.7;
  State<double> start = struck(sites, 1.2);
  start.y[1] = 0.3;
  start.y[2] = -0.2;
  auto end = start;
  Tangent<double> tangent(sites, 2 * sites);
  flow(chain, end, time, {}, &tangent);
  for (std::size_t column : {std::size_t(0), std::size_t(1), std::size_t(2), sites, sites + 1}) {
    const auto moved = [&](double h) {
      auto s = start;
      (column < sites ? s.y[column] : s.v[column - sites]) += h;
      flow(chain, s, time);
      return s;
    };
    const auto up = moved(1e-8), down = moved(-1e-8);
    for (std::size_t n = 0; n < 3; ++n) {
      CAPTURE(column, n);
      check_close(tangent(n, column), (up.y[n] - down.y[n]) / 2e-8, 1e-3);
      check_close(tangent(n + sites, column), (up.v[n] - down.v[n]) / 2e-8, 1e-3);
    }
  }
  // The last bead, of mass 4, is alone: it turns with the frequency 1/2.
  check_close(tangent(last, last), std::cos(time / 2), 1e-12);
  check_close(tangent(last, last + sites), 2 * std::sin(time / 2), 1e-12);
  check_close(tangent(last + sites, last), -std::sin(time / 2) / 2, 1e-12);
  check_close(tangent(last + sites, last + sites), std::cos(time / 2), 1e-12);
}

TEST_CASE("the extrapolation is worth its name", "[unit][formulas]") {
  // A wrong extrapolation still arrives, because its error is seen and the steps become short: 398 of
  // them instead of 10 for a single bead, 1220 instead of 45 for six.
  Chain one{1, Quartic{1}}, six{6, Quartic{1}};
  State<double> turned(1);
  turned.y[0] = 0.5;
  const auto smooth = flow(one, turned, 3.0);
  CHECK(smooth.steps <= 15);
  CHECK(smooth.error < 1e-12);
  auto hit = struck(6, 1.5);
  Tangent<double> tangent(6, 12);
  const auto switching = flow(six, hit, 3.0, {}, &tangent);
  CHECK(switching.steps <= 70);
  CHECK(switching.contact_events > 0);
  CHECK(switching.missed_events == 0);
  CHECK(switching.error < 3e-12);
}

TEST_CASE("the area counts the masses", "[unit][formulas]") {
  Chain chain{1};
  vary(chain, {4}, {1, 1});
  State<double> s(1);
  s.y[0] = 0.3;
  // v = -0.15 sin(t / 2): 4 * 0.15^2 * 2 pi over the period 4 pi.
  check_close(flow(chain, s, 4 * M_PI).area, 0.18 * M_PI, 1e-12);
  check_close(s.y[0], 0.3, 1e-12);
}

TEST_CASE("an event-corrected run across contact events agrees with the event-driven one",
          "[unit][formulas]") {
  // At this step the run errs by 5e-12. With a wrong sign in the correction of the positions or of the
  // stages' shift it errs by 3e-9 or 1e-10.
  for (double d : {0.0, 0.3}) {
    CAPTURE(d);
    Chain chain{6, Quartic{1}, CompressedHertz{d}, Ends::fixed};
    vary(chain, {1, 2, 1, 1, 1.5, 1}, {1, 0.6, 1.4, 1, 1, 0.8, 1});
    auto aware = struck(6, 1.5), event_driven = aware;
    Window all{0, 6};
    const EventCorrected method{0.02};
    NystromMemory memory = method.memory(chain);
    method.advance(chain, aware, all, 0.02, 400, memory);
    flow(chain, event_driven, 8.0);
    aware.t = event_driven.t;
    check_close(distance(aware, event_driven), 0, 2e-11);
  }
}

TEST_CASE("packets by hand", "[unit][formulas]") {
  const std::vector<double> e{1, 2, 3, 4, 5, 6};
  check_close(participation(e), 441.0 / 91, 1e-13);
  check_close(boundary_share(e), 15.0 / 21, 1e-15);
  check_close(boundary_share(e, 2), 3.0 / 21, 1e-15);
  check_close(energy_centre(e, 2, 1), (2 * 2 + 3 * 3 + 4 * 4) / 9.0, 1e-14);
  const auto s = struck(3, 1.5);
  check_all(s.y, {0, 0, 0});
  check_all(s.v, {1.5, 0, 0});
  Path path;
  for (int k = 0; k < 9; ++k) path.add(0.5 * k, {double(8 - k), double(k)}, 0);
  const auto line = path.line(1.2, 1.8);
  REQUIRE(line);
  check_close(line->slope, 0.25, 1e-13);
  check_close(line->intercept, 1, 1e-13);
}

TEST_CASE("the DpS equation by hand", "[unit][formulas]") {
  const double r = 1 / (2 * tau_0());
  const auto rate = [](std::vector<double> a, Ends end) {
    std::vector<double> da(a.size());
    Dps{a.size() / 2, end}(0, a.data(), da.data());
    return da;
  };
  check_all(rate({0, -1, 0, 0}, Ends::free), {r, 0, -r, 0});
  check_all(rate({0, 0, 4, 0}, Ends::free), {0, -8 * r, 0, 8 * r});
  check_all(rate({4, 0, 0, 0}, Ends::fixed), {0, 16 * r, 0, -8 * r});
  // |3 + 4 i|^{1/2} (3 + 4 i)
  const double m = std::sqrt(5.0);
  check_all(rate({0, 0, 3, 4}, Ends::free), {4 * m * r, -3 * m * r, -4 * m * r, 3 * m * r});
  check_close(energy(Field{0, 4}), 12.8, 1e-14);
  check_close(norm(Field{{3, 4}, 1}), 26, 1e-14);
  check_all(density(Field{{3, 4}, 1}), {25, 1});
  check_close(tau_0(), 1.5450622, 1e-7);
  check_close(breather_eps(1.5), tau_0() * tau_0(), 1e-14);
  const auto still = dps_state(Field{{1, 2}}, 0.25, 0),
             later = dps_state(Field{{1, 2}}, 0.25, M_PI / 2);
  check_all(still.y, {0.5});
  check_all(still.v, {-1});
  check_all(later.y, {-1});
  check_all(later.v, {-0.5});
  CHECK(dps_impact(2)[0] == std::complex<double>(0, -1));
}

TEST_CASE("the vertex of a parabola through three samples, by hand", "[unit][formulas]") {
  // 3 - 2 (x - 1/4)^2 at -1, 0 and 1
  const Parabola top(-0.125, 2.875, 1.875);
  check_close(top.slope, 1, 1e-15);
  check_close(top.bend, -4, 1e-15);
  check_close(top.vertex(), 0.25, 1e-15);
  check_close(top.extremum(), 3, 1e-15);
}

TEST_CASE("the singular values of a matrix with more rows than columns, by hand",
          "[unit][formulas]") {
  Matrix<double> tall(3, 2);
  tall << 3, 0, 4, 0, 0, 0.5;
  const Softness soft = condition_of(tall);
  check_close(soft.condition, 10, 1e-14, 1e-14);
  check_close(std::abs(soft.softest[1]), 1, 1e-14);
  check_close(soft.softest[0], 0, 1e-14);
}
