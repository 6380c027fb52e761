/**
# 3.4 Which packets turn round

Section 3.4 of James, Kevrekidis and Cuevas (Physica D 251, 2013) reports that the travelling breather
launched by an impact turns round as soon as the wells are hard, "$s>0$ (we have checked it for
$s\ge0.005$), but not for $s=0$" (`boomeron.any_s`), without saying for which impacts. This program
maps the turning against impact velocity and hardness and finds the law of its boundary.

![Fate of the packet against impact and well, and the law of the boundary.](fig:x11) */

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "lattice/measure/turning.hpp"
#include "lattice/numbers/parallel.hpp"
#include "lattice/report/program.hpp"
#include "lattice/report/sweep.hpp"

using namespace lattice;

/**
## The scaling that decides

A packet of amplitude $\epsilon$ feels the contacts as a relative force $\epsilon^{1/2}$ and the
hardness as $s\epsilon^2$, in units in which the well is one. In the limit of small amplitude time
scales out of the DpS equation with $\epsilon^{1/2}$, and only the ratio $\kappa = s\,v_0^{3/2}$ is left:
what happens at which site can depend on nothing else. So we expect
$$s_c(v_0) = v_0^{-3/2}\,(\kappa_0 + \kappa_1 v_0^{1/2} + \dots),$$
the second term being the first correction in $\epsilon^{1/2}$ to that limit. A point of the map has
*turned* when the centre, averaged over one internal period, has come back by five sites, and
has *escaped* when it passes site 40. It *stays* if it never got beyond site 8. */
constexpr double horizon = 40;

/**
The boundary is a narrow band across many decades of $s$, so we place the points of each velocity at
equal ratios of $\kappa$ instead of $s$. Rows of the map are kept as soon as they are known (sweep.hpp), so that an interrupted map goes on
where it stopped, and `sec34_boomeron map --part k/n` computes every n-th point alone. */
struct MapGrid {
  std::size_t columns = 42, rows = 42;
  double slowest = 0.03, fastest = 200, least = 0.7, most = 20;  ///< of v0 and of kappa
  double velocity(std::size_t i) const { return spaced(slowest, fastest, i / rows, columns); }
  double kappa(std::size_t i) const { return spaced(least, most, i % rows, rows); }
  static double spaced(double from, double to, std::size_t k, std::size_t count) {
    return from * std::pow(to / from, double(k) / double(std::max<std::size_t>(count, 2) - 1));
  }
};
constexpr double softest = 0.005;  // the smallest s of the article

Sweep map_sweep(const std::filesystem::path& folder, const MapGrid& grid) {
  const std::vector<Column> columns{
      number("velocity", "impact velocity"),
      number("s", "anharmonicity of the well"),
      number("kappa", "s v0^(3/2)"),
      count("fate", "0 escapes, 1 turns, 2 stays, 3 undecided or not the same at two steps"),
      number("apex", "furthest point before it turned, nan for other fates", "site"),
      number("apex_difference", "of two steps", "site")};
  std::ostringstream key;
  key << grid.columns << " x " << grid.rows << " points, kappa from " << grid.least << " to "
      << grid.most;
  return {folder, "reversal_map", columns, grid.columns * grid.rows, key.str()};
}

void compute_map(Sweep& sweep, const MapGrid& grid, Part part) {
  sweep.compute(part, [&](std::size_t i) {
    const double v = grid.velocity(i), kappa = grid.kappa(i), s = kappa / (v * std::sqrt(v));
    const double none = std::nan("");
    const Outlook coarse = probe(v, s, horizon, 0), fine = probe(v, s, horizon, 1);
    const Fate fate = coarse.fate == fine.fate ? fine.fate : Fate::undecided;
    Sweep::Row row{v, s, kappa};
    row.emplace_back(std::int64_t(fate));
    for (double x : {fine.apex, std::abs(fine.apex - coarse.apex)})
      row.emplace_back(fate == Fate::turns ? x : none);
    return row;
  });
}

