// Phonons, the NLS coefficient, exact waves, envelopes, and what a compressed impact leaves.

#include <algorithm>

#include "commands/compressed_impact.hpp"
#include "commands/phonon_band.hpp"
#include "lattice/algebra/eigenvalues.hpp"
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

std::vector<PacketSample> synthetic(double share_power, double boundary_power, double turn) {
  std::vector<PacketSample> samples;
  for (double t = 1; t <= 800; ++t) {
    const double centre = t < turn ? 0.6 * t : 0.6 * (2 * turn - t);
    samples.push_back({t, centre, std::pow(t, share_power), 0.1 * std::pow(t, boundary_power)});
  }
  return samples;
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

TEST_CASE("an exact wave is a series, and the largest one opens a contact", "[unit]") {
  const PlaneWave three{0.7, 1.3, {0.2, -0.05, 0.03}};
  check_close(three.profile(0.4), 0.2 * std::sin(0.4) - 0.05 * std::sin(0.8) + 0.03 * std::sin(1.2),
              1e-15);
  check_close(three.relative(0.4), three.profile(1.1) - three.profile(0.4), 1e-15);
  const PlaneWave one = plane_wave(Quartic{1}, contact, 1.9, 0.14, 24);
  CHECK((one.b.size() == 24 && one.b[0] == 0.14));
  CHECK(plane_wave(Quartic{}, contact, 1, 0.1).b.size() == 12);
  // The largest wave is the one that opens a contact, wherever in the period that is
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

TEST_CASE("breathers, trains, surface modes and boomerangs are told apart", "[unit]") {
  const Traits breather = traits(synthetic(-0.05, -1, 1e9)),
               train = traits(synthetic(-1.0 / 3, -1, 1e9)),
               surface = traits(synthetic(-1.0 / 3, 0, 1e9)),
               boomerang = traits(synthetic(0, -1, 500));
  check_close(breather.share_exponent, -0.05, 1e-12);
  check_close(train.share_exponent, -1.0 / 3, 1e-12);
  check_close(train.boundary_exponent, -1, 1e-12);
  check_close(surface.boundary_exponent, 0, 1e-12);
  check_close(breather.steadiness, 1, 1e-12);
  CHECK(boomerang.steadiness < 0);
  check_close(traits(synthetic(0, -1, 150), 0.5).steadiness, -1, 1e-12);  // after it has turned
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
  std::vector<double> narrow(200, 0.3), wide(200, 0);
  for (std::size_t i = 0; i < 200; ++i) {
    narrow[i] += std::pow(std::cosh((double(i) - 100) / 4), -2);
    wide[i] += std::pow(std::cosh((double(i) - 100) / 20), -2);
  }
  CHECK(packet_width(narrow) < packet_width(wide));
  CHECK(participation(narrow) > participation(wide));  // which is why it is not asked
}

TEST_CASE("a breather on the ring is concentrated and moves to the right", "[unit]") {
  const auto ring = [](double peak, double speed) {
    WatchedRing m;
    m.end.density.assign(200, 0.01);
    m.end.density[20] += peak;
    for (double t = 0; t <= 60; ++t) {
      m.t.push_back(t);
      m.centre.push_back(20 + speed * t + 0.3 * std::sin(t));
    }
    return m;
  };
  const Packet made = packet_of({ring(0, 0.3), ring(1, 0.3)}),
               flat = packet_of({ring(0, 0), ring(0, 0)});
  check_close(made.peak_over_mean.value, 1.01 / (3.0 / 200), 1e-11);
  check_close(made.peak_over_mean.error, made.peak_over_mean.value - 1, 1e-11);
  check_close(made.share_of_sites.value, 9 / (1.01 * 1.01 + 199e-4) / 200, 1e-12);
  CHECK(made.width.value < 10);
  check_close(flat.peak_over_mean.value, 1, 1e-12);
  CHECK((flat.share_of_sites.value > 0.99 && flat.width.value == 200));
  CHECK(made.speed.value > made.speed.error);
  check_close(made.speed.value, 0.3, 0.02);
  CHECK(flat.speed.value < flat.speed.error);
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

TEST_CASE("a packet by its densities, site by site", "[unit]") {
  std::vector<double> e(150);
  for (std::size_t n = 0; n < 150; ++n)
    e[n] = 0.2 + std::sin(0.7 * double(n)) * 0.1 + std::exp(-std::pow((double(n) - 70.3) / 9, 2));
  const auto sum = [&](int from, int to, auto of) {
    double all = 0;
    for (int n = from; n <= to; ++n) all += of(n, e[std::size_t(n)]);
    return all;
  };
  const auto itself = [](int, double x) { return x; };
  const auto square = [](int, double x) { return x * x; };
  int peak = 20;
  for (int n = 20; n < 130; ++n)
    if (sum(n - 20, n + 20, itself) > sum(peak - 20, peak + 20, itself)) peak = n;
  const int from = peak - 20, to = peak + 20;
  const double all = sum(0, 149, itself), inside = sum(from, to, itself);
  const PacketSample at = packet_sample(7, e);
  CHECK(at.t == 7);
  check_close(at.centre, sum(from, to, [](int n, double x) { return (n + 1) * x; }) / inside,
              1e-11);
  check_close(at.share, inside / all, 1e-13);
  check_close(at.boundary, sum(0, 4, itself) / all, 1e-13);
  check_close(at.sites, inside * inside / sum(from, to, square), 1e-10);
}

TEST_CASE("the envelope is that of the carrier in the window", "[unit]") {
  const Chain chain{4, Harmonic{}, Hertz{}, Ends::free};
  State<double> state(4);
  state.y = {0.1, -0.15, 0.1, 0.3};
  state.v = {0.5, 0.7, -0.2, 0.4};
  const double push = std::pow(0.25, 1.5);  // of the first bead on the second, the only one
  const double a[] = {-0.1 - push, 0.15 + push, -0.1, -0.3};
  const Envelope e = envelope(chain, state, {1, 3});
  const double omega = std::sqrt((a[1] * a[1] + a[2] * a[2]) / (0.49 + 0.04));
  check_close(e.omega, omega, 1e-14);
  REQUIRE(e.amplitude.size() == 4);
  for (std::size_t n = 0; n < 4; ++n)
    check_close(e.amplitude[n], std::sqrt(state.v[n] * state.v[n] + std::pow(a[n] / omega, 2)),
                1e-14);
}

TEST_CASE("no sech near the one that is fitted fits better", "[unit]") {
  const auto sech = [](double n, double height, double centre, double width) {
    return height / std::cosh((n - centre) / width);
  };
  struct Case {
    double centre, width, start;
    Window range;
  };
  for (const Case& c :
       {Case{30.4, 4, 8, {20, 41}}, {30, 9, 3, {25, 50}}, {27.3, 4, 20, {20, 41}}}) {
    std::vector<double> a(60, 0.9);
    for (std::size_t n = 15; n < 50; ++n) {
      const double x = double(n + 1);
      a[n] = sech(x, 0.7, c.centre, c.width) + 0.04 * std::sin(1.3 * x) + 0.002 * (x - 30);
    }
    const Sech f = fit_sech(a, c.range, c.start);
    const auto misfit = [&](double height, double centre, double width) {
      double sum = 0;
      for (std::size_t n = c.range.first; n < c.range.last; ++n)
        sum += std::pow(a[n] - sech(double(n + 1), height, centre, width), 2);
      return sum;
    };
    const double least = misfit(f.height, f.centre, f.width), h = 1e-4;
    CAPTURE(c.centre, f.centre, f.width);
    check_close(misfit(f.height + h, f.centre, f.width), misfit(f.height - h, f.centre, f.width),
                1e-11);
    check_close(misfit(f.height, f.centre + h, f.width), misfit(f.height, f.centre - h, f.width),
                1e-11);
    check_close(misfit(f.height, f.centre, f.width + h), misfit(f.height, f.centre, f.width - h),
                1e-11);
    check_close(f.residual, std::sqrt(least / double(c.range.last - c.range.first)) / f.height,
                1e-13);
    check_close(f.width, c.width, 0, 0.15);
    check_close(f.at(28), sech(28, f.height, f.centre, f.width), 1e-15);
  }
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
