#include "commands/damped_array.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "sec5/damped_packet.hpp"

namespace lattice {

void DampedArray::parameters(Parameters& p) {
  p.add("velocity", velocity, "impact velocity in m/s", {0.1, 2, "m/s"});
  p.add("lifetime", lifetime, "of the energy of a beam that swings freely, in ms",
        {0.5, 1e6, "ms"});
  p.add("restitution", restitution, "of two cantilevers that meet at 1 m/s", {0.5, 1});
}

Table DampedArray::table() const {
  const double t10 = array36.time(ten_ms), contact = contact_loss(restitution, array36.velocity(1));
  const TwoDampedRuns found = two_damped_runs(velocity, lifetime, contact, 16, {0.05, 0.025});
  // What steps leave depends on where in a step a contact switches, and two runs may agree by chance
  const std::array others{damped_arrivals(velocity, lifetime, contact, 16, 0.041),
                          damped_arrivals(velocity, lifetime, contact, 16, 0.033)};
  const auto of = [&](const auto& what) {
    Estimate e = found.both(what);
    for (const Arrivals& j : others) e.error = std::max(e.error, std::abs(what(j) - e.value));
    return e;
  };
  const auto of_travelled = [&](double Travelled::*what, double unit = 1) {
    return of([&](const Arrivals& j) { return travelled_after(j, t10).*what * unit; });
  };
  const double per_second = array36.per_second(1);
  Answers q;
  q.add("sites_10ms", of_travelled(&Travelled::sites), "sites",
        "distance of the packet from the first contact in the 10 ms after the impact, by the "
        "strongest push of each contact");
  q.add("periods_10ms", of_travelled(&Travelled::oscillations), "",
        "oscillations of the packet over this distance");
  q.add_small("speed", of_travelled(&Travelled::speed, per_second), "sites/s",
              "speed of the packet after 10 ms, over its last five sites; 0 if it has stopped");
  q.add("period", of_travelled(&Travelled::period, array36.milliseconds(1)), "ms",
        "period of the packet's oscillation after 10 ms");
  q.add_small(
      "budget", of([](const Arrivals& j) { return j.budget; }), "",
      "energy and losses less the energy of the impact, relative to it: zero but for errors");
  q.add("centre_10ms", of([&](const Arrivals& j) { return centre_after(j, t10); }), "site",
        "centre of the energy of the whole array after 10 ms, from the first bead as one");
  q.add("slow_clock", exact(array36.milliseconds(slow_clock(array36.rate(lifetime), t10))), "ms",
        "what the clock of the DpS field with these beams shows after 10 ms: without any losses "
        "the centre of the energy is about as far then; the strongest push is not");
  return q.table;
}

}  // namespace lattice
