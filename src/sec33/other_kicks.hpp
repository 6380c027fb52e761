#pragma once
/**
# What else the article may mean by a kick

The article prints neither the sign of a kick nor its phase, its caption names the pinning mode, its formula of $g_n$ has
another norm, and no run has a length. For the chapter `sec33_mobility` these functions compute what each choice gives. */

#include <array>
#include <cstddef>

#include "report/program.hpp"
#include "sec33/kick_threshold.hpp"

namespace lattice {

/// The breathers of the chapter: around a site, and around a bond with its contact stretched or compressed at the kick.
enum Which : std::size_t { around_site, stretched, compressed };
using Breathers = std::array<RestingBreather, 3>;
inline constexpr const char* breather_names[] = {"site", "bond_stretched", "bond_compressed"};

/// Slope of X between two times, without its sign.
Estimate speed_of(const KickedPath& path, double since, double until);

/// Table `other_strong`: the speed after a kick `c` of the other sign, or along the pinning mode.
void report_other_strong(Report& report, const Breathers& at, double c,
                         const TwoRuns<EventCorrected>& method);

/// Table `other_weak`: how far the site-centred breather comes after these kicks, until it has passed a third site.
void report_other_weak(Report& report, const RestingBreather& site, double c,
                       const TwoRuns<EventCorrected>& method);

/// Table `passages`: when the site-centred breather passes sites and bonds, and how fast.
void report_passages(Report& report, const TwoRuns<KickedPath>& site);

/// A row of table `readings`: the threshold along the mode and for the printed norm, from the same breather on two chains
/// and the threshold along g.
void add_other_thresholds(Table& table, Which phase, const RestingBreather& at,
                          const RestingBreather& longer, const Prediction& law,
                          const Estimate& found);

/// Table `short_run`: when the breather around a bond passes the next site after the kick `c` in `runs`, and where the
/// other one is by then.
void report_short_run(Report& report, const TwoRuns<KickedPath>& runs,
                      const TwoRuns<KickedPath>& site);

}  // namespace lattice
