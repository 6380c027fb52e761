/**
# 3.4 From travelling breather to kink in pendulum wells

What becomes of the travelling breather in the wells of a real cradle, $W = 1-\cos y$, where a bead that is struck too
hard swings over the top and comes down in the next well? Section 3.4 of James, Kevrekidis and Cuevas (Physica D 251,
2013) answers in one sentence, without a figure: at large impact velocity a *kink*, a step of one well that travels
along the chain, replaces the breather, beads are ejected at the far end, and nothing blows up. The kink is reminiscent
of Nesterenko's soliton, the pulse of a chain without wells. All of this is confirmed. The kink appears at the impact
velocity 4.7, far above the 2 that one bead needs. A fast kink is nearly that soliton, namely the one that moves every
bead by a whole number of wells. This fixes its speed within 8 per cent, if a bead's kinetic energy is about four times
the height of a well or more. Below this height kinks have about half the speed, which the soliton does not explain.

     before   (1) (2) (3) (4) (5) (6)            every bead in its own well
              \_/ \_/ \_/ \_/ \_/ \_/ \_/ \_/

     after        (1) (2) (3) (4) (5)     (6) -->    a kink has passed: all are one well on,
              \_/ \_/ \_/ \_/ \_/ \_/ \_/ \_/         and nothing stops the last one

![What a struck chain of pendulums does, and two examples.](fig:x01)

<!-- head -->
`build/bin/sec34_kink` computes this chapter in 4 s on two cores and writes 7 tables to `build/data/sec34_kink`. Its
figures: `make x01`, `make x52`, `make x67`. With your parameters: `run`, one impact in pendulum wells (a kink needs
neighbouring wells): how many beads changed wells.
<!-- /head -->

## Model

The chain is that of Eq. (9) with another well,
$$\ddot y_n + \sin y_n = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2}, \qquad
  y_n(0) = 0,\quad \dot y_n(0) = v_0\,\delta_{n,1},$$
dimensionless, with free ends. A bead that passes the maximum of the potential at $y = \pi$, where $W = 2$, falls into
the next well. Contacts do not attract, so the first bead can also be thrown back over $y = -\pi$ and leave the chain.
The article gives no parameters; those below are ours. */
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "lattice/diagnostics/pulse.hpp"
#include "lattice/gsl/reference.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "report/program.hpp"

using namespace lattice;
using namespace report;

/**
## The experiment

We strike the first bead, wait, and count the beads in each well. `advanced` are those that have moved on by at least
one well; a kink that crosses the whole chain advances all of them. `ejected_far` are the beads of the far half that
have advanced by more wells than the bead in the middle: they have separated from it and leave at the far end.
`ejected_near` have gone backwards over a maximum and leave at the near end.

Just above the transition a kink is slow, so no fixed time suffices. We count at the times 100, 200, 400, ..., until two
counts in a row are equal, at most until `patience`. Every impact is followed with two steps, corrected at contact
events. Where the counts of the two differ, or have not settled, it is *undecided*, and not used. */
const Well on_site = Pendulum{};                 // W = 1 - cos y
constexpr double period = 2 * std::numbers::pi;  // from well to well
constexpr double maximum = std::numbers::pi;     // between two wells
constexpr std::size_t beads = 50;
constexpr double first_count = 100;  // after an impact of 5 a kink needs 65 for fifty sites
constexpr double patience = 3200;
constexpr double coarse_step = 0.05, fine_step = 0.025;
constexpr double scan_from = 1, scan_to = 8;  // impact velocity
constexpr double largest_drift = 1e-3;        // of the energy, relative

// What is counted
struct WellCounts {
  std::int64_t advanced = 0, ejected_far = 0, ejected_near = 0;
  friend bool operator==(const WellCounts&, const WellCounts&) = default;
};

WellCounts wells_of(const State<double>& state) {
  WellCounts counts;
  const auto well = [&](std::size_t n) { return std::lround(state.y[n] / period); };
  const std::size_t half = state.y.size() / 2;
  for (std::size_t n = 0; n < state.y.size(); ++n) {
    counts.advanced += well(n) >= 1;
    counts.ejected_far += n > half && well(n) > well(half);
    counts.ejected_near += n < half && well(n) <= -1;
  }
  return counts;
}

