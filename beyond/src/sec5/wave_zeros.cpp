#include "sec5/wave_zeros.hpp"

#include "sec5/travelling.hpp"

namespace lattice {

double kappa_of(const KernelWave& w, double times) {
  Chain chain{2 * usual_half_length + 2};
  chain.contact = w.law;
  EventTolerance<double> rule;
  const double twice = 2 * w.law.exponent;
  rule.tolerance *= twice == std::round(twice) ? times : 8 * times;
  // A contact that is hard to land on may need more than that
  for (int tries = 0; tries < 8; ++tries, rule.tolerance *= 8) try {
      const auto map = shifted_map(chain, w.state(usual_half_length), w.shift_time(), rule);
      return phase_kappa(multipliers_of(map));
    } catch (const NewtonFailed&) {
    }
  return std::nan("");
}

}  // namespace lattice
