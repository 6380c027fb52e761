/**
# Statements of section 3.5: Physical scales of a cradle and of an array of cantilevers */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("scale.contact_time") {
  answer(fact("contact_time"));
}

STATEMENT("scale.max_compression") {
  answer(fact("max_compression"));
}

STATEMENT("scale.cradle") {
  answer(fact("cradle"));
}

STATEMENT("beam.stiffness") {
  answer(fact("beam_stiffness"));
}

STATEMENT("beam.frequency") {
  answer(fact("beam_frequency"));
}

STATEMENT("beam.mass") {
  answer(fact("beam_mass"));
}

STATEMENT("cantilever.tau_h") {
  answer(fact("tau_h"));
}

STATEMENT("cantilever.tau_c") {
  answer(fact("tau_c"));
}

STATEMENT("cantilever.lambda") {
  answer(fact("lambda"));
}

STATEMENT("outlook.dominated") {
  answer(fact("epsilon_printed_period"));
}