struct Outcome {
  WellCounts counts{};
  bool settled = false;
  State<double> end{};
  Run run{};
};

// One impact with one step, and with two
Outcome outcome(double v0, std::size_t sites, double longest, const Method& method) {
  const Chain chain{sites, on_site};
  Outcome out{.end = struck(sites, v0)};
  double duration = first_count;
  while (!out.settled && out.end.t + duration <= longest) {
    out.run = joined(out.run, evolve(method, chain, out.end, duration, Every{first_count}));
    const WellCounts now = wells_of(out.end);
    out.settled = now == out.counts && out.end.t > first_count;
    out.counts = now;
    duration = out.end.t;  // as long again
  }
  return out;
}

Outcome decided(double v0, std::size_t sites, double longest = patience) {
  const Outcome coarse = outcome(v0, sites, longest, EventCorrected{coarse_step});
  Outcome fine = outcome(v0, sites, longest, EventCorrected{fine_step});
  if (!(std::max(coarse.run.energy_drift, fine.run.energy_drift) < largest_drift))
    throw Failure("the energy is not conserved");
  fine.settled = fine.settled && coarse.settled && fine.counts == coarse.counts;
  return fine;
}

/**
## The transition (figure x01)

There are three regimes in a scan of the impact velocity. A weak impact leaves every bead in its well; below $v_0 = 2$
nothing else is possible, since $v_0^2/2$ is less than the maximum. Between 2.48 and 4.64 the recoil throws beads back
at the near end at almost all velocities, since no contact behind the first bead holds it. Between 4.64 and 4.72 a kink
replaces the breather: below, no impact of the scan sends a kink through the chain; above, every one does, and throws
none back. The impact of 4.68 between them is undecided.

| impact velocity | beads that advanced | ejected at the far end | at the near end |
|---|---|---|---|
| 2.48 | [0](cell:kink_transition/velocity=2.48/advanced) | [0](cell:ejected_far) | [1](cell:ejected_near) |
| 4.64 | [0](cell:kink_transition/velocity=4.64/advanced) | [0](cell:ejected_far) | [2](cell:ejected_near) |
| 4.72 | [50](cell:kink_transition/velocity=4.72/advanced) | [2](cell:ejected_far) | [0](cell:ejected_near) |
*/
void report_transition(Report& report) {
  const double spacing = report.quick ? 1 : 0.04;
  std::vector<double> velocities;
  for (long k = 0; k <= std::lround((scan_to - scan_from) / spacing); ++k)
    velocities.push_back(scan_from + spacing * double(k));
  const auto row = [&](double v0) {
    const Outcome found = decided(v0, beads);
    return Row{{"velocity", v0},
               {"advanced", found.counts.advanced},
               {"ejected_far", found.counts.ejected_far},
               {"ejected_near", found.counts.ejected_near},
               {"decided", found.settled}};
  };
  report.table("kink_transition").fill(velocities, row, "impact velocities");

  // One impact below the transition and one above
  Table& examples = report.table("kink_examples");
  for (double v0 : {2.0, 5.0}) {
    State<double> state = struck(beads, v0);
    const auto sample = [&](const State<double>& now) {
      for (std::size_t n = 0; n < beads; ++n)
        examples.add({{"velocity", v0}, {"t", now.t}, {"n", n + 1}, {"wells", now.y[n] / period}});
    };
    evolve(EventCorrected{coarse_step}, Chain{beads, on_site}, state, 100, Every{0.5}, sample);
  }
}

/**
## Why so far above 2

One bead passes its maximum with the energy 2, but the impact at the transition has 11. When a bead is the first to
reach its maximum, those ahead are still below theirs and press against it. So with $y_n = \pi$ the energy is at least
the minimum, over the beads ahead, of
$$U = \sum_{m\ge n} \bigl[W(y_m) + \tfrac25(y_m-y_{m+1})_+^{5/2}\bigr],$$
which is [4.84](cell:least_energy/potential) with eight beads ahead: no impact below
[3.11](cell:least_energy/velocity) can send a kink off. A moving kink needs more. When bead 145 passes its maximum, bead
142 and all ahead of it have [10.29](cell:kink_shape/velocity=4.8/energy) after an impact of 4.8, whose energy is 11.5,
and [10.50](cell:kink_shape/velocity=5/energy) after 5: an upper estimate of what a moving kink needs at least. */
void report_least_energy(Report& report) {
  // The beads ahead move down the gradient of U, the first one stays on its maximum
  const auto least = [](std::size_t ahead) {
    State<double> state(ahead + 1);
    state.y[0] = maximum;
    const Chain chain{ahead + 1, on_site};
    for (int k = 0; k < 2000; ++k) {
      const std::vector<double> force = accelerations(chain, state.y);
      for (std::size_t n = 1; n <= ahead; ++n) state.y[n] += 0.1 * force[n];
    }
    return energy(chain, state);
  };
  const Estimate potential = with_error(least(4), least(8));
  const double v = std::sqrt(2 * potential.value);
  Table& table = report.table("least_energy");
  table.add({{"potential", potential}, {"velocity", Estimate(v, potential.error / v)}});
}

