// Phonons, the NLS coefficient, exact waves, envelopes, and what a compressed impact leaves.

#include <algorithm>

#include "commands/compressed_impact.hpp"
#include "commands/phonon_band.hpp"
#include "lattice/algebra/dense.hpp"
#include "lattice/gsl/random.hpp"
#include "lattice/gsl/reference.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/orbits/floquet.hpp"
#include "sec4/exact_waves.hpp"
#include "sec4/packets.hpp"
#include "support/check.hpp"

using namespace lattice;
using namespace report;

namespace {

const double d = 0.5;
const CompressedHertz contact{d};

double slope(const PlaneWave& wave, double theta) {
  double sum = 0;
  for (std::size_t k = 0; k < wave.b.size(); ++k)
    sum += double(k + 1) * wave.b[k] * std::cos(double(k + 1) * theta);
  return sum;
}

State<double> on_ring(const PlaneWave& wave, std::size_t sites) {
  State<double> state(sites);
  for (std::size_t n = 0; n < sites; ++n) {
    const double theta = wave.q * double(n + 1);
    state.y[n] = wave.profile(theta);
    state.v[n] = -wave.omega * slope(wave, theta);
  }
  return state;
}

}  // namespace

TEST_CASE("an exact wave keeps its form and frequency in a run", "[property]") {
  const double q = 2 * M_PI * 5 / 24;
  const Chain ring{24, Quartic{1}, contact, Ends::periodic};
  const PlaneWave wave = plane_wave(ring.well, contact, q, 0.12);
  State<double> state = on_ring(wave, 24);
  evolve(Splitting{blanes_moan_6_14(), 0.1}, ring, state, 4, Every{1});
  for (std::size_t n = 0; n < 24; ++n) {
    const double theta = q * double(n + 1) - wave.omega * 4;
    check_close(state.y[n], wave.profile(theta), 1e-10);
    check_close(state.v[n], -wave.omega * slope(wave, theta), 1e-10);
  }
  CHECK(std::abs(wave.omega - phonon(q, contact_series(d).v1).omega) > 1e-4);
}

TEST_CASE("the largest exact wave opens a contact", "[unit]") {
  // Wherever in the period that is
  for (double q : {0.2, 2.0}) {
    double low = 0, high = 4, top = 0;
    for (int k = 0; k < 12; ++k) {
      const double a = (low + high) / 2;
      const auto make = [&] { plane_wave(Quartic{}, contact, q, a, 8); };
      (refusal<std::runtime_error>(make).empty() ? low : high) = a;
    }
    const PlaneWave wave = plane_wave(Quartic{}, contact, q, low, 8);
    for (double x = 0; x < 2 * M_PI; x += 0.01) top = std::max(top, wave.relative(x));
    CAPTURE(q, low);
    check_close(top, d, 0, 2e-3);
  }
}

TEST_CASE("a sech is fitted about the top of its envelope", "[unit]") {
  // A packet, and behind it a wave that draws the centre of energy to its side
  const Chain chain{300, Quartic{1}, contact};
  const double omega = phonon(1.9, contact_series(d).v1).omega;
  State<double> state(300);
  for (std::size_t i = 0; i < 300; ++i) {
    const double n = double(i + 1), wave = n > 140 && n < 165 ? 0.005 : 0;
    const double envelope = 0.01 / std::cosh((n - 177) / 6) + wave;
    state.y[i] = envelope * std::sin(1.9 * n);
    state.v[i] = -omega * envelope * std::cos(1.9 * n);
  }
  const double centre = packet_sample(0, energy_density(chain, state)).centre;
  CHECK(centre < 172);
  const Snapshot shot = snapshot(chain, state);
  CHECK(std::abs(shot.centre - 177) <= 1);
  check_close(shot.sech.centre, 177, 0, 0.01);
  check_close(shot.sech.width, 6, 0, 0.1);
  check_close(shot.sech.height, 0.01 * omega, 0, 0.1);
}

TEST_CASE("a packet is the richest 41 sites", "[unit]") {
  std::vector<double> e(150, 0.01);
  for (int n = 0; n < 150; ++n) e[std::size_t(n)] += 1 / (1.0 + std::abs(n - 70));
  double all = 0, inside = 0, squares = 0;
  for (int n = 0; n < 150; ++n) all += e[std::size_t(n)];
  for (std::size_t n = 50; n <= 90; ++n) inside += e[n], squares += e[n] * e[n];
  const PacketSample at = packet_sample(7, e);
  check_close(at.centre, 71, 1e-12);
  check_close(at.share, inside / all, 1e-13);
  check_close(at.sites, inside * inside / squares, 1e-12);
}

