/**
# 3.4 From travelling breather to kink in pendulum wells

What becomes of the travelling breather in the wells of a real cradle, $W = 1-\cos y$, where a bead that is struck too
hard swings over the top and comes down in the next well? We scan the impact velocity and count, after each impact, the
beads that have changed their wells.

     before   (1) (2) (3) (4) (5) (6)            every bead in its own well
              \_/ \_/ \_/ \_/ \_/ \_/ \_/ \_/

     after        (1) (2) (3) (4) (5)     (6) -->    a kink has passed: all are one well on,
              \_/ \_/ \_/ \_/ \_/ \_/ \_/ \_/         and nothing stops the last one

![What a struck chain of pendulums does, and two examples. Drawn by x01_kink_transition.py: `moved`, `ejected_near` and
`ejected_far` against `velocity` from the table `kink_transition`; `wells` over `n` and `t` from
`kink_examples`.](fig:x01)

Section 3.4 of James, Kevrekidis and Cuevas (Physica D 251, 2013) answers in one sentence, without a figure: at large
impact velocity a *kink*, a step of one well that travels along the chain, replaces the breather, and beads are ejected
at the far end; nothing blows up. The kink is reminiscent of Nesterenko's soliton, the pulse of a chain without wells.
We find all of it; the resemblance grows with the impact.

## Model

The chain is that of Eq. (9) with another well,
$$\ddot y_n + \sin y_n = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2}, \qquad
  y_n(0) = 0,\quad \dot y_n(0) = v_0\,\delta_{n,1},$$
dimensionless, with free ends. The article gives no parameters; we take fifty beads. A bead that passes the maximum of
the potential at $y = \pi$ falls into the next well instead of running away. Contacts do not attract, so the first bead
can also be thrown back over $y = -\pi$ and leave the chain. */
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "lattice/gsl/reference.hpp"
#include "lattice/integrators/refinement.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"

using namespace lattice;

