#pragma once
/**
# An impact in the chain and in the DpS equation, compared

What the chapter `sec34_dps_impact` measures on states of the chain (y and v) and of the DpS equation (the amplitudes A). */

#include <cstddef>
#include <vector>

#include "lattice/dps/evolve.hpp"
#include "lattice/integrators/event_corrected.hpp"
#include "report/program.hpp"

namespace lattice {
using namespace report;

/// The approximation, Eq. (13), at t = 0, from the right-hand side of the DpS equation alone: the largest displacement,
/// and the velocities of the first bead beyond 2 eps, of the second and, largest, of the others.
struct ApproximateStart {
  double place = 0, first = 0, second = 0, others = 0;
};
ApproximateStart approximate_start(std::size_t sites, double eps);
/// Table `start`: this for impacts of several sizes. Table `scales`: the size at which breathers have the frequency
/// 1.01, Eq. (20), and the time of the slow time `tau` there.
void report_start(Report& report, std::size_t sites, double tau);

/// The residue at the boundary during a stretch of time: the largest norm of the first ten sites and, at its end, the
/// norm of the first 40 sites and how many of them share it (participation number).
struct ResidueStretch {
  double tau, first_ten = 0, first_forty = 0, sharing = 0;
};
/// Stretches of the length `every` that end at `from`, `from` + `every` and so on; `tau` and `A` are the samples.
std::vector<ResidueStretch> residue_stretches(const std::vector<double>& tau,
                                              const std::vector<Field>& A, double from,
                                              double every);
/// How far the energy densities of the chain and of the approximation differ, up to ten sites behind both packets, at
/// most: roots of all energy, relative; roots at a site or over eleven sites, over the largest one in the chain.
struct TrainDifference {
  double all = 0, site = 0, eleven = 0;
  void add(const std::vector<double>& chain, const std::vector<double>& dps);
};

/// Of the packet in a snapshot, within five sites of its peak: from crest to trough, and the largest displacement.
struct Amplitude {
  double height = 0, displacement = 0;
};
Amplitude amplitude(const State<double>& now, std::size_t peak);
Amplitude amplitude(const Chain& chain, const State<double>& now);

/// The heights at these instants, in both models, from these starts.
struct Heights {
  std::vector<double> t{}, chain{}, dps{};
};
Heights heights_at(const Chain& chain, State<double> state, Field A, double eps, double from,
                   double to, std::size_t instants, const EventCorrected& method,
                   double dps_tolerance);

}  // namespace lattice
