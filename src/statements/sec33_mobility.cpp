/**
# Statements of section 3.3: Kicked breathers and the depinning threshold */

#include "report/statement.hpp"

using namespace lattice;

static Data strong(Data kicks, const char* breather, const char* kick = nullptr) {
  const Data of = kicks.where("breather", breather);
  return kick ? of.where("kick", kick) : of;
}

STATEMENT("moving.v_site") {
  const Data other = table("other_strong");
  answer(strong(table("strong_kicks"), "site")["speed"]);
  reading("opposite sign", strong(other, "site", "reversed")["speed"]);
  reading("along the mode", strong(other, "site", "along_mode")["speed"]);
}

STATEMENT("moving.v_bond") {
  const Data kicks = table("strong_kicks"), other = table("other_strong");
  answer(strong(kicks, "bond_stretched")["speed"]);
  reading("compressed", strong(kicks, "bond_compressed")["speed"]);
  reading("along the mode", strong(other, "bond_stretched", "along_mode")["speed"]);
  reading("compressed along the mode", strong(other, "bond_compressed", "along_mode")["speed"]);
}

STATEMENT("moving.steady") {
  for (const char* breather : {"site", "bond_stretched", "bond_compressed"})
    less(strong(table("strong_kicks"), breather)["unsteadiness"], bound(0.01));
}

STATEMENT("moving.dispersion") {
  for (const char* breather : {"site", "bond_stretched", "bond_compressed"})
    less(strong(table("strong_kicks"), breather)["outside"], bound(0.01));
}

STATEMENT("moving.kick_energy") {
  const auto norm = table("readings").at("breather", "bond_stretched")["printed_norm"];
  const auto kick = table("strong_kicks").at("breather", "bond_stretched")["kick"];
  answer(kick);
  reading("norm as printed", kick * norm * norm);
}

STATEMENT("moving.site_moves") {
  less(2, table("weak_kicks").at("breather", "site")["farthest"]);
}

STATEMENT("moving.site_below") {
  // Pinned after two sites, it never passes a third one
  less(table("weak_kicks").at("breather", "site")["farthest"], 3);
  const Data other = table("other_weak");
  reading("opposite sign", [&] { less(other.at("kick", "reversed")["farthest"], 3); });
  reading("along the mode", [&] { less(other.at("kick", "along_mode")["farthest"], 3); });
}

STATEMENT("moving.above_below") {
  const Estimate barrier =
      table("sec32_barrier", "key_pairs").at("s", 0, "omega", 1.1)["equal_frequency"];
  less(0.5 * 3e-6 * 3e-6, barrier);
  for (const char* breather : {"site", "bond_stretched", "bond_compressed"})
    less(bound(10) * barrier, table("strong_kicks").at("breather", breather)["kick"]);
}

STATEMENT("moving.speeds_close") {
  const Data kicks = table("strong_kicks");
  const auto apart = [&](const char* bond) {
    return abs(kicks.at("breather", bond)["speed"] / kicks.at("breather", "site")["speed"] - 1);
  };
  answer(apart("bond_stretched"), "relative");
  reading("compressed", apart("bond_compressed"));
}

STATEMENT("moving.bond_pinned") {
  for (const char* bond : {"bond_stretched", "bond_compressed"}) {
    const auto kick = table("weak_kicks").at("breather", bond);
    less(kick["farthest"], exact(0.5));  // the next site
    less(0, kick["came_back"]);
  }
}

STATEMENT("moving.c_threshold") {
  const Data chain = table("thresholds"), other = table("readings");
  answer(chain.at("breather", "bond_stretched")["threshold"]);
  reading("compressed", chain.at("breather", "bond_compressed")["threshold"]);
  reading("along the mode", other.at("breather", "bond_stretched")["along_mode"]);
  reading("compressed along the mode", other.at("breather", "bond_compressed")["along_mode"]);
}

STATEMENT("moving.pn_dynamic") {
  answer(table("thresholds").at("breather", "bond_stretched")["energy"]);
}

STATEMENT("moving.barrier_close") {
  const Data chain = table("thresholds");
  answer(chain.at("breather", "bond_stretched")["over_barrier"]);
  reading("compressed", chain.at("breather", "bond_compressed")["over_barrier"]);
}

STATEMENT("depinning.law") {
  for (const char* contact : {"bond_stretched", "bond_compressed"}) {
    const auto bond = table("thresholds").at("breather", contact);
    near(bond["predicted"], bond["threshold"], bound(1e-3) * bond["threshold"]);
    // A small fraction, and negative as is the effective mass of the translation
    within(bond["kinetic_share"], -bound(0.1), 0);
  }
}
