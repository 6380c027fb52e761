#include "sec4/nls_checks.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <tuple>
#include <vector>

#include "lattice/integrators/integrate.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "lattice/numerics/parallel.hpp"
#include "sec4/exact_waves.hpp"
#include "sec4/instability.hpp"

namespace lattice {

using std::numbers::pi;

static Coefficients<double> nls_of(const Carrier& wave) {
  return coefficients(wave.q, wave.d, wave.s);
}
static Chain ring_of(const Carrier& wave, std::size_t sites) {
  return {sites, Quartic{wave.s}, CompressedHertz{wave.d}, Ends::periodic};
}
static Splitting splitting(double step) {
  return {blanes_moan_6_14(), step};
}

// Growth rates of the exact wave and of the NLS equation
static double growth(const Carrier& wave, double modulation, std::size_t harmonics = 12) {
  const Chain chain = ring_of(wave, 0);
  return growth_rate(plane_wave(chain.well, chain.contact, wave.q, wave.amplitude, harmonics),
                     modulation);
}
static double fastest_modulation(const Carrier& wave) {
  const auto nls = nls_of(wave);
  return std::sqrt(std::abs(nls.h() * wave.amplitude * wave.amplitude / (2 * nls.curvature)));
}
static double growth_by_nls(const Carrier& wave) {
  return std::abs(nls_of(wave).h()) * wave.amplitude * wave.amplitude / 4;
}

// The largest growth of a slower, an equal and a faster modulation than the fastest one
static double slow_growth(const Carrier& wave, std::size_t harmonics) {
  double largest = 0;
  for (double m : {0.5, 1.0, 1.5})
    largest = std::max(largest, growth(wave, m * fastest_modulation(wave), harmonics));
  return largest;
}

// At the edges of the band, beside the thresholds of s
static void report_edges(Report& report, double d) {
  Table& waves = report.table("edge_waves");
  const double threshold = -16 * contact_series(d).v3;
  const char* harmonics =
      "6 and 12 harmonics, against the largest: stable waves have only rounding";
  for (const auto& [q, s, side] : {std::tuple{0.0, -0.05, "unstable"},
                                   {0.0, 0.05, "stable"},
                                   {pi, threshold + 0.05, "unstable"},
                                   {pi, threshold - 0.05, "stable"}}) {
    const Carrier wave{s, q, d, 0.005};
    const double six = slow_growth(wave, 6), twelve = slow_growth(wave, 12),
                 by_nls = growth_by_nls(wave);
    waves.add({{"q", "wavenumber", q, "1/site"},
               {"s", "anharmonicity of the well", s},
               {"edge", "zero or pi", q > 0 ? "pi" : "zero"},
               {"side", "of the threshold of s", side},
               {"growth", "largest growth rate of slow modulations of the exact wave",
                compare(six, twelve), "", harmonics},
               {"growth_over_nls", "the same over that of the NLS equation if it is focusing",
                compare(six / by_nls, twelve / by_nls), "", harmonics}});
  }
}

// The shift of an exact wave's frequency, from an amplitude that falls with the compression
static Estimate beta_from_frequency(double q, double d, double s) {
  const double omega = coefficients(q, d, s).omega;
  return at_zero_amplitude(0.04 * std::min(1.0, 2 * d), [&](double size) {
    const double shifted = plane_wave(Quartic{s}, CompressedHertz{d}, q, size).omega;
    return (shifted - omega) * (shifted + omega) / (size * size / 2);
  });
}

static Estimate phi_from_growth(double q, double d, double s) {
  return at_zero_amplitude(0.03, [&](double size) {
    const Carrier wave{s, q, d, size};
    const auto nls = nls_of(wave);
    return growth(wave, fastest_modulation(wave)) / (size * size / 4) * nls.omega *
           std::abs(nls.omega_2);
  });
}

// Where the growth can be measured
static bool grows_slowly(double q, double d, double s) {
  return coefficients(q, d, s).phi > 0 && std::abs(q - pi / 2) >= 1e-9 &&
         std::abs(q - inflection(contact_series(d).v1)) > 0.05;
}

// Formula and measurement beside each other
static void report_coefficient(Report& report, double chosen, std::span<const double> wells) {
  struct Point {
    double d, s, q;
  };
  std::vector<Point> points;
  for (double d : {chosen, 0.05, 0.2, 1.0, 4.0})
    for (double s : wells) {
      const int count = d == chosen && !report.quick ? 24 : 8;
      for (int k = 1; k < count; ++k) points.push_back({d, s, pi * k / count});
    }
  const auto of_formula = [](auto of, const Point& at) {
    return in_two_precisions([of](auto x, auto y, auto z) { return of(coefficients(x, y, z)); },
                             at.q, at.d, at.s);
  };
  // One row for each wavenumber
  const char* how = "difference of two precisions, against the largest";
  report.table("measured_coefficient").fill(points, [&](const Point& at) {
    const bool slow = at.d == chosen && grows_slowly(at.q, at.d, at.s);
    return Row{{"d", "compression of the contacts", at.d},
               {"s", "anharmonicity of the well", at.s},
               {"q", "wavenumber", at.q, "1/site"},
               {"beta", "NLS coefficient from its formula",
                of_formula([](const auto& nls) { return nls.beta; }, at), "", how},
               {"measured_beta", "NLS coefficient from the frequency of exact waves",
                beta_from_frequency(at.q, at.d, at.s), "",
                "from two pairs of amplitudes, against the largest"},
               {"phi", "modulation coefficient from its formula",
                of_formula([](const auto& nls) { return nls.phi; }, at), "", how},
               {"slow", "1 where the fastest modulation is slow, at d = 1/2", slow},
               {"growth_phi", "modulation coefficient from the measured growth; nan unless slow",
                slow ? phi_from_growth(at.q, at.d, at.s) : undefined, "",
                "from two pairs of amplitudes; nan where growth_phi is"}};
  });
  report.table("umklapp").add(
      {{"s", "anharmonicity of the well", 1.0},
       {"growth_over_nls", "at q = pi/2, over the growth of slow modulations",
        at_zero_amplitude(0.04,
                          [chosen](double size) {
                            const Carrier wave{1, pi / 2, chosen, size};
                            return growth(wave, pi) / growth_by_nls(wave);
                          }),
        "", "from two pairs of amplitudes"}});
}

// The moving breather of the NLS equation, Eq. (38)
static State<double> soliton(const Carrier& wave, double eps, std::size_t sites, double t) {
  const auto nls = nls_of(wave);
  const double height = 2 * eps * std::sqrt(-nls.curvature / nls.h()), speed = nls.group_velocity;
  const double frequency = nls.omega - eps * eps * nls.curvature / 2;
  State<double> state(sites);
  for (std::size_t i = 0; i < sites; ++i) {
    const double n = double(i) - double(sites) / 2;
    const double way = n - speed * t,
                 z = eps * (way - double(sites) * std::round(way / double(sites)));
    const double decay = std::exp(-std::abs(z)), square = decay * decay;
    const double theta = wave.q * n - frequency * t, sech = height * 2 * decay / (1 + square);
    state.y[i] = sech * std::cos(theta);
    state.v[i] =
        sech * (frequency * std::sin(theta) +
                speed * eps * std::copysign((1 - square) / (1 + square), z) * std::cos(theta));
  }
  return state;
}

struct AnsatzError {
  double l2 = 0, largest = 0, l2_y = 0;  // of y and v together, of any of them, of y alone
};
// Its distance from the motion of the ring
static AnsatzError ansatz_error(const Carrier& wave, double eps, double step, int samples) {
  const double time = 1 / (eps * eps);
  // A whole number of wavelengths (of 8 sites, or three in 10); on the far side sech z < 2e-6
  const std::size_t period = wave.s > 0 ? 10 : 8,
                    sites = period * std::size_t(std::ceil(28 / (eps * double(period))));
  const Chain chain = ring_of(wave, sites);
  State<double> state = soliton(wave, eps, sites, 0);
  AnsatzError error;
  const auto look = [&](const State<double>& now) {
    const State<double> ansatz = soliton(wave, eps, sites, now.t);
    double yy = 0, vv = 0;
    for (std::size_t i = 0; i < sites; ++i) {
      const double y = now.y[i] - ansatz.y[i], v = now.v[i] - ansatz.v[i];
      yy += y * y;
      vv += v * v;
      error.largest = std::max({error.largest, std::abs(y), std::abs(v)});
    }
    error.l2 = std::max(error.l2, std::sqrt(yy + vv));
    error.l2_y = std::max(error.l2_y, std::sqrt(yy));
  };
  evolve(splitting(step), chain, state, time, time / samples, look);
  return error;
}

static void report_ansatz(Report& report, double d) {
  const double smallest = report.quick ? 0.05 : 0.025;
  Table& table = report.table("ansatz_error");
  for (const Carrier& wave : {Carrier{-1.0 / 6, pi / 4, d, 0}, Carrier{1, 3 * pi / 5, d, 0}}) {
    std::vector<double> eps;
    for (double size = 0.2; size >= smallest; size /= 2) eps.push_back(size);
    std::vector<TwoRuns<AnsatzError>> runs(eps.size());
    parallel_for("error of the ansatz", eps.size(), [&](std::size_t k) {
      runs[k] = {ansatz_error(wave, eps[k], 0.8, 5000), ansatz_error(wave, eps[k], 0.4, 8000)};
    });
    // With the order of each error from one size to the next
    for (std::size_t k = 0; k < eps.size(); ++k) {
      const auto order = [&](auto of) {
        if (k == 0) return undefined;
        return order_between(eps[k - 1], runs[k - 1].of(of), eps[k], runs[k].of(of));
      };
      const auto l2 = [](const AnsatzError& error) { return error.l2; };
      const auto largest = [](const AnsatzError& error) { return error.largest; };
      const auto l2_y = [](const AnsatzError& error) { return error.l2_y; };
      const char* how = "from the errors of both; nan in the first row of a well";
      table.add(
          {{"s", "anharmonicity of the well", wave.s},
           {"q", "wavenumber of the carrier", wave.q, "1/site"},
           {"eps", "amplitude scale epsilon of the ansatz", eps[k]},
           {"l2", "error in l2, of displacements and velocities together", runs[k].of(l2)},
           {"largest", "largest error of any displacement or velocity", runs[k].of(largest)},
           {"l2_y", "error in l2 of the displacements alone", runs[k].of(l2_y)},
           {"order_l2", "power of eps with which l2 falls from the row before", order(l2), "", how},
           {"order_largest", "the same of the largest error", order(largest), "", how},
           {"order_l2_y", "the same of l2_y", order(l2_y), "", how}});
    }
  }
}

void report_nls_checks(Report& report, double d, std::span<const double> wells) {
  report_edges(report, d);
  report_coefficient(report, d, wells);
  report_ansatz(report, d);
}

}  // namespace lattice
