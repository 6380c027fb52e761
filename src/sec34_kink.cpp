/**
# 3.4 From breather to kink in pendulum wells

In the wells of a real cradle, $W = 1-\cos y$, a bead that is struck too hard does not fly off: it
swings over the top and comes down in the next well. What becomes of the travelling breather?

     before   (1) (2) (3) (4) (5) (6)            every bead in its own well
              \_/ \_/ \_/ \_/ \_/ \_/ \_/ \_/

     after        (1) (2) (3) (4) (5)     (6) -->    a kink has passed: all are one well on,
              \_/ \_/ \_/ \_/ \_/ \_/ \_/ \_/         and nobody stops the last one

![What a struck chain of pendulums does, and two examples.](fig:x01)

Section 3.4 of James, Kevrekidis and Cuevas (Physica D 251, 2013) answers in one sentence, without a figure: at large impact
velocity a *kink*, a step of one well that travels along the chain, replaces the breather, and beads are ejected at the far
end; nothing blows up. How the transition happens is left open; here we map it. */

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "lattice/impact/impact.hpp"
#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"
#include "sec34/blowup_band.hpp"

using namespace lattice;

/**
## Model and method

The chain is that of Eq. (9) with another well,
$$\ddot y_n + \sin y_n = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2}, \qquad
  y_n(0) = 0,\quad \dot y_n(0) = v_0\,\delta_{n,1},$$
dimensionless, with free ends and, unless something else is said, fifty beads. A bead that passes the maximum of the
potential at $y = \pi$ falls into the next well instead of running away. Beads do not attract each other, so the first bead
can also be thrown back over $y = -\pi$ and leave the chain.

Every run is made with two steps of an integrator that corrects them at contact events (event_corrected.hpp). What must agree
are the numbers of beads counted below; where they do not, the velocity is marked and supports no statement. Close to the
transition the outcome depends on details of many collisions, and there both steps are halved. */
EventCorrected method(double velocity, int halvings) {
  const bool close = velocity > 4.4 && velocity < 5;
  return method_for(1e-4, 0.1, halvings + (close ? 1 : 0));
}

/**
## What is counted

To tell breathers from kinks we count beads by the wells in which they are. `moved` have advanced by
at least one well; a kink that crosses the whole chain moves all beads. `ejected_far` are the beads
of the far half that have advanced by more wells than the bead in the middle of the chain: they have
separated from it and leave at the far end. `ejected_near` have gone backwards over a maximum and leave
at the near end. */
struct WellCounts {
  std::int64_t moved = 0, ejected_far = 0, ejected_near = 0;
  friend bool operator==(const WellCounts&, const WellCounts&) = default;
};

