/**
# Statements of section 3.5: Physical scales of a cradle and of an array of cantilevers */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("scale.contact_time") {
  answer(table("collision")["contact_time"]);
}

STATEMENT("scale.max_compression") {
  answer(table("collision")["compression"]);
}

STATEMENT("scale.cradle") {
  answer(table("cradle").at("digits", "printed", "g", 10)["impact"]);
}

STATEMENT("beam.stiffness") {
  answer(table("beam")["stiffness"]);
}

STATEMENT("beam.frequency") {
  answer(table("beam")["frequency"]);
}

STATEMENT("beam.mass") {
  answer(table("beam")["mass"]);
}

STATEMENT("cantilever.tau_h") {
  answer(table("array")["tau_h"]);
}

STATEMENT("cantilever.tau_c") {
  answer(table("array")["tau_c"]);
}

STATEMENT("cantilever.lambda") {
  answer(table("array")["lambda"]);
}

STATEMENT("outlook.dominated") {
  answer(table("losses").at("period", "printed")["epsilon"]);
}
