#pragma once
/**
# One impact in hard wells, with your own parameters

`sec34_boomeron run --velocity 1.9 --s 1 --time 1000` prints turning point, rebound, and the time at which two impacts
that differ by a fraction $10^{-8}$ have decorrelated, looked for up to four times as long. What did not happen in the
given time is `nan`. The step is halved until turning point and rebound of two runs agree to the tolerance, and what is
left of their difference is `step_difference`; where they do not agree, the motion became chaotic first, and the command
fails. The errors of the times also hold what another width of the smoothing would change. Nothing returns from the far
end of the chain, unless `--sites` gives it a length; where the far end moves the command fails. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "lattice/impact/turning.hpp"
#include "lattice/numerics/progress.hpp"
#include "report/model_options.hpp"
#include "report/program.hpp"

namespace lattice {
using namespace report;

inline constexpr double decorrelation_interval = 2;  ///< of time, between two comparisons

/// The time at which the states `a`, advanced by the method `first`, and `b`, advanced by `second`, first differ by a
/// tenth of the largest displacement or velocity; infinite if they do not by `time`. Both belong to `chain`. They go on
/// side by side, so that no more is kept than the two states.
inline double decorrelation_time(const Method& first, State<double> a, const Method& second,
                                 State<double> b, const Chain& chain, double time) {
  const TimeGrid one = time_grid(first, time, Every{decorrelation_interval}),
                 other = time_grid(second, time, Every{decorrelation_interval});
  Window of_a = waking(chain, a), of_b = waking(chain, b);
  const Advance advance_a = first.on(chain), advance_b = second.on(chain);
  const double start = a.t;
  Progress progress("two runs", 1);
  for (std::size_t k = 0;; ++k) {
    a.t = b.t = start + one.interval() * double(k);
    if (!bounded(a) || !bounded(b) || distance(a, b) > 0.1) return a.t;
    progress.reach(double(k) / double(one.samples));
    if (k == one.samples) return std::numeric_limits<double>::infinity();
    advance_a(chain, a, of_a, one.step(), one.steps);
    advance_b(chain, b, of_b, other.step(), other.steps);
  }
}

/// The decorrelation time of two impacts whose velocities differ by a fraction `delta`. Steps that are too long part
/// two impacts as well: those of `largest` are halved until equal steps, half of them, and both beside each other agree;
/// nothing if none is short enough.
inline std::optional<Estimate> decorrelation_to(const EventCorrected& largest, double velocity,
                                                double delta, const Chain& chain, double time) {
  const auto parted = [&](int one, int other) {
    EventCorrected first = largest, second = largest;
    first.halvings += one, first.finer += one;
    second.halvings += other, second.finer += other;
    return decorrelation_time(first, struck(chain.sites, velocity), second,
                              struck(chain.sites, velocity * (1 + delta)), chain, time);
  };
  double coarse = parted(0, 0);
  for (int k = 0; k < usual_halvings; ++k) {
    const double fine = parted(k + 1, k + 1);
    const auto [least, most] = std::minmax({coarse, parted(k, k + 1), fine});
    const double spread = least == most ? 0 : most - least;
    if (spread <= 1.01 * decorrelation_interval)
      return Estimate{fine, spread + decorrelation_interval};
    coarse = fine;
  }
  return {};
}

/// The command: the impact (dimensionless) and how long it is followed.
struct OneTurn {
  static constexpr Title title{
      "run", "one impact: turning point, reflection at the struck end, decorrelation time"};
  double velocity = 1.9, time = 1000, tolerance = 1e-3;
  std::optional<std::size_t> sites{};  // otherwise as many as needed
  Chain like{.well = Quartic{1}};

  void parameters(Parameters& p) {
    p.add("velocity", velocity, "velocity of the impact on the first bead", {1e-3, 1000});
    add_well(p, like.well, {{"s", {0, 1000}}});
    add_contact(p, like.contact);
    p.add("sites", sites, "number of sites (default: as many as needed)", {12, 1e5});
    p.add("time", time, "duration of the run", {50, 1e5});
    p.add("tolerance", tolerance,
          "relative difference allowed between the turning points and reflections of runs with two "
          "time steps",
          {1e-8, 0.1});
  }

  /// Throws RefinementFailed and FarEndReached.
  // The neighbours start from the steps that have proved to be short enough for the turn
  Table table() const {
    const auto chain_for = [&](double duration) {
      const Chain chain = on_long_chain({velocity, like, duration}).chain;
      return sites ? chain.with_sites(*sites) : chain;
    };
    const Impact impact{.velocity = velocity,
                        .chain = chain_for(time),
                        .time = time,
                        .denser = false,
                        .packet = WhichPacket::strongest};
    const auto runs = refined(
        tolerance, [&](const EventCorrected& method) { return strike(method, impact); },
        SameTurn{});
    const TurnEstimate read = estimate_turn(runs.coarse.path, runs.fine.path);
    const auto parted =
        decorrelation_to(runs.method, velocity, 1e-8, chain_for(4 * time), 4 * time);
    const Turn turn = turn_of(runs.fine.path);
    // The turn, and when the impacts of two neighbours part
    const std::string by = " by t = " + short_text(time),
                      on = "the packet has not come back by five sites" + by;
    Answers q{"a smaller --tolerance or a shorter --time"};
    q.add("apex_site", read.apex_site, "site",
          "turning point: the farthest site of the strongest packet's energy centre, smoothed over "
          "time",
          on);
    q.add("apex_time", read.apex_time, "",
          "time at which this packet turns back, at its farthest site", on);
    q.add("return_time", read.return_time, "",
          "time at which this packet, reflected at the struck end, is nearest to it",
          turn.apex.found()
              ? "the packet has turned back, but has not moved out again by three sites" + by
              : on);
    q.add("decorrelation_time", parted && std::isfinite(parted->value) ? *parted : undefined, "",
          "time by which two impacts whose velocities differ by a fraction 1e-8 have decorrelated",
          parted ? "the two impacts have not decorrelated by t = " + short_text(4 * time)
                 : "the step sizes separate the two impacts as early as their velocities do");
    q.add("step_difference", exact(runs.error), "relative",
          "difference of turning point and reflection between the last two runs, with a step and "
          "half of it, or a thousandth of the difference of their final states if that is larger");
    return q.table;
  }
};

}  // namespace lattice
