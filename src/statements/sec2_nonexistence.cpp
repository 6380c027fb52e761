/**
# Statements of section 2: No breathers without an on-site potential */

#include "report/statement.hpp"

using namespace report;

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
  const Data free = table("dispersal").where("motion", "breather"),
             wells = table("dispersal").where("motion", "breather_in_wells");
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
  // Without wells localized motions lose their energy for good: none comes back to its start
  const auto kept = [&](const char* motion) {
    return table("dispersal").where("motion", motion).where("t", 20, 200);
  };
  for (const char* motion : {"breather", "displaced", "kicked", "pair"})
    less(largest(kept(motion), "core"), bound(0.1));
  control([&] { less(1 - bound(0.01), least(kept("breather_in_wells"), "core")); });
}

STATEMENT("thm.wells") {
  // In wells the mean force falls from contact to contact, outwards from the centre of a breather
  for (const char* breather : {"breather_bond", "breather_site"}) {
    const Data means = table("mean_forces").where("motion", breather);
    for (int n = 13; n < 18; ++n) less(means.at("n", n + 1)["force"], means.at("n", n)["force"]);
  }
}
