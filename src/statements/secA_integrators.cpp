/**
# Statements: Appendix the order of integrators at contact events */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("integrators.order") {
  less(fact("order_blanes_moan_4"), 3);
  less(fact("order_blanes_moan_6"), 3);
  less(4, fact("order_contact_aware"));
  less(fact("order_blanes_moan_6"), fact("order_closed_blanes_moan_6"));
}
