#pragma once
/**
# One impact in hard wells, with your own parameters

`sec34_boomeron run --velocity 1.9 --s 1 --time 1000` prints turning point, rebound, and the time at which two impacts
that differ by a fraction $10^{-8}$ have decorrelated, looked for up to four times as long. What did not happen in the
given time is `nan`. The step is halved until turning point and rebound of two runs agree to the tolerance, and what is
left of their difference is `step_difference`; where they do not agree, the motion became chaotic first, and the command
fails. The errors of the times also hold what another width of the smoothing would change. Nothing returns from the far
end of the chain, unless `--sites` gives it a length; where the far end moves the command fails. */

#include <cstddef>
#include <optional>

#include "lattice/integrators/integrate.hpp"
#include "lattice/model/chain.hpp"
#include "report/program.hpp"

namespace lattice {

/// The command: the impact (dimensionless) and how long it is followed.
struct OneTurn {
  static constexpr Title title{"run", "one impact: apex, rebound, decorrelation"};
  double velocity = 1.9, time = 1000, tolerance = 1e-3;
  std::optional<std::size_t> sites{};  // otherwise as many as needed
  Chain like{.well = Quartic{1}};

  void parameters(Parameters& p);
  /// Throws RefinementFailed and FarEndReached.
  Table table() const;
};

/**
Steps that are too long part two impacts as well. So the two are run with equal steps, with half of them, and with one
of each beside the other, until these agree on the time within the two units between two comparisons. */
/// The time at which the states `a`, advanced by the method `first`, and `b`, advanced by `second`, first differ by a
/// tenth of the largest displacement or velocity; infinite if they do not by `time`. Both belong to `chain`.
double decorrelation_time(const Method& first, State<double> a, const Method& second,
                          State<double> b, const Chain& chain, double time);

}  // namespace lattice
