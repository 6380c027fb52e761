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

// The phase turns by -omega in a unit of time
static double frequency_in_run(const Chain& chain, const PlaneWave& wave, double step) {
  State<double> state = on_ring(wave, chain.sites);
  const double time = 2 * pi * 60 / wave.omega;
  double turned = 0, last = 0;
  evolve(splitting(step), chain, state, time, 0.5, [&](const State<double>& now) {
    const double phase = std::arg(fourier(now, wave.q, wave.omega));
    if (now.t > 0) turned += std::remainder(phase - last, 2 * pi);
    last = phase;
  });
  return -turned / time;
}

// From amplitudes of 0.04, 0.02 and 0.01
static Estimate beta_from_frequency(double q, double d, double s, double step) {
  const Chain chain = ring_of({s, q, d, 0}, 48);
  const double omega = coefficients(q, d, s).omega;
  return at_zero_amplitude(0.04, [&](double size) {
    const double shifted =
        frequency_in_run(chain, plane_wave(chain.well, chain.contact, q, size), step);
    return (shifted * shifted - omega * omega) / (size * size / 2);
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

static bool grows_slowly(double q, double d, double s) {
  return coefficients(q, d, s).phi > 0 && std::abs(q - pi / 2) >= 1e-9 &&
         std::abs(q - inflection(contact_series(d).v1)) > 0.05;
}

static constexpr const char* of_largest = "difference of two precisions, against the largest";

static void report_coefficient(Report& report, double d, std::span<const double> wells) {
  struct Point {
    double q, s;
    Estimate beta{}, phi = undefined;
  };
  std::vector<Point> points;
  for (double s : wells)
    for (int k = report.quick ? 4 : 1; k < 24; k += report.quick ? 4 : 1)
      points.push_back({pi * k / 24, s});
  parallel_for("nonlinear frequency", points.size(), [&](std::size_t i) {
    Point& at = points[i];
    at.beta =
        compare(beta_from_frequency(at.q, d, at.s, 0.2), beta_from_frequency(at.q, d, at.s, 0.1));
    if (grows_slowly(at.q, d, at.s)) at.phi = phi_from_growth(at.q, d, at.s);
  });

  // Both beside the formula
  Table& table = report.table("measured_coefficient");
  for (const auto& [q, s, beta, measured_phi] : points)
    table.add({{"q", "wavenumber", q, "1/site"},
               {"s", "anharmonicity of the well", s},
               {"beta", "NLS coefficient from its formula",
                in_two_precisions([](auto x, auto y, auto z) { return coefficients(x, y, z).beta; },
                                  q, d, s),
                "", of_largest},
               {"measured_beta", "NLS coefficient from the measured frequency shift", beta, "",
                "from two time steps and two pairs of amplitudes"},
               {"phi", "modulation coefficient from its formula",
                in_two_precisions([](auto x, auto y, auto z) { return coefficients(x, y, z).phi; },
                                  q, d, s),
                "", of_largest},
               {"slow", "1 where the fastest modulation is slow", grows_slowly(q, d, s)},
               {"growth_phi",
                "modulation coefficient from the measured growth; nan where stable or out of reach",
                measured_phi, "", "from two pairs of amplitudes; nan where growth_phi is"}});
  report.table("umklapp").add(
      {{"s", "anharmonicity of the well", 1.0},
       {"growth_over_nls", "at q = pi/2, over the growth of slow modulations",
        at_zero_amplitude(0.04,
                          [d](double size) {
                            const Carrier wave{1, pi / 2, d, size};
                            return growth(wave, pi) / growth_by_nls(wave);
                          }),
        "", "from two pairs of amplitudes"}});
}

// Each from its amplitude down to a sixteenth
void report_rate_error(Report& report, std::span<const Carrier> carriers) {
  Table& table = report.table("rate_error");
  for (Carrier wave : carriers)
    for (int k = 0; k < 5; ++k, wave.amplitude /= 2) {
      const auto relative = [&](std::size_t harmonics) {
        return std::abs(growth(wave, fastest_modulation(wave), harmonics) / growth_by_nls(wave) -
                        1);
      };
      table.add(
          {{"s", "anharmonicity of the well", wave.s},
           {"amplitude", "of the wave", wave.amplitude},
           {"error", "of the NLS rate of the fastest modulation, relative",
            compare(relative(8), relative(12)), "", "8 and 12 harmonics, against the largest"}});
    }
}

static State<double> soliton(const Carrier& wave, double eps, std::size_t sites, double t) {
  const auto nls = nls_of(wave);
  const double height = 2 * eps * std::sqrt(-nls.curvature / nls.h()), speed = nls.group_velocity;
  const double frequency = nls.omega - eps * eps * nls.curvature / 2;
  State<double> state(sites);
  for (std::size_t i = 0; i < sites; ++i) {
    const double n = double(i) - double(sites) / 2;
    const double z = eps * std::remainder(n - speed * t, double(sites));
    const double theta = wave.q * n - frequency * t, sech = height / std::cosh(z);
    state.y[i] = sech * std::cos(theta);
    state.v[i] =
        sech * (frequency * std::sin(theta) + speed * eps * std::tanh(z) * std::cos(theta));
  }
  return state;
}

struct AnsatzError {
  double l2 = 0, largest = 0, l2_y = 0;  // of y and v together, of any of them, of y alone
};
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
