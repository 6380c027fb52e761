#pragma once
/**
# The packet of an impact on the damped array

The array of section 3.6 with 200 cantilevers and losses: its first bead is struck, and the packet is followed contact by
contact (arrivals.hpp). Two runs, with a step and half of it, give each quantity with its error. What is given and read off
is in units of the experiment. */

#include <array>

#include "lattice/model/cantilever.hpp"
#include "lattice/numerics/estimate.hpp"
#include "sec5/arrivals.hpp"

namespace lattice {

/// Units of the array of section 3.6.
inline const Scales array36 = CantileverArray{}.scales();
constexpr double ten_ms = 10;         ///< time and lifetime, in ms
constexpr std::size_t beams36 = 200;  ///< as in section 3.6

/// One packet with two steps.
struct TwoDampedRuns {
  std::array<Arrivals, 2> runs;

  template <class Of>
  Estimate both(Of of) const {
    return compare(double(of(runs[0])), double(of(runs[1])));
  }
  Estimate of_travelled(double t, double Travelled::*what, double unit = 1) const {
    return both([&](const Arrivals& j) { return travelled_after(j, t).*what * unit; });
  }
};

/// One run after an impact of `velocity` (m/s): lifetime of the energy (ms, 0 without losses of the beams), the time A of the
/// contacts' law in units of tau_c, how long (ms), step.
Arrivals damped_arrivals(double velocity, double lifetime, double contact, double ms, double step);

/// Two of them.
TwoDampedRuns two_damped_runs(double velocity, double lifetime, double contact, double ms,
                              const std::array<double, 2>& h);

/// What the slow clock makes of both runs without losses.
TwoDampedRuns slowed_both(const TwoDampedRuns& free, double nu);

}  // namespace lattice
