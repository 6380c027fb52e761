#pragma once
/**
# Choosing a breather on the command line

A breather is named by its centre, its frequency, the well of the beads and, around a bond, the phase at $t = 0$. It
decides how many sites it needs; a chain length that the reader names is taken or refused with the reason. */

#include <string>

#include "lattice/orbits/breather.hpp"
#include "report/model_options.hpp"
#include "report/program.hpp"
#include "sec3/article_chains.hpp"
#include "sec3/breather_like.hpp"

namespace lattice {
using namespace report;

/// Frequencies of breathers, and why there are no others.
inline Allowed breather_range(double least, double most) {
  return {least, most, "",
          "these breathers bifurcate from 1, the frequency of a single bead, and uncompressed "
          "contacts raise it; higher frequencies are untested"};
}

/// Exponents of the contact force for which a command computes a static DpS breather.
inline Allowed static_exponents() {
  return {1.05, 4, "",
          "a breather needs an exponent above 1; as it approaches 1, the breather widens and its "
          "amplitude leaves the range of double precision; exponents above 4 are untested"};
}

/// The breather that a command is asked for, of `omega_b` in these wells.
struct ChosenBreather {
  Centre centre = Centre::site;
  Phase phase = Phase::compressed;
  double omega_b = 1.1;
  std::size_t sites = 0;  ///< 0: as many as needed
  Well well = Quartic{};
  Chain like{};  ///< its contacts and, if the beads differ, its masses and stiffnesses
  double mass_ratio = 1, defect_mass = 1;

  /// The options that ask for a breather, one function each, since not every command has them all.
  void add_centre(Parameters& p) {
    p.add("centre", centre, "where the breather is centred",
          {{"site", Centre::site}, {"bond", Centre::bond}});
  }
  void add_omega(Parameters& p) {
    p.add("omega", omega_b, "frequency omega_b of the breather; a single bead has 1",
          breather_range(1.0001, 3));
  }
  void parameters(Parameters& p) {
    add_centre(p);
    add_omega(p);
  }
  void add_phase(Parameters& p) {
    p.add("phase", phase,
          "state of the central contact of a bond-centred breather at t = 0; for a site-centred "
          "breather the two are mirror images",
          {{"compressed", Phase::compressed}, {"stretched", Phase::stretched}});
  }
  void add_well(Parameters& p) { add_holding_well(p, well, "there is no breather"); }
  void add_contacts(Parameters& p) { add_contact(p, like.contact, {{"alpha", {1.2, 3}}}); }
  /// Chains of two masses and with a defect at the centre; neither is symmetric about a bond.
  void add_masses(Parameters& p) {
    const Allowed range{0.1, 10};
    p.add("mass-ratio", mass_ratio, "mass of every second bead, starting next to the centre",
          range);
    p.add("defect-mass", defect_mass, "mass of the central bead", range);
    p.when_read([this] {
      if (mass_ratio == 1 && defect_mass == 1) return;
      if (centre == Centre::bond)
        throw UsageError(
            std::string(mass_ratio != 1 ? "--mass-ratio" : "--defect-mass") +
            ": such a chain is not symmetric about a bond (allowed: with --centre site)");
      like.sites = 5;
      vary(like, {1, mass_ratio, defect_mass, mass_ratio, 1}, {});
    });
  }
};

/// `make()`; throws UsageError for a length of the wrong parity or too short for the tail, or a frequency in the band.
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
    throw UsageError(sites + " are too few for this breather's tail (allowed: " +
                     std::to_string(error.needed) + " or more)");
  } catch (const InBand& error) {
    throw UsageError("--omega: " + std::string(error.what()));
  }
}

/// On a chain of about the article's length that holds its tail down to `precision`. Throws UsageError, NewtonFailed.
inline Fitted find_chosen(const ChosenBreather& chosen, double precision) {
  Chain like = chosen.like;
  like.well = chosen.well;
  return on_chosen_chain(chosen, [&] {
    return fit_chain(chosen.centre, chosen.omega_b, like, chosen.sites, sites_of(chosen.centre),
                     precision, chosen.phase);
  });
}

}  // namespace lattice
