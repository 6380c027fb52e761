/**
# A breather in the browser

Newton's method, the multipliers and a kick, from the library that the programs of sections 3.2
and 3.3 are compiled from. Where those confirm a breather in extended precision, which a browser does not
have, the page takes a second tolerance, sixteen times as large, for the error. */

#include "lattice/orbits/breather.hpp"
#include "lattice/integrators/event_corrected.hpp"
#include "lattice/orbits/floquet.hpp"
#include "page.hpp"
#include "sec3/article_chains.hpp"
#include "sec3/kick.hpp"

using namespace lattice;

/**
A request names the breather, and a kick with the time over which it is followed; no kick is zero. */
struct Request {
  double bond, stretched, omega, s, kick, time;

  Centre centre() const { return bond != 0 ? Centre::bond : Centre::site; }
  Phase phase() const { return stretched != 0 ? Phase::stretched : Phase::compressed; }
};

NewtonRule<double> coarser() {
  NewtonRule<double> rule;
  rule.events.tolerance *= 16;
  return rule;
}

/// On the article's chain, or on one of `sites` sites for a breather that will move.
Fitted find(const Request& r, std::size_t sites = 0) {
  const Length usual = sites ? Length::for_kicks : Length::article;
  return fit_chain(r.centre(), r.omega, Quartic{r.s}, sites, sites_of(r.centre(), usual),
                   sites ? 1e-16 : 1e-17, r.phase());
}

/**
## The breather

The history shows how fast Newton's method ends; the residual is that of a whole period, without
any symmetry. Where rounding stops the iteration, its last step, which it could not make smaller, is
a part of the error. */
Estimate known(double rough, double good, double step) {
  Estimate both = with_error(rough, good);
  both.error += 2 * step * std::abs(good);
  return both;
}

void report_orbit(const Fitted& found, const Orbit<double>& rough) {
  const Orbit<double>& orbit = found.orbit;
  const double step = orbit.variation();
  std::vector<double> residuals;
  for (const Iteration& i : orbit.history) residuals.push_back(i.residual);
  page::list("residuals", residuals);
  page::list("y", orbit.start.y);
  State<double> end = orbit.start;
  const FlowReport<double> run = flow(found.problem.chain, end, found.problem.period());
  const double miss = largest_difference(end, orbit.start) / orbit.amplitude;
  page::fact("sites", exact(double(orbit.start.y.size())));
  page::fact("amplitude", known(rough.amplitude, orbit.amplitude, step));
  page::fact("energy", known(rough.energy, orbit.energy, step));
  page::fact("area", known(rough.action_integral, orbit.action_integral, step));
  page::fact("residual", {miss, run.error});
}

/**
## Its stability

Each pair of multipliers is one number $\kappa$ with its error (floquet.hpp), and the verdict is that
of all pairs: how many are off the circle by more than their errors, and the largest modulus. */
void report_multipliers(const Fitted& found, const Orbit<double>& rough) {
  const double period = found.problem.period();
  const auto& chain = found.problem.chain;
  const auto good = floquet_pairs(chain, found.orbit.start, period);
  const auto bad = floquet_pairs(chain, rough.start, period, coarser().events);
  std::vector<double> points;
  double unstable = 0;
  const std::vector<MultiplierPair> pairs = pairs_with_errors(bad, good);
  for (const MultiplierPair& pair : pairs) {
    for (int sign : {1, -1}) {
      const auto m = multiplier(pair.kappa, sign);
      points.insert(points.end(), {m.real(), m.imag()});
    }
    if (pair.is_unstable()) ++unstable;
  }
  page::list("multipliers", points);
  page::fact("unstable_pairs", exact(unstable));
  const Estimate beyond = excess(pairs);
  page::fact("largest_modulus", {1 + beyond.value, beyond.error});
  page::fact("pinning_kappa", {pairs.front().kappa.real(), pairs.front().error});
}

/**
## A kick

The path of the centre comes from two runs with different steps. It says something only while the
energy drifts by far less than the kick has brought. */
KickedPath kicked_path(const Fitted& found, const Request& r, int halvings) {
  const Chain chain{found.problem.chain.sites, Quartic{r.s}};
  const EventCorrected method{halvings ? 0.05 : 0.1};
  const double sample = sample_of_mean(found.problem.period());
  return follow_kicked(
      method, chain, kicked(found.orbit.start, r.kick), sample, r.time,
      [&](const KickedPath& path, const State<double>&, const std::vector<double>&) {
        const double moved = path.travelled();
        page_row(halvings, path.back().t, &moved, 1);
        return true;
      });
}

void report_kick(const Request& r) {
  const Fitted found = find(r, r.bond != 0 ? 52 : 53);
  const KickedPath rough = kicked_path(found, r, 0), good = kicked_path(found, r, 1);
  page::fact("travelled", with_error(rough.travelled(), good.travelled()));
  page::fact("speed", with_error(rough.speed_during(r.time / 16, r.time),
                                 good.speed_during(r.time / 16, r.time)));
  page::fact("margin", exact(good.drift_margin(r.kick, found.orbit.energy)));
  page::fact("share", with_error(rough.share, good.share));
  const bool agree = mobility_of(rough) == mobility_of(good);
  page::fact("fate", exact(agree ? double(int(mobility_of(good))) : 0));
}

/**
All that the page shows is computed in one call. */
PAGE_REQUEST(Request)

extern "C" __attribute__((export_name("run"))) void run() {
  const Fitted found = find(asked);
  const Vector<double> elsewhere = 1.001 * found.orbit.x;  // so that it has something to find
  const Orbit<double> rough = newton(found.problem, elsewhere, coarser());
  report_orbit(found, rough);
  report_multipliers(found, rough);
  if (asked.kick != 0) report_kick(asked);
}
