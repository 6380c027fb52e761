/**
# Statements of the appendix: Numbers of other authors */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("fragment_1") {
  answer(fact("fragment_1"));
}

STATEMENT("fragment_2") {
  answer(fact("fragment_2"));
}

STATEMENT("fragment_4") {
  answer(fact("fragment_4"));
}

STATEMENT("fragment_8") {
  answer(fact("fragment_8"));
}

STATEMENT("fragment_16") {
  answer(fact("fragment_16"));
}

STATEMENT("pulse_energy") {
  answer(fact("pulse_energy"));
}

STATEMENT("pulse_amplitude") {
  answer(fact("pulse_amplitude"));
}

STATEMENT("pulse_slower") {
  answer(fact("pulse_slower"));
}

STATEMENT("pulse_narrower") {
  answer(fact("pulse_narrower"));
}

STATEMENT("sampled_width") {
  answer(fact("sampled_width"));
}

STATEMENT("pulse_kinetic") {
  answer(fact("pulse_kinetic"));
}

STATEMENT("exponent_hertz") {
  answer(fact("exponent_hertz"));
}

STATEMENT("exponent_four") {
  answer(fact("exponent_four"));
}

STATEMENT("sen_c1") {
  answer(fact("sen_c1"));
}

STATEMENT("dimer_1") {
  answer(fact("dimer_1"));
}

STATEMENT("dimer_2") {
  answer(fact("dimer_2"));
}

STATEMENT("dimer_3") {
  answer(fact("dimer_3"));
}

STATEMENT("dimer_4") {
  answer(fact("dimer_4"));
}
