// Phonons, the NLS coefficient, exact waves, envelopes, and what a compressed impact leaves.

#include <algorithm>
#include <filesystem>
#include <functional>

#include "commands/compressed_impact.hpp"
#include "commands/phonon_band.hpp"
#include "lattice/algebra/eigenvalues.hpp"
#include "lattice/gsl/random.hpp"
#include "lattice/gsl/reference.hpp"
#include "lattice/impact/impact.hpp"
#include "sec4/exact_waves.hpp"
#include "sec4/packets.hpp"
#include "support/check.hpp"
#include "support/run.hpp"

using namespace lattice;
using std::numbers::pi;

namespace {

const double d = 0.5;
const CompressedHertz contact{d};

/// Relative deviation of beta from the frequency of an exact wave, at zero amplitude.
double beta_from_wave(double q, double s) {
  const auto c = coefficients(q, d, s);
  const auto of = [&](double a) {
    const double omega = plane_wave(Quartic{s}, contact, q, a).omega;
    return (omega * omega - c.omega * c.omega) / (a * a / 2);
  };
  return (4 * of(0.01) - of(0.02)) / 3;
}

/// The ring of figure 26 in wells of anharmonicity s.
Chain ring_of(double s) {
  return {200, Quartic{s}, contact, Ends::periodic};
}

/// An impact on a compressed chain, looked at once in a unit of time; from t = 40 on all contacts stay closed.
struct Watched : ImpactRun {
  std::vector<PacketSample> samples{};
  std::vector<Snapshot> shown{};
  double last_open = 0;
};
Watched watched(double s, double velocity, double time, const std::vector<double>& times = {}) {
  const Impact impact =
      on_long_chain({velocity, {.well = Quartic{s}, .contact = contact}, time, 1});
  Watched run{{struck(impact.chain.sites, velocity)}};
  const auto look = [&](const State<double>& now, const std::vector<double>& density) {
    if (!run.samples.empty() && run.samples.back().t == now.t) return;
    run.samples.push_back(packet_sample(now.t, density));
    for (std::size_t n = 1; n < impact.chain.sites; ++n)
      if (now.y[n] - now.y[n - 1] > d) run.last_open = now.t;
    if (std::find(times.begin(), times.end(), std::round(now.t)) != times.end())
      run.shown.push_back(snapshot(impact.chain, now));
  };
  follow(EventCorrected{0.1}, impact, run, 40, look);
  follow(Splitting{blanes_moan_6_14(), 0.4}, impact, run, time, look);
  return run;
}

std::vector<PacketSample> synthetic(double share_power, double boundary_power, double turn) {
  std::vector<PacketSample> samples;
  for (double t = 1; t <= 800; ++t) {
    const double centre = t < turn ? 0.6 * t : 0.6 * (2 * turn - t);
    samples.push_back(
        {t, centre, std::pow(t, share_power), 0.1 * std::pow(t, boundary_power), 1 + t, 7});
  }
  return samples;
}

}  // namespace

TEST_CASE("the contact's series is that of its force", "[unit]") {
  const auto v = contact_series(d);
  for (double r : {1e-3, -1e-3, 1e-2}) {
    const double series = v.v1 * r + v.v2 * r * r + v.v3 * r * r * r;
    check_close(-contact.force(r), series, 0.2 * r * r * r * r);
    CHECK(std::abs(-contact.force(r) - (series - v.v3 * r * r * r)) > 0.1 * std::abs(r * r * r));
  }
  check_close(v.v1, contact.stiffness(0.0), 1e-15);
  CHECK_THROWS_AS(contact_series(0.0), std::invalid_argument);
  CHECK_THROWS_AS(contact_series(std::nan("")), std::invalid_argument);
}

TEST_CASE("phonons diagonalise the linearised ring", "[property]") {
  const std::size_t sites = 24;
  const Chain ring{sites, Quartic{0.3}, contact, Ends::periodic};
  const auto h = linearise(ring, std::vector<double>(sites, 0.0));
  for (int k = 0; k <= 12; ++k) {
    const double q = 2 * pi * k / double(sites);
    const Phonon<double> p = phonon(q, contact_series(d).v1);
    double force = 0;
    for (int n : {-1, 0, 1}) force += (n == 0 ? h.diagonal[5] : h.off[5]) * std::cos(q * n);
    check_close(p.omega * p.omega, force, 1e-13);
  }
}

