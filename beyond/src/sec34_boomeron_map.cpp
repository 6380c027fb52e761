/**
# 3.4 Which packets turn round

According to section 3.4 of James, Kevrekidis and Cuevas (Physica D 251, 2013) the packet launched by an impact seems to
turn round as soon as the wells are hard: they checked $s\ge0.005$, and at $s=0$ it does not turn. They do not say for
which impacts, nor how far out. We map where packets turn as a function of impact velocity $v_0$ and hardness $s$, and
find the law of one contour of this map: a turning point at site 40. The chain is that of `sec34_boomeron`, Eqs. (9),
(10) and (26),
$$\ddot y_n + y_n + s\,y_n^3 = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2},
  \qquad \dot y_n(0) = v_0\,\delta_{n,1},$$
at rest before the impact, with free ends, and so long that nothing returns from the far end.

![Fate of the packet against impact and well, and the law of a contour.](fig:x11) */

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "commands/sweep.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"
#include "sec34/fate.hpp"

using namespace lattice;

/**
## What counts as turning

A map needs one criterion for all its points, although the impacts differ by orders of magnitude. A packet has *turned*
when its energy centre, averaged over about one internal period, has come back by five sites; a packet that is trapped
between two sites swings by less. It has *escaped* when it passes site 40, and it *stays* if it never gets beyond
site 8. We wait ten times as long as the slow packet of a weak impact needs to reach site 40, and less after strong
impacts, where everything is faster (fate.hpp). So a packet that turns farther out than site 40 counts as escaped; this
is a limit of the map, not a statement about the chain: with $s=1$ and $v_0=1.5$ the map says *escaped*, and the packet
does turn, at site [183](num:sec34_boomeron.apex_site_150).

## The scaled hardness

Where should the points of the map lie? In a packet with displacements of size $y$ the well pulls with $y$, the contacts
push with $y^{3/2}$, and the hardness adds $s\,y^3$. Relative to the first, the contacts are of size $y^{1/2}$ and the
hardness is of size $s\,y^2$. If both are small, the beads oscillate almost freely and their amplitudes change slowly,
as in the DpS equation (`sec34_dps_impact`); $y^{1/2}$ only sets how slowly. In units of this slow time the contacts are
of order one and the hardness is the ratio of the two. So in this limit the motion depends only on this ratio,
$s\,y^{3/2}$, and, as $y$ is proportional to $v_0$, on the *scaled hardness*
$$\chi = s\,v_0^{3/2},$$
called `kappa` in tables and facts, though unrelated to multipliers. So we expect packets to turn before a given site if
$s$ is above
$$s_c(v_0) = v_0^{-3/2}\,(\chi_0 + \chi_1 v_0^{1/2} + \dots),$$
where the second term is the first correction, in $y^{1/2}$, to that limit, and both coefficients belong to
the site. The contour thus crosses many decades of $s$ while $\chi$ changes little, and we place the points of each
velocity at equal ratios of $\chi$, from 0.7 to 20. */
constexpr double horizon = 40;  // the site that a packet must pass to have escaped

struct MapGrid {
  std::size_t columns = 32, rows = 32;
  double slowest = 0.03, fastest = 200, least = 0.7, most = 20;  ///< of v0 and of chi
  double velocity(std::size_t i) const { return spaced(slowest, fastest, i / rows, columns); }
  double scaled(std::size_t i) const { return spaced(least, most, i % rows, rows); }
  static double spaced(double from, double to, std::size_t k, std::size_t count) {
    return from * std::pow(to / from, double(k) / double(std::max<std::size_t>(count, 2) - 1));
  }
};
constexpr double softest = 0.005;  // the smallest s of the article

