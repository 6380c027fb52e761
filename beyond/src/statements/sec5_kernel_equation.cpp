/**
# Statements of section 5: A theorem: exact travelling breathers exist */

#include <string>

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("travelling.exchanges") {
  // The last and the ninth exchange of the quotients
  less(5, fact("exchange_1"));
  less(fact("exchange_9"), 1.4);

  // Those of the pinned phase are not at the same exponent for both signs
  for (const std::string exchange : {"exchange_1", "exchange_2"})
    less(fact("kappa_plus_" + exchange), fact("kappa_minus_" + exchange));
  less(34, fact("phases_agree"));  // of 35 exponents
}
