/**
# Statements of the appendix: The order of integrators at contact events */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("integrators.order") {
  const Data open = table("orders").where("contacts", "open"),
             closed = table("orders").where("contacts", "closed");
  // At contact events splittings of order four and six lose it
  for (const char* splitting : {"blanes_moan_4", "blanes_moan_6"})
    less(open.at("method", splitting)["order"], 3);
  less(open.at("method", "blanes_moan_6")["order"], closed.at("method", "blanes_moan_6")["order"]);

  // A correct impulse at each event restores most of it
  less(4, open.at("method", "contact_aware")["order"]);
}
