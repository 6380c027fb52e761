/**
# Statements: 3.2 the Peierls-Nabarro barrier */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("pn.omega11") {
  answer(fact("equal_frequency_linear_110"));
  accuracy(fact("hidden_energy"));
}

STATEMENT("pn.small") {
  answer(fact("equal_frequency_linear_101"));
}

STATEMENT("pn.omega15") {
  answer(fact("equal_frequency_soft_150"));
}

STATEMENT("pn.harmonic_ratio") {
  answer(fact("harmonic_ratio_soft"));
}

STATEMENT("pn.grows") {
  less(1, fact("amplitude_least_growth"));
  less(1, fact("arches_least_growth"));
  less(1, fact("end_over_highest_before"));
}

STATEMENT("pn.remains_small") {
  answer(fact("largest_relative"));
}

STATEMENT("pn.ratio_smallest") {
  less(fact("relative_mean_linear"), fact("relative_mean_soft"));
  less(fact("relative_mean_linear"), fact("relative_mean_hard"));
}

STATEMENT("barrier.signs") {
  less(6.5, fact("zeros_linear"));
  less(13.5, fact("zeros_soft"));
  less(fact("zeros_hard"), 1.5);
}

STATEMENT("barrier.equal_area") {
  within(fact("equal_area_law"), 0.95, 1.05);
  less(fact("equal_area_linear_110"), 0);
  less(0, fact("equal_frequency_linear_110"));
}
