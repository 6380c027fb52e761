#pragma once
/**
# Waves beside a breather at rest

The last experiment of sec34_boomeron_why.cpp: does a bond-centred breather in a quiet chain move, if sites on one side of
it oscillate at random phases? */

#include <vector>

#include "lattice/impact/turning.hpp"
#include "lattice/orbits/shooting.hpp"
#include "report/program.hpp"

namespace lattice {

/// Of the phases that are drawn.
inline constexpr unsigned long phase_seed = 20130502;

/// One draw of phases in one well, with the waves on one side.
struct ExposedBreather {
  double well, omega;
  int side;  ///< -1: waves on the left
  std::vector<double> phase;
  Path path{}, coarse{};

  double moved(const Path& p) const {
    const Path q = smooth(p, path_smoothing);
    return q.centre.back() - q.centre.front();
  }
};

/// The path of the breather `orbit` until $t = 300$; its displacement is measured from the bond at which it rested.
Path expose(const ExposedBreather& trial, const Orbit<double>& orbit, double step);

/// Draws, each used four times: in both wells and, mirrored, on both sides. The frequencies 1.68 and 1.6045 are chosen
/// such that the energies of the two breathers agree.
std::vector<ExposedBreather> exposed_breathers(std::size_t count);

/// Adds the mean displacement towards the waves in one well, with its standard error, and how many trials moved there.
void add_pull(Quantities& facts, const std::vector<ExposedBreather>& list, double well);

}  // namespace lattice