TEST_CASE("group velocity, curvature and inflection are derivatives of the band", "[unit]") {
  const double step = 1e-3;
  for (double compression : {0.05, 0.5, 3.0}) {
    const double v1 = contact_series(compression).v1;
    const auto omega = [&](double q) { return phonon(q, v1).omega; };
    for (double q : {0.3, 1.0, 2.5}) {
      const Phonon<double> p = phonon(q, v1);
      check_close(p.group_velocity, (omega(q + step) - omega(q - step)) / (2 * step), 1e-5);
      check_close(p.curvature, (omega(q + step) - 2 * omega(q) + omega(q - step)) / (step * step),
                  1e-5);
    }
    const double q = inflection(v1), x = 1 - std::cos(q);
    CHECK(q > 0);
    CHECK(q < pi / 2);
    check_close(std::cos(q), v1 * x * x, 1e-14);
    check_close(phonon(q, v1).omega_2, 0, 1e-14);
    CHECK(phonon(q - 0.05, v1).group_velocity < phonon(q, v1).group_velocity);
    CHECK(phonon(q + 0.05, v1).group_velocity < phonon(q, v1).group_velocity);
    check_close(omega(pi), std::sqrt(1 + 4 * v1), 1e-14);
  }
}

TEST_CASE("beta is the frequency shift of an exact wave; no term of it can be spared",
          "[property]") {
  const auto v = contact_series(d);
  for (double s : {-1.0 / 6, 0.0, 1.0})
    for (double q : {0.5, 1.3, 1.9, 2.6}) {
      CAPTURE(s, q);
      const double measured = beta_from_wave(q, s), beta = nls_beta(q, v, s);
      check_close(beta, measured, 0, 1e-3);
      ContactSeries<double> without = v;
      without.v2 = 0;
      CHECK(std::abs(nls_beta(q, without, s) - measured) > 1e-3 * std::abs(measured));
      without = v;
      without.v3 = 0;
      CHECK(std::abs(nls_beta(q, without, s) - measured) > 1e-3 * std::abs(measured));
      CHECK(std::abs(nls_beta(q, v, s + 0.01) - measured) > 1e-3 * std::abs(measured));
    }
}

TEST_CASE("an exact wave keeps its form and frequency in a run", "[property]") {
  const double q = 2 * pi * 5 / 24, a = 0.12;
  const Chain ring{24, Quartic{1}, contact, Ends::periodic};
  const PlaneWave wave = plane_wave(ring.well, contact, q, a);
  State<double> state = on_ring(wave, 24);
  const double start = energy(ring, state);
  evolve(Splitting{blanes_moan_6_14(), 0.1}, ring, state, 2 * pi / wave.omega, 1);
  const State<double> again = on_ring(wave, 24);
  for (std::size_t n = 0; n < 24; ++n) check_close(state.y[n], again.y[n], 1e-10);
  check_close(energy(ring, state), start, 0, 1e-11);
  CHECK(std::abs(wave.omega - phonon(q, contact_series(d).v1).omega) > 1e-4);
  CHECK_THROWS_AS(plane_wave(Quartic{1}, contact, 2.5, 0.6), std::runtime_error);
}

TEST_CASE("exact waves are unstable where phi is positive, at the rate of NLS", "[property]") {
  for (double s : {-1.0 / 6, 0.0, 1.0})
    for (double q : {pi / 4, 1.9, 2.8}) {
      CAPTURE(s, q);
      const double a = 0.01;
      const auto c = coefficients(q, d, s);
      const PlaneWave wave = plane_wave(Quartic{s}, contact, q, a);
      const double modulation = std::sqrt(std::abs(c.h() * a * a / (2 * c.curvature)));
      const double rate = growth_rate(wave, modulation);
      if (c.phi > 0) {
        check_close(rate, std::abs(c.h()) * a * a / 4, 0, 0.02);
        CHECK(growth_rate(wave, 2 * modulation) < 1e-9);
      } else {
        CHECK(rate < 1e-9);
      }
    }
}

