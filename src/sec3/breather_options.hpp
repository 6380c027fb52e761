#pragma once
/**
# Choosing a breather on the command line

A breather is named by its centre, its frequency, the well of the beads and, around a bond, the phase at
$t = 0$; how many sites it needs follows from that. If the reader names a chain length as well, it is taken or
refused with the reason. */

#include <string>

#include "lattice/orbits/breather.hpp"
#include "report/model_options.hpp"
#include "report/program.hpp"

namespace lattice {

/// Frequencies of breathers, and why there are no others.
inline Allowed breather_range(double least, double most) {
  return {least, most, "",
          "these breathers begin at 1, the frequency of a bead at rest, which contacts without "
          "precompression raise; higher ones are untested"};
}

/// The breather that a command is asked for, of `omega_b` in these wells.
struct ChosenBreather {
  Centre centre = Centre::site;
  Phase phase = Phase::compressed;
  double omega_b = 1.1;
  std::size_t sites = 0;  ///< 0: as many as needed
  Well well = Quartic{};

  /// The options that ask for a breather, one function each, since not every command has them all: `--centre`,
  void add_centre(Parameters& p) {
    p.add("centre", centre, "where the breather is centred",
          {{"site", Centre::site}, {"bond", Centre::bond}});
  }
  /// `--omega`,
  void add_omega(Parameters& p) {
    p.add("omega", omega_b, "frequency omega_b > 1", breather_range(1.0001, 3));
  }
  /// both of them,
  void parameters(Parameters& p) {
    add_centre(p);
    add_omega(p);
  }
  /// `--phase`,
  void add_phase(Parameters& p) {
    p.add("phase", phase,
          "central contact of a bond-centred breather at t = 0; around a site the two are mirror "
          "images",
          {{"compressed", Phase::compressed}, {"stretched", Phase::stretched}});
  }
  /// and `--well` with the parameters of the wells.
  void add_well(Parameters& p) { add_holding_well(p, well, "there is no breather"); }
};

/**
What comes from a chain that does not fit is a complaint about `--sites`. */
/// `make()`; throws UsageError for a length of the wrong parity or too short for the tail.
template <class Make>
auto on_chosen_chain(const ChosenBreather& chosen, Make make) {
  const std::string sites = "--sites: " + std::to_string(chosen.sites);
  const bool around_site = chosen.centre == Centre::site;
  if (chosen.sites && !fits(chosen.centre, chosen.sites))
    throw UsageError(sites + " does not fit --centre " + (around_site ? "site" : "bond") +
                     " (allowed: " + (around_site ? "odd" : "even") + " numbers)");
  try {
    return make();
  } catch (const ShortChain& error) {
    throw UsageError(sites + " cannot hold this breather's tail (allowed: " +
                     std::to_string(error.needed) + " or more)");
  }
}

/// The breather that was chosen, on a chain of about the article's length that holds its tail down to
/// `precision`. Throws UsageError, NewtonFailed.
inline Fitted find_chosen(const ChosenBreather& chosen, double precision) {
  return on_chosen_chain(chosen, [&] {
    return fit_chain(chosen.centre, chosen.omega_b, chosen.well, chosen.sites,
                     sites_of(chosen.centre), precision, chosen.phase);
  });
}

}  // namespace lattice
