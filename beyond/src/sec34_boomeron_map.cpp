/**
# 3.4 Which packets turn round

In hard wells, $s > 0$, the packet launched by an impact slows down, turns round and comes back. Section 3.4 of James,
Kevrekidis and Cuevas (Physica D 251, 2013) says that it does so for $s\ge0.005$ and not for $s = 0$, but not for which
impacts and how far out. We map where packets turn; why they do is the subject of `sec34_why_packets_turn`.

- In the limit of weak impacts the site at which a packet turns should depend on one number, $\chi = s\,v_0^{3/2}$. The values of $s$ at
  which it turns at site 40 follow a fit with two coefficients.
- This contour is not a boundary: in softer wells packets turn farther out. Whether contours of ever farther sites
  approach one is open.

## Model

The chain is that of `sec34_boomeron`, Eqs. (9), (10) and (26), at rest before the impact, with free ends,
$$\ddot y_n + y_n + s\,y_n^3 = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2},
  \qquad \dot y_n(0) = v_0\,\delta_{n,1}.$$
As in that chapter the packet is where the energy density
$e_n$ of Eq. (23) is largest, and its place $X$ is the energy centre, Eq. (24). */

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "commands/sweep.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/integrators/event_corrected.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"

using namespace lattice;
using namespace report;

/**
## What counts as turning

A map needs one criterion for all its points, although the impacts differ by orders of magnitude. A packet has *turned*
when $X$, averaged over about one internal period, has come back by five sites; a packet that is trapped between two
sites swings by less. It has *escaped* when it passes site 40, the *horizon*, and it *stays* if it never gets beyond
site 8. A packet that turns farther out than site 40 counts as escaped: with $s=1$ and $v_0=1.5$ the map says *escaped*,
and the packet does turn, at site [183](cell:sec34_boomeron/turns/velocity=1.5/apex_site).

Samples and steps follow the fastest motion, that of the well, of the contact or of the quartic term, with rates one,
$v_0^{1/5}$ and $(s v_0^2)^{1/4}$. How long to wait is decided by the slowest packets, those of the DpS limit, which
move at $0.36\,(v_0/2)^{1/2}$ sites per unit of time (dps.hpp), with 0.4 as an upper limit. We wait ten times as long as
they need to reach the horizon; a packet that has not left the end after four times as long stays. After a strong impact
all is faster, so both times are divided by the largest rate. The chain ends twenty sites beyond the horizon. */
enum class Fate : std::int64_t { escapes, turns, stays, undecided };

struct Outcome {
  Fate fate = Fate::undecided;
  double apex = 0;  ///< furthest mean centre so far
};

/// Strikes the chain and follows the packet until its fate is known; steps are halved `halvings` times.
Outcome outcome_of(double velocity, double s, double horizon, int halvings) {
  const double rate =
      std::max({1.0, std::pow(velocity, 0.2), std::pow(s * velocity * velocity, 0.25)});
  const double crossing = horizon / std::min(0.36 * std::sqrt(velocity / 2), 0.4);
  const double interval = 0.8 / rate, time = 10 * crossing / rate,
               stays_after = 4 * crossing / rate;
  const Chain chain{std::size_t(horizon) + 20, Quartic{s}};
  Outcome out;
  Path period;
  // The mean over one internal period decides: past the horizon, on the way back, or never away
  const auto look = [&](const State<double>& now, const std::vector<double>& density) {
    period.add(now.t, density);
    if (period.size() < 8) return true;
    double x = 0;
    for (const PathSample& at : period) x += at.centre / 8;
    period = {};
    out.apex = std::max(out.apex, x);
    if (x > horizon) out.fate = Fate::escapes;
    if (x < out.apex - 5) out.fate = Fate::turns;
    if (now.t > stays_after && out.apex < 8) out.fate = Fate::stays;
    return out.fate == Fate::undecided;
  };
  // Four steps between two looks resolve the fastest motion; halvings shorten the steps only
  EventCorrected method{interval / 4};
  method.halvings = halvings;
  strike(method, {velocity, chain, time, interval, may_move, false}, look);
  return out;
}

/**
## The map (figure x11a)

Where should the points of the map lie? In a packet with displacements of size $y$ the well pulls with $y$, the contacts
push with $y^{3/2}$, and the hardness adds $s\,y^3$. If both are small compared with $y$, the beads oscillate almost
freely and their amplitudes change slowly, as in the DpS equation (`sec34_dps_impact`); $y^{1/2}$ only sets how slowly.
In units of this slow time the motion depends only on the ratio of the two, $s\,y^{3/2}$, and, as $y$ is proportional to
$v_0$, on the *scaled hardness*
$$\chi = s\,v_0^{3/2}.$$
So we expect packets to turn before a given site if $s$ is above
$$s_c(v_0) = v_0^{-3/2}\,(\chi_0 + \chi_1 v_0^{1/2} + \dots),$$
where the second term is the first correction, in $y^{1/2}$, to that limit. The contour crosses many decades of $s$
while $\chi$ changes little, so we place the points of each velocity at equal ratios of $\chi$, from 0.7 to 20.

![Fate of the packet against impact and well, and the law of a contour.](fig:x11) */
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

