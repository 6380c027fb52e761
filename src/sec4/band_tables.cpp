#include "sec4/band_tables.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "lattice/numerics/line_fit.hpp"
#include "sec4/instability.hpp"
#include "sec4/phonons.hpp"

namespace lattice {

using std::numbers::pi;

static constexpr const char *by_precisions = "difference of two precisions",
                            *of_largest = "difference of two precisions, against the largest";

// Formulas in both precisions: the coefficients of the contact and of the NLS equation, and where the frequency inflects
template <class Of>
static Estimate of_contact(Of of, double d) {
  return in_two_precisions([of](auto x) { return of(contact_series(x)); }, d);
}
template <class Of>
static Estimate of_phonon(Of of, double q, double d, double s) {
  return in_two_precisions([of](auto x, auto y, auto z) { return of(coefficients(x, y, z)); }, q, d,
                           s);
}
static Estimate phi(double q, double d, double s) {
  return of_phonon([](const auto& nls) { return nls.phi; }, q, d, s);
}
static double inflection_at(double d) {
  return inflection(contact_series(d).v1);
}
static Estimate band_width(double d) {
  const auto width = [](const auto& v) {
    using std::sqrt;
    return sqrt(1 + 4 * v.v1) - 1;
  };
  return of_contact(width, d);
}

// How often the curvature changes its sign between 0 and pi
static int sign_changes(double v1) {
  // On a grid that is fine against the band
  int changes = 0;
  for (int k = 1; k < 9999; ++k) {
    const double here = phonon(pi * k / 10000, v1).omega_2,
                 next = phonon(pi * (k + 1) / 10000, v1).omega_2;
    if (here * next < 0) ++changes;
  }
  return changes;
}

static void report_compressions(Report& report, std::span<const double> wells) {
  // The inflection and the width of the band, and the sign of Phi on both sides
  Table &table = report.table("compressions"), &signs = report.table("inflection_signs");
  double last = 0;
  for (double d : {1e-8, 1e-6, 1e-4, 0.01, 0.1, 0.5, 1.0, 10.0, 100.0, 1e4}) {
    const Estimate q_c = of_contact([](const auto& v) { return inflection(v.v1); }, d);
    Estimate order = undefined;
    if (last > 0) order = order_between(last, band_width(last), d, band_width(d));
    table.add({{"d", "compression of the contacts", d},
               {"v1", "coefficient of r", of_contact([](const auto& v) { return v.v1; }, d), "",
                by_precisions},
               {"q_c", "inflection of the frequency", q_c, "1/site", by_precisions},
               {"sign_changes", "of the curvature between 10000 wavenumbers from 0 to pi",
                sign_changes(contact_series(d).v1)},
               {"band_width", "largest frequency of a phonon less the smallest", band_width(d), "",
                by_precisions},
               {"order", "power of d with which it grows from the row before", order, "",
                "from the errors of both; nan in the first row"}});
    last = d;
    for (double s : wells)
      signs.add({{"d", "compression of the contacts", d},
                 {"s", "anharmonicity of the well", s},
                 {"phi_below", "Phi at q_c (1 - 1e-8)", phi(q_c.value * (1 - 1e-8), d, s), "",
                  by_precisions},
                 {"phi_above", "Phi at q_c (1 + 1e-8)", phi(q_c.value * (1 + 1e-8), d, s), "",
                  by_precisions}});
  }
}

// On which side of the inflection waves are unstable
static void report_sides(Report& report) {
  Table& table = report.table("sides");
  for (double d : {0.1, 0.5, 1.0, 4.0})
    for (double s : {-1.0 / 6, 0.0, 1.0, 4.0}) {
      const std::vector<double> edges = edges_of_instability(d, s);
      const auto is_inflection = [q_c = inflection_at(d)](double q) {
        return std::abs(q - q_c) < 1e-9;
      };
      int below = 0, above = 0, beside = 0, reach = 0;
      for (std::size_t i = 0; i + 1 < edges.size(); i += 2) {
        const double from = edges[i], to = edges[i + 1];
        if (is_inflection(to) || to < inflection_at(d))
          ++below;
        else
          ++above;
        beside += is_inflection(from) + is_inflection(to);
        reach += (from == 0) + (to == pi);
      }
      table.add({{"d", "compression of the contacts", d},
                 {"s", "anharmonicity of the well", s},
                 {"below", "intervals of unstable wavenumbers below q_c", below},
                 {"above", "those above q_c", above},
                 {"beside", "those that begin or end at q_c", beside},
                 {"reach", "edges of the band that unstable wavenumbers reach", reach}});
    }
}

// The article's conditions at both edges of the band
static void report_edges(Report& report, double chosen) {
  Table& edges = report.table("band_edges");
  for (double d : {0.01, 0.1, chosen, 1.0, 10.0})
    for (double part : {-1.0, -0.01, 0.0, 0.01, 0.5, 0.99, 1.01, 2.0})  // of the threshold at pi
      for (double q : {0.0, pi}) {
        const double s = part * -16 * contact_series(d).v3;
        edges.add({{"d", "compression of the contacts", d},
                   {"q", "wavenumber", q, "1/site"},
                   {"s", "anharmonicity of the well", s},
                   {"v3", "coefficient of r^3", of_contact([](const auto& v) { return v.v3; }, d)},
                   {"phi", "modulation coefficient Phi", phi(q, d, s), "", of_largest}});
      }
}

// Phi of the chosen compression, and its largest value and mean over the unstable wavenumbers
static void report_instability(Report& report, double d, std::span<const double> wells) {
  Table &table = report.table("instability"), &in_wells = report.table("inflection");
  for (double s : wells) {
    for (int k = 0; k <= 200; ++k)
      table.add({{"q", "wavenumber", pi * k / 200, "1/site"},
                 {"s", "anharmonicity of the well", s},
                 {"phi", "modulation coefficient Phi; unstable where positive",
                  phi(pi * k / 200, d, s), "", of_largest}});
    double largest[2], mean[2];
    for (int grid : {0, 1}) {
      std::vector<double> all;
      for (int k = 0, points = 2000 << grid; k <= points; ++k)
        if (const double here = coefficients(pi * k / points, d, s).phi; here > 0)
          all.push_back(here);
      largest[grid] = *std::ranges::max_element(all);
      mean[grid] = std::accumulate(all.begin(), all.end(), 0.0) / double(all.size());
    }
    const char* how = "two grids of wavenumbers";
    in_wells.add(
        {{"s", "anharmonicity of the well", s},
         {"largest_phi", "largest Phi of all wavenumbers", compare(largest[0], largest[1]), "",
          how},
         {"mean_phi", "mean Phi of the unstable wavenumbers", compare(mean[0], mean[1]), "", how}});
  }
}

// All of them
void report_band(Report& report, double d, std::span<const double> wells) {
  report.table("contact_series")
      .add({{"v1", "coefficient of r", of_contact([](const auto& v) { return v.v1; }, d), "",
             by_precisions},
            {"v2", "coefficient of r^2", of_contact([](const auto& v) { return v.v2; }, d), "",
             by_precisions},
            {"v3", "coefficient of r^3", of_contact([](const auto& v) { return v.v3; }, d), "",
             by_precisions}});
  report_compressions(report, wells);
  report_sides(report);
  report_edges(report, d);
  report_instability(report, d, wells);
}

}  // namespace lattice
