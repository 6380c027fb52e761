/**
# Statements of the appendix: The order of integrators at contact events */

#include "report/statement.hpp"

using namespace report;

STATEMENT("integrators.order") {
  const Data open = table("orders").where("contacts", "open"),
             closed = table("orders").where("contacts", "closed");
  // At contact events splittings of order four and six lose it
  for (const char* splitting : {"blanes_moan_4", "blanes_moan_6"})
    less(open.at("method", splitting)["order"] + bound(0.5),
         closed.at("method", splitting)["order"]);

  // Correct impulses within six steps of each event restore more than order four, in impacts and at single events
  less(closed.at("method", "blanes_moan_4")["order"], open.at("method", "six_steps")["order"]);
  const Data events = table("event_orders");
  for (const char* name : {"closing", "opening", "grazing"}) {
    const auto event = events.at("event", name);
    less(event["plain"] + bound(0.75), event["six"]);
    // Within two steps they do so while steps are long, and short steps follow the law without corrections
    less(event["two_short"] + bound(0.75), event["two_long"]);
    near(event["two_short"], event["plain"], bound(0.5));
  }
}