// Each row is stored as soon as it is known, together with all parameters that determine it (sweep.hpp)
Sweep turning_map_sweep(const std::filesystem::path& folder, const MapGrid& grid) {
  const std::vector<Column> columns{
      number("velocity", "impact velocity"),
      number("s", "anharmonicity of the well"),
      number("chi", "the scaled hardness chi = s v0^(3/2)"),
      count("fate",
            "0 escapes, 1 turns back, 2 stays, 3 undecided or different for two time steps"),
      number("apex", "farthest mean centre of a packet that turns back; nan for others", "site"),
      number("apex_difference", "difference between two time steps", "site")};
  std::ostringstream key;
  key << grid.columns << " x " << grid.rows << " points, chi from " << grid.least << " to "
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
## The law of a contour (figure x11b)

The contour on which the turning point is at a given site needs more precision than the map has, so we bisect between a
packet that escapes and one that does not in the time that we wait, with two steps. The finer step begins where the
coarser one has ended; if the fate does not change in that last interval with the finer step too, it goes all the way by
itself. The error is the difference of the two plus the last interval. */
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
  Estimate s = with_error(s_of(coarse), s_of(fine));
  s.error += s.value * std::log(60 / 0.5) / std::ldexp(1.0, bisections);
  return s;
}

/**
The expected law is a line when $\chi_c = s_c v_0^{3/2}$ is plotted against $v_0^{1/2}$. We fit it for $v_0 < 3$, a
bound that is our choice (the last point is at 2.07; stronger impacts leave the line), and quote its largest relative
deviation, because the curvature of a contour would show at the ends of the line and not in the mean. The limit $v_0=0$
lies outside the range of the points, so the error of $\chi_0$ is that of the slope times the root mean square of
$v_0^{1/2}$. It is the error of a fit at *one* horizon, and $\chi_0$ is not the limit of weak impacts: below $v_0 =
0.01$ the line bends. After some strong impacts, one of them at $v_0 = 1.27$, the fate changes more than once as $s$
grows: within three per cent of the line packets turn and pass again. The bisection finds one of these changes
(`beyond/paper/findings.ecsv`).

<!-- turning.contour -->
In hard wells a packet has its turning point at site 40 if $s = v_0^{-3/2}(\chi_0+\chi_1v_0^{1/2})$ with $\chi_0 =$
1.022 ± 0.008 and $\chi_1 =$ 0.99 ± 0.01, to within a fraction 0.015 ± 0.005 for impacts from $v_0 = 0.01$ to 2.07. This
curve is a contour, not a boundary: in softer wells packets turn farther out. (computed)
<!-- /turning.contour --> */
struct Contour {
  std::vector<double> velocity, root, chi;  // root = v0^(1/2)
  std::vector<Estimate> s;
};

/// A contour of `count` impacts from `slowest` to 100.
Contour contour(double slowest, std::size_t count, int bisections) {
  const std::vector<double> none(count);
  Contour c{none, none, none, std::vector<Estimate>(count)};
  parallel_for("contour", count, [&](std::size_t i) {
    const double v = c.velocity[i] = MapGrid::spaced(slowest, 100, i, count);
    c.s[i] = critical_s(v, bisections);
    c.root[i] = std::sqrt(v);
    c.chi[i] = c.s[i].value * v * c.root[i];
  });
  return c;
}

