/**
# Statements: 3.3 floquet multipliers of the breathers of the chain */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("floquet.spectrum") {
  less(fact("spectrum_fourth"), 0.01);
  less(fact("spectrum_share_of_fifth"), 0.1);
  less(fact("spectrum_others"), 1e-3);
  less(fact("spectrum_not_at_edge"), 0.5);
}

STATEMENT("floquet.s0_bond") {
  answer(fact("exchange_bond"));
}

STATEMENT("floquet.s0_site") {
  answer(fact("exchange_site"));
}

STATEMENT("floquet.harmonic") {
  less(0, fact("kappa_site"));
  less(fact("kappa_bond"), 0);
  less(fact("harmonic_off_circle"), 0.5);
}

STATEMENT("floquet.instability_size") {
  less(fact("largest_excess"), 1e-3);
}

STATEMENT("pinning.gradient") {
  answer(fact("cosine_bond"));
}

STATEMENT("outlook.sign_of_s") {
  less(0, fact("kappa_s_01_site"));
  less(fact("kappa_s_01_bond"), 0);
  less(fact("kappa_s_1_site"), 0);
  less(0, fact("kappa_s_1_bond"));
  less(0, fact("kappa_s_minus_1_site"));
  less(fact("kappa_s_minus_1_bond"), 0);
  less(fact("others_off_circle"), 0.5);
}

STATEMENT("floquet.weaker") {
  answer(fact("rate_exponent"));
}

STATEMENT("exchange.equal") {
  less(fact("exchange_site"), fact("exchange_bond"));
  less(0.15, fact("exchange_site"));
  less(fact("exchange_bond"), 0.155);
  less(fact("exchange_gap"), 1e-6);
  less(fact("others_off_circle"), 0.5);
}
