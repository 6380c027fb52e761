// The criteria of section 4.1, slow growth, waves on rings and the soliton, by second formulas.

#include <algorithm>

#include "check.hpp"
#include "sec4/instability.hpp"
#include "sec4/soliton.hpp"
#include "sec4/wave_on_ring.hpp"

namespace rings_again {

using namespace lattice;
using std::numbers::pi;

namespace {

const double d = 0.5;

/// The fastest growth of three modulations about the NLS equation's, and that over its largest rate.
double fastest(const PhaseOfWave& at, double a, std::size_t harmonics,
               std::size_t* which = nullptr) {
  const double scale =
      a * std::sqrt(std::abs(at.nls().beta / at.nls().omega / at.nls().curvature) / 2);
  const PlaneWave wave = plane_wave(Quartic{at.s}, CompressedHertz{at.d}, at.q, a, harmonics);
  std::vector<double> rates;
  for (double part : {0.5, 1.0, 1.5})
    rates.push_back(growth_rate(wave, Quartic{at.s}, CompressedHertz{at.d}, part * scale));
  const auto most = std::max_element(rates.begin(), rates.end());
  if (which) *which = std::size_t(most - rates.begin());
  return *most;
}
double over_nls(const PhaseOfWave& at, double a, std::size_t harmonics) {
  return fastest(at, a, harmonics) * 4 / (a * a * std::abs(at.nls().beta / at.nls().omega));
}

/// Whether every condition holds.
bool all(const Criterion& c) {
  return holds(c);
}

}  // namespace

TEST_CASE("of three slow modulations the fastest counts", "[unit]") {
  // The scattered wave may help a slower or a faster one than that of the NLS equation
  const PhaseOfWave phases[] = {{pi / 2, d, 1}, {pi / 4, d, -1.0 / 6}, {1.4, d, 1}};
  for (std::size_t k : {0, 1, 2}) {
    std::size_t which = 9;
    check_close(slow_growth(phases[k], 0.1, 6), fastest(phases[k], 0.1, 6, &which), 1e-13);
    CHECK(which == k);
  }
}

TEST_CASE("the criteria of section 4.1 at both sides of their bounds", "[unit][criteria]") {
  const auto known = [](double x) { return Estimate{x, 1e-9}; };
  CHECK(all(confirmed_beta(known(0.9e-3), known(0.9e-3))));
  CHECK_FALSE(all(confirmed_beta(known(1.1e-3), known(0))));
  CHECK_FALSE(all(confirmed_beta(known(0), known(1.1e-3))));
  using Three = std::array<double, 3>;
  const auto small = [](Three coarse, Three fine) {
    return all(small_in_linear_wells(coarse, fine));
  };
  for (const Three& x : {Three{1, 0.099, 2}, {2, 0.099, 1}}) CHECK(small(x, x));
  for (const Three& x : {Three{1, 0.101, 2}, {2, 0.101, 1}, {1, 0, 2}, {1, -0.01, 2}})
    CHECK_FALSE(small(x, x));
  const Criterion read = small_in_linear_wells({4, 0.5, 3}, {2, 0.4, 5});
  check_close(read.at(0).value.value, 0.4, 0);
  check_close(read.at(0).value.error, 0.1, 1e-15);
  check_close(read.at(1).value.value, 0.2, 1e-15);
  CHECK_FALSE(small({1, 0.01, 2}, {1, 0.099, 2}));  // not known well enough
  // The place is where the condition holds and where every well says: here beta vanishes instead, at 1.2
  const double D = 0.01, v1 = 1.5 * std::sqrt(D), x = 1 - std::cos(1.2), sine = std::sin(1.2);
  const double s =
      -1.5 * sine * sine * x * x / D / (4 * v1 * x * x + 3) + x * x / (4 * std::pow(D, 1.5));
  const double inflected = std::acos(1 - 2 / (1 + std::sqrt(1 + 4 * v1)));
  const Criterion here = sign_changes_at(1.2, D, {s, s, s}),
                  there = sign_changes_at(inflected, D, {s, s, s});
  check_close(here.at(0).value.value, std::abs(std::cos(1.2) / (v1 * x * x) - 1), 1e-12);
  check_close(there.at(0).value.value, 1 - 1.2 / inflected, 1e-12);
  CHECK_FALSE(all(here));
  CHECK_FALSE(all(there));
  // A threshold that is wrong by 0.06, so that a well on its stable side is beyond the right one
  const double threshold = std::pow(d, -1.5);
  const Criterion opens = opens_at_edges(d, threshold + 0.06);
  check_close(opens.at(0).value.value, 0.09, 1e-12);
  const PhaseOfWave left{0, d, -0.05}, right{pi, d, threshold + 0.11};
  Estimate worst{};
  for (const PhaseOfWave& at : {left, right}) {
    const double six = std::abs(over_nls(at, 0.005, 6) - 1),
                 twelve = std::abs(over_nls(at, 0.005, 12) - 1);
    worst = twelve + std::abs(six - twelve) > worst.value + worst.error
                ? Estimate{twelve, std::abs(six - twelve)}
                : worst;
  }
  check_close(opens.at(1).value.value, worst.value, 1e-7);
  check_close(opens.at(1).value.error, worst.error, 1e-6);
  CHECK(opens.at(1).limit == 0.02);
  const double past = fastest({pi, d, threshold + 0.01}, 0.005, 12);
  check_close(opens.at(2).value.value, past, 1e-10);
  CHECK(past > 1e-8);
}

TEST_CASE("what is read from a ring, by plain sums", "[unit]") {
  State<double> state(3);
  state.y = {0.3, -0.1, 0.4, 9};
  state.v = {0.2, 0.5, -0.7, 9};
  state.y.pop_back(), state.v.pop_back();  // what lies behind the last site is none of its business
  CHECK((PlaneWave{}.q == 0 && PlaneWave{}.omega == 0));
  double re = 0, im = 0;
  for (int n = 1; n <= 3; ++n) {
    const double y = state.y[std::size_t(n - 1)], w = state.v[std::size_t(n - 1)] / 1.7;
    re += y * std::cos(0.6 * n) + w * std::sin(0.6 * n);
    im += w * std::cos(0.6 * n) - y * std::sin(0.6 * n);
  }
  check_close(fourier(state, 0.6, 1.7).real(), re, 1e-15);
  check_close(fourier(state, 0.6, 1.7).imag(), im, 1e-15);
  const Chain four{4, Quartic{1}, CompressedHertz{d}, Ends::periodic};
  const PlaneWave wave = plane_wave(four.well, four.contact, pi / 2, 0.12);
  check_close(measured_frequency(Splitting{blanes_moan_6_14(), 0.05}, four, wave, 3), wave.omega,
              1e-9);
  // beta from the shift of the frequency at three amplitudes, with two steps
  const Chain ring{4, Quartic{1}, CompressedHertz{d}, Ends::periodic};
  const double omega = phonon(pi / 2, contact_series(d).v1).omega;
  const auto from = [&](double step, double a0 = 0.02) {
    const auto shift = [&](double a) {
      const PlaneWave wave = plane_wave(ring.well, ring.contact, pi / 2, a);
      const double w = measured_frequency(Splitting{blanes_moan_6_14(), step}, ring, wave, 60);
      return 2 * (w * w - omega * omega) / (a * a);
    };
    return (4 * shift(a0 / 2) - shift(a0)) / 3;
  };
  const Estimate beta = measured_beta(ring, pi / 2, omega);
  check_close(beta.value, from(0.1), 1e-9);
  const double limit = from(0.1);
  check_close(beta.error, std::abs(from(0.2) - limit) + std::abs(from(0.1, 0.04) - limit), 1e-10);
}

TEST_CASE("a modulation's growth is the slope of its side band", "[unit]") {
  const Chain ring{16, Quartic{1}, CompressedHertz{d}, Ends::periodic};
  const PlaneWave wave = plane_wave(ring.well, ring.contact, pi / 2, 0.12);
  const double Q = 2 * pi * 3 / 16;
  State<double> state = on_ring(wave, 16);
  for (int n = 1; n <= 16; ++n) {
    const std::size_t i = std::size_t(n - 1);
    state.y[i] *= 1 + 1e-6 * std::cos(Q * n);
    state.v[i] *= 1 + 1e-6 * std::cos(Q * n);
  }
  // The same run, from t = 8 to 16, and a line through the logarithms
  std::vector<double> t, log;
  const Splitting stepper{blanes_moan_6_14(), 0.1};
  evolve(stepper, ring, state, 16, 0.04, [&](const State<double>& now) {
    double re = 0, im = 0;
    for (int n = 1; n <= 16; ++n) {
      const double y = now.y[std::size_t(n - 1)], w = now.v[std::size_t(n - 1)] / wave.omega;
      re += y * std::cos((wave.q + Q) * n) + w * std::sin((wave.q + Q) * n);
      im += w * std::cos((wave.q + Q) * n) - y * std::sin((wave.q + Q) * n);
    }
    if (now.t > 7.99) t.push_back(now.t), log.push_back(std::log(std::hypot(re, im)));
  });
  CHECK(t.size() == 201);
  double tm = 0, xm = 0, tt = 0, tx = 0;
  for (std::size_t k = 0; k < t.size(); ++k)
    tm += t[k] / double(t.size()), xm += log[k] / double(t.size());
  for (std::size_t k = 0; k < t.size(); ++k)
    tt += (t[k] - tm) * (t[k] - tm), tx += (t[k] - tm) * (log[k] - xm);
  check_close(measured_growth(stepper, ring, wave, 3, 0.5), tx / tt, 1e-9);
}

TEST_CASE("the soliton is the ansatz, and its error that of a plain run", "[unit]") {
  const PhaseOfWave carrier{pi / 4, d, -1.0 / 6};
  CHECK(Soliton(carrier, 8, 0.05).sites == 560);
  CHECK(Soliton(carrier, 8, 0.06).sites == 472);
  const Soliton one(carrier, 8, 0.5);
  CHECK(one.sites == 56);
  const Chain ring = one.ring();
  CHECK(ring.sites == 56);
  CHECK(ring.ends == Ends::periodic);
  CHECK(ring.well.as<Quartic>().s == -1.0 / 6);
  CHECK(ring.contact.opening() == d);
  const auto c = coefficients(pi / 4, d, -1.0 / 6);
  const double height = std::sqrt(-c.curvature * c.omega / c.beta);
  const auto y_at = [&](double site, double t) {
    const double n = site - 28, turned = c.omega * t - 0.25 * c.curvature * t / 2;
    const double x = 0.5 * std::remainder(n - c.group_velocity * t, 56);
    return 2 * 0.5 * height / std::cosh(x) * std::cos(pi / 4 * n - turned);
  };
  for (double t : {0.0, 3.0, 61.0}) {
    const State<double> state = one.at(t);
    CHECK(state.t == t);
    for (std::size_t i : {3, 17, 30, 55}) {
      const double n = double(i), h = 1e-3;
      check_close(state.y[i], y_at(n, t), 1e-12);
      check_close(
          state.v[i],
          (8 * (y_at(n, t + h) - y_at(n, t - h)) - y_at(n, t + 2 * h) + y_at(n, t - 2 * h)) /
              (12 * h),
          1e-9);
    }
  }
  // Looked at five times on its way
  for (double tau : {0.4, 0.6, 1.0}) {
    State<double> state = one.at(0);
    double l2 = 0, largest = 0;
    evolve(Splitting{blanes_moan_6_14(), 0.02}, ring, state, 4 * tau, 4 * tau / 5,
           [&](const State<double>& now) {
             const State<double> other = one.at(now.t);
             double squares = 0;
             for (std::size_t i = 0; i < 56; ++i)
               for (double off : {now.y[i] - other.y[i], now.v[i] - other.v[i]}) {
                 squares += off * off;
                 largest = std::max(largest, std::abs(off));
               }
             l2 = std::max(l2, std::sqrt(squares));
           });
    const AnsatzError error = ansatz_error(one, tau, 0.02, 5);
    check_close(error.l2, l2, 1e-12);
    check_close(error.largest, largest, 1e-12);
  }
}

}  // namespace rings_again
