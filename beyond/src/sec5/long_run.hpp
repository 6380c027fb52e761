#pragma once
/**
# A long run at little cost

How a packet's tail falls shows only over many sites, but most of them need not be computed. Waves behind the packet
do not catch up with it, so we keep a frame of sites around the packet and move it on: beads far behind are dropped,
beads at rest come in ahead.

To see what is left behind we look at the bead eleven sites behind the largest one, which is out of the
packet's reach; with the next one behind it, it gives the angle of the phase. Energy, contact energy and speed of the
packet fluctuate with its internal oscillation, so each row holds means over the stretch since the row before. Two runs
can be compared row by row if the rows belong to the same sites: a row is written when the centre passes certain sites,
twelve to a decade from site 20 on. The chain is sampled once per unit of time. */

#include <cstddef>
#include <vector>

namespace lattice {

/// What is seen of a packet, row by row.
struct LongRun {
  std::vector<double> t, site, left, angle, energy, contact, speed;
};

/// Sites of the frame, how many are dropped at a time, and the step.
struct MovingFrame {
  std::size_t sites = 64, drop = 16;
  double step = 0.2;
};

/// Strikes a chain of linear wells with `velocity` and follows the packet for so many rows.
LongRun long_run(double velocity, const MovingFrame& frame, std::size_t rows);

}  // namespace lattice
