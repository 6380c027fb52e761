#pragma once
/**
# A barrier with your own parameters

`sec32_barrier barrier --omega 1.1` prints the barrier (breather_pairs.hpp) at equal frequency and at equal area, both
with their signs, from two tolerances in extended precision, for other wells (`--well pendulum`) and contacts too
(`--contact power --alpha 1.75`, `--precompression 1e-3 --omega 1.3`). In Python this is `lattice.barrier`. */

#include "sec3/article_chains.hpp"
#include "sec3/breather_options.hpp"
#include "sec3/breather_pairs.hpp"
#include "sec3/resolutions.hpp"

namespace lattice {
using namespace report;

/// The command: omega_b, well and contact, the pair of breathers, the table.
struct OneBarrier : ChosenBreather {
  static constexpr Title title{
      "barrier",
      "Peierls-Nabarro barrier: the energy difference E_site - E_bond of the two breathers"};

  void parameters(Parameters& p) {
    add_omega(p);
    add_well(p);
    add_contacts(p);
  }

  /**
  Between spheres that are not compressed the chains are those of the chapter; other breathers decide themselves how long
  theirs is. */
  /// Both breathers, measured in extended precision. Throws UsageError, NewtonFailed, NoBranch.
  BreatherPair find() const {
    BreatherPair pair{0, omega_b};
    const bool plain = like.contact.is<Hertz>();
    for (int k : {0, 1}) {
      ChosenBreather one = *this;
      one.centre = both_centres[k];
      auto problem = breather_problem(one.centre, omega_b, well, sites_of(one.centre));
      const Fitted found =
          plain ? Fitted{problem, find_breather(problem)} : find_chosen(one, 1e-20);
      pair.others.push_back(found.problem);
      pair.orbit[k] = found.orbit;
    }
    measure_in<Wide>(pair);
    return pair;
  }

  Table table() const {
    const BreatherPair found = find();
    Answers q;
    q.add_small("equal_frequency", found.equal_frequency, "",
                "E_site - E_bond, both breathers at the frequency omega_b");
    q.add_small("equal_area", found.equal_action, "",
                "E_site - E_bond, both breathers at the bond-centred one's area (2 pi times the "
                "action), which a moving breather keeps");
    return q.table;
  }
};

}  // namespace lattice