WellCounts count_wells(const State<double>& state) {
  WellCounts counts;
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
## One impact

Just above the transition a kink is slow, may stop, and may come back, so a count can be taken too
early. The loop in time therefore goes on until the counts have stayed the same while the time
doubled, and gives up at the time `patience`: such a velocity is undecided. */
struct KinkImpact {
  static constexpr Title title{"run",
                               "one impact: who moved on (pendulums: a kink needs a well "
                               "beside every well)"};
  double velocity = 5, patience = 3200;
  std::size_t sites = 50;

  void parameters(Parameters& p) {
    p.add("velocity", velocity, "impact velocity", {1e-6, 100});
    p.add("patience", patience, "longest wait for the counts to settle", {400, 1e5});
    p.add("sites", sites, "chain length", {2, 1e5});
  }
  Table table() const;
};
constexpr double first_look = 100;  // a kink needs about sixty units of time for the fifty sites

struct Verdict {
  WellCounts counts{};
  bool settled = false;
  State<double> end{};
  Run run{};
};

Verdict count_after_impact(const KinkImpact& impact, const EventCorrected& method) {
  const Impact whole{
      impact.velocity, {impact.sites, Pendulum{}}, impact.patience, first_look, may_move, false};
  Verdict verdict;
  double next = first_look;
  const auto look = [&](const State<double>& now, const auto&) {
    if (now.t < next * (1 - 1e-9)) return true;
    const WellCounts counts = count_wells(now);
    verdict.settled = next > first_look && counts == verdict.counts;
    verdict.counts = counts;
    next *= 2;
    return !verdict.settled;
  };
  ImpactRun run = strike(method, whole, look);
  verdict.end = std::move(run.end), verdict.run = run.run;
  return verdict;
}

// Among the velocities of a scan some stay undecided: their counts have not settled, or differ at two steps
struct ScanPoint {
  double velocity = 0;
  WellCounts counts{};
  bool decided = false;

  void measure() {
    const KinkImpact impact{.velocity = velocity};
    const Verdict coarse = count_after_impact(impact, method(velocity, 0)),
                  fine = count_after_impact(impact, method(velocity, 1));
    counts = fine.counts;
    decided = coarse.settled && fine.settled && fine.counts == coarse.counts;
  }
};

/**
## Where the kink takes over

Among the decided velocities we look for the last breather, up to which no bead has moved on when the counts have
settled, and for the first certain kink, from which on *every* impact moves the whole chain and ejects a bead at the far
end. A velocity that is in neither range counts as undecided: a third regime would be there. */
bool is_breather(const ScanPoint& p) {
  return p.counts.moved == 0;
}
bool is_kink(const ScanPoint& p) {
  return p.counts.ejected_far > 0 && p.counts.moved == std::int64_t(KinkImpact{}.sites);
}

struct Transition {
  std::size_t breathers, kinks;  ///< velocities up to the last breather and from the first kink on
  double last_breather, first_kink;  ///< impact velocities
  double undecided;                  ///< share of the scan
};

Transition find_transition(std::vector<ScanPoint> points) {
  const auto all = double(points.size());
  std::erase_if(points, [](const ScanPoint& p) { return !p.decided; });
  std::size_t breathers = 0, first = points.size();
  while (breathers < points.size() && is_breather(points[breathers])) ++breathers;
  while (first > 0 && is_kink(points[first - 1])) --first;
  const std::size_t kinks = points.size() - first;
  const double none = std::nan("");
  return {breathers, kinks, breathers > 0 ? points[breathers - 1].velocity : none,
          kinks > 0 ? points[first].velocity : none, 1 - double(breathers + kinks) / all};
}

/**
## The transition (figure x01)

Now we scan the impact velocity, from 1 to 8 in steps of 0.02, in a chain of fifty beads. There are three regimes. A weak
impact leaves every bead in its well; below $v_0 = 2$ nothing else is possible, since the way over a maximum costs
$W(\pi) = 2$. From $v_0 =$ [2.48](num:sec34_kink.first_thrown_back) on the recoil throws beads back at the near end at most
velocities, while the breather still travels: beads that swing back push each other apart, and no contact lies behind the
first bead to hold it. Between [4.66](num:sec34_kink.last_breather) and [4.72](num:sec34_kink.first_certain_kink) the breather
gives way to a kink: in the scan no impact below sends a kink through the chain, and every one above does. The error of
these velocities is the spacing of the scan; the two velocities between them stay undecided, a share of
[0.00569801](num:sec34_kink.kink_undecided) of the scan.

Why so far above 2? The first bead does not climb alone, but pushes on the second all the way up. When it first stops, less
than half of the impact's energy is in its own well, after each of eleven impacts from 2 to 4.72 that were tried in another
program, not part of this repository; the rest is in the contact and ahead. With half of $v_0^2/2$ it would pass the maximum
from $v_0 = 2\sqrt2$ on, so this explains a factor of $\sqrt2$ or somewhat more, not the whole. For it is not enough that the
first bead passes: after 4.0 and 4.4 it does so and is thrown back all the same. In a kink *every* bead passes its maximum;
each pays 2 on the way up and gets 2 back on the way down, so that a kink, once on its way, can go on. We have no theory that
gives 4.7. */
void report_transition(Report& report) {
  const std::size_t sites = KinkImpact{}.sites;

  // Two impacts, one below the transition and one above, show what the counts mean
  Table& examples =
      report.table("kink_examples",
                   {number("velocity", "impact velocity"), number("t", "time"),
                    count("n", "site", "site"), number("wells", "displacement in units of 2 pi")});
  for (double velocity : {2.0, 5.0}) {
    const Impact impact{velocity, {sites, Pendulum{}}, 100, 0.5, may_move, false};
    strike(method(velocity, 1), impact, [&](const State<double>& now, const auto&) {
      for (std::size_t n = 0; n < now.y.size(); ++n)
        examples.add({velocity, now.t, n + 1, now.y[n] / (2 * std::numbers::pi)});
    });
  }

  // The scan; the figure marks the undecided velocities, so the table keeps them
  const double from = 1, to = 8, spacing = report.quick ? 0.25 : 0.02;
  std::vector<ScanPoint> points(std::size_t(std::lround((to - from) / spacing)) + 1);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].velocity = from + spacing * double(i);
  Table& scan =
      report.table("kink_transition",
                   {number("velocity", "impact velocity"),
                    number("moved", "share of the beads that advanced by a well"),
                    count("ejected_far", "beads thrown off the far end"),
                    count("ejected_near", "beads thrown back at the near end"),
                    count("decided", "1 where the counts have settled and agree at two steps")});
  const auto row = [&](ScanPoint& p) {
    p.measure();
    return Cells{p.velocity, double(p.counts.moved) / double(sites), p.counts.ejected_far,
                 p.counts.ejected_near, p.decided};
  };
  scan.fill(points, row, "impact velocities");

  // Between the last breather and the first certain kink the regime changes
  const Transition found = find_transition(points);
  report.facts.add("kink_breathers", exact(double(found.breathers)));
  report.facts.add("kink_kinks", exact(double(found.kinks)));
  report.facts.add("kink_undecided", exact(found.undecided));
  report.facts.add("last_breather", {found.last_breather, spacing});
  report.facts.add("first_certain_kink", {found.first_kink, spacing});

  // The recoil throws beads back already at smaller velocities
  const auto back = std::find_if(points.begin(), points.end(), [](const ScanPoint& p) {
    return p.decided && p.counts.ejected_near > 0;
  });
  if (back != points.end()) report.facts.add("first_thrown_back", {back->velocity, spacing});
}