void report_law(Report& report) {
  const Contour c = report.quick ? contour(0.1, 6, 6) : contour(0.01, 20, 10);

  // A line through chi for weak impacts, and a power of the strong ones
  const auto weak =
      std::size_t(std::lower_bound(c.velocity.begin(), c.velocity.end(), 3) - c.velocity.begin());
  const auto first = [&](const std::vector<double>& x) {
    return std::vector<double>(x.begin(), x.begin() + std::ptrdiff_t(weak));
  };
  const Line line = fit_line(first(c.root), first(c.chi));
  const auto law = [&](std::size_t i) { return line.intercept + line.slope * c.root[i]; };
  std::vector<double> log_v, log_s;
  for (std::size_t i = 0; i < c.s.size(); ++i)
    if (c.velocity[i] > 1)
      log_v.push_back(std::log(c.velocity[i])), log_s.push_back(std::log(c.s[i].value));

  // How well they fit: the largest deviation from the line, with the error of that point
  Estimate deviation{};
  double square = 0;
  for (std::size_t i = 0; i < weak; ++i) {
    square += c.root[i] * c.root[i] / double(weak);
    if (const double off = std::abs(c.chi[i] / law(i) - 1); off > deviation.value)
      deviation = {off, c.s[i].error / c.s[i].value};
  }
  const Estimate chi_0{line.intercept, line.slope_error * std::sqrt(square)};
  report.table("law").add(
      {{"chi_0", "chi of the line at v0 = 0", chi_0, "", "of the fit"},
       {"chi_1", "slope of the line", line.estimate(), "", "of the fit, known to 2 per cent"},
       {"deviation", "largest deviation of a point with v0 < 3 from the line", deviation,
        "relative", "of that point, relative"},
       {"power", "exponent of v0 in s of the contour for v0 > 1", fit_line(log_v, log_s).estimate(),
        "", "of the fit"}});
  Table& table = report.table(
      "critical_s", {number("velocity", "impact velocity"),
                     number("root_velocity", "square root of the impact velocity"),
                     estimate("s", "anharmonicity above which the packet does not pass site 40", "",
                              "from two time steps and the last interval of the bisection"),
                     number("chi", "s v0^(3/2)"), number("law", "chi_0 + chi_1 v0^(1/2)")});
  for (std::size_t i = 0; i < c.s.size(); ++i)
    table.add({c.velocity[i], c.root[i], c.s[i], c.chi[i], law(i)});
}

/**
Site 40 is our choice. If the contour were the boundary between packets that turn and packets that do not turn at all,
it would not depend on it. It does at all impacts, and three sites do not tell whether the contours approach a limit.

| $\chi_c$ for a turning point at | site 20 | site 40 | site 80 |
|---|---|---|---|
| $v_0=0.1$ | [1.554 ± 0.007](cell:contours/site=20/velocity=0.1/chi) | [1.338 ± 0.006](cell:site=40/chi) | [1.179 ± 0.006](cell:site=80/chi) |
| $v_0=2.5$ | [2.80 ± 0.01](cell:contours/site=20/velocity=2.5/chi) | [2.53 ± 0.01](cell:site=40/chi) | [2.36 ± 0.01](cell:site=80/chi) | */
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
               "chi", "s v0^(3/2)", "",
               "from two time steps and the last interval of the bisection, against the largest")})
      .fill(points, row, "horizons");
}

/**
## Does every hard well turn packets?

At the article's least hardness, $s=0.005$, it takes an impact of [128.4 ± 0.6](cell:needed/velocity) to turn a
packet before site 40, far above the velocities that the article prints. At $v_0=1.9$, where it shows a packet that
turns, it takes $s$ above [0.908 ± 0.004](cell:needed/s). We do not know for which impact and until when the article
looked, nor whether a weaker packet turns farther out. */
void report_any_s(Report& report) {
  const double slowest = 20, fastest = MapGrid{}.fastest;
  const int bisections = report.quick ? 5 : 9;
  const auto escapes = [](double v, int halvings) {
    return outcome_of(v, 0.005, horizon, halvings).fate == Fate::escapes;
  };
  const auto middle = [](double low, double high) { return std::sqrt(low * high); };
  const auto [coarse, fine] = bisect_twice({slowest, fastest}, bisections, middle, escapes);
  Estimate v0 = with_error(coarse, fine);
  v0.error += v0.value * std::log(fastest / slowest) / std::ldexp(1.0, bisections);
  report.table("needed").add(
      {{"velocity", "impact above which packets turn before site 40 at s = 0.005", v0, "",
        "from two time steps and the last interval of the bisection"},
       {"s", "anharmonicity above which they do at v0 = 1.9",
        critical_s(1.9, report.quick ? 6 : 10), "",
        "from two time steps and the last interval of the bisection"}});
}

/**
## Differences and limits

We cannot show that a packet never turns, only that it does not before a given site or time. For $\chi$ far above the
contour the motion near the end that was hit is erratic, and the fate of single points depends on the last digit. */
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
## Try it

**To change it.** The impacts and wells of the map are those of `MapGrid`, the site of the contour is `horizon`.

1. *Easy.* Halve the impact $v_0 = 1.9$ at $s = 1$ and keep $\chi$:
   `build/bin/sec34_boomeron run --velocity 0.95 --s 2.828427 --time 1500` gives `apex_site` = 10.00 and `return_time` =
   331, instead of 20.07 and 898. Hint: $\chi = 2.6$ is above the contour of site 40 for both, but these impacts are not
   weak.
2. *Harder.* Weaker impacts at $\chi = 1.6$: `build/bin/sec34_boomeron run --velocity 0.475 --s 4.887419 --time 4000`
   gives `apex_site` = 60.9, `build/bin/sec34_boomeron run --velocity 0.2375 --s 13.823708 --time 6000` gives
   `apex_site` = 30.7. Hint: the contour of site 40 lies between them; its correction is proportional to $v_0^{1/2}$.

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