// Each row is stored as soon as it is known, together with all parameters that determine it (sweep.hpp)
Sweep turning_map_sweep(const std::filesystem::path& folder, const MapGrid& grid) {
  const std::vector<Column> columns{
      number("velocity", "impact velocity"),
      number("s", "anharmonicity of the well"),
      number("kappa", "the scaled hardness chi = s v0^(3/2)"),
      count("fate",
            "0 escapes, 1 turns back, 2 stays, 3 undecided or different for two time steps"),
      number("apex", "farthest mean centre of a packet that turns back; nan for others", "site"),
      number("apex_difference", "difference between two time steps", "site")};
  std::ostringstream key;
  key << grid.columns << " x " << grid.rows << " points, kappa from " << grid.least << " to "
      << grid.most;
  return {folder, "reversal_map", columns, grid.columns * grid.rows, key.str()};
}

/**
Each point is computed with two steps. Where they disagree on the fate, the motion is erratic and neither result is
reliable: such a point is marked as undecided. */
void compute_turning_map(Sweep& sweep, const MapGrid& grid, Part part) {
  sweep.compute(part, [&](std::size_t i) {
    const double v = grid.velocity(i), chi = grid.scaled(i), s = chi / (v * std::sqrt(v));
    const double none = std::nan("");
    const Outcome coarse = outcome_of(v, s, horizon, 0), fine = outcome_of(v, s, horizon, 1);
    const Fate fate = coarse.fate == fine.fate ? fine.fate : Fate::undecided;
    Cells row{v, s, chi};
    row.emplace_back(std::int64_t(fate));
    for (double x : {fine.apex, std::abs(fine.apex - coarse.apex)})
      row.emplace_back(fate == Fate::turns ? x : none);
    return row;
  });
}

/**
We also need single points of the contour, by bisection between a packet that escapes and one that does not, with either
step. The finer step begins where the coarser one has ended. If the fate changes in that last interval with the finer
step too, this is the result; if not, the finer step goes all the way by itself. */
struct Bracket {
  double low, high;
};

/// The middles of the last intervals, with the coarse and with the fine step. `escapes(x, halvings)` holds at
/// the lower end.
template <class Middle, class Escapes>
std::pair<double, double> bisect_twice(Bracket all, int bisections, Middle middle,
                                       Escapes escapes) {
  const auto bisect = [&](int halvings) {
    Bracket at = all;
    for (int k = 0; k < bisections; ++k) {
      const double x = middle(at.low, at.high);
      (escapes(x, halvings) ? at.low : at.high) = x;
    }
    return at;
  };
  const Bracket coarse = bisect(0);
  const bool same = escapes(coarse.low, 1) && !escapes(coarse.high, 1);
  const Bracket fine = same ? coarse : bisect(1);
  return {middle(coarse.low, coarse.high), middle(fine.low, fine.high)};
}

/**
## The law of a contour

The contour on which the turning point is at a given site needs more precision than the map has, so we bisect in $s$,
with two steps. The error is their difference plus the last interval. The bisection asks only whether the packet passes
the site in the time of the run. If not, it counts as turning, whether it has turned, stays at the end that was hit, or
is still undecided. */
Estimate critical_s(double velocity, int bisections, double site = horizon) {
  const auto s_of = [&](double log_chi) {
    return std::exp(log_chi) / (velocity * std::sqrt(velocity));
  };
  const auto escapes = [&](double log_chi, int halvings) {
    return outcome_of(velocity, s_of(log_chi), site, halvings).fate == Fate::escapes;
  };
  const auto middle = [&](double low, double high) { return (low + high) / 2; };
  const auto [coarse, fine] =
      bisect_twice({std::log(0.5), std::log(60.0)}, bisections, middle, escapes);
  Estimate s = compare(s_of(coarse), s_of(fine));
  s.error += s.value * std::log(60 / 0.5) / std::ldexp(1.0, bisections);
  return s;
}

/**
The expected law is a line when $\chi_c = s_c v_0^{3/2}$ is plotted against $v_0^{1/2}$. We fit it
for $v_0 < 3$, a bound that is our choice, and measure it by its largest relative deviation, because the curvature of
a contour would show at the ends of the line and not in the mean. */
struct Contour {
  std::vector<double> velocity;
  std::vector<Estimate> s;
  double scaled(std::size_t i) const { return s[i].value * velocity[i] * std::sqrt(velocity[i]); }
};

