/**
# Statements of section 3.4: A weak impact, in the chain and in the DpS equation */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("impact.dps_breather") {
  less(fact("dps_breather_speed_change"), 0.05);
  less(fact("dps_breather_energy_change"), 0.1);
  less(fact("dps_breather_residue"), 1);
}

STATEMENT("impact.amp_full") {
  answer(fact("height_lattice_8091"));
}

STATEMENT("impact.amp_dps") {
  answer(fact("height_dps_8091"));
}

STATEMENT("impact.speed_order") {
  const Estimate tau_per_time{std::sqrt(0.9548e-3), 1e-6};  // eps as printed
  less(fact("lattice_speed"), tau_per_time * fact("dps_speed"));
}

STATEMENT("impact.support") {
  // A hundredth of the peak is still visible in a plot
  less(0.01, fact("support_outermost"));
  less(fact("support_next"), 0.01);
}

STATEMENT("impact.wavetrain") {
  answer(fact("wavetrain"));
}

STATEMENT("impact.residual_extended") {
  answer(fact("residual_extended"));
}

STATEMENT("impact.scales_fig17") {
  answer(fact("time_of_tau_250"));
}
