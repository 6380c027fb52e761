/**
# Statements of section 2: No breathers without an on-site potential */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("thm.mean_force") {
  // Without wells every contact of a periodic motion has the same mean force, which is not zero
  const Data means = table("mean_forces");
  for (const char* periodic : {"uneven_ring", "walls"}) {
    const Data contacts = means.where("motion", periodic);
    const Estimate most = largest(contacts, "force");
    for (const auto& contact : contacts) {
      less((most - contact["force"]) / most, bound(1e-8));
      control([&] { less(bound(1e-3), contact["force"]); });
    }
  }
  control([&] {
    const Data other = means.where("motion", "not_returning");
    less(bound(1e-5), (largest(other, "force") - least(other, "force")) / largest(other, "force"));
  });

  // A localized state disperses and its mean push falls like 1/t; in wells both remain
  const Data free = table("dispersal").where("chain", "free"),
             wells = table("dispersal").where("chain", "wells");
  const auto late = [](const Data& chain) {
    return chain.at("t", 200)["mean"] / chain.at("t", 100)["mean"];
  };
  less(free.at("t", 200)["core"], bound(0.1));
  near(late(free), 0.5, bound(0.1));
  control([&] {
    less(1 - bound(0.01), wells.at("t", 200)["core"]);
    near(late(wells), 1, bound(0.1));
  });
}

STATEMENT("thm.equilibria") {
  // In free chains no localized motion comes back to its start; a sequence that increases stays
  const Data returns = table("returns");
  for (const char* chain : {"equal", "uneven"}) {
    for (const char* start : {"displaced", "kicked", "pair", "breather", "step_down"})
      less(bound(0.1), returns.at("start", start, "chain", chain)["back"]);
    less(returns.at("start", "increasing", "chain", chain)["away"], bound(1e-12));
  }
  control([&] { less(returns.at("chain", "wells")["back"], bound(0.01)); });
}

STATEMENT("thm.wells") {
  // In wells the mean force falls from contact to contact, outwards from the centre of a breather
  for (const char* breather : {"breather_bond", "breather_site"}) {
    const Data means = table("mean_forces").where("motion", breather);
    for (int n = 13; n < 18; ++n) less(means.at("n", n + 1)["force"], means.at("n", n)["force"]);
  }
}