TEST_CASE("a packet that turns round is not steady", "[unit]") {
  std::vector<PacketSample> samples;
  for (double t = 1; t <= 800; ++t)
    samples.push_back({t, 0.6 * (t < 500 ? t : 1000 - t), std::pow(t, -0.3), 0.1 / t});
  const Traits all = traits(samples), after = traits(samples, 0.75);
  check_close(all.share_exponent, -0.3, 1e-12);
  check_close(all.boundary_exponent, -1, 1e-12);
  check_close(after.steadiness, -1, 1e-12);
}

TEST_CASE("a tail on one side is not one on both", "[unit]") {
  const auto packet = [](double behind, double ahead) {
    Snapshot shot{
        State<double>(301), {}, 150, {1, std::vector<double>(301, behind)}, {0.5, 150, 5, 0}};
    std::fill(shot.envelope.amplitude.begin() + 150, shot.envelope.amplitude.end(), ahead);
    return shot;
  };
  check_close(tail_amplitude(packet(0.01, 0.02), -1), 0.02, 1e-15);
  check_close(tail_amplitude(packet(0.01, 0.02), 1), 0.04, 1e-15);
  // Only from 40 to 80 sites, and only what is far behind belongs to the train
  Snapshot shot = packet(0.01, 0.02);
  shot.envelope.amplitude[149 + 39] = shot.envelope.amplitude[149 + 81] = 1;
  check_close(tail_amplitude(shot, 1), 0.04, 1e-15);
  shot.envelope.amplitude[149 + 40] = 1;
  CHECK(tail_amplitude(shot, 1) > 0.2);
  check_close(train_amplitude(shot), 0.02, 1e-15);
  shot.envelope.amplitude[149 - 31] = 0.1, shot.envelope.amplitude[149 - 30] = 3;
  check_close(train_amplitude(shot), 0.2, 1e-15);
}

namespace {

/// One pulse until `split`, then a second one of this height for a time `lasting`; the energy gathers at t = 2000.
RingPair drawn(double split, double height, double lasting) {
  RingPair pair;
  pair.localized = {2000, 50};
  for (double t = 50; t <= 9000; t += 50) {
    const bool two = t >= split && t < split + lasting;
    const RingSample at{t, 10, two ? height : 0.1, t >= 2000};
    pair.samples.push_back({at, at});
  }
  return pair;
}

}  // namespace

TEST_CASE("a pulse that splits was one before", "[unit]") {
  const double round = 340;
  const PulseSplits splits = pulse_splits(drawn(3000, 0.8, 2000), round);
  CHECK((splits.one_pulse_for.value == 1000 && splits.second.value == 0.8));
  CHECK(splits.kept.value == 0.8);
  const PulseSplits brief = pulse_splits(drawn(3000, 0.8, 350), round);  // seven samples
  CHECK((brief.second.value == 0.8 && brief.kept.value == 0.1));
  CHECK(pulse_splits(drawn(3000, 0.8, 400), round).kept.value == 0.8);
  const PulseSplits never = pulse_splits(drawn(5000, 0.8, 2000), round);  // too late
  CHECK((never.second.value == 0.1 && never.one_pulse_for.value == 2000));
  CHECK(pulse_splits(drawn(3000, 0.4, 2000), round).one_pulse_for.value == 2000);
  CHECK(std::isnan(pulse_splits({}, round).second.value));
}

TEST_CASE("a second hump has a valley on both sides", "[unit]") {
  // Two pulses on a ring, at these sites and of these heights, on a background
  const auto ring = [](double far, double height, double background) {
    std::vector<double> e(200, background);
    for (std::size_t i = 0; i < 200; ++i)
      for (const auto& [at, size] : {std::pair{190.0, 1.0}, {190 + far, height}})
        e[i] += size * std::pow(std::cosh(std::remainder(double(i) - at, 200.0) / 8), -2);
    return e;
  };
  CHECK(second_hump(ring(60, 0, 0.1)) == 0);
  check_close(second_hump(ring(60, 0.7, 0)), 0.7, 1e-3);
  check_close(second_hump(ring(60, 0.7, 0.1)), 0.8 / 1.1, 0, 0.02);
  CHECK(second_hump(ring(20, 0.7, 0)) == 0);    // no valley between the two
  CHECK(second_hump(ring(60, 0.7, 0.8)) == 0);  // nor here, on this background
  check_close(second_hump(ring(-60, 0.7, 0)), second_hump(ring(60, 0.7, 0)), 1e-12);
  // On the ring two equal heaps of energy are two packets, one heap is one
  const Chain chain{200, Quartic{}, contact, Ends::periodic};
  State<double> state(200);
  state.v[195] = 1;
  CHECK(ring_sample(chain, state).second == 0);
  state.v[95] = 1;
  check_close(ring_sample(chain, state).second, 1, 1e-15);
  CHECK(ring_sample(chain, state).localized);
}