/**
The boundary between turning and escaping is found by bisection in $s$, at two steps. Where
the grid is only as fine as the colour of the figure, this is as fine as a fit needs. A packet that
has neither turned nor escaped in the time of a run counts with those that turn. */
Estimate critical_s(double velocity, int bisections) {
  const auto bisect = [&](int halvings) {
    double low = std::log(0.5), high = std::log(60.0);  // of kappa
    for (int k = 0; k < bisections; ++k) {
      const double kappa = (low + high) / 2, s = std::exp(kappa) / (velocity * std::sqrt(velocity));
      (probe(velocity, s, horizon, halvings).fate == Fate::escapes ? low : high) = kappa;
    }
    return std::exp((low + high) / 2) / (velocity * std::sqrt(velocity));
  };
  Estimate s = compare(bisect(0), bisect(1));
  s.error += s.value * std::log(60 / 0.5) / std::ldexp(1.0, bisections);
  return s;
}

/**
We fit the law where the amplitude is below three, its two coefficients from
$\kappa_c$ against $v_0^{1/2}$, and the plain power that describes all the larger impacts. The claim
that packets turn for $s\ge0.005$ needs an impact: at $s=0.005$ we bisect in $v_0$. It stands if
there is such an impact, and if none of the map's velocities makes the linear chain
($s=0$) turn anything. */
void report_law(Report& report) {
  const std::size_t count = report.quick ? 6 : 20;
  std::vector<double> velocity(count);
  std::vector<Estimate> critical(count);
  parallel_for(count, [&](std::size_t i) {
    velocity[i] = MapGrid::spaced(report.quick ? 0.1 : 0.01, 100, i, count);
    critical[i] = critical_s(velocity[i], report.quick ? 6 : 10);
  });
  Table table{{number("velocity", "impact velocity"), number("root_velocity", "its square root"),
               number("s", "anharmonicity from which on the packet turns before site 40"),
               number("s_error", "two steps and the last interval"), number("kappa", "s v0^(3/2)"),
               number("law", "kappa_0 + kappa_1 v0^(1/2)")}};
  std::vector<double> root, kappa, log_v, log_s;
  for (std::size_t i = 0; i < count; ++i) {
    const double k = critical[i].value * velocity[i] * std::sqrt(velocity[i]);
    if (velocity[i] < 3) root.push_back(std::sqrt(velocity[i])), kappa.push_back(k);
    if (velocity[i] > 1)
      log_v.push_back(std::log(velocity[i])), log_s.push_back(std::log(critical[i].value));
  }
  const Line law = fit_line(root, kappa);
  for (std::size_t i = 0; i < count; ++i)
    table.add({velocity[i], std::sqrt(velocity[i]), critical[i].value, critical[i].error,
               critical[i].value * velocity[i] * std::sqrt(velocity[i]),
               law.intercept + law.slope * std::sqrt(velocity[i])});
  report.output.add("critical_s", std::move(table));
  report.facts.add("law_kappa_1", law.estimate());
  const double mean = std::accumulate(root.begin(), root.end(), 0.0) / double(root.size());
  double scatter = 0, square = 0;
  for (std::size_t i = 0; i < root.size(); ++i) {
    scatter = std::max(scatter, std::abs(kappa[i] / (law.intercept + law.slope * root[i]) - 1));
    square += root[i] * root[i] / double(root.size());
  }
  report.facts.add("law_kappa_0", {law.intercept, law.slope_error * std::sqrt(square)});
  report.facts.add("law_largest_deviation", exact(scatter), "relative");
  report.facts.add("law_mean_root", exact(mean));
  report.facts.add("power_large_impacts", fit_line(log_v, log_s).estimate());
}

