#pragma once
/**
# Choosing a model on the command line

`--well` and `--contact` take the names that the potentials give themselves (potential_names.hpp), and every parameter that
any of them has is an option. A parameter that the chosen potential does not have is refused rather than ignored. The
variable holds the program's own potential before the line is read, and the reader's after it; it must live as long as the
parameters. */

#include <string>

#include "lattice/model/chain.hpp"
#include "lattice/model/potential_names.hpp"
#include "report/parameters.hpp"

namespace report {

/// Adds `--well` and its parameters, which may have ranges of the program's `own`.
void add_well(Parameters& p, Well& well, const Ranges& own = {});

/// Adds `--contact` and its parameters in the same way.
void add_contact(Parameters& p, Contact& contact, const Ranges& own = {});

/// As `add_well`; a well that does not hold its bead with the frequency one is refused, because `without` a well
/// something is missing.
void add_holding_well(Parameters& p, Well& well, const std::string& without);

/// Adds `--ends`, by the names of chain.hpp.
void add_ends(Parameters& p, Ends& ends);

}  // namespace report