struct Law {
  std::vector<double> root{}, chi{};  ///< v0^(1/2) and chi_c for v0 < 3
  std::vector<double> error{};        ///< of chi_c, relative
  Line line{};

  double at(double x) const { return line.intercept + line.slope * x; }
  Estimate chi_0() const;
};

Law fit_law(const Contour& c) {
  Law law;
  for (std::size_t i = 0; i < c.velocity.size(); ++i) {
    if (c.velocity[i] >= 3) continue;
    law.root.push_back(std::sqrt(c.velocity[i]));
    law.chi.push_back(c.scaled(i));
    law.error.push_back(c.s[i].error / c.s[i].value);
  }
  law.line = fit_line(law.root, law.chi);
  return law;
}

/**
The limit $v_0=0$ lies outside the range of the points, and the error of the slope enters $\chi_0$. So we take as its
error that of the slope times the root mean square of $v_0^{1/2}$. It is the error of a fit at *one* horizon and says
nothing about other horizons or weaker impacts. */
Estimate Law::chi_0() const {
  double square = 0;
  for (double x : root) square += x * x / double(root.size());
  return {line.intercept, line.slope_error * std::sqrt(square)};
}

/**
To test a limit the impacts must come close to it and also leave it. They span four decades, from
amplitudes at which the scaling should hold to those at which the linear part of the well hardly
matters. Above $v_0=1$ we also fit the plain power law that a reader would draw through the points of a
logarithmic plot, to compare its exponent with the $-3/2$ of the limit. */
void report_law(Report& report) {
  const std::size_t count = report.quick ? 6 : 20;
  Contour c{std::vector<double>(count), std::vector<Estimate>(count)};
  parallel_for("contour", count, [&](std::size_t i) {
    c.velocity[i] = MapGrid::spaced(report.quick ? 0.1 : 0.01, 100, i, count);
    c.s[i] = critical_s(c.velocity[i], report.quick ? 6 : 10);
  });
  const Law law = fit_law(c);
  Table& table = report.table(
      "critical_s", {number("velocity", "impact velocity"),
                     number("root_velocity", "square root of the impact velocity"),
                     estimate("s", "anharmonicity above which the packet does not pass site 40", "",
                              "from two time steps and the last interval of the bisection"),
                     number("kappa", "chi = s v0^(3/2)"), number("law", "chi_0 + chi_1 v0^(1/2)")});
  std::vector<double> log_v, log_s;
  for (std::size_t i = 0; i < count; ++i) {
    const double v = c.velocity[i], root = std::sqrt(v);
    table.add({v, root, c.s[i], c.scaled(i), law.at(root)});
    if (v > 1) log_v.push_back(std::log(v)), log_s.push_back(std::log(c.s[i].value));
  }

  // The largest deviation from the line, with the error of that point
  Estimate scatter{};
  for (std::size_t i = 0; i < law.root.size(); ++i)
    if (const double off = std::abs(law.chi[i] / law.at(law.root[i]) - 1); off > scatter.value)
      scatter = {off, law.error[i]};
  report.facts.add("law_kappa_1", law.line.estimate());
  report.facts.add("law_kappa_0", law.chi_0());
  report.facts.add("law_largest_deviation", scatter, "relative");
  report.facts.add("power_large_impacts", fit_line(log_v, log_s).estimate());
}