void report_any_s(Report& report) {
  const MapGrid grid;
  const std::size_t columns = report.quick ? 6 : grid.columns;
  std::vector<int> moved(columns);
  parallel_for(columns, [&](std::size_t i) {
    const double v = MapGrid::spaced(grid.slowest, grid.fastest, i, columns);
    for (int halvings : {0, 1}) moved[i] += probe(v, 0, horizon, halvings).fate != Fate::escapes;
  });
  const bool linear_turns = std::any_of(moved.begin(), moved.end(), [](int m) { return m > 0; });
  const auto slowest_turning = [&](int halvings) {
    double low = 20, high = grid.fastest;
    for (int k = 0; k < (report.quick ? 5 : 9); ++k) {
      const double v = std::sqrt(low * high);
      (probe(v, softest, horizon, halvings).fate == Fate::escapes ? low : high) = v;
    }
    return std::sqrt(low * high);
  };
  Estimate v0 = compare(slowest_turning(0), slowest_turning(1));
  v0.error += v0.value * std::log(grid.fastest / 20) / (report.quick ? 32 : 512);
  report.facts.add("v0_needed_at_s_0005", v0);
  report.facts.add("s_needed_at_190", critical_s(1.9, report.quick ? 6 : 10));
  const Fate beyond = probe(1.05 * (v0.value + v0.error), softest, horizon, 1).fate;
  report.results.claim("boomeron.any_s", beyond == Fate::turns && !linear_turns);
}

/**
## Results

For small and moderate impacts $\kappa_c = s_c v_0^{3/2}$ follows the expected line: $\kappa_0$ is
[1.022](num:sec34_boomeron_map.law_kappa_0) and $\kappa_1$ is [0.99](num:sec34_boomeron_map.law_kappa_1), with
no point further off than the relative [0.0149181](num:sec34_boomeron_map.law_largest_deviation). Strong impacts,
for which the linear part of the well no longer matters, leave the line; above $v_0=1$ a plain power of
[-1.236](num:sec34_boomeron_map.power_large_impacts) describes the boundary, but only as an average over a
slope that changes. At $v_0=1.9$ a packet turns before site 40 if $s$ exceeds
[0.908](num:sec34_boomeron_map.s_needed_at_190), and at $s=0.005$ it needs an impact of
[128.4](num:sec34_boomeron_map.v0_needed_at_s_0005). At the article's velocities and $s=0.005$ nothing
turns there. The boundary belongs to site 40: how it depends on the distance is shown by `apex` in the map.

## One part of the map

`sec34_boomeron_map map --part 2/8 --folder rows` computes every eighth point from the second on, and
keeps it in the folder; without `--part` it collects what all parts have left there, computes what
is missing and prints the whole map.

## Differences and limits

A turning is never seen to be absent, only not seen up to site 40. The apex moves out steeply as
$\kappa$ falls, so another horizon would change $\kappa_0$ a little and the exponent not at all. Deep
inside the turning region the motion near the end is erratic, and the fate of single points there depends
on the last digit; points at which two steps do not agree are marked as undecided.

## Extensions

- Is there a $\kappa$ below which a packet never turns, or does the apex grow without limit?
- Derive $\kappa_0$ from the DpS equation with a cubic term, where it is a pure number.
- Does the law hold for a struck chain with fixed end? */
int main(int argc, char** argv) {
  Program program({"sec34_boomeron_map", "3.4", "Which packets turn round (section 3.4, s > 0)"},
                  argc, argv);
  MapGrid grid;
  std::string part = "1/1", folder = "build/data/sec34_boomeron_map";
  CLI::App* map = program.command("map", "the map of turning, or a part of it", [&] {
    const Part mine = parse_part(part);
    Sweep sweep = map_sweep(folder, grid);
    compute_map(sweep, grid, mine);
    return sweep.table(mine);
  });
  map->add_option("--part", part, "k/n: every n-th point from the k-th on")->check(part_text());
  map->add_option("--folder", folder, "where rows wait for each other")->check(not_empty());
  map->add_option("--columns", grid.columns, "impact velocities")->check(in_range(2, 1000));
  map->add_option("--rows", grid.rows, "anharmonicities")->check(in_range(2, 1000));

  program.everything = [&](Output& output) {
    Report report{output, program.quick};
    if (program.quick) grid.columns = grid.rows = 8;
    Sweep sweep = map_sweep(output.folder(), grid);
    compute_map(sweep, grid, {});
    output.add("reversal_map", sweep.table());
    report_law(report);
    report_any_s(report);
    output.add("facts", report.facts.table);
    sweep.forget();
    return report.results;
  };
  return program.run(argc, argv);
}
