#pragma once
/**
# Why a packet has no speed

The foremost packet of an impact is measured on its way from site 20 to twenty sites before the far end. Where its speed is
`nan` there is no such way, or no packet on it. */

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "lattice/impact/impact.hpp"
#include "report/table.hpp"

namespace lattice {
using namespace report;

/// Where this way ends in a chain of so many sites.
inline double way_end(std::size_t sites) {
  return double(sites) - 20;
}

/// Why there is no packet in `path`; empty if there is one.
inline std::string why_no_packet(const Path& path) {
  return path.empty() ? "no packet: no eleven neighbouring sites hold a hundredth of the whole"
                      : "";
}

/// Why `path` has no speed on this way, from the `density` at the end; empty if it has one. `share` is what the
/// first `sites` sites then hold a part of, such as the energy.
inline std::string why_no_speed(const Path& path, const std::vector<double>& density,
                                std::size_t sites, const std::string& share) {
  const double to = way_end(density.size());
  if (path.line(fit_from, to)) return "";
  if (!(to > fit_from))
    return "the chain is too short for a fit from site 20 to twenty sites before the far end: it "
           "needs more than 40 sites";
  if (path.empty()) return why_no_packet(path);
  const double farthest = std::ranges::max(path.all(&PathSample::centre));
  if (farthest >= fit_from)
    return "fewer than three samples of the packet lie between sites 20 and " + short_text(to);
  return "no packet reaches site 20: the foremost one reaches " +
         short_text(std::round(10 * farthest) / 10) + ", and " +
         short_text(std::round(100 * boundary_share(density, sites))) + " % of the " + share +
         " stays on the first " + std::to_string(sites) + " sites";
}

}  // namespace lattice