/**
## Other horizons

Site 40 is our choice. If the contour were the boundary between packets that turn and packets that do not turn at all,
it would not depend on it. So we bisect again for a turning point at half and at twice that distance. At $v_0=0.1$
$\chi_c$ falls from [1.55](num:sec34_boomeron_map.kappa_010_site_20) at site 20 to
[1.34](num:sec34_boomeron_map.kappa_010_site_40) at 40 and [1.18](num:sec34_boomeron_map.kappa_010_site_80) at 80, and
with it the $\chi_0$ of a line through six impacts from $0.1$ to $2.5$, from
[1.26](num:sec34_boomeron_map.kappa_0_site_20) over [1.06](num:sec34_boomeron_map.kappa_0_site_40) to
[0.887](num:sec34_boomeron_map.kappa_0_site_80). A $\chi_0$ depends on the impacts, too: the twelve from $0.01$ to 3,
with which the law was fitted for site 40, give [1.02](num:sec34_boomeron_map.law_kappa_0). The contours are not quite
straight and bend down towards weak impacts. So none of these is the limit at $v_0 \to 0$, which lies lower: at $v_0 =
2.5\cdot10^{-5}$ another program, not part of this repository, finds $\chi_c = 1.16$, $1.00$ and $0.87$. */
void report_horizons(Report& report) {
  struct Point {
    double site, velocity;
    Estimate s;
  };
  const std::size_t count = report.quick ? 3 : 6;
  const std::vector<double> sites =
      report.quick ? std::vector<double>{20, 40} : std::vector<double>{20, 40, 80};
  std::vector<Point> points;
  for (double site : sites)
    for (std::size_t i = 0; i < count; ++i)
      points.push_back({site, MapGrid::spaced(0.1, 2.5, i, count), {}});
  const auto row = [&](Point& p) {
    p.s = critical_s(p.velocity, report.quick ? 6 : 10, p.site);
    const double scale = p.velocity * std::sqrt(p.velocity);
    return Cells{p.site, p.velocity, Estimate{p.s.value * scale, p.s.error * scale}};
  };
  report
      .table(
          "contours",
          {number("site", "site of the turning point", "site"),
           number("velocity", "impact velocity"),
           estimate(
               "kappa", "chi = s v0^(3/2)", "",
               "from two time steps and the last interval of the bisection, against the largest")})
      .fill(points, row, "horizons");

  // At each horizon the value at v0 = 0.1 and the limit
  for (std::size_t i = 0; i < points.size(); i += count) {
    Contour c;
    for (std::size_t k = i; k < i + count; ++k)
      c.velocity.push_back(points[k].velocity), c.s.push_back(points[k].s);
    const std::string at = "_site_" + short_text(points[i].site);
    report.facts.add("kappa_010" + at, {c.scaled(0), c.s[0].error / c.s[0].value * c.scaled(0)});
    report.facts.add("kappa_0" + at, fit_law(c).chi_0());
  }
}

/**
## Does every hard well turn packets?

The article saw packets turn for $s\ge0.005$ and not at $s=0$. For the first we bisect in $v_0$, at $s=0.005$,
for the weakest impact whose packet turns before site 40, and in $s$ at $v_0=1.9$, the article's strongest
impact. For the second we try every velocity of the map at $s=0$, with either of two steps. */
void report_any_s(Report& report) {
  // The weakest impact in the softest well
  const double slowest = 20, fastest = MapGrid{}.fastest;
  const int bisections = report.quick ? 5 : 9;
  const auto escapes = [](double v, int halvings) {
    return outcome_of(v, softest, horizon, halvings).fate == Fate::escapes;
  };
  const auto middle = [](double low, double high) { return std::sqrt(low * high); };
  const auto [coarse, fine] = bisect_twice({slowest, fastest}, bisections, middle, escapes);
  Estimate v0 = compare(coarse, fine);
  v0.error += v0.value * std::log(fastest / slowest) / std::ldexp(1.0, bisections);
  report.facts.add("v0_needed_at_s_0005", v0);

  // No packet may turn in the linear well
  const MapGrid grid;
  const std::size_t columns = report.quick ? 6 : grid.columns;
  std::vector<int> moved(columns);
  parallel_for(columns, [&](std::size_t i) {
    const double v = MapGrid::spaced(grid.slowest, grid.fastest, i, columns);
    for (int halvings : {0, 1})
      moved[i] += outcome_of(v, 0, horizon, halvings).fate != Fate::escapes;
  });
  report.facts.add("turns_without_hardness",
                   exact(std::accumulate(moved.begin(), moved.end(), 0.0)), "runs");

  // At the article's velocity the answer is a hardness
  report.facts.add("s_needed_at_19", critical_s(1.9, report.quick ? 6 : 10));
}