TEST_CASE("growth gives phi without the formula for beta", "[property]") {
  const auto c = coefficients(pi / 4, d, -1.0 / 6);
  const auto growth = [&](double a, double modulation) {
    return growth_rate(plane_wave(Quartic{-1.0 / 6}, contact, pi / 4, a), modulation) /
           (a * a / 4) * c.omega * std::abs(c.omega_2);
  };
  const Estimate phi = at_zero_amplitude(
      0.04, [&](double a) { return growth(a, std::sqrt(-c.h() * a * a / (2 * c.curvature))); });
  check_close(phi.value, c.phi, 0, 1e-3);
  CHECK(phi.error < 1e-3 * phi.value);
  CHECK(std::abs(growth(0.04, 0.1) - phi.value) > 1e-3 * phi.value);
}

TEST_CASE("the envelope of a wave is its amplitude, and the richest sites are found", "[unit]") {
  const Chain ring{48, Quartic{-1.0 / 6}, contact, Ends::periodic};
  const PlaneWave wave = plane_wave(ring.well, contact, pi / 4, 1e-3);
  const Envelope e = envelope(ring, on_ring(wave, 48), {0, 48});
  check_close(e.omega, wave.omega, 0, 1e-4);
  for (double x : e.amplitude) check_close(x, 1e-3 * wave.omega, 0, 1e-2);
  std::vector<double> density(200, 1e-3);
  density[130] = 1;
  density[20] = 0.9;
  const std::size_t at = richest(density);
  CHECK(at >= 110);
  CHECK(at <= 150);
  CHECK(std::size_t(energy_centre(density, at, 20)) >= 127);
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

TEST_CASE("the wave trains of soft and linear wells are no breathers", "[property]") {
  // A front has a crest, which a broad sech may fit; but it does not keep the energy.
  const Watched made = watched(1, 1.87, 1500, {291, 724});
  const Traits seen = traits(made.samples);
  CHECK(made.shown.size() == 2);
  CHECK((seen.share_exponent > -1.0 / 6 && seen.steadiness > 0.5));
  for (const Snapshot& shot : made.shown) {
    CHECK((shot.sech.residual < 0.1 && shot.sech.width < 10));
    CHECK(std::abs(shot.sech.centre - shot.centre) < 10);
  }
  for (double s : {0.0, -1.0 / 6})
    CHECK(traits(watched(s, 1.87, 1500).samples).share_exponent < -1.0 / 6);
}

TEST_CASE("the NLS ansatz is as good as the article says, with the right coefficient",
          "[property]") {
  // The soliton of Eq. (38) by its displacements; velocities by differences in time
  struct Error {
    double l2 = 0, largest = 0;
  };
  const auto c = coefficients(pi / 4, d, -1.0 / 6);
  const auto error = [&](double beta, double eps) {
    const std::size_t sites = 8 * std::size_t(std::ceil(3.5 / eps));
    const auto y = [&](std::size_t i, double t) {
      const double n = double(i) - double(sites) / 2,
                   turned = c.omega * t - eps * eps * c.curvature * t / 2,
                   x = eps * std::remainder(n - c.group_velocity * t, double(sites));
      return 2 * eps * std::sqrt(-c.curvature * c.omega / beta) / std::cosh(x) *
             std::cos(pi / 4 * n - turned);
    };
    const auto v = [&](std::size_t i, double t) {
      const double h = 1e-3;
      return (8 * (y(i, t + h) - y(i, t - h)) - y(i, t + 2 * h) + y(i, t - 2 * h)) / (12 * h);
    };
    const Chain ring{sites, Quartic{-1.0 / 6}, contact, Ends::periodic};
    State<double> state(sites);
    for (std::size_t i = 0; i < sites; ++i) state.y[i] = y(i, 0), state.v[i] = v(i, 0);
    Error worst;
    evolve(Splitting{blanes_moan_6(), 0.4}, ring, state, 1 / (eps * eps), 1 / (100 * eps * eps),
           [&](const State<double>& now) {
             double squares = 0;
             for (std::size_t i = 0; i < sites; ++i)
               for (double off : {now.y[i] - y(i, now.t), now.v[i] - v(i, now.t)}) {
                 squares += off * off;
                 worst.largest = std::max(worst.largest, std::abs(off));
               }
             worst.l2 = std::max(worst.l2, std::sqrt(squares));
           });
    return worst;
  };
  const auto order = [&](double Error::*of, double beta) {
    return std::log2(error(beta, 0.05).*of / (error(beta, 0.025).*of));
  };
  check_close(order(&Error::l2, c.beta), 1.5, 0.1);
  check_close(order(&Error::largest, c.beta), 2, 0.2);
  CHECK(order(&Error::l2, 1.5 * c.beta) < 1);
}

TEST_CASE("a tail on one side is not one on both", "[unit]") {
  const auto packet = [](double behind, double ahead) {
    Snapshot shot{State<double>(301), 150, {1, std::vector<double>(301, behind)}, {0.5, 150, 5, 0}};
    std::fill(shot.envelope.amplitude.begin() + 150, shot.envelope.amplitude.end(), ahead);
    return shot;
  };
  check_close(tail_amplitude(packet(0.01, 0.02), -1), 0.02, 1e-15);
  check_close(tail_amplitude(packet(0.01, 0.02), 1), 0.04, 1e-15);
}

namespace {

/// One pulse until `split`, then two; the energy gathers at t = 1000.
RingPair drawn(double split, bool apart = true) {
  RingPair pair;
  pair.gathered = {1000, 50};
  for (double t = 50; t <= 5000; t += 50) {
    const RingSample at{t, 6, t >= 1000 && t < split ? 0.1 : 0.9,
                        t >= 1000 && (apart || t < split)};
    pair.samples.push_back({at, at});
  }
  return pair;
}

}  // namespace

TEST_CASE("a pulse that splits was one before", "[unit]") {
  const double round = 340;
  const PulseSplits splits = pulse_splits(drawn(3000), round);
  CHECK((splits.one_pulse_for.value == 1950 && splits.splits_at.value == 3000));
  CHECK(splits.apart_at.value == 3000);
  CHECK(std::isnan(pulse_splits(drawn(6000), round).splits_at.value));  // never
  CHECK(std::isnan(pulse_splits(drawn(1200), round).splits_at.value));  // two nearly from the start
  const PulseSplits spreads = pulse_splits(drawn(3000, false), round);
  CHECK(
      (spreads.splits_at.value == 3000 && std::isnan(spreads.apart_at.value)));  // and that is all
  // On the ring two equal heaps of energy are two packets, one heap is one
  const Chain ring = ring_of(-1.0 / 6);
  State<double> state(200);
  state.v[195] = 1;
  CHECK(ring_sample(ring, state).second == 0);
  state.v[95] = 1;
  check_close(ring_sample(ring, state).second, 1, 1e-15);
  CHECK(ring_sample(ring, state).gathered);
  // And so many unstable wavenumbers fit on it, in hard and in linear wells
  const auto unstable = [](double s) {
    int count = 0;
    for (int k = 1; k < 100; ++k) count += coefficients(pi * k / 100, d, s).phi > 0;
    return count;
  };
  CHECK(unstable(1) == 26);
  CHECK(unstable(0) == 37);
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
    WatchedRing m{State<double>(200), std::vector<double>(200, 0.01)};
    m.density[20] += peak;
    for (double t = 0; t <= 60; ++t) {
      m.t.push_back(t);
      m.centre.push_back(20 + speed * t + 0.3 * std::sin(t));
    }
    return m;
  };
  const Formed made = formed(ring(0, 0.3), ring(1, 0.3)), flat = formed(ring(0, 0), ring(0, 0));
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

TEST_CASE("a linear chain sends out a train", "[property]") {
  // Weak blows see neither the well's nor the contact's nonlinearity: no breather for any s.
  for (double s : {-1.0 / 6, 1.0}) {
    const Watched flight = watched(s, 1e-3, 600);
    const Traits t = traits(flight.samples);
    CHECK((t.share_exponent < -1.0 / 6 && t.boundary_exponent < -0.5));
    CHECK(flight.last_open == 0);
    CHECK(flight.far_end == 0);
    check_close(t.speed,
                phonon(inflection(contact_series(d).v1), contact_series(d).v1).group_velocity, 0,
                0.02);
  }
}

TEST_CASE("what section 4 rests on", "[published]") {
  const Table facts = read(std::filesystem::path(DATA_DIR) / "sec4_precompression_mi/facts.ecsv");
  const auto value = [&](const std::string& name) {
    return facts.numbers("value")[row_of(facts, name)];
  };
  CHECK(value("mi_state_error") < 1e-4);
  CHECK(value("agree_s_minus_1_6") > 6619);
  CHECK(value("mi_run_control_peak_over_mean") < 2);
  CHECK(facts.numbers("error")[row_of(facts, "packet_exponent_s_1")] < 1e-3);
}

TEST_CASE("splittings have their full order where no contact opens", "[published]") {
  const Table facts = read(std::filesystem::path(DATA_DIR) / "secA_integrators/facts.ecsv");
  const auto value = facts.numbers("value");
  check_close(value[row_of(facts, "order_closed_blanes_moan_4")], 4, 0.05);
  check_close(value[row_of(facts, "order_closed_blanes_moan_6")], 6, 0.05);
}

namespace {

std::vector<double> bumps(std::size_t sites) {
  std::vector<double> e(sites);
  for (std::size_t n = 0; n < sites; ++n)
    e[n] = 0.2 + std::sin(0.7 * double(n)) * 0.1 + std::exp(-std::pow((double(n) - 70.3) / 9, 2));
  return e;
}

}  // namespace

TEST_CASE("a packet by its densities, site by site", "[unit]") {
  const std::vector<double> e = bumps(150);
  const auto sum = [&](int from, int to) {
    double all = 0;
    for (int n = from; n <= to; ++n) all += e[std::size_t(n)];
    return all;
  };
  int peak = 0;
  for (int n = 20; n < 130; ++n)
    if (sum(n - 20, n + 20) > sum(std::max(peak, 20) - 20, std::max(peak, 20) + 20)) peak = n;
  const int from = peak - 20, to = peak + 20;
  double moment = 0, squares = 0, all_squares = 0;
  for (int n = from; n <= to; ++n) {
    moment += (n + 1) * e[std::size_t(n)];
    squares += std::pow(e[std::size_t(n)], 2);
  }
  for (double x : e) all_squares += x * x;
  const double all = sum(0, 149), inside = sum(from, to);
  const PacketSample at = packet_sample(7, e);
  CHECK(at.t == 7);
  check_close(at.centre, moment / inside, 1e-11);
  check_close(at.share, inside / all, 1e-13);
  check_close(at.boundary, sum(0, 4) / all, 1e-13);
  check_close(at.participation, all * all / all_squares, 1e-10);
  check_close(at.packet_sites, inside * inside / squares, 1e-10);
  CHECK(compressed_half_width == 20);
  CHECK(envelope_half_width == 10);
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
  for (const Case& c : {Case{30.4, 4, 8, {20, 41}},
                        {31.7, 3, 8, {18, 44}},
                        {29.6, 7, 2, {20, 41}},
                        {30.2, 2, 12, {20, 41}},
                        {33, 5, 1.5, {20, 41}},
                        {30, 9, 3, {25, 50}},
                        {27.3, 4, 20, {20, 41}}}) {
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

TEST_CASE("the ring of figure 26 starts from the phonon of Eq. (39), and arrives", "[published]") {
  const auto folder = std::filesystem::path(DATA_DIR) / "sec4_precompression_mi";
  const Table ring = read(folder / "modulated_ring.ecsv"), facts = read(folder / "facts.ecsv");
  const auto shown = ring.numbers("y"), start = ring.numbers("y_start");
  REQUIRE(start.size() == 200);
  const double v1 = 1.5 * std::sqrt(0.5), c = std::cos(pi / 4), s = std::sin(pi / 4);
  const double omega = std::sqrt(1 + 2 * v1 * (1 - c));
  check_close(facts.numbers("value")[row_of(facts, "splitting_round")], 200 * omega / (v1 * s),
              1e-10);
  State<double> state(200);
  for (std::size_t i = 0; i < 200; ++i) {
    const double n = double(i + 1), factor = 0.15 * (1 + 0.01 * std::cos(pi * n / 100));
    state.y[i] = factor * std::sin(pi / 4 * n);
    state.v[i] = -omega * factor * std::cos(pi / 4 * n);
    check_close(start[i], state.y[i], 1e-14);
  }
  // Another splitting and another step come to the same state
  evolve(Splitting{blanes_moan_6(), 0.1}, ring_of(-1.0 / 6), state, 6619, 6619);
  for (std::size_t i = 0; i < 200; ++i) check_close(shown[i], state.y[i], 1e-5);
}

namespace {

const double rest = std::pow(d, 1.5);

/// The force of a compressed contact of relative displacement r, Eq. (33), and its derivative.
double bond(double r) {
  return r < d ? rest - std::pow(d - r, 1.5) : rest;
}

double bend(double r) {
  return r < d ? 1.5 * std::sqrt(d - r) : 0;
}

/// Positions, then velocities, on a ring of wells of anharmonicity s; classical Runge-Kutta.
using Flow = std::function<std::vector<double>(const std::vector<double>&)>;

std::vector<double> stepped(const std::vector<double>& z, double h, const Flow& rate) {
  const auto at = [&](double by, const std::vector<double>& k) {
    std::vector<double> x(z);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += by * k[i];
    return x;
  };
  const auto a = rate(z), b = rate(at(h / 2, a)), c = rate(at(h / 2, b)), e = rate(at(h, c));
  std::vector<double> x(z);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + e[i]);
  return x;
}

/// The rates of a ring and of `columns` small disturbances of it, one after the other in z.
Flow ring_rates(std::size_t n, double s, std::size_t columns) {
  return [=](const std::vector<double>& z) {
    std::vector<double> out(z.size());
    for (std::size_t i = 0; i < n; ++i) {
      const double y = z[i], right = z[(i + 1) % n] - y, left = y - z[(i + n - 1) % n];
      out[i] = z[n + i];
      out[n + i] = -y - s * y * y * y + bond(right) - bond(left);
      for (std::size_t c = 1; c <= columns; ++c) {
        const double *u = &z[2 * n * c], x = u[i];
        out[2 * n * c + i] = u[n + i];
        out[2 * n * c + n + i] = -(1 + 3 * s * y * y) * x + bend(right) * (u[(i + 1) % n] - x) -
                                 bend(left) * (x - u[(i + n - 1) % n]);
      }
    }
    return out;
  };
}

std::vector<double> flat(const State<double>& z) {
  std::vector<double> x(z.y);
  x.insert(x.end(), z.v.begin(), z.v.end());
  return x;
}

/// The anharmonicity at which beta vanishes.
double without_beta(double q, double compression) {
  const double x = 1 - std::cos(q), v1 = 1.5 * std::sqrt(compression), sine = std::sin(q);
  return -1.5 * sine * sine * x * x / compression / (4 * v1 * x * x + 3) +
         x * x / (4 * std::pow(compression, 1.5));
}

}  // namespace

TEST_CASE("what the band and the NLS equation say of a phonon, by a second formula", "[unit]") {
  for (double D : {0.5, 2.0})
    for (double q : {0.4, pi / 2, 2.7})
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
  CHECK(edges_of_instability(0.5, 4.0).back() == pi);
}

TEST_CASE("unstable are the wavenumbers at which Phi is positive", "[property]") {
  Random random(3);
  for (int k = 0; k < 3000; ++k) {
    const double D = std::pow(10, random.uniform(-6, 2)),
                 s = std::copysign(std::pow(10, random.uniform(-12, 2)), random.uniform(-1, 1));
    const auto edges = edges_of_instability(D, s);
    for (int j = 0; j < 20; ++j) {
      const double q = random.uniform(0, pi), phi = coefficients(q, D, s).phi;
      bool inside = false, beside = std::abs(phi) < 1e-9 * std::abs(s);
      for (double edge : edges) {
        inside = inside != (q > edge);
        beside = beside || std::abs(q - edge) < 1e-9;
      }
      if (!beside && inside != (phi > 0)) FAIL_CHECK("d = " << D << ", s = " << s << ", q = " << q);
    }
  }
}

TEST_CASE("an exact wave obeys its equation between the points where it was imposed", "[unit]") {
  const PlaneWave three{0.7, 1.3, {0.2, -0.05, 0.03}};
  check_close(three.profile(0.4), 0.2 * std::sin(0.4) - 0.05 * std::sin(0.8) + 0.03 * std::sin(1.2),
              1e-15);
  check_close(three.slope(0.4), 0.2 * std::cos(0.4) - 0.1 * std::cos(0.8) + 0.09 * std::cos(1.2),
              1e-15);
  check_close(three.relative(0.4), three.profile(1.1) - three.profile(0.4), 1e-15);
  for (double q : {0.6, 1.9})
    for (double s : {-0.2, 1.0}) {
      const PlaneWave wave = plane_wave(Quartic{s}, CompressedHertz{d}, q, 0.14, 24);
      CHECK(wave.b.size() == 24);
      CHECK(wave.b[0] == 0.14);
      const auto phi = [&](double x) {
        double sum = 0;
        for (int k = 1; k <= 24; ++k) sum += wave.b[std::size_t(k - 1)] * std::sin(k * x);
        return sum;
      };
      for (double x : {0.1, 1.7, 3.3, 5.9}) {
        double second = 0;
        for (int k = 1; k <= 24; ++k)
          second -= k * k * wave.b[std::size_t(k - 1)] * std::sin(k * x);
        const double y = phi(x);
        check_close(wave.omega * wave.omega * second + y + s * y * y * y,
                    bond(phi(x + q) - y) - bond(y - phi(x - q)), 1e-11);
      }
      const State<double> ring = on_ring(wave, 3);
      check_close(ring.y[1], phi(2 * q), 1e-15);
      check_close(ring.v[2], -wave.omega * (phi(3 * q + 1e-5) - phi(3 * q - 1e-5)) / 2e-5, 1e-9);
    }
  CHECK(plane_wave(Quartic{}, CompressedHertz{d}, 1, 0.1).b.size() == 12);
  // The largest wave is the one that opens a contact, wherever in the period that is
  for (double q : {0.2, 2.0}) {
    double low = 0, high = 4, top = 0;
    for (int k = 0; k < 12; ++k) {
      const double a = (low + high) / 2;
      const auto make = [&] { plane_wave(Quartic{}, CompressedHertz{d}, q, a, 8); };
      (refusal<std::runtime_error>(make).empty() ? low : high) = a;
    }
    const PlaneWave wave = plane_wave(Quartic{}, CompressedHertz{d}, q, low, 8);
    for (double x = 0; x < 2 * pi; x += 0.01) top = std::max(top, wave.relative(x));
    CAPTURE(q, low);
    check_close(top, d, 0, 2e-3);
  }
}

TEST_CASE("the growth rate is that of a disturbance that is followed for a period", "[unit]") {
  // Backscattering, on four sites and, beside it, modulations that grow with the NLS equation's help, on eight
  const auto compare_on = [](std::size_t n, double s, double a, int waves) {
    const PlaneWave wave =
        plane_wave(Quartic{s}, CompressedHertz{d}, 2 * pi * waves / double(n), a);
    std::vector<double> z = flat(on_ring(wave, n));
    z.resize(2 * n * (2 * n + 1), 0.0);
    for (std::size_t c = 0; c < 2 * n; ++c) z[2 * n * (c + 1) + c] = 1;
    const double period = 2 * pi / wave.omega;
    for (int k = 0; k < 200; ++k) z = stepped(z, period / 200, ring_rates(n, s, 2 * n));
    const auto size = Eigen::Index(2 * n);
    const Eigen::Map<const Eigen::MatrixXd> map(z.data() + size, size, size);
    double most = 0;
    for (const std::complex<double>& value : eigenvalues_of(Matrix<double>(map)))
      most = std::max(most, std::abs(value));
    // Modulations that differ by a wavenumber of the wave are the same
    double best = 0;
    for (int k = 0; k < waves; ++k)
      best = std::max(best, growth_rate(wave, 2 * pi * k / double(n)));
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
