/**
# Statements of section 3.3: Floquet multipliers of the breathers of the chain */

#include <algorithm>
#include <string>
#include <utility>

#include "report/statement.hpp"

using namespace report;

STATEMENT("floquet.spectrum") {
  const auto structure = [&](const Data& breathers) {
    for (const auto& breather : breathers) {
      less(breather["fourth"], bound(0.01));
      less(bound(3), breather["at_edge"]);
    }
  };
  structure(table("spectra").where("omega", 1.01, 2));
  reading("plotted", [&] { structure(table("spectra").where("omega", 1.1).where("s", -1, 1)); });
}

STATEMENT("floquet.s0_bond") {
  answer(table("exchange")["bond"]);
}

STATEMENT("floquet.s0_site") {
  answer(table("exchange")["site"]);
}

STATEMENT("floquet.collision") {
  const Data near_one = table("spectra").where("omega", 1.1);
  const double side[] = {-1,
                         1};  // where the pair is real: below around a site, above around a bond
  for (const char* centre : {"site", "bond"}) {
    const bool is_bond = std::string(centre) == "bond";
    const double s_0 = table("exchange")[centre].value;
    for (const auto& well : table(std::string(centre) + "_against_s").where("s", -1, 1)) {
      if (side[is_bond] * (well("s") - s_0) > 0)
        less(0, well["kappa"]);
      else
        less(well["kappa"], 0);
    }
    // Where it leaves the circle or comes back, between these two wells, it is at +1
    double below = -1, above = 1;
    for (const auto& well : near_one.where("centre", centre))
      if (well("s") < s_0)
        below = std::max(below, well("s"));
      else
        above = std::min(above, well("s"));
    for (const double s : {below, above})
      less(near_one.at("centre", centre, "s", s)["fourth"], bound(1e-4));
  }
}

STATEMENT("floquet.harmonic") {
  // kappa > 0: the pinning pair is real and the breather unstable, by as little as the conclusion says
  const Data breathers = table("harmonic");
  less(0, breathers.at("centre", "site")["kappa"]);
  less(table("site_against_s").at("s", 0)["largest_modulus"] - 1, 1e-3);
  less(breathers.at("centre", "bond")["kappa"], 0);
  for (const auto& breather : breathers) less(breather["others"], bound(1e-6));
}

STATEMENT("floquet.instability_size") {
  for (const char* wells : {"site_against_s", "bond_against_s"})
    for (const auto& well : table(wells).where("s", -1, 1)) less(well["largest_modulus"] - 1, 1e-3);
  reading("section", [&] {
    for (const auto& breather : table("spectra").where("omega", 1.01, 2))
      less(breather["largest"], 1e-3);
  });
}

STATEMENT("pinning.gradient") {
  answer(table("harmonic").at("centre", "bond")["cosine"]);
}

STATEMENT("outlook.sign_of_s") {
  // A breather is unstable where kappa > 0
  const Data site = table("site_against_s"), bond = table("bond_against_s");
  for (double s : {-1.0, 0.1}) {
    less(0, site.at("s", s)["kappa"]);
    less(bond.at("s", s)["kappa"], 0);
  }
  less(site.at("s", 1)["kappa"], 0);
  less(0, bond.at("s", 1)["kappa"]);
  for (const auto& well : table("spectra").where("omega", 1.1).where("s", -1, 1))
    less(well["others"], bound(1e-6));
}

STATEMENT("floquet.weaker") {
  answer(table("slow_limit")["exponent"]);
}

STATEMENT("exchange.equal") {
  const Estimate site = table("exchange")["site"], bond = table("exchange")["bond"];
  less(site, bond);
  less(0.055, site);  // farther from both printed values than these were rounded
  less(bond, 0.255);
  less(bond - site, bound(1e-6));

  // The site-centred breather becomes stable there, and the other one unstable
  for (const auto& [s, is_before] : {std::pair{0.1, true}, {1.0, false}}) {
    const Estimate of_site = table("site_against_s").at("s", s)["kappa"],
                   of_bond = table("bond_against_s").at("s", s)["kappa"];
    less(0, is_before ? of_site : of_bond);
    less(is_before ? of_bond : of_site, 0);
  }
  for (const auto& well : table("spectra").where("omega", 1.1).where("s", -1, 1))
    less(well["others"], bound(1e-6));
}
