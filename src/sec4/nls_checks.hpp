#pragma once
/**
# The band at other compressions, and the NLS equation against the chain

What the article says about the band holds for any compression, so it is evaluated from 1e-8 to 1e4. The formulas of
section 4.1 are tested by the frequency of exact waves (exact_waves.hpp), by the growth of their modulations at the
wavenumber that the formulas call the fastest one, and by runs from the soliton of Eq. (38). */

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>
#include <tuple>
#include <vector>

#include "lattice/integrators/integrate.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"
#include "sec4/exact_waves.hpp"
#include "sec4/phonons.hpp"

namespace lattice {
using namespace report;

using std::numbers::pi;

// Formulas in both precisions
template <class Of>
inline Estimate of_contact(Of of, double d) {
  return in_two_precisions([of](auto x) { return of(contact_series(x)); }, d);
}
template <class Of>
inline Estimate of_phonon(Of of, double q, double d, double s) {
  return in_two_precisions([of](auto x, auto y, auto z) { return of(coefficients(x, y, z)); }, q, d,
                           s);
}
inline Estimate phi(double q, double d, double s) {
  return of_phonon([](const auto& nls) { return nls.phi; }, q, d, s);
}
inline constexpr auto v_1 = [](const auto& v) { return v.v1; };

// How often the curvature changes its sign between 0 and pi, on a grid that is fine against the band
inline int sign_changes(double v1) {
  int changes = 0;
  for (int k = 1; k < 9999; ++k)
    if (phonon(pi * k / 10000, v1).omega_2 * phonon(pi * (k + 1) / 10000, v1).omega_2 < 0)
      ++changes;
  return changes;
}

// The inflection and the width of the band, and the sign of Phi on both sides
inline void report_compressions(Report& report, std::span<const double> wells) {
  Table &table = report.table("compressions"), &signs = report.table("inflection_signs");
  const auto width = [](const auto& v) { return std::sqrt(1 + 4 * v.v1) - 1; };
  double last = 0;
  for (double d : {1e-8, 1e-6, 1e-4, 0.01, 0.1, 0.5, 1.0, 10.0, 100.0, 1e4}) {
    const Estimate q_c = of_contact([](const auto& v) { return inflection(v.v1); }, d);
    Estimate order = undefined;
    if (last > 0) order = order_between(last, of_contact(width, last), d, of_contact(width, d));
    table.add({{"d", d},
               {"v1", of_contact(v_1, d)},
               {"q_c", q_c},
               {"sign_changes", sign_changes(contact_series(d).v1)},
               {"order", order}});
    last = d;
    for (double s : wells)
      signs.add({{"d", d},
                 {"s", s},
                 {"phi_below", phi(q_c.value * (1 - 1e-8), d, s)},
                 {"phi_above", phi(q_c.value * (1 + 1e-8), d, s)}});
  }
}

// On which side of the inflection waves are unstable
inline void report_sides(Report& report) {
  Table& table = report.table("sides");
  for (double d : {0.1, 0.5, 1.0, 4.0})
    for (double s : {-1.0 / 6, 0.0, 1.0, 4.0}) {
      const std::vector<double> edges = edges_of_instability(d, s);
      const double q_c = inflection(contact_series(d).v1);
      const auto is_inflection = [q_c](double q) { return std::abs(q - q_c) < 1e-9; };
      int below = 0, above = 0, beside = 0, reach = 0;
      for (std::size_t i = 0; i + 1 < edges.size(); i += 2) {
        const double from = edges[i], to = edges[i + 1];
        ++(is_inflection(to) || to < q_c ? below : above);
        beside += is_inflection(from) + is_inflection(to);
        reach += (from == 0) + (to == pi);
      }
      table.add({{"d", d},
                 {"s", s},
                 {"below", below},
                 {"above", above},
                 {"beside", beside},
                 {"reach", reach}});
    }
}

// The article's conditions at both edges of the band
inline void report_edges(Report& report, double chosen) {
  Table& edges = report.table("band_edges");
  for (double d : {0.01, 0.1, chosen, 1.0, 10.0})
    for (double part : {-1.0, -0.01, 0.0, 0.01, 0.5, 0.99, 1.01, 2.0})  // of the threshold at pi
      for (double q : {0.0, pi}) {
        const double s = part * -16 * contact_series(d).v3;
        edges.add({{"d", d},
                   {"q", q},
                   {"s", s},
                   {"v3", of_contact([](const auto& v) { return v.v3; }, d)},
                   {"phi", phi(q, d, s)}});
      }
}

// Phi of the chosen compression, and its largest value
inline void report_instability(Report& report, double d, std::span<const double> wells) {
  Table &table = report.table("instability"), &in_wells = report.table("inflection");
  for (double s : wells) {
    for (int k = 0; k <= 200; ++k)
      table.add({{"q", pi * k / 200}, {"s", s}, {"phi", phi(pi * k / 200, d, s)}});
    const auto largest = [&](int points) {
      double top = 0;
      for (int k = 0; k <= points; ++k)
        top = std::max(top, coefficients(pi * k / points, d, s).phi);
      return top;
    };
    in_wells.add({{"s", s}, {"largest_phi", with_error(largest(2000), largest(4000))}});
  }
}

/// Writes `contact_series` (of the compression `d`), `compressions`, `inflection_signs`, `sides`, `band_edges` and
/// `instability` and `inflection` (of `d`).
inline void report_band(Report& report, double d, std::span<const double> wells) {
  report.table("contact_series")
      .add({{"v1", of_contact(v_1, d)},
            {"v2", of_contact([](const auto& v) { return v.v2; }, d)},
            {"v3", of_contact([](const auto& v) { return v.v3; }, d)}});
  report_compressions(report, wells);
  report_sides(report);
  report_edges(report, d);
  report_instability(report, d, wells);
}

// The exact wave of amplitude a
struct Carrier {
  double s, q, d, a;

