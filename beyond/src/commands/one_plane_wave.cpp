#include "commands/one_plane_wave.hpp"

#include <cmath>
#include <string>

#include "sec5/dps_waves.hpp"

namespace lattice {

void OnePlaneWave::parameters(Parameters& p) {
  p.add("q", q, "wavenumber q of the plane wave", {1e-6, std::numbers::pi, "1/site"});
  p.add("modulation", modulation, "wavenumber Q of the modulation",
        {1e-6, std::numbers::pi, "1/site"});
  p.add("amplitude", amplitude, "modulus |A| of the plane wave", {1e-12, 1e12});
}

Table OnePlaneWave::table() const {
  const auto both = [this](auto of) { return in_two_precisions(q, of, amplitude); };
  // The wave and this modulation, then all modulations
  const std::string stable = std::string("the wave is ") +
                             (std::abs(std::cos(q)) < 1e-9 ? "marginal" : "stable") +
                             ": none of its modulations grows exponentially";
  Answers answers;
  answers.add("frequency", both([](const auto& w) { return w.frequency(); }), "",
              "frequency Omega of the plane wave in the slow time of the DpS equation");
  answers.add_small(
      "growth", both([this](const auto& w) { return w.growth(modulation); }), "",
      "growth rate, in slow time, of the modulation with this Q; 0 if it does not grow");
  answers.add_small("edge", both([](const auto& w) { return w.edge(); }), "1/site",
                    std::cos(q) > -0.2 ? "edge Q_* above which all modulations grow, up to Q = pi"
                                       : "edge Q_* below which all modulations grow, down to Q = 0",
                    stable);
  answers.add_small("fastest", both([](const auto& w) { return w.fastest(); }), "1/site",
                    "wavenumber Q of the modulation that grows fastest", stable);
  answers.add_small(
      "fastest_growth",
      both([](const auto& w) { return w.unstable() ? w.growth(w.fastest()) : 0; }), "",
      "growth rate, in slow time, of the fastest-growing modulation; 0 if none grows");
  return answers.table;
}

}  // namespace lattice
