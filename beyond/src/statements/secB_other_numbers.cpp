/**
# Statements of the appendix: Numbers of other authors */

#include "report/statement.hpp"

using namespace lattice;
using namespace report;

STATEMENT("fragment_1") {
  answer(table("rebounds").at("ball", 1)["velocity"]);
}

STATEMENT("fragment_2") {
  answer(table("rebounds").at("ball", 2)["velocity"]);
}

STATEMENT("fragment_4") {
  answer(table("rebounds").at("ball", 4)["velocity"]);
}

STATEMENT("fragment_8") {
  answer(table("rebounds").at("ball", 8)["velocity"]);
}

STATEMENT("fragment_16") {
  answer(table("rebounds").at("ball", 16)["velocity"]);
}

STATEMENT("pulse_energy") {
  answer(table("pulse")["energy"]);
}

STATEMENT("pulse_amplitude") {
  answer(table("pulse")["amplitude"]);
}

STATEMENT("pulse_slower") {
  answer(table("solitary_wave")["slower"]);
}

STATEMENT("pulse_narrower") {
  answer(table("solitary_wave")["narrower"]);
}

STATEMENT("sampled_width") {
  answer(table("pulse")["sampled_width"]);
}

STATEMENT("pulse_kinetic") {
  answer(table("solitary_wave")["kinetic"]);
}

STATEMENT("exponent_hertz") {
  answer(table("exponents").at("others", 2.5)["exponent"]);
}

STATEMENT("exponent_four") {
  answer(table("exponents").at("others", 4)["exponent"]);
}

STATEMENT("sen_c1") {
  answer(table("solitary_wave")["c1"]);
}

STATEMENT("dimer_1") {
  answer(table("dimers").at("about", 0.34)["mass_ratio"]);
}

STATEMENT("dimer_2") {
  answer(table("dimers").at("about", 0.155)["mass_ratio"]);
}

STATEMENT("dimer_3") {
  answer(table("dimers").at("about", 0.09)["mass_ratio"]);
}

STATEMENT("dimer_4") {
  answer(table("dimers").at("about", 0.0615)["mass_ratio"]);
}
