#include "sec4/nls_checks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lattice/gsl/reference.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "sec4/exact_waves.hpp"

namespace lattice {

using std::numbers::pi;

void report_beta(Report& report) {
  struct Point {
    PhaseOfWave phase;
    Coefficients<double> nls;
    Estimate beta{}, phi{};
  };
  std::vector<Point> points;
  for (double s : {-1.0 / 6, 0.0, 1.0})
    for (int k = report.quick ? 4 : 1; k < 24; k += report.quick ? 4 : 1) {
      const PhaseOfWave phase{pi * k / 24, 0.5, s};
      points.push_back({phase, phase.nls(), {}, {std::nan(""), std::nan("")}});
    }
  const double q_c = inflection(contact_series(0.5).v1);
  const auto slow = [&](const Point& p) {
    return p.nls.phi > 0 && std::abs(p.phase.q - pi / 2) >= 1e-9 &&
           std::abs(p.phase.q - q_c) > 0.05;
  };
  parallel_for("nonlinear frequency", points.size(), [&](std::size_t i) {
    Point& p = points[i];
    const Chain ring{48, Quartic{p.phase.s}, CompressedHertz{p.phase.d}, Ends::periodic};
    p.beta = measured_beta(ring, p.phase.q, p.nls.omega);
    if (slow(p)) p.phi = p.phase.phi_from_growth(0.04);
  });

  // Both against the formula
  Estimate shift{}, growth{};
  Table& table = report.table("measured_coefficient");
  for (const Point& p : points) {
    shift = larger(shift, relative_distance(p.beta, p.nls.beta));
    if (slow(p)) growth = larger(growth, relative_distance(p.phi, p.nls.phi));
    table.add({{"q", "wavenumber", p.phase.q, "1/site"},
               {"s", "anharmonicity of the well", p.phase.s},
               {"beta", "NLS coefficient from its formula", p.nls.beta},
               {"measured_beta", "from the measured frequency shift", p.beta, "",
                "two steps and two pairs of amplitudes"},
               {"shift_phi", "modulation coefficient with the measured beta",
                -p.beta.value * p.nls.omega_2},
               {"growth_phi", "from the growth, nan where stable or out of reach", p.phi, "",
                "two pairs of amplitudes, nan where growth_phi is"}});
  }
  report.facts.add("beta_shift", shift);
  report.facts.add("beta_growth", growth);
  report.facts.add("beta_apart_by_shift", compare(0.0, shift.value + shift.error));

  // Two waves q that scatter into two waves near q - pi, once where Phi < 0
  const auto over_nls = [](const PhaseOfWave& at, double a, double Q, std::size_t harmonics = 12) {
    return at.growth(a, Q, harmonics) / (std::abs(at.nls().h()) * a * a / 4);
  };
  const PhaseOfWave resonant{pi / 2, 0.5, 1}, stable{11 * pi / 24, 0.5, 0};
  const double Q = pi - 11 * 2 * pi / 384;
  report.facts.add("backscattering",
                   at_zero_amplitude(0.04, [&](double a) { return over_nls(resonant, a, pi); }));
  report.facts.add("backscattering_where_stable",
                   compare(over_nls(stable, 0.1, Q, 8), over_nls(stable, 0.1, Q)));
}

void report_growth(Report& report) {
  const double q = pi / 4, s = -1.0 / 6;
  const Chain ring{200, Quartic{s}, CompressedHertz{0.5}, Ends::periodic};
  const auto c = coefficients(q, 0.5, s);
  Table &curves = report.table("growth"), &runs = report.table("growth_runs");
  for (double a : {0.15, 0.05}) {
    const PlaneWave wave = plane_wave(ring.well, ring.contact, q, a);
    for (int k = 1; k <= 60; ++k) {
      const double modulation = fastest_modulation(c, a) * 1.6 * k / 60, unit = a * a / 4;
      curves.add({{"modulation", "wavenumber Q of the modulation", modulation, "1/site"},
                  {"a", "amplitude of the wave", a},
                  {"growth", "eigenvalue over |A|^2",
                   growth_rate(wave, ring.well, ring.contact, modulation) / unit},
                  {"nls", "NLS growth over |A|^2", nls_growth(c, a, modulation) / unit}});
    }
  }

  // The same growth in runs
  Estimate apart;
  const PlaneWave wave = plane_wave(ring.well, ring.contact, q, 0.15);
  for (int turns = 1; turns <= 3; ++turns) {
    const double modulation = 2 * pi * turns / double(ring.sites), unit = 0.15 * 0.15 / 4;
    const double rate = growth_rate(wave, ring.well, ring.contact, modulation);
    const auto run = [&](double step) {
      return measured_growth(Splitting{blanes_moan_6_14(), step}, ring, wave, turns, rate);
    };
    const Estimate seen = compare(run(0.4), run(0.2));
    apart.value = std::max(apart.value, std::abs(seen.value / rate - 1));
    apart.error = std::max(apart.error, seen.error / rate);
    runs.add({{"modulation", "wavenumber Q of the modulation", modulation, "1/site"},
              {"growth", "growth in a run over |A|^2",
               Estimate{seen.value / unit, seen.error / unit}, "", "difference of two steps"}});
  }
  report.facts.add("simulated_growth_apart", apart);
  if (!(apart.value + apart.error < 1e-3))
    throw Failure("growth in runs and eigenvalues differ: " + number_text(apart.value));
}

void report_ansatz(Report& report) {
  struct Size {
    double eps;
    Estimate l2{}, largest{};
  };
  std::vector<Size> sizes;
  for (double eps = 0.2; eps > (report.quick ? 0.04 : 0.02); eps /= 2) sizes.push_back({eps});
  parallel_for("error of the ansatz", sizes.size(), [&](std::size_t i) {
    Size& size = sizes[sizes.size() - 1 - i];
    const Soliton soliton{{pi / 4, 0.5, -1.0 / 6}, 8, size.eps};
    const AnsatzError coarse = ansatz_error(soliton, 1, 0.8, 5000),
                      fine = ansatz_error(soliton, 1, 0.4, 8000);
    size.l2 = compare(coarse.l2, fine.l2);
    size.largest = compare(coarse.largest, fine.largest);
  });
  Table& table = report.table("ansatz_error");
  for (const Size& size : sizes)
    table.add({{"eps", "size of the ansatz", size.eps},
               {"l2", "of displacements and velocities together", size.l2},
               {"largest", "of any displacement or velocity", size.largest}});

  // Local orders
  const auto order = [&](std::size_t i, Estimate Size::*of) {
    return order_between(sizes[i].eps, sizes[i].*of, sizes[i + 1].eps, sizes[i + 1].*of);
  };
  const auto last = [&](Estimate Size::*of) {
    return compare(order(sizes.size() - 3, of), order(sizes.size() - 2, of));
  };
  report.facts.add("nls_order", last(&Size::l2));
  report.facts.add("nls_order_first", order(0, &Size::l2));
  report.facts.add("nls_order_largest", last(&Size::largest));
}

void report_order(Report& report, const Chain& ring, const State<double>& phonon) {
  struct Case {
    std::string name;
    Chain chain;
    State<double> start;
    double time;
  };
  Table& table = report.table("order");
  for (const Case& c :
       {Case{"closed", ring, phonon, 50},
        {"opening", {60, Quartic{1}, CompressedHertz{0.5}}, struck(60, 1.87), 30}}) {
    const auto end_of = [&](const Method& method) {
      State<double> state = c.start;
      evolve(method, c.chain, state, c.time, c.time);
      return state;
    };
    const State<double> right = end_of(EventCorrected{1.0 / 256, nystrom(blanes_moan_6_14())});
    report.facts.add("independent_route_difference_" + c.name,
                     compare(0.0, distance_from_reference(c.chain, c.start, c.time, right, 1e-9)));
    // The slope on logarithmic axes where neither too long steps nor rounding dominate
    for (const Scheme& scheme : {verlet(), blanes_moan_4(), blanes_moan_6(), blanes_moan_6_14()}) {
      std::vector<double> x, y;
      for (double step = 0.5; step > 0.007; step /= 2) {
        const double error = distance(right, end_of(Splitting{scheme, step}));
        table.add({{"contacts", "closed all the time, or opening", c.name},
                   {"scheme", "splitting", scheme.name},
                   {"step", "time step", step},
                   {"error", "relative error of the end state", error}});
        if (error < 1e-2 && error > 3e-12)
          x.push_back(std::log(step)), y.push_back(std::log(error));
      }
      std::string name = scheme.name;
      std::replace(name.begin(), name.end(), '-', '_');
      report.facts.add("order_" + c.name + "_" + name, fit_line(x, y).estimate());
    }
  }
}

}  // namespace lattice
