#include "sec34/loose_steps.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lattice {

const std::pair<ErrorNorm, const char*> norms[] = {
    {ErrorNorm::rms, "rms"}, {ErrorNorm::two, "two"}, {ErrorNorm::largest, "largest"}};

// Two methods, three norms, eight tolerances; then longer chains
std::vector<LooseSteps> loose_settings(std::size_t sites) {
  std::vector<LooseSteps> all;
  for (const RungeKutta& method : {dormand_prince_5(), fehlberg_5()})
    for (const auto& [norm, name] : norms)
      for (double relative : {1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 1e-5})
        all.push_back({method, norm, relative, sites});
  for (std::size_t longer : {100U, 150U, 200U, 300U, 400U})
    all.push_back({dormand_prince_5(), ErrorNorm::rms, 1e-3, longer});
  return all;
}

std::string name_of(ErrorNorm norm) {
  const auto same = [&](const auto& named) { return named.first == norm; };
  return std::find_if(std::begin(norms), std::end(norms), same)->second;
}

// The first step is a tenth of the interval between two samples
DpsPair loose_runs(const LooseSteps& how, double tau_end, std::size_t samples) {
  const auto run = [&](std::size_t count) {
    return follow_dps_by(Dps{how.sites}, dps_impact(how.sites),
                         [&](const Rhs& rhs, std::vector<double>& x, const auto& observe) {
                           integrate_controlled(how.method, rhs, x, tau_end, count,
                                                {how.relative, 1e-3 * how.relative, how.norm,
                                                 0.1 * tau_end / double(count)},
                                                observe);
                         });
  };
  return {run(samples), run(2 * samples)};
}

// The norm of the start is one
double growth(const DpsOutcome& out) {
  return norm(out.end) - 1;
}
double train_difference(const DpsOutcome& out, const DpsOutcome& converged) {
  double difference = 0, all = 0;
  for (std::size_t n = 0; n < 60; ++n) {
    const double off = std::abs(out.end[n]) - std::abs(converged.end[n]);
    difference += off * off;
    all += std::norm(converged.end[n]);
  }
  return std::sqrt(difference / all);
}

}  // namespace lattice