/**
## The experiment

We strike the first bead, wait, and count the beads in each well. `moved` have advanced by at least one well; a kink
that crosses the whole chain moves all of them. `ejected_far` are the beads of the far half that have advanced by more
wells than the bead in the middle: they have separated from it and leave at the far end. `ejected_near` have gone
backwards over a maximum and leave at the near end.

Just above the transition a kink is slow, may stop, and may come back. So the run goes on until the counts have stayed
the same while the time doubled; if they have not settled by the time `patience`, the impact is undecided. `evolve`
integrates Eq. (9) with steps that are corrected where a contact opens or closes (event_corrected.hpp). */
struct WellCounts {
  std::int64_t moved = 0, ejected_far = 0, ejected_near = 0;
  friend bool operator==(const WellCounts&, const WellCounts&) = default;
};
struct Outcome {
  WellCounts counts{};
  bool settled = false;
  State<double> end{};
  Run run{};
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

/// The chain at rest but for its first bead, Eq. (26).
State<double> after_impact(std::size_t sites, double v0) {
  State<double> state(sites);
  state.v[0] = v0;
  return state;
}

const Well on_site = Pendulum{};  // W = 1 - cos y

Outcome outcome(double v0, std::size_t sites, double patience, const Method& method) {
  Outcome out{.end = after_impact(sites, v0)};
  double next = 100;  // a kink needs about sixty units of time for fifty sites
  const auto look = [&](const State<double>& now) {
    if (now.t < next * (1 - 1e-9)) return true;
    const WellCounts counts = count_wells(now);
    out.settled = next > 100 && counts == out.counts;
    out.counts = counts;
    next *= 2;
    return !out.settled;
  };
  out.run = evolve(method, Chain{sites, on_site}, out.end, patience, 100, look);
  return out;
}

/**
Every impact is followed with two steps, 0.1 and 0.05, and both are halved close to the transition, where the outcome
depends on details of many collisions. The numbers of beads must agree. Where they do not, or have not settled, the
impact is *undecided*: it is marked and not used. */
constexpr std::size_t beads = 50;
constexpr double patience = 3200;

EventCorrected method(double v0, int halvings) {
  const bool close = v0 > 4.4 && v0 < 5;
  return method_for(1e-4, 0.1, halvings + (close ? 1 : 0));
}

struct Counted {
  WellCounts counts;
  bool decided;
};

Counted counted(double v0, std::size_t sites = beads) {
  const Outcome coarse = outcome(v0, sites, patience, method(v0, 0)),
                fine = outcome(v0, sites, patience, method(v0, 1));
  if (!(std::max(coarse.run.energy_drift, fine.run.energy_drift) < 1e-3))
    throw Failure("the energy is not conserved");
  return {fine.counts, coarse.settled && fine.settled && fine.counts == coarse.counts};
}

/**
## The transition (figure x01)

We scan the impact velocity from 1 to 8 in steps of 0.02 (table `kink_transition`). There are three regimes. A weak
impact leaves every bead in its well; below $v_0 = 2$ nothing else is possible, since the maximum is $W(\pi) = 2$. From
2.48 on the recoil throws beads back at the near end, at all but four velocities, while the breather still travels:
beads that swing back push each other apart, and no contact behind the first bead holds it. Between 4.66 and 4.72 a kink
replaces the breather: up to 4.66 no impact of the scan sends a kink through the chain, and from 4.72 on every one does.
The two velocities between, 4.68 and 4.70, are undecided.

| impact velocity | beads that moved on | ejected at the far end | at the near end | decided |
|---|---|---|---|---|
| 2.46 | [0](cell:kink_transition/velocity=2.46/advanced) | [0](cell:ejected_far) | [0](cell:ejected_near) | [1](cell:decided) |
| 2.48 | [0](cell:kink_transition/velocity=2.48/advanced) | [0](cell:ejected_far) | [1](cell:ejected_near) | [1](cell:decided) |
| 4.66 | [0](cell:kink_transition/velocity=4.66/advanced) | [0](cell:ejected_far) | [2](cell:ejected_near) | [1](cell:decided) |
| 4.68 | [50](cell:kink_transition/velocity=4.68/advanced) | [2](cell:ejected_far) | [0](cell:ejected_near) | [0](cell:decided) |
| 4.70 | [0](cell:kink_transition/velocity=4.7/advanced) | [0](cell:ejected_far) | [2](cell:ejected_near) | [0](cell:decided) |
| 4.72 | [50](cell:kink_transition/velocity=4.72/advanced) | [2](cell:ejected_far) | [0](cell:ejected_near) | [1](cell:decided) |
| 8 | [50](cell:kink_transition/velocity=8/advanced) | [1](cell:ejected_far) | [0](cell:ejected_near) | [1](cell:decided) |

*No bead moves on* means until the counts have settled.

Why so far above 2? The first bead pushes on the second all the way up, and loses energy to it. In a kink *every* bead
passes its maximum; each needs the energy 2 on the way up and regains it on the way down, so a kink, once formed, can go
on. We have no theory for the value 4.7. */
void report_examples(Report& report) {
  // One impact below the transition and one above
  Table& examples =
      report.table("kink_examples", {number("velocity", "velocity of the impact on the first bead"),
                                     number("t", "time"), count("n", "site", "site"),
                                     number("wells", "displacement in units of 2 pi")});
  for (double v0 : {2.0, 5.0}) {
    State<double> state = after_impact(beads, v0);
    const auto look = [&](const State<double>& now) {
      for (std::size_t n = 0; n < beads; ++n)
        examples.add({v0, now.t, n + 1, now.y[n] / (2 * std::numbers::pi)});
    };
    evolve(method(v0, 1), Chain{beads, on_site}, state, 100, 0.5, look);
  }
}

void report_transition(Report& report) {
  // The figure marks the undecided velocities, so the table keeps them
  const double from = 1, to = 8, spacing = report.quick ? 0.25 : 0.02;
  std::vector<double> velocities(std::size_t(std::lround((to - from) / spacing)) + 1);
  for (std::size_t i = 0; i < velocities.size(); ++i) velocities[i] = from + spacing * double(i);
  const auto row = [](double v0) {
    const auto [counts, decided] = counted(v0);
    return Cells{v0,
                 double(counts.moved) / double(beads),
                 counts.moved,
                 counts.ejected_far,
                 counts.ejected_near,
                 decided};
  };
  report
      .table("kink_transition",
             {number("velocity", "velocity of the impact on the first bead"),
              number("moved", "fraction of the beads that advanced by at least one well"),
              count("advanced", "number of these beads"),
              count("ejected_far", "number of beads ejected at the far end"),
              count("ejected_near", "number of beads ejected at the struck end"),
              count("decided", "1 where the counts have settled and agree for two time steps")})
      .fill(velocities, row, "impact velocities");

  // A longer chain
  std::vector<double> coarser;
  for (double v0 = 1; v0 <= 8; v0 += report.quick ? 1 : 0.5) coarser.push_back(v0);
  report
      .table("hundred_beads",
             {number("velocity", "velocity of the impact on the first bead"),
              count("advanced", "number of beads that advanced by at least one well"),
              count("ejected_far", "number of beads ejected at the far end"),
              count("decided", "1 where the counts have settled and agree for two time steps")})
      .fill(coarser, [](double v0) {
        const auto [counts, decided] = counted(v0, 100);
        return Cells{v0, counts.moved, counts.ejected_far, decided};
      });
}

/**
## Nesterenko's soliton

Without wells an impact sends out a solitary pulse of the velocities, a few beads long. Its length does not depend on
the impact, and its speed grows as the fifth root of its largest velocity. Is the kink like that? We strike the same
chain with and without wells, and measure the speed and the largest velocity of what passes the beads 21 to 35, and its
length, the speed times the time for which a bead has more than half of its largest velocity (table `kink_shape`).

| $v_0$ | 5 | 6 | 8 | 16 | 64 |
|---|---|---|---|---|---|
| speed of the kink, sites per unit of time | [0.75](cell:kink_shape/velocity=5/speed) | [1.06](cell:velocity=6/speed) | [1.18](cell:velocity=8/speed) | [1.43](cell:velocity=16/speed) | [1.92](cell:velocity=64/speed) |
| of the pulse without wells | [1.16](cell:kink_shape/velocity=5/pulse_speed) | [1.20](cell:velocity=6/pulse_speed) | [1.27](cell:velocity=8/pulse_speed) | [1.46](cell:velocity=16/pulse_speed) | [1.93](cell:velocity=64/pulse_speed) |
| length of the kink, sites | [2.2](cell:kink_shape/velocity=5/length) | [2.2](cell:velocity=6/length) | [1.7](cell:velocity=8/length) | [1.5](cell:velocity=16/length) | [1.6](cell:velocity=64/length) |
| of the pulse | [1.58](cell:kink_shape/velocity=5/pulse_length) | [1.58](cell:velocity=6/pulse_length) | [1.58](cell:velocity=8/pulse_length) | [1.58](cell:velocity=16/pulse_length) | [1.58](cell:velocity=64/pulse_length) |
| kink, speed over the fifth root of the largest velocity | [0.67](cell:kink_shape/velocity=5/scaled) | [0.85](cell:velocity=6/scaled) | [0.87](cell:velocity=8/scaled) | [0.89](cell:velocity=16/scaled) | [0.90](cell:velocity=64/scaled) |
| pulse | [0.907](cell:kink_shape/velocity=5/pulse_scaled) | [0.907](cell:velocity=6/pulse_scaled) | [0.907](cell:velocity=8/pulse_scaled) | [0.907](cell:velocity=16/pulse_scaled) | [0.907](cell:velocity=64/pulse_scaled) |

Just above the transition the kink is slower and longer, since it loses energy at every maximum of the potential until
it has passed it. The height of the maximum is always 2, so a strong kink hardly feels the wells: at $v_0 = 16$ it is
the pulse to a few per cent. */
struct Passage {
  double speed = 0, largest = 0, length = 0;
  double scaled() const { return speed / std::pow(largest, 0.2); }
};

/// When the velocity of a bead passes `level`, between the samples `i` and `i + 1`, in units of their distance.
double crossing(const std::vector<double>& v, std::size_t i, double level) {
  return double(i) + (level - v[i]) / (v[i + 1] - v[i]);
}

Passage passage(double v0, const Well& well, const EventCorrected& method, double every) {
  constexpr std::size_t from = 20, until = 35, last = 45;
  std::vector<std::vector<double>> v(until);
  State<double> state = after_impact(60, v0);
  evolve(method, Chain{60, well}, state, 200, every, [&](const State<double>& now) {
    for (std::size_t n = from; n < until; ++n) v[n].push_back(now.v[n]);
    return now.y[last] < 1;
  });
  if (state.y[last] < 1) throw Failure("nothing passes the chain");

  // Each bead: its largest velocity, and when it has more than half of it
  Passage out;
  std::vector<double> times, places;
  double duration = 0;
  for (std::size_t n = from; n < until; ++n) {
    const auto peak = std::size_t(std::max_element(v[n].begin(), v[n].end()) - v[n].begin());
    const Parabola top(v[n].at(peak - 1), v[n][peak], v[n].at(peak + 1));
    std::size_t begin = peak, end = peak;
    while (v[n].at(begin) > top.extremum() / 2) --begin;
    while (v[n].at(end) > top.extremum() / 2) ++end;
    duration += every * (crossing(v[n], end - 1, top.extremum() / 2) -
                         crossing(v[n], begin, top.extremum() / 2));
    out.largest += top.extremum() / double(until - from);
    times.push_back(every * (double(peak) + top.vertex())), places.push_back(double(n + 1));
  }
  out.speed = fit_line(times, places).slope;
  out.length = out.speed * duration / double(until - from);
  return out;
}

void report_shape(Report& report) {
  const std::vector<double> velocities{5, 6, 7, 8, 16, 32, 64};
  const auto row = [](double v0) -> Row {
    const auto twice = [v0](const Well& well) {
      return TwoRuns<Passage>{passage(v0, well, EventCorrected{0.02}, 0.02),
                              passage(v0, well, EventCorrected{0.01}, 0.01)};
    };
    const auto kink = twice(on_site), pulse = twice(None{});
    const auto speed = [](const Passage& p) { return p.speed; };
    const auto length = [](const Passage& p) { return p.length; };
    const auto scaled = [](const Passage& p) { return p.scaled(); };
    return {{"velocity", "velocity of the impact on the first bead", v0},
            {"speed", "of the kink", kink.of(speed), "site per unit of time"},
            {"length", "of the kink, at half of the largest velocity", kink.of(length), "site"},
            {"scaled", "speed of the kink over the fifth root of its largest velocity",
             kink.of(scaled)},
            {"pulse_speed", "the same without wells", pulse.of(speed), "site per unit of time"},
            {"pulse_length", "the same without wells", pulse.of(length), "site"},
            {"pulse_scaled", "the same without wells", pulse.of(scaled)}};
  };
  report.table("kink_shape").fill(velocities, row, "kinks");
}

/**
## No blow-up

In soft quartic wells a strong impact ends in a blow-up; with $W = 1-\cos y$ it cannot. No term of the energy is
negative, so no bead is ever faster than $v_0$ or farther away than $v_0t$, at any impact velocity and at all times. We
follow impacts of up to $v_0 = 6$ until $t = 2000$, with two steps, and at every sample all beads keep to that (table
`confinement`). */
struct Excursion {
  double speed = 0, way = 0, drift = 0, lasted = 0;  // in units of v0, of v0 t; relative; of t
};

Excursion excursion(double v0, double time, const Method& method) {
  State<double> state = after_impact(beads, v0);
  Excursion out;
  const auto look = [&](const State<double>& now) {
    for (double v : now.v) out.speed = std::max(out.speed, std::abs(v) / v0);
    for (double y : now.y)
      if (now.t > 0) out.way = std::max(out.way, std::abs(y) / (v0 * now.t));
  };
  out.drift = evolve(method, Chain{beads, on_site}, state, time, 0.2, look).energy_drift;
  out.lasted = state.t / time;
  return out;
}

void report_confinement(Report& report) {
  const double time = report.quick ? 200 : 2000;
  const std::vector<double> velocities =
      report.quick ? std::vector{2.0, 6.0} : std::vector{2.0, 3.0, 4.0, 5.0, 6.0};
  const auto row = [&](double v0) -> Row {
    const TwoRuns<Excursion> runs{excursion(v0, time, method(v0, 0)),
                                  excursion(v0, time, method(v0, 1))};
    const auto of = [&](double Excursion::*number) {
      return runs.of([&](const Excursion& x) { return x.*number; });
    };
    return {{"velocity", "velocity of the impact on the first bead", v0},
            {"speed", "largest speed of a bead, in units of the impact's", of(&Excursion::speed)},
            {"way",
             "largest displacement at any time, in units of the impact's velocity times this time",
             of(&Excursion::way)},
            {"drift", "drift of the energy, relative", of(&Excursion::drift), "",
             "difference of two resolutions, relative"},
            {"lasted", "end of the run, in units of its length", of(&Excursion::lasted)}};
  };
  report.table("confinement").fill(velocities, row, "strong impacts");
}

/**
## Accuracy and checks

Whole beads are counted, at two steps; an energy drift of more than a thousandth stops the program. The independent
check is GSL's adaptive method of order eight, which has no event detection: it has to find a breather, after $v_0=2$,
and a kink, after $v_0=5$, within $10^{-8}$ at the same positions at $t=60$, when the kink is about to leave. Much later
the motion is chaotic, so the scan compares counts and not positions. */
void check_by_gsl() {
  const Chain chain{beads, on_site};
  for (double v0 : {2.0, 5.0}) {
    State<double> state = after_impact(beads, v0);
    evolve(EventCorrected{0.0125}, chain, state, 60, 60);
    distance_from_reference(chain, after_impact(beads, v0), 60, state, 1e-8);  // or it throws
  }
}

/**
Chain length, run length and scan are our choice, and the velocity of the transition depends on them: in a longer chain
a slow kink may stop before the end. In a chain of a hundred beads (table `hundred_beads`) the impacts of 5 and more
that we tried send a kink through it, and those of 4.5 and less do not. */
void reproduce(Report& report) {
  report.output.note("tolerance", "steps 0.1 and 0.05, half of that near the transition");
  report_examples(report);
  report_transition(report);
  report_shape(report);
  report_confinement(report);
  check_by_gsl();
}

/**
## Statement by statement

<!-- statements -->
| statement | printed | here | verdict |
|---|---|---|---|
| `impact.kink`: for W = 1 - cos y and large impact the breather becomes a kink ejecting beads at the far end | kink | kink_transition.advanced (velocity = 1) and 864 other values: 1 <= 184; kink_transition.advanced (velocity = 1) and 864 other values: 1 <= 165; kink_transition.advanced (velocity = 1) and 864 other values: 0.005698 < 0.05 | holds |
| `impact.kink_soliton`: the kink is reminiscent of Nesterenko's soliton | reminiscent | kink_shape.speed (velocity = 7), (velocity = 8): 1.15 < 1.179 (the closest of 22) | holds, assuming |
| `impact.no_blowup_pendulum`: no blow-up for W = 1 - cos y | does not occur | confinement.speed (velocity = 2): 1 < 1.001 (the closest of 15) | holds |
<!-- /statements -->

## Try it

**To change it.** The well is `on_site`, the counts are `count_wells`, which needs the period of another well, as
`report_examples` does; the wait is `patience`. The number of `beads` stands in the statement, too, and the velocities
of the two examples in the script of the figure, which reads columns by name.

1. *Easy.* Does the kink need the whole chain? `build/bin/sec34_kink run --velocity 5 --sites 30` gives `moved` = 30.
   Hint: it forms within a few beads.
2. *Harder.* A kink is much faster than a breather: `build/bin/sec34_impact run --well pendulum --velocity 5 --time 60`
   gives `speed` = 0.7697, and `build/bin/sec34_impact run --well pendulum --velocity 3 --time 200` gives `speed` =
   0.2471. Hint: a bead that falls into the next well regains the energy of the maximum and can pass it on.

## With your own parameters

`run` prints the counts for one velocity. Two decorrelated runs may have the same counts by chance, so here the steps
are halved until the positions of each bead differ by at most one, less than half of a well. */
struct KinkImpact {
  static constexpr Title title{"run",
                               "one impact in pendulum wells (a kink needs neighbouring wells): "
                               "how many beads changed wells"};
  double velocity = 5, patience = ::patience;
  std::size_t sites = beads;