/**
## No blow-up

In soft quartic wells a strong impact ends in a blow-up; with $W = 1-\cos y$ that cannot be. No term of the energy is
negative, so that no bead is ever faster than $v_0$ or farther away than $v_0t$, at every impact velocity and for ever.
We follow impacts of up to $v_0 = 6$ until $t = 2000$, and the beads keep to that: the largest displacement is
[0.868672](num:sec34_kink.no_blowup_pendulum_way) of $v_0t$. It belongs to a bead which has been thrown off and goes on
over well after well, to a displacement of [10424.1](num:sec34_kink.furthest). */
void report_confinement(Report& report) {
  const std::vector<double> velocities =
      report.quick ? std::vector{2.0, 6.0} : std::vector{2.0, 3.0, 4.0, 5.0, 6.0};
  std::vector<Confinement> all(velocities.size());
  parallel_for(all.size(), [&](std::size_t i) {
    const Impact impact{velocities[i],
                        {KinkImpact{}.sites, Pendulum{}},
                        report.quick ? 200.0 : 2000.0,
                        0.2,
                        may_move,
                        false};
    all[i] = confinement(impact, method(velocities[i], 0), method(velocities[i], 1));
  });

  // The largest of each
  const auto larger = [](const Estimate& a, const Estimate& b) {
    return a.value > b.value ? a : b;
  };
  Confinement worst = all.front();
  for (const Confinement& c : all)
    worst = {larger(worst.speed, c.speed), larger(worst.way, c.way), larger(worst.drift, c.drift),
             std::min(worst.lasted, c.lasted), larger(worst.furthest, c.furthest)};
  report.facts.add("no_blowup_pendulum_speed", worst.speed);
  report.facts.add("no_blowup_pendulum_way", exact(worst.way.value));
  report.facts.add("no_blowup_pendulum_drift", worst.drift);
  report.facts.add("no_blowup_pendulum_lasted", exact(worst.lasted));
  report.facts.add("furthest", worst.furthest);
}

