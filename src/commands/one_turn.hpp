#pragma once
/**
# One impact in hard wells, with your own parameters

`sec34_boomeron run --velocity 1.9 --s 1 --time 1000` prints turning point, rebound, and the time at which two impacts
that differ by a fraction $10^{-8}$ have decorrelated, looked for up to four times as long. What did not happen in the
given time is `nan`. The step is halved until turning point and rebound of two runs agree to the tolerance; where they do
not, the motion became chaotic first, and the command fails. What is left of their difference is printed as
`step_difference`. The errors of the times are larger: they hold what another width of the smoothing would change, and
no step makes that smaller. Nothing returns from the far end of the chain, unless `--sites` gives it a length; where the
far end moves the command fails. */

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
## How long two runs stay together

The motion is in general chaotic: two runs that differ by a rounding, by the step or by the last digit of the initial
state decorrelate sooner or later. We call them decorrelated when their states differ by a tenth of the largest
displacement or velocity. Steps that are too long part two impacts as well. So the two impacts are run with equal steps,
with half of them, and with one of each beside the other, until these agree on the time within the two units between two
comparisons. */
/// The time at which the states `a`, advanced by the method `first`, and `b`, advanced by `second`, are first seen to
/// have decorrelated; infinite if they have not by `time`. Both belong to `chain`.
double decorrelation_time(const Method& first, State<double> a, const Method& second,
                          State<double> b, const Chain& chain, double time);

}  // namespace lattice