/**
## The speeds follow from Nesterenko's soliton (figure x52)

Without wells an impact sends out a solitary pulse of the velocities, a few beads long. If $y_n(t)$ solves the equation
without wells, so does $a\,y_n(a^{1/4}t)$. So of all pulses the largest velocity of a bead goes as $V\propto a^{5/4}$,
the displacement that stays behind as $D = d\,V^{4/5}\propto a$, and the speed as $c = b\,V^{1/5}\propto a^{1/4}$; the
length is the same. One run gives $d =$ [1.840](cell:pulse/d) and $b =$ [0.9075](cell:pulse/b). A kink has no such
freedom: it moves each bead by a whole number $k$ of wells. If it is a pulse that hardly feels the wells, then
$$D = 2\pi k, \qquad V = (2\pi k/d)^{5/4}, \qquad c = b\,(2\pi k/d)^{1/4} \propto k^{1/4}.$$
We time the passage of $y = \pi$ by beads 21 to 35 and again by beads 121 to 135; the speed is the slope. $V$ is the
mean of the largest velocities of the latter beads, and the length is the speed times the time for which a bead's
velocity exceeds half of its maximum. */
constexpr std::size_t long_chain = 160;
struct Stretch {
  std::size_t first, last;  // beads, counted from one
};
constexpr Stretch near_stretch{21, 35}, far_stretch{121, 135};
constexpr std::size_t watched = 145, behind = 3;        // a run ends when bead 145 passes
constexpr double kink_coarse = 0.02, kink_fine = 0.01;  // steps, and times between samples

// What passes: a kink, or a pulse without wells
struct Passage {
  double speed_near = 0, speed_far = 0;  // on the two stretches
  double largest = 0, length = 0;        // largest velocity of a bead; means over the far stretch
  double shift = 0, energy = 0;          // of a bead; of `behind` beads, `watched` and all ahead
};

double speed_on(const Stretch& beads, const std::vector<double>& t,
                const std::vector<std::vector<double>>& y) {
  std::vector<double> times, places;
  for (std::size_t n = beads.first; n <= beads.last; ++n) {
    times.push_back(upward_crossings(t, y[n - 1], maximum).at(0));
    places.push_back(double(n));
  }
  return fit_line(times, places).slope;
}

Passage passage(const Well& well, double v0, double step) {
  const Chain chain{long_chain, well};
  std::vector<double> t;
  std::vector<std::vector<double>> y(watched), v(watched);
  State<double> state = struck(long_chain, v0), last = state, before_last = state;
  const auto sample = [&](const State<double>& now) {
    t.push_back(now.t);
    for (std::size_t n = 0; n < y.size(); ++n) {
      y[n].push_back(now.y[n]);
      v[n].push_back(now.v[n]);
    }
    before_last = last;
    last = now;
    return now.y[watched - 1] < maximum;
  };
  evolve(EventCorrected{step}, chain, state, 400, Every{step}, sample);
  if (state.y[watched - 1] < maximum) throw Failure("nothing passes the chain");

  // Each bead: its largest velocity, and for how long it has more than half of it
  Passage out{.speed_near = speed_on(near_stretch, t, y), .speed_far = speed_on(far_stretch, t, y)};
  double duration = 0;
  const double count = double(far_stretch.last - far_stretch.first + 1);
  for (std::size_t n = far_stretch.first; n <= far_stretch.last; ++n) {
    const double largest = largest_modulus(t, v[n - 1]);
    out.largest += largest / count;
    duration += time_above(t, v[n - 1], largest / 2) / count;
  }
  out.length = out.speed_far * duration;
  out.shift = state.y[far_stretch.first - 1];
  // Between the last two samples
  const auto energy_of = [&](const State<double>& at) {
    const std::vector<double> e = energy_density(chain, at);
    return std::accumulate(e.begin() + watched - 1 - behind, e.end(), 0.0);
  };
  const double y_end = last.y[watched - 1], y_before = before_last.y[watched - 1];
  const double end = energy_of(last), beyond = (y_end - maximum) / (y_end - y_before);
  out.energy = end + beyond * (energy_of(before_last) - end);
  return out;
}

