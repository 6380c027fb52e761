/**
# Statements of section 5: Exact travelling breathers */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("travelling.speeds") {
  less(fact("missed"), 1e-15);
  within(fact("turns_type_two_1"), 0.89, 0.9);
}

STATEMENT("travelling.stability") {
  // Pinned with the sign plus, unstable with the sign minus, and everything else decays
  less(fact("kappa_k1_plus"), 0);
  less(0, fact("kappa_k1_minus"));
  less(fact("next_modulus_k1_plus"), 0.9);
}

STATEMENT("travelling.wells") {
  less(fact("fold_k1"), fact("fold_k2"));
  less(fact("fold_k2"), fact("fold_k3"));
}

STATEMENT("travelling.packets") {
  // The second shift time lies between those of two exact orbits
  within(fact("final_turns_v66"), 1.1, 1.2);
  within(fact("final_turns_v150"), fact("turns_type_two_2"), fact("turns_type_two_1"));
  less(-0.8, fact("tail_exponent_v66"));
}
