#pragma once
/**
# Choosing a breather on the command line

A breather is named by its centre, its frequency, the well of the beads and, around a bond, the phase at
$t = 0$; how many sites it needs follows from that. Who names a chain length as well gets that chain, or is told why not. */

#include <string>

#include "lattice/orbits/breather.hpp"
#include "lattice/report/model_options.hpp"
#include "lattice/report/program.hpp"

namespace lattice {

struct ChosenBreather {
  std::string centre = "site", phase = "compressed";
  double omega = 1.1;
  std::size_t sites = 0;  ///< 0: as many as needed
  Well onsite = Quartic{};

  Centre kind() const { return centre == "site" ? Centre::site : Centre::bond; }
  Phase start() const { return phase == "stretched" ? Phase::stretched : Phase::compressed; }
  void offer_centre(Command& app) {
    app.add_option("--centre", centre, "site or bond")->check(one_of({"site", "bond"}));
  }
  void offer_phase(Command& app) {
    app.add_option("--phase", phase, "central contact of a bond-centred breather at t = 0")
        ->check(one_of({"compressed", "stretched"}));
  }
  void offer_well(Command& app) { add_well_options(app, onsite, "there is no breather"); }
};

/**
What comes from a chain that does not fit is a complaint about `--sites`. */
/// `make()`; throws UsageError for a length of the wrong parity or too short for the tail.
template <class Make>
auto on_chosen_chain(const ChosenBreather& chosen, Make make) {
  const std::string sites = "--sites: " + std::to_string(chosen.sites);
  if (chosen.sites && !fits(chosen.kind(), chosen.sites))
    throw UsageError(sites + " does not fit --centre " + chosen.centre + " (allowed: " +
                     (chosen.kind() == Centre::site ? "odd" : "even") + " numbers)");
  try {
    return make();
  } catch (const ShortChain& error) {
    throw UsageError(sites + " cannot hold this breather's tail (allowed: " +
                     std::to_string(error.needed) + " or more)");
  }
}

/// The breather that was chosen, on a chain of about the article's length that holds its tail down to
/// `precision`. Throws UsageError, NoConvergence.
inline Fitted find_chosen(const ChosenBreather& chosen, double precision) {
  return on_chosen_chain(chosen, [&] {
    return fit_chain(chosen.kind(), chosen.omega, chosen.onsite, chosen.sites,
                     sites_of(chosen.kind()), precision, chosen.start());
  });
}

}  // namespace lattice