  void parameters(Parameters& p) {
    p.add("velocity", velocity, "velocity of the impact on the first bead", {1e-6, 100});
    p.add("patience", patience, "longest time to wait for the counts to settle", {400, 1e5});
    p.add("sites", sites, "number of sites", {2, 1e5});
  }
  Table table() const;
};

// What must agree in two runs; its tolerance is that of the energy as well
struct SamePlaces {
  static constexpr double tolerance = 1e-3;
  std::string name = "counts or places";
  double operator()(const Outcome& a, const Outcome& b) const {
    if (a.counts != b.counts || a.end.t != b.end.t) return std::numeric_limits<double>::infinity();
    double apart = 0;
    for (std::size_t n = 0; n < a.end.y.size(); ++n)
      apart = std::max(apart, std::abs(a.end.y[n] - b.end.y[n]));
    return apart * tolerance;
  }
};

Table KinkImpact::table() const {
  const auto run = [&](const EventCorrected& at) { return outcome(velocity, sites, patience, at); };
  const auto runs = refined(SamePlaces::tolerance, run, SamePlaces{});
  if (!runs.fine.settled)
    throw Failure("the counts have not settled: --patience is too short, or the motion is erratic");
  const auto both = [&](std::int64_t WellCounts::*count) {
    return compare(runs.coarse.counts.*count, runs.fine.counts.*count);
  };
  Answers q;
  q.add_small("moved", both(&WellCounts::moved), "beads",
              "beads that have advanced by at least one well");
  q.add_small("ejected_far", both(&WellCounts::ejected_far), "beads",
              "beads of the far half that have advanced by more wells than the middle bead");
  q.add_small("ejected_near", both(&WellCounts::ejected_near), "beads",
              "beads of the near half that have moved backwards over a potential maximum");
  return q.table;
}

int main(int argc, char** argv) {
  return run({"sec34_kink", "3.4", "Breather and kink in pendulum wells (section 3.4)", reproduce,
              commands<KinkImpact>()},
             argc, argv);
}
