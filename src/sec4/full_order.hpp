#pragma once
/**
# 4 Checks: the full order, and an independent route (figure x08)

A contact that opens or closes limits every splitting to about order 2.5 (secA_integrators.cpp). The modulated phonon of
figure 26 keeps all contacts closed until $t = 50$, so each method must show the order in its name; the struck chain, up
to $t = 30$, opens contacts, and the methods must lose it. As an independent route GSL's method of order eight must
arrive at the same states. This part of the chapter of section 4 belongs to the program sec4_precompression_mi.cpp.

![Error against step with closed and with opening contacts.](fig:x08) */

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "lattice/gsl/reference.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/integrators/event_corrected.hpp"
#include "lattice/integrators/integrate.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "report/program.hpp"
#include "sec4/modulation.hpp"

namespace full_order {

using namespace lattice;

/// A run, in which contacts open or do not.
struct OrderCase {
  std::string name;
  Chain chain;
  State<double> start;
  double time;

  template <class Stepper>
  State<double> run(const Stepper& method) const {
    State<double> state = start;
    evolve(method, chain, state, time, time);
    return state;
  }
};

/// Errors of one method for halved steps, and their slope on logarithmic axes between errors of 1e-2
/// and 3e-12, where neither too long steps nor rounding dominate.
inline Line order_of(const OrderCase& c, const Scheme& scheme, const State<double>& right,
                     Table& table) {
  std::vector<double> x, y;
  for (double step = 0.5; step > 0.007; step /= 2) {
    const double error = distance(right, c.run(Splitting{scheme, step}));
    table.add({{"contacts", "closed all the time, or opening", c.name},
               {"scheme", "splitting", scheme.name},
               {"step", "time step", step},
               {"error", "relative error of the end state", error}});
    if (error < 1e-2 && error > 3e-12) x.push_back(std::log(step)), y.push_back(std::log(error));
  }
  return fit_line(x, y);
}

/**
To measure errors we need the right end state. It is that of an event-corrected run with a very short step, once an
adaptive integrator that shares nothing with it has confirmed it. */
/// That state; the facts have its distance from the independent one.
inline State<double> confirmed_end(const OrderCase& c, Quantities& facts) {
  const State<double> right = c.run(EventCorrected{1.0 / 256, nystrom(blanes_moan_6_14())});
  const double apart = distance_from_reference(c.chain, c.start, c.time, right, 1e-9);
  facts.add("independent_route_difference_" + c.name, compare(0.0, apart));
  return right;
}

/**
If opening contacts are to blame, the methods lose their order in the one case and not in the other. Only Verlet's order
of two lies below the limit and is kept in both. */
/// The orders of four splittings in both cases.
inline void report_order(Report& report) {
  const ModulatedPhonon phonon;
  const OrderCase cases[] = {
      {"closed", phonon.ring(), phonon.start(), 50},
      {"opening", {60, Quartic{1}, CompressedHertz{0.5}}, struck(60, 1.87), 30}};
  Table table;
  for (const OrderCase& c : cases) {
    const State<double> right = confirmed_end(c, report.facts);
    for (const Scheme& scheme : {verlet(), blanes_moan_4(), blanes_moan_6(), blanes_moan_6_14()}) {
      const Line line = order_of(c, scheme, right, table);
      std::string name = scheme.name;
      std::replace(name.begin(), name.end(), '-', '_');
      report.facts.add("order_" + c.name + "_" + name, line.estimate());
    }
  }
  report.output.add("order", std::move(table));
}

}  // namespace full_order
