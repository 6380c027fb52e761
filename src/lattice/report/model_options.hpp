#pragma once
/**
# Choosing a model on the command line

Every program that computes with wells and contacts of the reader's choice offers the same
options: `--onsite` and `--contact` with the names that the potentials give themselves, and
one option for every parameter that any of them has. Nothing is listed here. A parameter that
the chosen potential does not have is refused rather than ignored. Where the contact is not the
reader's choice, only the well is offered. */

#include <string>

#include "lattice/model/chain.hpp"
#include "lattice/report/program.hpp"

namespace lattice {

/**
A program has a model with its own values before the line is read, and the reader's model after it. A
parameter may have another range in a program than elsewhere. */

/// Adds `--onsite`, `--contact` and their parameters to a command; `model` holds the defaults and,
/// once the command line is read, the choice. It must live as long as `app`. Parameters of wells may have
/// ranges of the program's `own`.
void add_model_options(Command& app, Chain& model, const Ranges& own = {});

/**
A breather begins as the vibration of a bead in its well, and phonons are vibrations of a chain of such
beads; without a well there is neither. Where this is the subject, the wells on offer are those that hold a
bead with the frequency one, which the unit of time makes of every frequency. */

/// Adds `--onsite` and its parameters alone. A well that does not hold its bead is refused because
/// `without` a well something is missing.
void add_well_options(Command& app, Well& well, const std::string& without);

/**
What lies beyond the first and the last bead is a choice among few, and a name again. */

/// Adds `--ends`; as above, `model` holds the default and must live as long as `app`.
void add_ends_option(Command& app, Chain& model);

}  // namespace lattice