TEST_CASE("a packet is as wide on a background as without", "[unit]") {
  const auto width = [](double at, double w, double background) {
    std::vector<double> e(200, background);
    for (std::size_t i = 0; i < 200; ++i)
      e[i] += std::pow(std::cosh(std::remainder(double(i) - at, 200.0) / w), -2);
    return packet_width(e);
  };
  check_close(width(100, 10, 0), 2 * std::acosh(std::sqrt(2.0)) * 10, 0, 0.03);
  check_close(width(199, 10, 0), width(100, 10, 0), 1e-12);  // across the joint of the ring
  check_close(width(100, 10, 0.05), width(100, 10, 0), 0, 0.06);
  CHECK(packet_width(std::vector<double>(200, 1)) == 200);
}

TEST_CASE("a weak blow sends out a train, as fast as the fastest phonon", "[property]") {
  // It sees neither the well's nor the contact's nonlinearity: no breather for any s
  const double v1 = contact_series(d).v1;
  for (double s : {-1.0 / 6, 1.0}) {
    std::vector<PacketSample> samples;
    const Impact impact = on_long_chain({1e-3, {.well = Quartic{s}, .contact = contact}, 600, 1});
    strike(Splitting{blanes_moan_6_14(), 0.4}, impact,
           [&](const State<double>& now, const std::vector<double>& density) {
             samples.push_back(packet_sample(now.t, density));
           });
    const Traits t = traits(samples);
    CHECK((t.share_exponent < -1.0 / 6 && t.boundary_exponent < -0.5));
    check_close(t.speed, phonon(inflection(v1), v1).group_velocity, 0, 0.02);
  }
}

TEST_CASE("no sech near the one that is fitted fits better", "[unit]") {
  const Window range{20, 41};
  std::vector<double> a(60);
  for (std::size_t n = 0; n < 60; ++n) {
    const double x = double(n + 1);
    a[n] = 0.7 / std::cosh((x - 30.4) / 4) + 0.04 * std::sin(1.3 * x) + 0.002 * (x - 30);
  }
  const auto misfit = [&](const Sech& other) {
    double sum = 0;
    for (std::size_t n = range.first; n < range.last; ++n)
      sum += std::pow(a[n] - other.at(double(n + 1)), 2);
    return sum;
  };
  const Sech f = fit_sech(a, range, 8);
  for (double Sech::*of : {&Sech::height, &Sech::centre, &Sech::width}) {
    Sech less = f, more = f;
    less.*of -= 1e-4, more.*of += 1e-4;
    check_close(misfit(more), misfit(less), 1e-11);
  }
  check_close(f.residual, std::sqrt(misfit(f) / 21) / f.height, 1e-13);
  check_close(f.width, 4, 0, 0.15);
}

namespace {

/// The anharmonicity at which beta vanishes.
double without_beta(double q, double compression) {
  const double x = 1 - std::cos(q), v1 = 1.5 * std::sqrt(compression), sine = std::sin(q);
  return -1.5 * sine * sine * x * x / compression / (4 * v1 * x * x + 3) +
         x * x / (4 * std::pow(compression, 1.5));
}

}  // namespace

TEST_CASE("what the band and the NLS equation say of a phonon, by a second formula", "[unit]") {
  for (double D : {0.5, 2.0})
    for (double q : {0.4, M_PI / 2, 2.7})
      for (double s : {-0.3, 0.2, 1.0}) {
        CAPTURE(D, q, s);
        const double v1 = 1.5 * std::sqrt(D), x = 1 - std::cos(q);
        const double omega = std::sqrt(1 + 2 * v1 * x), c = v1 * std::sin(q) / omega;
        const double curvature = (v1 * std::cos(q) - c * c) / omega;
        const double beta = 1.5 * (s - without_beta(q, D));
        const Coefficients<double> at = coefficients(q, D, s);
        check_close(at.omega, omega, 1e-14);
        check_close(at.group_velocity, c, 1e-14);
        check_close(at.curvature, curvature, 1e-14);
        check_close(at.beta, beta, 1e-13);
        check_close(at.omega_2, curvature * omega / v1, 1e-14);
        check_close(at.phi, -beta * at.omega_2, 1e-13);
        check_close(at.h(), beta / omega, 1e-13);
      }
  CHECK_THROWS_AS(contact_series(0.0), std::invalid_argument);
  CHECK_THROWS_AS(contact_series(std::nan("")), std::invalid_argument);
}

