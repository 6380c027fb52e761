#include "lattice/orbits/newton.ipp"

#include <cstdio>

#include "lattice/model/precisions.hpp"
#include "lattice/orbits/shooting.ipp"

namespace lattice {

/// Residuals in one line.
static std::string to_text(const History& history) {
  std::string text;
  for (const Iteration& i : history) {
    char buffer[48];
    std::snprintf(buffer, sizeof buffer, "%s%.1e", text.empty() ? "" : ", ", i.residual);
    text += buffer;
  }
  return text;
}

NewtonFailed::NewtonFailed(const std::string& what, History steps)
    : std::runtime_error(what + (steps.empty() ? "" : "; relative residuals " + to_text(steps))),
      history(std::move(steps)) {}

LATTICE_IN_EACH_PRECISION(LATTICE_NEWTON)
LATTICE_IN_EACH_PRECISION(LATTICE_SHOOTING)

#ifndef __wasm__
// An orbit begins at one of double precision, or of extended precision
template Orbit<long double> newton<long double, long double>(const Shooting<long double>&,
                                                             const Orbit<long double>&,
                                                             const NewtonRule<long double>&);
#endif

}  // namespace lattice
