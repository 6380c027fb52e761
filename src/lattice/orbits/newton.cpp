#include "lattice/orbits/newton.ipp"

#include <cstdio>

#include "lattice/model/precisions.hpp"

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

}  // namespace lattice
