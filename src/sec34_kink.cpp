/**
# 3.4 From breather to kink in pendulum wells

Section 3.4 of James, Kevrekidis and Cuevas (Physica D 251, 2013) closes with a remark:
in the gravity wells of a real cradle, $W = 1-\cos y$, a strong impact does not blow up; the
travelling breather gives way to a kink that throws a finite number of beads off the far
end. Nothing is shown, and the transition is left open. This program maps it.

The claim, and where its answer is recorded: at large impact velocity a kink replaces the
breather and beads are ejected at the far end (`impact.kink`). */

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "lattice/impact.hpp"
#include "lattice/parallel.hpp"
#include "lattice/program.hpp"

using namespace lattice;

/**
## Model and method

The chain is that of the impact chapter with another well,
$$\ddot y_n + \sin y_n = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2}, \qquad
  \dot y_1(0) = v_0,$$
dimensionless, with free ends. A bead that passes the rim at $y = \pi$ falls into the next
well instead of running away. A bead never attracts its neighbour, so the first bead can
also be thrown back over $y = -\pi$, and leaves.

The same runs are made with two steps. Where they disagree about the integers below, the
velocity is marked and supports no statement. */
constexpr double step = 0.05;

ContactAware stepper(int halvings) {
  return {std::ldexp(step, -halvings)};
}

/**
## What is counted

We wait until the fastest disturbance has crossed the chain and everything that will jump has
jumped, and count the beads by the well in which they then are: `moved` have advanced by at
least one well. After a kink that crosses the whole chain this is everybody between the two
ends. A bead more than one well ahead at the far end has nobody in front of it: it is
`ejected_far`. A bead that went backwards is `ejected_near`. */
struct Counts {
  std::int64_t moved = 0, ejected_far = 0, ejected_near = 0;
  friend bool operator==(const Counts&, const Counts&) = default;
};

Counts count_wells(const State<double>& state) {
  Counts counts;
  const std::size_t half = state.y.size() / 2;
  for (std::size_t n = 0; n < state.y.size(); ++n) {
    const long well = std::lround(state.y[n] / (2 * std::numbers::pi));
    counts.moved += well >= 1;
    counts.ejected_far += well >= 2 && n >= half;
    counts.ejected_near += well <= -1 && n < half;
  }
  return counts;
}

struct Options {
  double velocity = 5, time = 150;
  std::size_t sites = 50;
};

/// Runs one impact; `watch(state)` sees every half unit of time.
template <class Watch>
Counts strike(const Options& options, int halvings, Watch watch) {
  const Chain<Pendulum, Hertz> chain{options.sites};
  State<double> state = struck(options.sites, options.velocity);
  evolve(stepper(halvings), chain, state, options.time, 0.5, watch);
  return count_wells(state);
}

/**
## The transition (figure x01)

We scan the impact velocity. A breather moves nobody, a kink moves everybody.

![The share of beads that a struck chain advances by one well, and two examples.](fig:x01) */
struct Point {
  double velocity = 0;
  Counts counts{};
  bool agree = false;
};

std::vector<Point> scan(double from, double to, double spacing) {
  std::vector<Point> points(std::size_t(std::lround((to - from) / spacing)) + 1);
  Progress progress("impact velocities", points.size());
  parallel_for(points.size(), [&](std::size_t i) {
    Point& p = points[i];
    p.velocity = from + spacing * double(i);
    const Counts coarse = strike({.velocity = p.velocity}, 0, Unobserved{});
    p.counts = strike({.velocity = p.velocity}, 1, Unobserved{});
    p.agree = p.counts == coarse;
    progress.tick();
  });
  return points;
}

Table scan_table(const std::vector<Point>& points, std::size_t sites) {
  Table table{{number("velocity", "impact velocity"),
               number("moved", "share of the beads that advanced by a well"),
               count("ejected_far", "beads thrown off the far end"),
               count("ejected_near", "beads thrown back at the near end"),
               count("agree", "1 where two resolutions give the same counts")}};
  for (const Point& p : points)
    table.add({p.velocity, double(p.counts.moved) / double(sites), p.counts.ejected_far,
               p.counts.ejected_near, std::int64_t(p.agree)});
  return table;
}

