/**
# Statements of section 3.3: Kicked breathers and the depinning threshold */

#include "report/statement.hpp"

using namespace report;

static Quantity speed(const Data& strong_kicks, const char* breather) {
  return strong_kicks.at("breather", breather)["speed"];
}

STATEMENT("moving.v_site") {
  const Data kicks = table("strong_kicks");
  answer(speed(kicks, "site"));
  reading("along the mode", speed(kicks, "site_along_mode"));
}

STATEMENT("moving.v_bond") {
  const Data kicks = table("strong_kicks");
  answer(speed(kicks, "bond_stretched"));
  reading("compressed", speed(kicks, "bond_compressed"));
  reading("along the mode", speed(kicks, "bond_along_mode"));
}

STATEMENT("moving.steady") {
  for (const char* breather : {"site", "bond_stretched", "bond_compressed"})
    less(table("strong_kicks").at("breather", breather)["unsteadiness"], bound(0.01));
}

STATEMENT("moving.dispersion") {
  for (const char* breather : {"site", "bond_stretched", "bond_compressed"})
    less(table("strong_kicks").at("breather", breather)["outside"], bound(0.01));
}

STATEMENT("moving.kick_energy") {
  const auto norm = table("printed_norm")["norm"];
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
  const auto stays = [&](const char* breather) {
    less(table("weak_kicks").at("breather", breather)["farthest"], 3);
  };
  reading("opposite sign", [&] { stays("site_reversed"); });
  reading("along the mode", [&] { stays("site_along_mode"); });
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
    return abs(speed(kicks, bond) / speed(kicks, "site") - 1);
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
  const Data chain = table("thresholds");
  answer(chain.at("breather", "bond_stretched")["threshold"]);
  reading("compressed", chain.at("breather", "bond_compressed")["threshold"]);
}

STATEMENT("moving.pn_dynamic") {
  const Estimate c = table("thresholds").at("breather", "bond_stretched")["threshold"];
  answer({{0.5 * c * c}});
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
