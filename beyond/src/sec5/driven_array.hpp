#pragma once
/**
# One drive of the array

What is driven, how fast and how far, in the units of the array. A run tells what passes a detector bead; two runs, the
finer with half the step, give each quantity with its error. The command `drive` and the live page ask for the
same. */

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "lattice/model/cantilever.hpp"
#include "lattice/numerics/estimate.hpp"
#include "sec5/driven_end.hpp"

namespace lattice {

/// A quantity of such a drive.
struct DrivenQuantity {
  std::string name;
  Estimate value;
  std::string unit, meaning;
};

/// The array of section 3.6 with losses.
struct ArraySetup : Scales {
  ArraySetup() : Scales(CantileverArray{}.scales()) {}

  /// Beads, and the one behind which a packet counts. The packets of strong drives reach the end of so short an array.
  static constexpr std::size_t sites = 120, detector = 20;

  double lifetime = 10;  ///< of the energy, in ms; 0 without losses

  /// The chain, with a drive that grows from `from` to `amplitude` within `ramp`, in units of the chain.
  DrivenChain driven(Drive::By by, double omega, double amplitude, double from, double ramp,
                     std::size_t beads = sites) const {
    return {Chain{beads}, {rate(lifetime), 0}, {by, omega, amplitude, from, ramp}};
  }
};

/// One drive, which grows during the first sixth of its `duration`.
struct DrivenArray : ArraySetup {
  /// Beads, and those that a map shows. Of the chart, the strongest drives above 7.8 kHz send packets to the end.
  static constexpr std::size_t sites = 300, drawn = 60;
  static constexpr double step = 0.02;  ///< of the finer run, in units of tau_c

  double frequency = 7000, amplitude = 5, duration = 60;  ///< Hz, micrometres, ms
  Drive::By by = Drive::By::piston;
  std::size_t beads = sites;  ///< to begin with; `quantities` lengthens an array whose end moves

  /// The duration in units of tau_c.
  double horizon() const { return time(duration); }
  /// The same array in units of the chain.
  DrivenChain driven() const {
    return ArraySetup::driven(by, omega(frequency), amplitude / micrometres(1), 0, horizon() / 6,
                              beads);
  }
  /// The law of the DpS limit at `omega`, in micrometres.
  Estimate law(double omega) const {
    const Estimate a = law_estimate(by, omega);
    return {micrometres(a.value), micrometres(a.error)};
  }
  /// One run with steps of length `h`.
  Emission run(double h) const { return drive_chain(driven(), horizon(), detector, h); }

  /// Three runs and what they say; the law of the DpS limit holds above the frequency of a beam.
  std::vector<DrivenQuantity> quantities() const {
    // What comes back from the far end is no answer to the drive, and such an array is too short
    DrivenArray array = *this;
    Emission coarse = array.run(2 * step);
    for (; coarse.far > 1e-9 * amplitude / micrometres(1); coarse = array.run(2 * step))
      array.beads *= 2;
    const Emission fine = array.run(step), between = array.run(1.65 * step);
    // What steps leave depends on where in a step a contact switches, and two runs may agree by chance
    const auto of = [&](auto what) {
      Estimate e = compare(double(what(coarse)), double(what(fine)));
      e.error = std::max(e.error, std::abs(what(between) - e.value));
      return e;
    };
    std::vector<DrivenQuantity> out{
        {"outcome", of([](const Emission& e) { return int(!e.passages.empty()); }), "",
         "1 if a packet passes bead 20, otherwise 0"},
        {"emitted_per_second",
         of([&](const Emission& e) { return e.rate(horizon()) * per_second(1); }), "1/s",
         "packets that pass bead 20 in the second half of the run, per second"},
        {"power", of([&](const Emission& e) { return watts(e.power); }), "W",
         "mean power of the drive in the second half of the run"},
        {"response", of([&](const Emission& e) { return micrometres(e.response); }), "um",
         "largest displacement of the first bead in the second half of the run"},
        {"budget", of([](const Emission& e) { return e.budget; }), "",
         "energy and losses less work, over the most energy that was there or came in: zero but "
         "for errors"}};
    if (omega(frequency) > 1)
      out.push_back({"threshold_law", law(omega(frequency)), "um",
                     "amplitude of the fold of the quiet motion, by the law of small amplitudes"});
    return out;
  }
};

}  // namespace lattice
