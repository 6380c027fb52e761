#include "sec36/trapped.hpp"

#include <numbers>
#include <vector>

#include "lattice/diagnostics/pulse.hpp"
#include "lattice/numerics/parallel.hpp"

namespace lattice {

namespace {

// Fractions of the energy, on equally many sites each
struct Remains {
  double before, next, near;
};
struct Trapped {
  std::array<Remains, 2> at{};
  double frequency = 0;  // of the defect, after the first of the times
};

Trapped trapped(const StruckArray& struck, double ratio, const TrappedAt& where, double step) {
  ImpactRun run =
      strike(EventCorrected{step}, struck.impact({.ratio = ratio, .until = where.times.front()}));
  const Impact dense = struck.impact({.ratio = ratio, .sample = 0.1});
  const std::size_t defect = struck.array.defect - 1, m = where.near_sites;
  std::vector<double> t, v;
  const auto record = [&](const State<double>& now, const std::vector<double>&) {
    t.push_back(now.t);
    v.push_back(now.v[defect]);
  };

  // The energy at each of the times, and the motion in between
  Trapped out;
  for (std::size_t k = 0; k < where.times.size(); ++k) {
    if (k > 0) follow(EventCorrected{step}, dense, run, struck.scales.time(where.times[k]), record);
    const auto around = [&](std::size_t site) {
      return window_sum(run.density, site, m) / struck.energy();
    };
    out.at[k] = {
        .before = around(defect - m), .next = around(defect - 3 * m - 1), .near = around(defect)};
  }
  const std::vector<double> turns = upward_crossings(t, v);
  out.frequency = 2 * std::numbers::pi * double(turns.size() - 1) / (turns.back() - turns.front());
  return out;
}

}  // namespace

void report_trapped(Report& report, const StruckArray& struck, const TrappedAt& where,
                    const TwoSteps& steps) {
  // Heavy, none, light
  const std::array<double, 3> ratios{1.6, 1, 0.925};
  std::array<TwoRuns<Trapped>, 3> found{};
  parallel_for(6, [&](std::size_t i) {
    TwoRuns<Trapped>& runs = found[i / 2];
    if (i % 2)
      runs.fine = trapped(struck, ratios[i / 2], where, steps.fine);
    else
      runs.coarse = trapped(struck, ratios[i / 2], where, steps.coarse);
  });

  Table& table = report.table("trapped");
  for (std::size_t i = 0; i < ratios.size(); ++i)
    for (std::size_t k = 0; k < where.times.size(); ++k) {
      const auto of = [&](auto number) {
        return found[i].of([&](const Trapped& run) { return number(run.at[k]); });
      };
      const Estimate left =
          found[i].of([&](const Trapped& run) { return run.at[k].near / run.at[0].near; });
      table.add({{"ratio", "radius of the defect's beads divided by that of the others", ratios[i]},
                 {"t", "time after the impact", where.times[k], "ms"},
                 {"before", "fraction of the energy, on the nine sites that end at the defect",
                  of([](const Remains& r) { return r.before; })},
                 {"next", "the same, on the nine sites before these",
                  of([](const Remains& r) { return r.next; })},
                 {"near", "the same, on the nine sites around the defect",
                  of([](const Remains& r) { return r.near; })},
                 {"near_left", "part of this that is left of the one at the first time", left}});
    }

  // The frequency of the light one
  report.table("light_defect")
      .add({{"alone", "frequency of a defect of 0.925 radii alone",
             exact(struck.array.linear_frequency(ratios[2])), "1 / tau_c", "exact"},
            {"in_run", "its mean frequency between the first and the last time",
             found[2].of([](const Trapped& run) { return run.frequency; }), "1 / tau_c"}});
}

}  // namespace lattice