/**
![Speed of the kink on two stretches, and of the pulse that moves beads by as many wells.](fig:x52)

| $v_0$ | $k$ | $V$ | $V$ of the pulse | speed, beads 21-35 | beads 121-135 | of the pulse | length |
|---|---|---|---|---|---|---|---|
| 4.8 | [1](cell:kink_shape/velocity=4.8/wells) | [1.877](cell:largest) | [4.641](cell:pulse_largest) | [0.492](cell:speed_near) | [0.535](cell:speed_far) | [1.234](cell:pulse_speed) | [2.78](cell:length) |
| 5 | [1](cell:kink_shape/velocity=5/wells) | [1.641](cell:largest) | [4.641](cell:pulse_largest) | [0.766](cell:speed_near) | [0.751](cell:speed_far) | [1.234](cell:pulse_speed) | [2.40](cell:length) |
| 5.5 | [1](cell:kink_shape/velocity=5.5/wells) | [1.731](cell:largest) | [4.641](cell:pulse_largest) | [0.929](cell:speed_near) | [0.772](cell:speed_far) | [1.234](cell:pulse_speed) | [2.33](cell:length) |
| 6 | [1](cell:kink_shape/velocity=6/wells) | [2.873](cell:largest) | [4.641](cell:pulse_largest) | [1.057](cell:speed_near) | [1.054](cell:speed_far) | [1.234](cell:pulse_speed) | [2.25](cell:length) |
| 8 | [1](cell:kink_shape/velocity=8/wells) | [3.971](cell:largest) | [4.641](cell:pulse_largest) | [1.178](cell:speed_near) | [1.140](cell:speed_far) | [1.234](cell:pulse_speed) | [1.78](cell:length) |
| 14 | [1](cell:kink_shape/velocity=14/wells) | [4.128](cell:largest) | [4.641](cell:pulse_largest) | [1.291](cell:speed_near) | [1.151](cell:speed_far) | [1.234](cell:pulse_speed) | [1.75](cell:length) |
| 16 | [2](cell:kink_shape/velocity=16/wells) | [10.71](cell:largest) | [11.04](cell:pulse_largest) | [1.432](cell:speed_near) | [1.427](cell:speed_far) | [1.467](cell:pulse_speed) | [1.52](cell:length) |
| 26 | [2](cell:kink_shape/velocity=26/wells) | [14.41](cell:largest) | [11.04](cell:pulse_largest) | [1.591](cell:speed_near) | [1.527](cell:speed_far) | [1.467](cell:pulse_speed) | [1.51](cell:length) |
| 28 | [3](cell:kink_shape/velocity=28/wells) | [18.89](cell:largest) | [18.32](cell:pulse_largest) | [1.621](cell:speed_near) | [1.618](cell:speed_far) | [1.623](cell:pulse_speed) | [1.54](cell:length) |
| 36 | [3](cell:kink_shape/velocity=36/wells) | [20.43](cell:largest) | [18.32](cell:pulse_largest) | [1.700](cell:speed_near) | [1.645](cell:speed_far) | [1.623](cell:pulse_speed) | [1.54](cell:length) |
| 64 | [6](cell:kink_shape/velocity=64/wells) | [43.70](cell:largest) | [43.58](cell:pulse_largest) | [1.925](cell:speed_near) | [1.924](cell:speed_far) | [1.931](cell:pulse_speed) | [1.56](cell:length) |

For $k\ge2$ the kink's speed on the far stretch is the pulse's within 5 per cent, with nothing fitted to kinks: wells
are 2 high, but beads have the kinetic energy $V^2/2 > 50$. With $k=1$ it is 8 after 8 and 14, and these kinks are 7 to
8 per cent slower; after 6 it is 4, and the kink 15 per cent slower. Kinks shed most of what an impact gives beyond a
whole $k$. But after 26 the speed still exceeds that after 16 by 7 per cent, and $V$, on which it depends weakly, by 35.
The length approaches the pulse's, [1.579](cell:pulse/length). After 4.8 to 5.5 the kinetic energy is less than the
height of a well, and the kinks have 0.4 to 0.6 of the pulse's speed. What selects it we do not know. */
void report_shape(Report& report) {
  const auto twice = [](const Well& well, double v0) {
    return TwoRuns<Passage>{passage(well, v0, kink_coarse), passage(well, v0, kink_fine)};
  };
  // The constants of the pulse, and the pulse that moves each bead by this displacement
  const TwoRuns<Passage> pulse = twice(NoWell{}, 5);
  const auto d = [](const Passage& p) { return p.shift / std::pow(p.largest, 0.8); };
  const auto b = [](const Passage& p) { return p.speed_far / std::pow(p.largest, 0.2); };
  report.table("pulse").add(
      {{"d", pulse.of(d)}, {"b", pulse.of(b)}, {"length", pulse.of(&Passage::length)}});

  // The kinks
  const auto row = [&](double v0) -> Row {
    const TwoRuns<Passage> kink = twice(on_site, v0);
    const auto wells = [](const Passage& p) { return std::lround(p.shift / period); };
    const double D = period * double(wells(kink.fine));
    const auto V = [&](const Passage& p) { return std::pow(D / d(p), 1.25); };
    return {{"velocity", v0},
            {"wells", kink.of(wells)},
            {"largest", kink.of(&Passage::largest)},
            {"pulse_largest", pulse.of(V)},
            {"speed_near", kink.of(&Passage::speed_near)},
            {"speed_far", kink.of(&Passage::speed_far)},
            {"pulse_speed", pulse.of([&](const Passage& p) { return b(p) * std::pow(V(p), 0.2); })},
            {"length", kink.of(&Passage::length)},
            {"energy", kink.of(&Passage::energy)}};
  };
  const std::vector<double> velocities{4.8, 5, 5.5, 6, 8, 14, 16, 26, 28, 36, 64};
  report.table("kink_shape").fill(report.quick ? std::vector{6.0} : velocities, row, "kinks");
}