/**
## Differences and limits

What the article says in its one sentence is found: at large impact velocity a kink, beads ejected at the far end, no
blow-up. It gives no parameters; chain length, run length and scan are our choice, and the velocity of the transition
depends on them. A count that has settled may still change: at $v_0 = 4.28$ it has by $t = 200$, but when the breather
arrives at the far end, before $t = 400$, it throws the last bead off (`sec34_impact run` with these parameters). In a
longer chain a slow kink may stop before the end: in the other program, with $v_0 = 4.70$, after 244 of 1000 beads. At high
velocity several kinks follow each other, and which beads leave the far end then depends on all of them. */
void reproduce(Report& report) {
  report.output.note("tolerance", "steps 0.1 and 0.05, half of that near the transition");
  report_transition(report);
  report_confinement(report);
}

/**
## Try it

1. *Easy.* Does the kink need the whole chain? `build/bin/sec34_kink run --velocity 5 --sites 30` gives `moved` = 30. Hint:
   it is there after a few beads; at 4.5 it is not.
2. *Easy.* Which quartic well is most like a pendulum? `build/bin/sec34_impact run --well pendulum --velocity 1 --time 400`
   gives `speed` = 0.1817, and `build/bin/sec34_impact run --s -1/6 --velocity 1 --time 400` gives `speed` = 0.1814.
   Hint: expand $\sin y$ to the third order.
3. *Harder.* A kink is much faster than a breather: `build/bin/sec34_impact run --well pendulum --velocity 5 --time 60`
   gives `speed` = 0.7697, and `build/bin/sec34_impact run --well pendulum --velocity 3 --time 200` gives `speed` = 0.2471.
   Hint: a bead that falls into the next well gets back the energy that the maximum has cost, and can hand it on.
4. *Open.* Which kinks stop in a longer chain, and where does their energy go? Why are just one or two beads ejected by
   impacts up to 8? What remains of the transition with precompression?

## With your own parameters

`build/bin/sec34_kink run` prints the counts for one velocity. Two runs that have parted may have the same counts by
chance, so here the steps are halved until no bead differs by more than one in its place, which is less than half of a
well. It fails where they never agree, and where the counts have not settled within `--patience`. */
struct SamePlaces {
  std::string name = "counts or places";
  double operator()(const Verdict& a, const Verdict& b) const {
    if (a.counts != b.counts || a.end.t != b.end.t) return std::numeric_limits<double>::infinity();
    double apart = 0;
    for (std::size_t n = 0; n < a.end.y.size(); ++n)
      apart = std::max(apart, std::abs(a.end.y[n] - b.end.y[n]));
    return apart * places;
  }
  static constexpr double places = 1e-3;  ///< the tolerance, which is that of the energy as well
};

Table KinkImpact::table() const {
  const auto runs = refined(
      SamePlaces::places, [&](const EventCorrected& at) { return count_after_impact(*this, at); },
      SamePlaces{});
  const Verdict &coarse = runs.coarse, &fine = runs.fine;
  if (!fine.settled)
    throw Failure("the counts have not settled: --patience is too short, or the motion is erratic");
  const auto both = [&](std::int64_t WellCounts::*count) {
    return compare(coarse.counts.*count, fine.counts.*count);
  };
  Answers q;
  q.add_small("moved", both(&WellCounts::moved), "beads",
              "beads that have advanced by at least one well");
  q.add_small("ejected_far", both(&WellCounts::ejected_far), "beads",
              "beads of the far half that have advanced by more wells than the middle bead");
  q.add_small("ejected_near", both(&WellCounts::ejected_near), "beads",
              "beads of the near half that have gone backwards over a maximum of the potential");
  return q.table;
}

int main(int argc, char** argv) {
  return run({"sec34_kink", "3.4", "Breather and kink in pendulum wells (section 3.4)", reproduce,
              commands<KinkImpact>()},
             argc, argv);
}
