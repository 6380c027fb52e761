#pragma once
/**
# What an impact leaves in a compressed chain

The tables that decide whether it is a breather or a wave train, by several definitions of a packet and of its width. */

#include <span>
#include <vector>

#include "lattice/impact/impact.hpp"
#include "report/program.hpp"
#include "sec4/packets.hpp"

namespace lattice {

/// An impact on a compressed chain: well, compression, end of the run.
struct Strike {
  double s, compression, time;
  double closed = time;         ///< from then on no contact may open
  std::vector<double> shown{};  ///< times of the figures
  double step = 0.1;            ///< until then, in the coarser one of two runs
};

/// What is recorded of it.
struct StruckChain {
  ImpactRun run{};
  std::vector<PacketSample> samples{};         ///< of the packet, once in a unit of time
  std::vector<Snapshot> shown{};               ///< the state at the times of the figures
  std::vector<std::vector<double>> density{};  ///< of the energy then
  double last_open = 0;                        ///< when a contact was open for the last time

  /// Records one instant; the same instant again is ignored.
  void record(const Strike& of, const Chain& chain, const State<double>& now,
              const std::vector<double>& e);
  /// Throws Failure if a bead has escaped, energy is lost, or a contact has opened too late.
  void check(const Strike& of) const;
};

/// An impact and its two runs.
struct Struck {
  Strike of;
  TwoRuns<StruckChain> runs{};
};

/// Writes `impact_profiles`, `packet_history` and `impacts` of the compressed chains.
void report_trains(Report& report, std::span<const Struck> compressed);
/// Writes `uncompressed`: a packet that turns round, and a surface mode.
void report_uncompressed(Report& report, const Struck& turns, const Struck& surface);
/// Writes `linear_train`, the exponents of `impacts` after an impact that excites linear waves only.
void report_linear_train(Report& report, const Struck& weak);
/// Writes `splitting`: what becomes of the pulse on a ring.
void report_splitting(Report& report, const RingPair& pair, double round);
/// Writes `envelope_fits`, `tails` and `packet_sites` of a breather, beside a packet without compression.
void report_breather(Report& report, const Struck& breather, const Struck& uncompressed);

}  // namespace lattice