  Coefficients<double> nls() const { return coefficients(q, d, s); }
  PlaneWave exact(std::size_t harmonics = 12) const {
    return plane_wave(Quartic{s}, CompressedHertz{d}, q, a, harmonics);
  }
  double fastest() const { return std::sqrt(std::abs(nls().h() * a * a / (2 * nls().curvature))); }
  double growth_by_nls() const { return std::abs(nls().h()) * a * a / 4; }
};

// The largest growth of a slower, an equal and a faster modulation than the fastest one
inline double slow_growth(const Carrier& wave, std::size_t harmonics) {
  double largest = 0;
  for (double m : {0.5, 1.0, 1.5})
    largest = std::max(largest, growth_rate(wave.exact(harmonics), m * wave.fastest()));
  return largest;
}

// At the edges of the band, beside the thresholds of s
inline void report_edge_waves(Report& report, double d) {
  Table& waves = report.table("edge_waves");
  const double threshold = -16 * contact_series(d).v3;
  for (const auto& [q, s, side] : {std::tuple{0.0, -0.05, "unstable"},
                                   {0.0, 0.05, "stable"},
                                   {pi, threshold + 0.05, "unstable"},
                                   {pi, threshold - 0.05, "stable"}}) {
    const Carrier wave{s, q, d, 0.005};
    const double six = slow_growth(wave, 6), twelve = slow_growth(wave, 12),
                 by_nls = wave.growth_by_nls();
    waves.add({{"q", q},
               {"s", s},
               {"edge", q > 0 ? "pi" : "zero"},
               {"side", side},
               {"growth", with_error(six, twelve)},
               {"growth_over_nls", with_error(six / by_nls, twelve / by_nls)}});
  }
}

// From the frequency of exact waves, whose amplitude falls with the compression, and from their growth
inline Estimate measured_beta(double q, double d, double s) {
  const double omega = coefficients(q, d, s).omega;
  return at_zero_amplitude(0.04 * std::min(1.0, 2 * d), [&](double a) {
    const double shifted = Carrier{s, q, d, a}.exact().omega;
    return (shifted - omega) * (shifted + omega) / (a * a / 2);
  });
}
inline Estimate measured_phi(double q, double d, double s) {
  return at_zero_amplitude(0.03, [&](double a) {
    const Carrier wave{s, q, d, a};
    const auto nls = wave.nls();
    return growth_rate(wave.exact(), wave.fastest()) / (a * a / 4) * nls.omega *
           std::abs(nls.omega_2);
  });
}

// Formula and measurement beside each other
inline void report_coefficient(Report& report, double chosen, std::span<const double> wells) {
  std::vector<Carrier> points;
  for (double d : {chosen, 0.05, 0.2, 1.0, 4.0})
    for (double s : wells) {
      const int count = d == chosen && !report.quick ? 24 : 8;
      for (int k = 1; k < count; ++k) points.push_back({s, pi * k / count, d, 0});
    }
  report.table("measured_coefficient").fill(points, [&](const Carrier& at) {
    const auto& [s, q, d, a] = at;
    const bool slow = d == chosen && at.nls().phi > 0 && std::abs(q - pi / 2) >= 1e-9 &&
                      std::abs(q - inflection(contact_series(d).v1)) > 0.05;
    return Row{{"d", d},
               {"s", s},
               {"q", q},
               {"beta", of_phonon([](const auto& nls) { return nls.beta; }, q, d, s)},
               {"measured_beta", measured_beta(q, d, s)},
               {"phi", phi(q, d, s)},
               {"slow", slow},
               {"growth_phi", slow ? measured_phi(q, d, s) : undefined}};
  });
  const auto umklapp = [chosen](double a) {
    const Carrier wave{1, pi / 2, chosen, a};
    return growth_rate(wave.exact(), pi) / wave.growth_by_nls();
  };
  report.table("umklapp").add({{"s", 1.0}, {"growth_over_nls", at_zero_amplitude(0.04, umklapp)}});
}

// The moving breather of the NLS equation, Eq. (38)
inline State<double> soliton(const Carrier& wave, double eps, std::size_t sites, double t) {
  const auto nls = wave.nls();
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

// Its distance from the motion of the ring
struct AnsatzError {
  double l2 = 0, largest = 0;  // of y and v together, of any of them
};
inline AnsatzError ansatz_error(const Carrier& wave, double eps, double step, int samples) {
  const double time = 1 / (eps * eps);
  // A whole number of wavelengths of 8 sites; on the far side sech z < 2e-6
  const std::size_t sites = 8 * std::size_t(std::ceil(28 / (eps * 8)));
  const Chain chain{sites, Quartic{wave.s}, CompressedHertz{wave.d}, Ends::periodic};
  State<double> state = soliton(wave, eps, sites, 0);
  AnsatzError error;
  const auto watch = [&](const State<double>& now) {
    const State<double> ansatz = soliton(wave, eps, sites, now.t);
    double squares = 0;
    for (std::size_t i = 0; i < sites; ++i) {
      const double y = now.y[i] - ansatz.y[i], v = now.v[i] - ansatz.v[i];
      squares += y * y + v * v;
      error.largest = std::max({error.largest, std::abs(y), std::abs(v)});
    }
    error.l2 = std::max(error.l2, std::sqrt(squares));
  };
  evolve(Splitting{blanes_moan_6_14(), step}, chain, state, time, Every{time / samples}, watch);
  return error;
}

// For amplitudes that are halved, with two steps
inline void report_ansatz(Report& report, double d) {
  const Carrier wave{-1.0 / 6, pi / 4, d, 0};
  std::vector<double> eps{0.2, 0.1};
  if (!report.quick) eps.insert(eps.end(), {0.05, 0.025});
  std::vector<TwoRuns<AnsatzError>> runs(eps.size());
  parallel_for("error of the ansatz", eps.size(), [&](std::size_t k) {
    runs[k] = {ansatz_error(wave, eps[k], 0.8, 5000), ansatz_error(wave, eps[k], 0.4, 8000)};
  });
  // With the order of each error from one size to the next
  Table& table = report.table("ansatz_error");
  for (std::size_t k = 0; k < eps.size(); ++k) {
    const auto order = [&](auto of) {
      if (k == 0) return undefined;
      return order_between(eps[k - 1], runs[k - 1].of(of), eps[k], runs[k].of(of));
    };
    table.add({{"eps", eps[k]},
               {"l2", runs[k].of(&AnsatzError::l2)},
               {"largest", runs[k].of(&AnsatzError::largest)},
               {"order_l2", order(&AnsatzError::l2)},
               {"order_largest", order(&AnsatzError::largest)}});
  }
}

/// Writes `edge_waves`, `measured_coefficient`, `umklapp` and `ansatz_error`.
inline void report_nls_checks(Report& report, double d, std::span<const double> wells) {
  report_edge_waves(report, d);
  report_coefficient(report, d, wells);
  report_ansatz(report, d);
}

}  // namespace lattice
