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

#include "lattice/measure/impact.hpp"
#include "lattice/numbers/parallel.hpp"
#include "lattice/report/program.hpp"

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

We count the beads by the wells in which they are: `moved` have advanced by at least one. A kink
that crosses the whole chain moves everybody. Beads in the far half that are further ahead than
the middle of the chain have nobody in front of them and leave: `ejected_far`. Beads that have
gone backwards over the rim are thrown out at the near end: `ejected_near`. */
struct Counts {
  std::int64_t moved = 0, ejected_far = 0, ejected_near = 0;
  friend bool operator==(const Counts&, const Counts&) = default;
};

Counts count_wells(const State<double>& state) {
  Counts counts;
  const auto well = [&](std::size_t n) { return std::lround(state.y[n] / (2 * std::numbers::pi)); };
  const std::size_t half = state.y.size() / 2;
  for (std::size_t n = 0; n < state.y.size(); ++n) {
    counts.moved += well(n) >= 1;
    counts.ejected_far += n > half && well(n) > well(half);
    counts.ejected_near += n < half && well(n) <= -1;
  }
  return counts;
}

/**
Just above the transition a kink creeps, may stop, and may come back; a count taken too early
mistakes it for a state. We therefore wait until the counts have not changed while the time
doubled, and give up at `patience`: such a velocity is undecided. */
struct Options {
  double velocity = 5, patience = 3200;
  std::size_t sites = 50;
};
constexpr double first_look = 100;

struct Verdict {
  Counts counts{};
  bool settled = false;
};

Verdict strike(const Options& options, const ContactAware& stepper) {
  const Chain<Pendulum, Hertz> chain{options.sites};
  State<double> state = struck(options.sites, options.velocity);
  Verdict verdict;
  double next = first_look;
  evolve(stepper, chain, state, options.patience, first_look, [&](const State<double>& now) {
    if (now.t < next * (1 - 1e-9)) return true;
    const Counts counts = count_wells(now);
    verdict.settled = next > first_look && counts == verdict.counts;
    verdict.counts = counts;
    next *= 2;
    return !verdict.settled;
  });
  return verdict;
}

/**
## The transition (figure x01)

We scan the impact velocity, each one with two steps.

![What a struck chain of pendulums does, and two examples.](fig:x01) */
struct Point {
  double velocity = 0;
  Counts counts{};
  bool decided = false;  ///< settled, and the same at both steps
};

std::vector<Point> scan(double from, double to, double spacing) {
  std::vector<Point> points(std::size_t(std::lround((to - from) / spacing)) + 1);
  Progress progress("impact velocities", points.size());
  parallel_for(points.size(), [&](std::size_t i) {
    Point& p = points[i];
    p.velocity = from + spacing * double(i);
    const Options options{.velocity = p.velocity};
    const Verdict coarse = strike(options, stepper(0)), fine = strike(options, stepper(1));
    p.counts = fine.counts;
    p.decided = coarse.settled && fine.settled && fine.counts == coarse.counts;
    progress.tick();
  });
  return points;
}

Table scan_table(const std::vector<Point>& points, std::size_t sites) {
  Table table{{number("velocity", "impact velocity"),
               number("moved", "share of the beads that advanced by a well"),
               count("ejected_far", "beads thrown off the far end"),
               count("ejected_near", "beads thrown back at the near end"),
               count("decided", "1 where the counts have settled and agree at two steps")}};
  for (const Point& p : points)
    table.add({p.velocity, double(p.counts.moved) / double(sites), p.counts.ejected_far,
               p.counts.ejected_near, std::int64_t(p.decided)});
  return table;
}

/// Displacements over time for one velocity below the transition and one above.
Table examples() {
  Table table{{number("velocity", "impact velocity"), number("t", "time"),
               count("n", "site", "site"), number("wells", "displacement in units of 2 pi")}};
  for (double velocity : {2.0, 5.0}) {
    const Chain<Pendulum, Hertz> chain{Options{}.sites};
    State<double> state = struck(chain.sites, velocity);
    evolve(stepper(1), chain, state, 100, 0.5, [&](const State<double>& now) {
      for (std::size_t n = 0; n < now.y.size(); ++n)
        table.add({velocity, now.t, std::int64_t(n + 1), now.y[n] / (2 * std::numbers::pi)});
    });
  }
  return table;
}

/**
## Results

There are three regimes. A weak impact moves nobody. From
[2.48](num:sec34_kink.first_thrown_back) on the recoil throws beads back at the near end, and the
breather still travels. Between [4.66](num:sec34_kink.last_breather), up to which nobody has moved on,
and [4.72](num:sec34_kink.first_certain_kink), from which every decided impact moves the whole chain and
ejects somebody at the far end, the kink takes over. Errors are the spacing of the scan; velocities
that stay undecided support no statement. */
Results everything(Output& output, bool quick) {
  output.note("tolerance", "steps " + short_text(step) + " and " + short_text(step / 2));
  const double spacing = quick ? 0.25 : 0.02;
  auto points = scan(1, 8, spacing);
  output.add("kink_transition", scan_table(points, Options{}.sites));
  output.add("kink_examples", examples());
  const double all = double(points.size());
  std::erase_if(points, [](const Point& p) { return !p.decided; });
  Quantities facts;
  facts.add("velocities_undecided", {1 - double(points.size()) / all, 0}, "share");
  std::size_t still = 0, always = points.size(), back = 0;
  while (still < points.size() && points[still].counts.moved == 0) ++still;
  while (back < points.size() && points[back].counts.ejected_near == 0) ++back;
  const auto is_kink = [](const Point& p) {
    return p.counts.ejected_far > 0 && p.counts.moved == std::int64_t(Options{}.sites);
  };
  while (always > 0 && is_kink(points[always - 1])) --always;
  const bool found = still > 0 && always < points.size() && still <= always;
  if (found) {
    facts.add("last_breather", {points[still - 1].velocity, spacing});
    facts.add("first_certain_kink", {points[always].velocity, spacing});
  }
  if (back < points.size()) facts.add("first_thrown_back", {points[back].velocity, spacing});
  output.add("facts", facts.table);
  Results results;
  results.claim("impact.kink", found);
  return results;
}

/**
## One impact with your own parameters

`sec34_kink run --velocity 5` prints the counts for one velocity, the difference of two
resolutions as their error. It fails where they have not settled within `--patience`. */
Table run_command(const Options& options) {
  const Verdict coarse = strike(options, stepper(0)), fine = strike(options, stepper(1));
  if (!coarse.settled || !fine.settled)
    throw Failure("the counts have not settled: --patience is too short, or the motion is erratic");
  const auto both = [&](std::int64_t Counts::*count) {
    return compare(double(coarse.counts.*count), double(fine.counts.*count));
  };
  Quantities q;
  q.add("moved", both(&Counts::moved), "beads");
  q.add("ejected_far", both(&Counts::ejected_far), "beads");
  q.add("ejected_near", both(&Counts::ejected_near), "beads");
  return q.table;
}

/**
## Differences and limits

The article gives no parameters, so the chain length, the patience and the scan are ours. A count
that settles once may still change much later, and in a longer chain a slow kink may stop
before the end. At high velocity several kinks follow each other, and which beads leave the far
end then depends on all of them.

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
  run->add_option("--patience", options.patience, "longest wait for the counts to settle")
      ->check(in_range(400, 1e5));
  run->add_option("--sites", options.sites, "chain length")->check(in_range(2, 1e5));
  program.everything = [&](Output& output) { return everything(output, program.quick); };
  return program.run(argc, argv);
}
