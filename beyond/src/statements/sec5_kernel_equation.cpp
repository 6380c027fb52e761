/**
# Statements: 5 a theorem: exact travelling breathers exist */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("travelling.exchanges") {
  less(5, fact("exchange_1"));
  less(fact("exchange_9"), 1.4);
  less(fact("kappa_plus_exchange_2"), fact("kappa_minus_exchange_2"));
  less(fact("kappa_plus_exchange_1"), fact("kappa_minus_exchange_1"));
  less(34, fact("phases_agree"));
}