/**
## No blow-up, and checks

In soft quartic wells a strong impact ends in a blow-up; with $W = 1-\cos y$ it cannot. No term of the energy is
negative, so no bead is ever faster than $v_0$ or farther away than $v_0t$. The runs of the table `confinement` respect
these bounds until $t = 2000$, and conserve their energy.

In the scan we trust only whole numbers that are equal for two steps. Two of them may also agree by chance; we use only
that all decided impacts on one side of the transition agree in whether a kink passes the chain. Speed and length
come from single passages. The error of the length falls with the square of the step (figure x67), since times between
samples are interpolated linearly; in the speed such errors are small. GSL's adaptive method of order eight, without
event detection, must arrive at our state to $10^{-8}$ at $t=60$ after $v_0=2$ (breather) and $v_0=5$ (kink).

![Error of speed and length of the kink after an impact of 6 against the step.](fig:x67) */
struct Excursion {
  double speed = 0, way = 0, drift = 0;  // in units of v0, of v0 t; relative
};
Excursion excursion(double v0, double time, double step) {
  State<double> state = struck(beads, v0);
  Excursion out;
  const auto watch = [&](const State<double>& now) {
    for (double v : now.v) out.speed = std::max(out.speed, std::abs(v) / v0);
    for (double y : now.y)
      if (now.t > 0) out.way = std::max(out.way, std::abs(y) / (v0 * now.t));
  };
  const Chain chain{beads, on_site};
  out.drift = evolve(EventCorrected{step}, chain, state, time, Every{0.2}, watch).energy_drift;
  return out;
}

