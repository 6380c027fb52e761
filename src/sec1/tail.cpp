#include "sec1/tail.hpp"

#include <cmath>
#include <string>

#include "lattice/numerics/estimate.hpp"

using Eigen::Index, Eigen::VectorXd;

namespace lattice {
namespace {

/// The three measures of every bead.
struct Sizes {
  VectorXd energy, instant, displacement;

  explicit Sizes(const std::vector<Sample>& samples)
      : energy(VectorXd::Zero(samples.front().energy.size())),
        instant(samples.back().energy),
        displacement(energy) {
    for (const Sample& now : samples) {
      energy += now.energy;
      displacement = displacement.cwiseMax(now.displacement.cwiseAbs());
    }
  }
};

/// The rows of one side, `outwards` by 1 or -1.
void report_side(Table& table, const std::string& side, Index outwards, Index beads,
                 const Sizes& coarse, const Sizes& fine) {
  const char* scale = "of two steps, against the largest";
  Index peak = 0;
  fine.energy.maxCoeff(&peak);
  for (Index k = 0; k < beads; ++k) {
    const Index n = peak + k * outwards, next = n + outwards;
    if (next < 0 || next >= fine.energy.size() || coarse.instant[next] < 1e-300) return;
    const auto fall = [&](const VectorXd& rough, const VectorXd& good) {
      return compare(std::log(rough[n] / rough[next]), std::log(good[n] / good[next]));
    };
    table.add({{"side", "of the packet: ahead or behind", side},
               {"beads", "from the bead with the most energy", k},
               {"energy", "logarithm of the mean energy over that of the next bead outwards",
                fall(coarse.energy, fine.energy), "", scale},
               {"instant", "the same of the energies at the last instant",
                fall(coarse.instant, fine.instant), "", scale},
               {"displacement", "the same of the largest displacements",
                fall(coarse.displacement, fine.displacement), "", scale}});
  }
}

}  // namespace

void report_tail(Table& table, const std::vector<Sample>& coarse, const std::vector<Sample>& fine) {
  const Sizes rough(coarse), good(fine);
  report_side(table, "ahead", 1, 20, rough, good);
  report_side(table, "behind", -1, 10, rough, good);
}

}  // namespace lattice