TEST_CASE("no interval of unstable wavenumbers is too narrow to be found", "[unit]") {
  const auto check = [&](double D, double s, const std::vector<double>& right) {
    const std::vector<double> found = edges_of_instability(D, s);
    CAPTURE(D, s, found);
    REQUIRE(found.size() == right.size());
    for (std::size_t k = 0; k < right.size(); ++k) check_close(found[k], right[k], 3e-8, 1e-11);
  };
  // An edge next to 0 and next to pi, and a narrow gap; the values are those of a program with sixty digits
  check(1e-6, 2.27e-5, {0.000776312306718529, 1.56930080943298});
  check(0.5, 2.828427, {1.16795002276345, 3.14134384488821});
  check(1, 1e-9, {0.0112475972836517, 1.04710809692715, 1.0472869823720304, 1.1024444801741456});
  // Both edges of an interval of this width between the zeros of the curvature and of beta
  for (double width : {1e-4, 1e-6, 1e-9}) {
    const double zero = 1.2,
                 D = std::pow(2 * std::cos(zero) / std::pow(1 - std::cos(zero), 2) / 3, 2);
    const auto seen = edges_of_instability(D, without_beta(zero - width, D));
    check_close(seen.end()[-2], zero - width, 1e-14);
    check_close(seen.back(), zero, 1e-14);
  }
  CHECK(edges_of_instability(0.5, 0.0) ==
        std::vector<double>{0, inflection(contact_series(0.5).v1)});
  CHECK(edges_of_instability(0.5, 4.0).back() == M_PI);
}

TEST_CASE("unstable are the wavenumbers at which Phi is positive", "[property]") {
  Random random(3);
  for (int k = 0; k < 3000; ++k) {
    const double D = std::pow(10, random.uniform(-6, 2)),
                 s = std::copysign(std::pow(10, random.uniform(-12, 2)), random.uniform(-1, 1));
    const auto edges = edges_of_instability(D, s);
    for (int j = 0; j < 20; ++j) {
      const double q = random.uniform(0, M_PI), phi = coefficients(q, D, s).phi;
      bool inside = false, beside = std::abs(phi) < 1e-9 * std::abs(s);
      for (double edge : edges) {
        inside = inside != (q > edge);
        beside = beside || std::abs(q - edge) < 1e-9;
      }
      if (!beside && inside != (phi > 0)) FAIL_CHECK("d = " << D << ", s = " << s << ", q = " << q);
    }
  }
}

TEST_CASE("the growth rate is that of a disturbance that is followed for a period", "[unit]") {
  // Backscattering, on four sites and, beside it, modulations that grow with the NLS equation's help, on eight
  const auto compare_on = [](std::size_t n, double s, double a, int waves) {
    const PlaneWave wave = plane_wave(Quartic{s}, contact, 2 * M_PI * waves / double(n), a);
    const Chain ring{n, wave.well, contact, Ends::periodic};
    const double period = 2 * M_PI / wave.omega;
    double most = 0;
    for (const std::complex<double>& value :
         eigenvalues_of(monodromy(ring, on_ring(wave, n), period)))
      most = std::max(most, std::abs(value));
    // Modulations that differ by a wavenumber of the wave are the same
    double best = 0;
    for (int k = 0; k < waves; ++k)
      best = std::max(best, growth_rate(wave, 2 * M_PI * k / double(n)));
    CAPTURE(n, s, a, best);
    check_close(best, std::log(most) / period, 2e-7);
    CHECK(best > 1e-3);
  };
  compare_on(4, 1, 0.12, 1);
  compare_on(4, 1, 0.16, 1);
  compare_on(8, 1, 0.12, 2);
}

TEST_CASE("an impact whose contacts go on opening has the error that it states", "[unit]") {
  // Against GSL's method. In the first three runs contacts open after the settling time of the chapter
  struct Blow {
    double velocity, s, d, time;
  };
  for (const Blow& b : {Blow{0.014854110076982853, 5.470967112522019, 0.001, 100},
                        {0.8, 1, 0.02, 60},
                        {0.05, -0.3, 0.004, 80},
                        {1e-6, 1, 0.5, 30}}) {
    CompressedImpact one;
    one.velocity = b.velocity, one.well = Quartic{b.s}, one.d = b.d, one.time = b.time;
    const Table table = one.table();
    const Chain chain =
        on_long_chain({b.velocity, {.well = one.well, .contact = CompressedHertz{b.d}}, b.time})
            .chain;
    State<double> end = struck(chain.sites, b.velocity);
    evolve_reference(chain, end, b.time, {1e-12 * b.velocity, 1e-12, gsl_odeiv2_step_rk8pd});
    const PacketSample seen = packet_sample(b.time, energy_density(chain, end));
    const auto value = table.numbers("value"), error = table.numbers("error");
    CAPTURE(b.velocity, b.s, b.d, value[0], seen.centre, value[4], seen.boundary);
    check_close(value[0], seen.centre, 3 * error[0] + 1e-9);
    check_close(value[3], seen.share, 3 * error[3] + 1e-11);
    check_close(value[4], seen.boundary, 3 * error[4] + 1e-11);
  }
}
