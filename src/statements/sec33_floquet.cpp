/**
# Statements of section 3.3: Floquet multipliers of the breathers of the chain */

#include <utility>

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("floquet.spectrum") {
  const Data all = table("spectra");
  for (const Data& line :
       {all.where("s", 0).where("omega", 1.01, 2), all.where("omega", 1.1).where("s", -1, 1)})
    for (const auto& breather : line) {
      less(breather["fourth"], 0.01);
      less(breather["fourth"] / breather["fifth"], 0.1);
      less(breather["others"], 1e-3);
    }
  // Ten more sites add twenty multipliers at exp(+-2 pi i / omega_b)
  for (const auto& longer : table("edges").where("s", -1, 1)) near(longer["added"], 20, 0.5);
}

STATEMENT("floquet.s0_bond") {
  answer(table("exchange")["bond"]);
}

STATEMENT("floquet.s0_site") {
  answer(table("exchange")["site"]);
}

STATEMENT("floquet.harmonic") {
  // kappa > 0: the pinning pair is real and the breather unstable
  const Data breathers = table("harmonic");
  less(0, breathers.at("centre", "site")["kappa"]);
  less(breathers.at("centre", "bond")["kappa"], 0);
  for (const auto& breather : breathers) less(breather["off_circle"], 0.5);
}

STATEMENT("floquet.instability_size") {
  for (const char* wells : {"site_against_s", "bond_against_s"})
    for (const auto& well : table(wells).where("s", -1, 1)) less(well["largest_modulus"] - 1, 1e-3);
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
    less(well["off_circle"], 0.5);
}

STATEMENT("floquet.weaker") {
  answer(table("slow_limit")["exponent"]);
}

STATEMENT("exchange.equal") {
  const Estimate site = table("exchange")["site"], bond = table("exchange")["bond"];
  less(site, bond);
  within(site, 0.15, 0.155);
  less(bond - site, 1e-6);

  // The site-centred breather becomes stable there, and the other one unstable
  for (const auto& [s, is_before] : {std::pair{0.1, true}, {1.0, false}}) {
    const Estimate of_site = table("site_against_s").at("s", s)["kappa"],
                   of_bond = table("bond_against_s").at("s", s)["kappa"];
    less(0, is_before ? of_site : of_bond);
    less(is_before ? of_bond : of_site, 0);
  }
  for (const auto& well : table("spectra").where("omega", 1.1).where("s", -1, 1))
    less(well["off_circle"], 0.5);
}
