/**
# Statements of section 3.2: Static breathers of the DpS equation */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("dps.scaling") {
  answer(fact("scaling"));
}

STATEMENT("dps.qc_support") {
  answer(fact("qc_support"));
}

STATEMENT("dps.qc_site") {
  answer(fact("qc_difference_site"));
}

STATEMENT("dps.qc_bond") {
  answer(fact("qc_difference_bond"));
}
