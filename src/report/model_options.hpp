#pragma once
/**
# Choosing a model on the command line

Every program that computes with wells and contacts of the reader's choice offers the same
options: `--well` and `--contact` with the names that the potentials give themselves, and
one option for every parameter that any of them has. Nothing is listed here. A parameter that
the chosen potential does not have is refused rather than ignored. Where the contact is not the
reader's choice, only the well is offered. */

#include <string>

#include "lattice/model/chain.hpp"
#include "lattice/model/potential_names.hpp"
#include "report/parameters.hpp"

namespace lattice {

/**
A program has wells and contacts of its own before the line is read, and the reader's after it. A
parameter may have another range in a program than elsewhere. */

/// Adds `--well` and its parameters; `well` holds the default and, once the line is read, the choice. It
/// must live as long as `p`. Parameters may have ranges of the program's `own`.
void add_well(Parameters& p, Well& well, const Ranges& own = {});

/// Adds `--contact` and its parameters in the same way.
void add_contact(Parameters& p, Contact& contact, const Ranges& own = {});

/**
A breather begins as the vibration of a bead in its well, and phonons are vibrations of a chain of such
beads; without a well there is neither. Where this is the subject, the wells on offer are those that hold a
bead with the frequency one, which the unit of time makes of every frequency. */

/// As `add_well`; a well that does not hold its bead is refused because `without` a well something is
/// missing.
void add_holding_well(Parameters& p, Well& well, const std::string& without);

/**
What lies beyond the first and the last bead is a choice among few, and a name again. */

/// Adds `--ends`; as above, `ends` holds the default.
void add_ends(Parameters& p, Ends& ends);

}  // namespace lattice