/**
## Results

[](finding:turning.contour) The exponent $-3/2$ belongs to the chain; $\chi_0$ belongs to the horizon and to the impacts
that are fitted. Above $v_0=1$ the points seem to lie on another power law, and a fit gives the exponent
[-1.24](num:sec34_boomeron_map.power_large_impacts); but the slope changes along the contour, and this is a mean.

**At the article's least hardness, $s=0.005$, packets turn before site 40 after very strong impacts only.** At $v_0=1.9$
it takes $s$ above [0.908](num:sec34_boomeron_map.s_needed_at_19) to turn a packet before site 40 (if $s$ is far larger,
it stays at the end that was hit), and at $s=0.005$ an impact of [128](num:sec34_boomeron_map.v0_needed_at_s_0005), far
above the velocities that the article prints. It does not say for which impact and until when it looked, and we do not
know whether a weaker packet turns farther out. At $s=0$ none turned before site 40. */
void reproduce(Report& report) {
  MapGrid grid;
  if (report.quick) grid.columns = grid.rows = 8;
  Sweep sweep = turning_map_sweep(report.output.folder(), grid);
  compute_turning_map(sweep, grid, {});
  report.output.add("reversal_map", sweep.table());
  report_law(report);
  report_horizons(report);
  report_any_s(report);
  sweep.forget();
}

/**
## Differences and limits

We cannot show that a packet never turns, only that it does not turn before a given site. So there is no boundary here,
only contours. They move to smaller $\chi$ as the site moves out, and from the three that we have we cannot say whether
they approach a limit. For $\chi$ far above the contour the motion near the end that was hit is erratic, and the fate of
single points depends on the last digit.

## Try it

1. *Easy.* Halve the impact $v_0 = 1.9$ at $s = 1$ and keep $\chi$:
   `build/bin/sec34_boomeron run --velocity 0.95 --s 2.828427 --time 1500` gives `apex_site` = 10.00 and `return_time` =
   331, instead of 20.07 and 898. Hint: $\chi = 2.6$ is above the contour of site 40 for both, but these impacts are not
   weak.
2. *Harder.* Weaker impacts at $\chi = 1.6$: `build/bin/sec34_boomeron run --velocity 0.475 --s 4.887419 --time 4000`
   gives `apex_site` = 60.9, `build/bin/sec34_boomeron run --velocity 0.2375 --s 13.823708 --time 6000` gives
   `apex_site` = 30.7. Hint: the contour of site 40 lies between them; its correction is proportional to $v_0^{1/2}$.
3. *Open.* Is there a $\chi$ below which no packet turns? Does $\chi_0$ follow from a DpS equation with a cubic term?
4. *Open.* Does the law hold for an impact on a chain with a fixed end?

## With your own parameters

The points of the map are independent, so several machines can share them. `sec34_boomeron_map map --part 2/8 --folder
rows` computes every eighth point from the second on and keeps it in the folder; without `--part` the command collects
what is there, computes what is missing and prints the whole map. */
struct TurningMap : MapPart {
  static constexpr Title title{"map",
                               "map of the impacts whose packets turn back, or a part of the map"};
  MapGrid grid{};

  void parameters(Parameters& p) {
    MapPart::parameters(p);
    p.add("columns", grid.columns, "number of impact velocities", {2, 1000});
    p.add("rows", grid.rows, "number of anharmonicities", {2, 1000});
  }
  Table table() const {
    Sweep sweep = turning_map_sweep(folder, grid);
    compute_turning_map(sweep, grid, mine());
    return sweep.table(mine());
  }
};

int main(int argc, char** argv) {
  return run({"sec34_boomeron_map", "3.4", "Which packets turn round (section 3.4, s > 0)",
              reproduce, commands<TurningMap>()},
             argc, argv);
}