void report_checks(Report& report) {
  const double time = report.quick ? 200 : 2000;
  const auto bounds = [time](double v0) -> Row {
    const TwoRuns<Excursion> runs{excursion(v0, time, 0.1), excursion(v0, time, 0.05)};
    return {{"velocity", v0},
            {"speed", runs.of(&Excursion::speed)},
            {"way", runs.of(&Excursion::way)},
            {"drift", runs.of(&Excursion::drift)}};
  };
  report.table("confinement").fill(std::array{2.0, 4.0, 6.0}, bounds, "strong impacts");

  // The error against the step
  const Passage best = passage(on_site, 6, kink_fine / 2);
  const auto row = [&](double step) {
    const Passage at = passage(on_site, 6, step);
    return Row{{"step", step},
               {"speed", std::abs(at.speed_far / best.speed_far - 1)},
               {"length", std::abs(at.length / best.length - 1)}};
  };
  report.table("kink_convergence").fill(std::array{0.16, 0.08, 0.04, kink_coarse}, row, "steps");

  for (double v0 : {2.0, 5.0}) {
    const Chain chain{beads, on_site};
    State<double> state = struck(beads, v0);
    evolve(EventCorrected{0.0125}, chain, state, 60);
    distance_from_reference(chain, struck(beads, v0), 60, state, 1e-8);  // or it throws
  }
}

void reproduce(Report& report) {
  report_transition(report);
  report_least_energy(report);
  report_shape(report);
  report_checks(report);
}

/**
## Statement by statement

<!-- statements -->
| statement | printed | here | verdict |
|---|---|---|---|
| `impact.kink`: for W = 1 - cos y and large impact the breather becomes a kink ejecting beads at the far end | kink | kink_transition.advanced (velocity = 1) and 433 other values: 1 <= 92; kink_transition.advanced (velocity = 1) and 433 other values: 1 <= 83; kink_transition.advanced (velocity = 1) and 433 other values: 0.005682 < 0.05 | holds |
| `impact.kink_soliton`: the kink is reminiscent of Nesterenko's soliton | reminiscent | 0.9245 of the soliton's speed | quantified |
| `impact.no_blowup_pendulum`: no blow-up for W = 1 - cos y | does not occur | confinement.speed (velocity = 2): 1 < 1.001 (the closest of 6) | holds |
<!-- /statements -->

## Try it

**To change it.** The constants of the experiment are free: `beads` (the number is repeated in
`src/statements/sec34_kink.cpp`), steps, scan and `patience`. Another periodic well takes the place of `Pendulum`, with
its `period` and `maximum`. The velocities of the two examples are also in the script of figure x01.

1. *Easy.* Does the kink need the whole chain? `build/bin/sec34_kink run --velocity 5 --sites 30` gives `advanced` = 30.
   Hint: so do all of five beads. How long is the kink (the table above)?
2. *Harder.* Compare a kink with a breather: `build/bin/sec34_impact run --well pendulum --velocity 5 --time 60` gives
   `speed` = 0.7697, and `build/bin/sec34_impact run --well pendulum --velocity 3 --time 200` gives `speed` = 0.2471.
   These are speeds of the energy centre. Hint: the second impact moves no bead on (figure x01). */
struct KinkImpact {
  static constexpr Title title{"run",
                               "one impact in pendulum wells (a kink needs neighbouring wells): "
                               "how many beads changed wells"};
  double velocity = 5, longest = patience;
  std::size_t sites = beads;

  void parameters(Parameters& p) {
    p.add("velocity", velocity, "velocity of the impact on the first bead", {1e-6, 100});
    p.add("patience", longest, "longest time to wait for the counts to settle", {400, 1e5});
    p.add("sites", sites, "number of sites", {2, 1e5});
  }
  Table table() const {
    const Outcome found = decided(velocity, sites, longest);
    if (!found.settled)
      throw Failure("undecided: the counts have not settled (--patience), or depend on the step");
    Answers q;
    q.add_small("advanced", exact(double(found.counts.advanced)), "beads",
                "beads that have advanced by at least one well");
    q.add_small("ejected_far", exact(double(found.counts.ejected_far)), "beads",
                "beads of the far half that have advanced by more wells than the middle bead");
    q.add_small("ejected_near", exact(double(found.counts.ejected_near)), "beads",
                "beads of the near half that have moved backwards over a potential maximum");
    return q.table;
  }
};

int main(int argc, char** argv) {
  return run({"sec34_kink", "3.4", "Breather and kink in pendulum wells (section 3.4)", reproduce,
              commands<KinkImpact>()},
             argc, argv);
}
