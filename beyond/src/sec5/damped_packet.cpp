#include "sec5/damped_packet.hpp"

namespace lattice {

Arrivals damped_arrivals(double velocity, double lifetime, double contact, double ms, double step) {
  // Where a packet is after twenty lifetimes the strongest overlaps are 1e-100
  const DrivenChain driven{Chain{beams36, Harmonic{}, Hertz{.floor = 0}},
                           {array36.rate(lifetime), contact}};
  return packet_arrivals(driven, array36.velocity(velocity), array36.time(ms), beams36 - 1, step);
}

TwoDampedRuns two_damped_runs(double velocity, double lifetime, double contact, double ms,
                              const std::array<double, 2>& h) {
  TwoDampedRuns out;
  for (std::size_t i : {0U, 1U})
    out.runs[i] = damped_arrivals(velocity, lifetime, contact, ms, h[i]);
  return out;
}

TwoDampedRuns slowed_both(const TwoDampedRuns& free, double nu) {
  return {{slowed(free.runs[0], nu), slowed(free.runs[1], nu)}};
}

}  // namespace lattice