/// Displacements over time for one velocity below the transition and one above.
Table examples() {
  Table table{{number("velocity", "impact velocity"), number("t", "time"),
               count("n", "site", "site"), number("wells", "displacement in units of 2 pi")}};
  for (double velocity : {2.0, 5.0})
    strike({.velocity = velocity, .time = 100}, 1, [&](const State<double>& now) {
      for (std::size_t n = 0; n < now.y.size(); ++n)
        table.add({velocity, now.t, std::int64_t(n + 1), now.y[n] / (2 * std::numbers::pi)});
    });
  return table;
}

/**
## Results

The transition is not sharp. We give the highest velocity up to which no bead has moved on, and
the lowest one from which the kink always crosses the whole chain and ejects somebody, with
the spacing of the scan as the error. The claim holds if both exist and the first is the
smaller one. */
Results everything(Output& output, bool quick) {
  const double spacing = quick ? 0.25 : 0.02;
  const auto points = scan(1, 8, spacing);
  Results results;
  Quantities facts;
  std::size_t still = 0, always = points.size(), disagree = 0;
  while (still < points.size() && points[still].counts.moved == 0) ++still;
  const auto is_kink = [](const Point& p) {
    return p.agree && p.counts.ejected_far > 0 &&
           p.counts.moved + 1 >= std::int64_t(Options{}.sites);
  };
  while (always > 0 && is_kink(points[always - 1])) --always;
  for (const Point& p : points) disagree += !p.agree;
  const bool found = still > 0 && always < points.size() && still <= always;
  output.add("kink_transition", scan_table(points, Options{}.sites));
  output.add("kink_examples", examples());
  if (found) {
    facts.add("last_breather", {points[still - 1].velocity, spacing});
    facts.add("first_certain_kink", {points[always].velocity, spacing});
  }
  facts.add("velocities_undecided", {double(disagree) / double(points.size()), 0}, "share");
  output.add("facts", facts.table);
  results.claim("impact.kink", found);
  return results;
}

/**
## One impact with your own parameters

`sec34_kink run --velocity 5` prints the counts for one velocity, the difference of two
resolutions as their error. */
Table run_command(const Options& options) {
  const Counts coarse = strike(options, 0, Unobserved{}), fine = strike(options, 1, Unobserved{});
  Quantities q;
  q.add("moved", compare(double(coarse.moved), double(fine.moved)), "beads");
  q.add("ejected_far", compare(double(coarse.ejected_far), double(fine.ejected_far)), "beads");
  q.add("ejected_near", compare(double(coarse.ejected_near), double(fine.ejected_near)), "beads");
  return q.table;
}

/**
## Differences and limits

The article gives no parameters, so the chain length, the waiting time and the scan are ours:
50 beads and 150 units of time, several times what the kink needs to cross the chain. At high
velocity several kinks can follow each other, and which beads leave the far end then depends
on all of them.

## Extensions

- Does the kink slow down and stop in a longer chain, and where does its energy go?
- How does the number of ejected beads grow with the velocity?
- What is left of the transition with precompression? */
int main(int argc, char** argv) {
  Program program({"sec34_kink", "3.4", "Breather and kink in pendulum wells (section 3.4)"}, argc,
                  argv);
  Options options;
  CLI::App* run =
      program.command("run", "one impact: who moved on", [&] { return run_command(options); });
  run->add_option("--velocity", options.velocity, "impact velocity")->check(in_range(1e-6, 100));
  run->add_option("--time", options.time, "length of the run")->check(in_range(1, 1e4));
  run->add_option("--sites", options.sites, "chain length")->check(in_range(2, 1e5));
  program.everything = [&](Output& output) { return everything(output, program.quick); };
  return program.run(argc, argv);
}
