/**
# Statements: 3.6 scattering of a breather by a defect in an array of cantilevers */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("cantilever.speed") {
  answer(fact("speed_mean"));
}

STATEMENT("cantilever.bead_velocity") {
  answer(fact("bead_velocity"));
}

STATEMENT("cantilever.deflection") {
  answer(fact("deflection"));
}

STATEMENT("cantilever.force") {
  answer(fact("force"));
}

STATEMENT("cantilever.duration") {
  answer(fact("duration_thousandth"));
}

STATEMENT("cantilever.period") {
  answer(fact("period"));
}

STATEMENT("cantilever.reflect16") {
  within(fact("net_reflected_16"), 0.95, 1);
}

STATEMENT("cantilever.partial11") {
  within(fact("net_transmitted_11"), 0.1, 0.9);
}

STATEMENT("cantilever.trapped") {
  answer(fact("before_75_16"));
}

STATEMENT("outlook.travel_10ms") {
  answer(fact("travel_10ms"));
}

STATEMENT("outlook.periods_10ms") {
  answer(fact("periods_10ms"));
}

STATEMENT("cantilever.dps_valid") {
  answer(fact("dps_deflection_apart"));
}

STATEMENT("cantilever.frequency") {
  answer(fact("frequency"));
}

STATEMENT("outlook.small_period") {
  answer(fact("small_period"));
}

STATEMENT("outlook.ranges") {
  answer(fact("range_load"));
}

STATEMENT("cantilever.wavetrain") {
  answer(fact("wavetrain_sites"));
}

STATEMENT("cantilever.total_reflection") {
  less(0.95, fact("total_reflection_least"));
  less(fact("total_reflection_most"), 1);
}

STATEMENT("defect.map") {
  less(0.99, fact("net_reflected_16"));
  less(0.04, fact("most_trapped"));
  less(fact("most_trapped_at"), 0.98);
  less(0.99, fact("kept_0925"));
  less(fact("kept_16"), fact("kept_0925"));
}
