/**
# Statements of the appendix: The order of integrators at contact events */

#include <string>

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("integrators.order") {
  // At contact events splittings of order four and six lose it
  for (const std::string splitting : {"blanes_moan_4", "blanes_moan_6"})
    less(fact("order_" + splitting), 3);
  less(fact("order_blanes_moan_6"), fact("order_closed_blanes_moan_6"));

  // A correct impulse at each event restores most of it
  less(4, fact("order_contact_aware"));
}
