#pragma once
/**
# A kick with your own parameters

`sec33_mobility kick --centre bond --omega 1.1 --c 2e-4` kicks one breather along its discrete gradient (kick.hpp). The
run ends early if the breather comes within eight sites of an end of its chain. If less than nine tenths of the energy
stays together, the breather has broken up, and that is an error; so is a chain too short for the breather. Errors come
from two step sizes and, unless `--sites` is given, from two chains, of which the longer one has the smaller step: what a
strong kick sheds comes back from its ends later. A third run with a longer step, which takes a sixth of the time, shows
where those two agree by chance. A breather that has moved less than one site has no speed: it is `nan`.

`sec33_mobility threshold --centre bond --omega 1.1` finds the least kick that depins it (kick_threshold.hpp), takes
some seconds and refuses an unstable centre. */

#include "sec3/breather_options.hpp"
#include "sec3/kick_threshold.hpp"

namespace lattice {
using namespace report;

/// Which breather is kicked, on which chain.
struct KickedBreather : ChosenBreather {
  KickedBreather() { centre = Centre::bond; }
  void parameters(Parameters& p) {
    add_centre(p);
    p.add("omega", omega_b, "frequency omega_b of the breather; a single bead has 1",
          breather_range(1.01, 2));
    add_phase(p);
    p.add("sites", sites, "number of sites (default: 52 or 53)", {8, 400});
  }
  /// The breather before the kick. Throws UsageError, NewtonFailed.
  RestingBreather at_rest() const {
    return on_chosen_chain(
        *this, [&] { return resting_breather(centre, phase, omega_b, sites ? sites : 52); });
  }
};

/// The command `kick`.
struct OneKick : KickedBreather {
  static constexpr Title title{"kick",
                               "speed of a breather after a kick along its discrete gradient"};
  double c = 2e-4, time = 20000;

  void parameters(Parameters& p) {
    KickedBreather::parameters(p);
    p.add("c", c, "size c of the kick, a velocity; its energy is c^2/2", {1e-9, 1});
    p.add("time", time, "duration of the run", {1000, 1e6});
  }

  /// Runs with shorter and shorter steps. Throws Failure where the breather breaks up.
  std::array<KickedPath, 3> find() const {
    const RestingBreather at = at_rest();
    const RestingBreather longer =
        sites ? at : resting_breather(centre, phase, omega_b, at.chain.sites + 20);
    const double room = 0.5 * double(at.chain.sites) - 8;
    std::array<KickedPath, 3> runs;
    parallel_for(3, [&](std::size_t i) {
      runs[i] = (i == 2 ? longer : at)
                    .after(c, EventCorrected{std::array{0.2, 0.1, 0.05}[i]}, time,
                           [&](const KickedPath& path, const State<double>&, const auto&) {
                             return path.share > 0.9 && std::abs(path.travelled()) < room;
                           });
      if (runs[i].share <= 0.9 || runs[i].run.escaped())
        throw Failure("the breather breaks up after a kick of " + short_text(c));
    });
    return runs;
  }

  Table table() const {
    const auto runs = find();
    const auto& [coarsest, coarse, fine] = runs;
    const auto of = [&runs](auto number) {
      return after_halving(with_error(number(runs[0]), number(runs[1])),
                           with_error(number(runs[1]), number(runs[2])));
    };
    const double ends = std::min({coarsest.run.t_end, coarse.run.t_end, fine.run.t_end});
    const double way = std::abs(fine.travelled());
    const bool few = std::min({coarsest.size(), coarse.size(), fine.size() - 1}) < 3;
    // A breather that hardly moves has no speed
    Estimate speed = undefined;
    if (way >= 1 && !few)
      speed = of([&](const KickedPath& path) { return path.speed_during(0, ends); });
    Answers q{"a larger --c or a shorter --time"};
    q.add("velocity", speed, "site per unit of time",
          "velocity of the breather's energy centre over the whole run, with its sign",
          way < 1
              ? "the breather has moved by " + short_text(std::round(100 * way) / 100) +
                    " sites, less than one"
              : "the run is shorter than four averages of the position, each over eleven periods");
    q.add_small("drift", of([](const KickedPath& path) { return path.run.energy_drift; }),
                "relative", "largest change of the chain's energy during the run");
    q.add_small("sites_travelled", of([](const KickedPath& path) { return path.travelled(); }),
                "site",
                "signed displacement of the energy centre, from its first mean over eleven periods "
                "to the last");
    q.add("time", exact(fine.run.t_end), "",
          "end of the run: the given time, or earlier if the breather comes near an end of the "
          "chain");
    return q.table;
  }
};

/// The command `threshold`.
struct OneThreshold : KickedBreather {
  static constexpr Title title{
      "threshold", "depinning threshold: the least kick that sets a pinned breather moving"};

  /**
  The kicks are those beyond the prediction. An extrapolation is no proof: a kick one per cent below it must turn back, one per
  cent above it must get over. */
  Table table() const {
    const RestingBreather at = at_rest();
    const Prediction p = predict_threshold(at, barriers_at(omega_b).equal_action);
    if (!p.exists())
      throw UsageError("--centre: this breather at omega_b = " + short_text(omega_b) +
                       " is unstable, so any kick moves it (allowed: the other centre)");
    if (!(p.frequency.value > 1e-5))
      throw Failure(
          "the breather is too close to an exchange of stability: its pinning mode oscillates too "
          "slowly");
    // The threshold from two methods, and what brackets it
    const EventCorrected fine = fourteen_stages(0.06);
    const double limit = 10 / p.frequency.value;
    std::array<Estimate, 2> found;
    parallel_for("thresholds", 2, [&](std::size_t i) {
      found[i] = depinning(at, p.threshold.value, i ? EventCorrected{0.15} : fine, limit).threshold;
    });
    const Estimate c = with_error(found[1], found[0]);
    parallel_for("bracket", 2, [&](std::size_t i) {
      const double beside = (i ? 1.01 : 0.99) * c.value;
      const Mobility found_to_be = mobility_of(decided_path(at, beside, fine, limit));
      if (found_to_be != (i ? Mobility::free : Mobility::pinned))
        throw Failure("the threshold is not within one per cent of " + short_text(c.value));
    });
    // What the runs find, and what was predicted
    Answers q;
    q.add("c_threshold", c, "",
          "least size c of a kick after which the breather passes the barrier, from runs");
    q.add("barrier", {c.value * c.value / 2, c.value * c.error}, "",
          "energy c^2/2 of the threshold kick");
    q.add("predicted", p.threshold, "",
          "threshold predicted from the barrier and the pinning mode");
    q.add_small("effective_barrier", p.barrier, "",
                "E_site - E_bond at equal action, the barrier for the moving breather");
    q.add_small("kinetic_share", p.phi, "",
                "fraction of the energy c^2/2 that goes into translational kinetic energy; "
                "negative if the effective mass is");
    return q.table;
  }
};

}  // namespace lattice
