#include "commands/phonon_band.hpp"

#include <cmath>
#include <string>

namespace lattice {
using namespace report;

static constexpr char speed_unit[] = "site per unit of time";

/**
The edges of the instability come in pairs, `unstable_from` and `unstable_to`, and those of a second interval
with its number. Where every phonon is stable there are none. */
static void add_edges_of_instability(Answers& q, double d, double s) {
  const auto narrow = edges_of_instability(d, s);
  const auto edge = [&](std::size_t i) {
    return in_two_precisions(
        [&](auto x, auto y) {
          const auto edges = edges_of_instability(x, y);
          if (edges.size() != narrow.size())
            throw Failure("the unstable wavenumbers are too close together to be resolved");
          return edges[i];
        },
        d, s);
  };
  if (narrow.empty())
    for (const char* name : {"unstable_from", "unstable_to"})
      q.add(name, undefined, "1/site", "edge of the unstable wavenumbers; no phonon is unstable",
            "all phonons are stable: Phi is nowhere positive");

  // From each interval its two ends
  for (std::size_t i = 0; i < narrow.size(); i += 2) {
    const std::string number = i == 0 ? "" : "_" + std::to_string(i / 2 + 1);
    q.add_small("unstable_from" + number, edge(i), "1/site",
                "lower end of an interval of modulationally unstable wavenumbers");
    q.add("unstable_to" + number, edge(i + 1), "1/site",
          "upper end of this interval, which begins at unstable_from" + number);
  }
}

Table Band::table() const {
  const auto fastest = [](auto compression) {
    const auto v1 = contact_series(compression).v1;
    return phonon(inflection(v1), v1).group_velocity;
  };

  // The band, its inflection, and where modulations grow
  Answers q;
  q.add("lower_edge", with_error(1.0, 1.0), "", "frequency at q = 0, that of a bead in its well");
  q.add("upper_edge",
        in_two_precisions(
            [](auto x) {
              return phonon(std::numbers::pi_v<decltype(x)>, contact_series(x).v1).omega;
            },
            d),
        "", "frequency at q = pi, the highest of the band");
  q.add("inflection", in_two_precisions([](auto x) { return inflection(contact_series(x).v1); }, d),
        "1/site", "wavenumber q_c of the fastest phonons, the inflection point of omega(q)");
  q.add("largest_group_velocity", in_two_precisions(fastest, d), speed_unit,
        "group velocity at q_c");
  const auto phi_at_0 = [](auto x, auto y) { return coefficients(0 * x, x, y).phi; };
  const auto phi_at_pi = [](auto x, auto y) {
    return coefficients(std::numbers::pi_v<decltype(x)>, x, y).phi;
  };
  q.add_small("phi_at_0", in_two_precisions(phi_at_0, d, s), "",
              "Phi = -beta omega_2 of Eq. (37) at q = 0; modulations grow if it is positive");
  q.add_small("phi_at_pi", in_two_precisions(phi_at_pi, d, s), "",
              "Phi of Eq. (37) at q = pi; modulations grow if it is positive");
  add_edges_of_instability(q, d, s);
  return q.table;
}

// All that is known of one wavenumber
Table OneWavenumber::table() const {
  const auto both = [&](auto of) {
    return in_two_precisions([&](auto x, auto y, auto z) { return of(coefficients(x, y, z)); }, q,
                             d, s);
  };
  Answers a;
  a.add("omega", both([](const auto& c) { return c.omega; }), "",
        "frequency of the phonon of wavenumber q");
  a.add_small("group_velocity", both([](const auto& c) { return c.group_velocity; }), speed_unit,
              "group velocity of this phonon, d omega / d q");
  a.add_small("beta", both([](const auto& c) { return c.beta; }), "",
              "coefficient beta of the cubic term of the NLS equation, below Eq. (36)");
  a.add_small("omega_2", both([](const auto& c) { return c.omega_2; }), "",
              "scaled dispersion omega omega''/v_1, negative beyond the inflection");
  a.add_small("phi", both([](const auto& c) { return c.phi; }), "",
              "-beta omega_2 of Eq. (37); the phonon is modulationally unstable if it is positive");
  return a.table;
}

}  // namespace lattice
