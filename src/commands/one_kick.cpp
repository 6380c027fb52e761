#include "commands/one_kick.hpp"

namespace lattice {

void KickedBreather::parameters(Parameters& p) {
  add_centre(p);
  p.add("omega", omega_b, "frequency omega_b > 1", breather_range(1.01, 2));
  add_phase(p);
  p.add("sites", sites, "chain length (default: 52 or 53)", {8, 400});
}

RestingBreather KickedBreather::at_rest() const {
  return on_chosen_chain(
      *this, [&] { return resting_breather(centre, phase, omega_b, sites ? sites : 52); });
}

void OneKick::parameters(Parameters& p) {
  KickedBreather::parameters(p);
  p.add("c", c, "size of the kick, a velocity", {1e-9, 1});
  p.add("time", time, "duration", {1000, 1e6});
}

// Two runs, which end where the breather comes near an end of the shorter chain. What a strong kick sheds comes back from
// the ends of that chain earlier than from those of the other
Table OneKick::table() const {
  const RestingBreather at = at_rest();
  const RestingBreather longer =
      sites ? at : resting_breather(centre, phase, omega_b, at.chain.sites + 20);
  const double room = 0.5 * double(at.chain.sites) - 8;
  std::array<KickedPath, 2> runs;
  parallel_for(2, [&](std::size_t i) {
    runs[i] = (i ? longer : at)
                  .after(c, EventCorrected{i ? 0.05 : 0.1}, time,
                         [&](const KickedPath& path, const State<double>&, const auto&) {
                           return path.share > 0.9 && std::abs(path.travelled()) < room;
                         });
    if (runs[i].share <= 0.9 || runs[i].run.escaped())
      throw Failure("the breather breaks up after a kick of " + short_text(c));
  });
  const double ends = std::min(runs[0].run.t_end, runs[1].run.t_end);
  const double way = std::abs(runs[1].travelled());
  const bool few = runs[1].t.size() <= 3 || runs[0].t.size() < 3;
  Estimate speed{std::nan(""), std::nan("")};
  if (way >= 1 && !few)
    speed = compare(runs[0].speed_during(0, ends), runs[1].speed_during(0, ends));
  Answers q{"a larger --c or a shorter --time"};
  q.add("velocity", speed, "site per unit of time",
        "speed of the breather's energy centre over the whole run, with its sign",
        way < 1 ? "the breather has moved by " + short_text(std::round(100 * way) / 100) +
                      " sites, less than one"
                : "the run ends before the place has been averaged four times over eleven periods");
  q.add_small("drift", compare(runs[0].run.energy_drift, runs[1].run.energy_drift), "relative",
              "largest change of the chain's energy during the run");
  q.add_small("sites_travelled", compare(runs[0].travelled(), runs[1].travelled()), "site",
              "way of the energy centre from its first mean over eleven periods to the last, with "
              "its sign");
  q.add("time", exact(runs[1].run.t_end), "",
        "when the run ended: the given time, or earlier near an end of the chain");
  return q.table;
}

// The prediction says where to look
Table OneThreshold::table() const {
  const RestingBreather at = at_rest();
  const Prediction p = predict_threshold(at, barriers_at(omega_b).equal_area);
  if (!p.exists())
    throw UsageError("--centre: this breather at omega_b = " + short_text(omega_b) +
                     " is unstable and any kick moves it (allowed: the other centre)");
  if (!(p.frequency.value > 1e-5))
    throw Failure("so close to an exchange of stability the breather swings too slowly");
  const EventCorrected fine = fourteen_stages(0.06);
  std::array<Estimate, 2> found;
  parallel_for("thresholds", 2, [&](std::size_t i) {
    found[i] = freeing_kick_of(at, p, i ? EventCorrected{0.15} : fine);
  });
  const Estimate c = compare(found[1], found[0]);
  // An extrapolation is no proof: one per cent below it must turn back, one per cent above it must get over
  parallel_for("bracket", 2, [&](std::size_t i) {
    const double beside = (i ? 1.01 : 0.99) * c.value;
    const Mobility fate = mobility_of(decided_path(at, beside, fine, 10 / p.frequency.value));
    if (fate != (i ? Mobility::free : Mobility::pinned))
      throw Failure("the threshold is not within one per cent of " + short_text(c.value));
  });
  Answers q;
  q.add("c_threshold", c, "site per unit of time",
        "least size c of the kick after which the breather passes the barrier, from runs");
  q.add("barrier", {c.value * c.value / 2, c.value * c.error}, "",
        "energy c^2/2 of the threshold kick");
  q.add("predicted", p.threshold, "site per unit of time",
        "the threshold kick as it follows from the barrier and the pinning mode");
  q.add_small("effective_barrier", p.barrier, "",
              "E_site - E_bond at equal area, the barrier of the moving breather");
  q.add_small("kinetic_share", p.share, "",
              "share of the energy c^2/2 that moves the breather along; below 0 if its mass is");
  return q.table;
}

}  // namespace lattice
