/**
# 3.5 Physical scales of a cradle and of an array of cantilevers

In which real system can the travelling breather of the DpS equation be seen, and how well does the equation describe it
there? Section 3.5 of James, Kevrekidis and Cuevas (Physica D 251, 2013) reduces an impact to one number,
$\lambda^{5/2}$, which is astronomical for Newton's cradle and less than one for the array of stiff cantilevers of
section 3.6. We strike chains of all $\lambda$ and find that the packet of the DpS equation is too high and too fast by
a fraction that grows like the square root of this number: 0.15 and 0.11 in the array. Then we derive every constant in
SI units.

![Newton's cradle and an array of clamped cantilevers decorated by beads. Drawn by fig01_two_chains.py: the sizes of the
table `schematic`.](fig:01)

<!-- head -->
`build/bin/sec35_scales` computes this chapter in 2 s on two cores and writes 11 tables to `build/data/sec35_scales`.
Its figures: `make fig01`, `make x53`. With your parameters: `scales`, constants of the cantilever array and of the
cradle, in SI units.
<!-- /head -->

## Model

Beads of mass $m$ that push on each other with $\gamma x^{3/2}$ at the overlap $x$ and collide at the speed $V$ touch for
a time of order $\tau_h$, and in a well of stiffness $k$ each of them oscillates with the period $2\pi\tau_c$,
$$\tau_h = \Bigl(\frac{m^2}{\gamma^2V}\Bigr)^{1/5},\qquad \tau_c = \Bigl(\frac mk\Bigr)^{1/2}.$$
Their ratio is the only parameter of an impact, Eqs. (29) and (30),
$$\lambda = (\tau_c/\tau_h)^2,\qquad \dot y_1(0) = \lambda^{5/2} = (\tau_c/\tau_h)^5,$$
if lengths are measured in units of $\xi = (k/\gamma)^2$, at which well and contact are equally strong, and times in units
of $\tau_c$. For small $\lambda$ the beads oscillate with slowly varying amplitudes, which obey the discrete
$p$-Schrödinger (DpS) equation, Eq. (25), with $\epsilon = \lambda^{5/2}/2$ and the slow time $\tau = \epsilon^{1/2}t$:
$$y_n(t) \approx 2\epsilon\,\mathrm{Re}\bigl[A_n(\tau)\,e^{it}\bigr].$$ */
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "commands/all_scales.hpp"
#include "lattice/diagnostics/pulse.hpp"
#include "lattice/dps/dps_impact.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/model/cantilever.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"
#include "sec35/collision.hpp"
#include "sec35/constants.hpp"

using namespace lattice;

// The article's cradle and array
const Cradle cradle{.length = 0.5, .collision = 0.077e-3};  // m, s
const CantileverArray cantilevers{};                        // materials and sizes of section 3.6
constexpr double array_impact = 1;                          // m/s
constexpr double cradle_impact = 1.75e19;                   // lambda^(5/2), as printed

/**
## The experiment

We strike the first bead of a chain of harmonic wells with $\dot y_1(0) = \lambda^{5/2}$, Eq. (30), and record the
largest deflection, velocity and contact force of bead 80, and the speed of the packet between sites 20 and 60. The run
ends when the packet is at site 95 of 150. A stronger collision is shorter, as $\tau_h$, and we shorten the steps
accordingly. */
constexpr std::size_t sites = 150, observed = 80, half_way = 40;
constexpr double fit_until = 60, run_until = 95;  // sites; fit_from = 20 (path.hpp)

struct Packet {
  double deflection, velocity;  // the largest ones of bead 80
  double half_way;              // the largest deflection of bead 40
  double speed;
  double push = 0, share = 0;  // chain only: largest force, fraction of the energy at bead 80
};

Packet packet_of(double impact, double step) {
  const double tau_h = std::pow(impact, -0.2);
  step *= std::min(1.0, tau_h);
  // Below the speed of weak packets, sqrt(impact / 2) / 3.3, and of strong ones; it only bounds the run
  const double least_speed = std::min(0.1 * std::sqrt(impact), 0.3 / tau_h);
  Impact strong{impact, Chain{sites}, run_until / least_speed, step};
  strong.until = run_until;
  std::vector<double> t, half, y, v, push;
  const auto watch = [&](const State<double>& now, const auto&) {
    t.push_back(now.t);
    half.push_back(now.y[half_way - 1]);
    y.push_back(now.y[observed - 1]);
    v.push_back(now.v[observed - 1]);
    push.push_back(contact_push(strong.chain, now.y.data(), observed));
  };
  const ImpactRun run = strike(EventCorrected{step}, strong, watch);
  return {.deflection = largest_modulus(t, y),
          .velocity = largest_modulus(t, v),
          .half_way = largest_modulus(t, half),
          .speed = run.path.line(fit_from, fit_until)->slope,
          .push = largest_modulus(t, push),
          .share = run.path.energy_at(observed) / (impact * impact / 2)};
}

/**
The DpS chain needs one run for all impacts, in its own units, where deflection and velocity are both $|A_n|$. */
constexpr double dps_end = 320;  // slow time: the packet is beyond site 95

Packet packet_of_dps(std::size_t samples, double tolerance) {
  std::vector<double> at, half, amplitude;
  const auto watch = [&](double now, const Field& field) {
    at.push_back(now);
    half.push_back(std::abs(field[half_way - 1]));
    amplitude.push_back(std::abs(field[observed - 1]));
  };
  const DpsOutcome out =
      follow_dps(Dps{sites}, dps_impact(sites), dps_end, samples, tolerance, watch);
  const double most = largest_modulus(at, amplitude);
  return {.deflection = most,
          .velocity = most,
          .half_way = largest_modulus(at, half),
          .speed = out.path.line(fit_from, fit_until)->slope};
}

/**
## Where the DpS equation is valid (figure x53)

The excess of the DpS equation is (its value)/(the value in the chain) $-$ 1, both in the units of the chain. It falls
nearly like $\lambda^{5/4} = (\lambda^{5/2})^{1/2}$, the order of the terms that the equation leaves out
(`sec31_dps_limit`): in the weakest decade the exponent of $\lambda^{5/2}$ is [0.485](cell:dps_order/deflection) for the
deflection and [0.48](cell:dps_order/speed) for the speed. The article calls the approximation valid in the array and
gives no accuracy. In the array the largest velocity of the bead agrees far better than its deflection. In the DpS
equation both are $|A_n|$; in the array's packet their ratio is [1.137](cell:arrays/array=section_3.6/ratio), so at most
one of them can be right.

![Excess of the DpS equation against the impact. Drawn by x53_dps_excess.gp: `deflection` and `speed` over `impact` from
`dps_regime` and, filled, `arrays`.](fig:x53)

| $\lambda^{5/2}$ | excess of the deflection | at bead 40 | of the speed | of the bead's velocity |
|---|---|---|---|---|
| $10^{-3}$ | [0.0253](cell:dps_regime/impact=1e-3/deflection) | [0.0244](cell:half_way) | [0.0187](cell:speed) | |
| array of section 3.6 | [0.150](statement:cantilever.dps_valid) | | [0.112](cell:arrays/array=section_3.6/speed) | [0.0115](cell:velocity_excess) |
| 1 | [0.495](cell:dps_regime/impact=1/deflection) | [0.484](cell:half_way) | [0.379](cell:speed) | |
| $1.75\cdot10^{19}$, the cradle | | | [1.827e5](cell:far/speed) | | */
struct Compared {
  Estimate deflection, half_way, velocity, speed, push, share, ratio;
};

Compared compared(double impact, const TwoRuns<Packet>& dps, bool quick) {
  const double step = quick ? 0.2 : 0.1, eps = impact / 2;
  const TwoRuns<Packet> chain{packet_of(impact, step), packet_of(impact, step / 2)};
  const auto excess = [&](double unit, auto number) {
    const Estimate ratio = quotient(dps.of(number), chain.of(number));
    return Estimate{unit * ratio.value - 1, unit * ratio.error};
  };
  return {.deflection = excess(2 * eps, [](const Packet& p) { return p.deflection; }),
          .half_way = excess(2 * eps, [](const Packet& p) { return p.half_way; }),
          .velocity = excess(2 * eps, [](const Packet& p) { return p.velocity; }),
          .speed = excess(std::sqrt(eps), [](const Packet& p) { return p.speed; }),
          .push = chain.of([](const Packet& p) { return p.push; }),
          .share = chain.of([](const Packet& p) { return p.share; }),
          .ratio = chain.of([](const Packet& p) { return p.velocity / p.deflection; })};
}

void report_regime(Report& report, const TwoRuns<Packet>& dps) {
  const std::vector<double> impacts{1e-3, 3e-3, 0.01, 0.03, 0.1, 0.3, 1, 3, 10};
  std::vector<Compared> found(impacts.size());
  parallel_for("DpS regime", impacts.size(),
               [&](std::size_t i) { found[i] = compared(impacts[i], dps, report.quick); });
  Table& regime = report.table("dps_regime");
  for (std::size_t i = 0; i < impacts.size(); ++i)
    regime.add({{"impact", "lambda^(5/2), velocity of the dimensionless impact", impacts[i]},
                {"deflection", "of bead 80 by the DpS equation, over that in the chain, less one",
                 found[i].deflection},
                {"half_way", "of bead 40, likewise", found[i].half_way},
                {"speed", "of the packet between sites 20 and 60, likewise", found[i].speed}});
  report.table("dps_order")
      .add({{"deflection", "power of lambda^(5/2) with which the excess grows, the first rows",
             order_between(impacts[2], found[2].deflection, impacts[0], found[0].deflection)},
            {"speed", "of the packet, likewise",
             order_between(impacts[2], found[2].speed, impacts[0], found[0].speed)}});
  report.table("far").add(Row{{"impact", "of the article's cradle", cradle_impact},
                              {"speed", "of the DpS packet, over that in the chain, less one",
                               compared(cradle_impact, dps, report.quick).speed}});
}

/**
## Two beads collide

All scales follow from the collision of two free beads. Bead 1 runs into bead 2, which is at rest, with $V=1$ in units
in which $m=\gamma=1$; then times are in units of $\tau_h$ and lengths in units of $\delta = (mV^2/\gamma)^{2/5}$. The
masses are equal, so the beads exchange their velocities. After the contact bead 1 is at rest, and the centre of mass,
at the speed $V/2$, has moved $V t_c/2$, and bead 1 with it: this gives the contact time $t_c$ without event location.
The compression is largest at $t_c/2$. The conservation of energy (collision.hpp) gives both in closed form, the
compression as $(5/8)^{2/5}\,\delta$, and the program stops unless they agree to $10^{-7}$.

The printed contact time is our 2.439 if its digits are cut off; the printed compression is not ours. The article quotes
both from other works. With the reduced mass $\frac12m$ the compression is $(\frac12mV^2/K)^{2/5}$, $K = \frac45\gamma$.
A possible cause of 0.76 is $\gamma$ in place of $K$, which gives $2^{-2/5}\,\delta = 0.758\,\delta$.

A cradle with strings of length $L$ has $\tau_c^2 = L/g$, and a collision of its balls was measured to take 0.077 ms. As
$\lambda^{5/2} = (L/g\tau_h^2)^{5/2}$ contains the fifth power of $\tau_h$, rounding matters. The article prints no $g$;
10 m/s² and its own 2.43 give its value. With any of these values a collision is over long before a pendulum has moved.

| quantity | article | here |
|---|---|---|
| contact time, in $\tau_h$ | 2.43 | [2.439](cell:collision/contact_time) |
| largest compression, in $\delta$ | 0.76 | [0.829](cell:collision/compression) |
| cradle: $\lambda^{5/2}$ with $g = 10$ m/s² and 2.43 | $1.75\cdot10^{19}$ | [1.74986e19](cell:cradle/digits=printed/g=10/impact) |
| the same with 9.81 m/s² and all digits of the contact time | | [1.869e19](cell:cradle/digits=all/g=9.81/impact) | */
Collision collide(double step) {
  const Chain beads{2, None{}};  // no wells
  State<double> state = struck(2, 1), middle = state;
  evolve(EventCorrected{step}, beads, state, 4, 4);  // it is over at t = 2.44
  const double contact_time = 2 * state.y[0];
  evolve(EventCorrected{step}, beads, middle, contact_time / 2, contact_time / 2);
  return {.contact_time = contact_time, .compression = middle.y[0] - middle.y[1]};
}

void report_collision(Report& report) {
  const double step = report.quick ? 0.2 : 0.1;
  const TwoRuns<Collision> runs{collide(step), collide(step / 2)};
  const Estimate time = runs.of([](const Collision&c) { return c.contact_time; }),
                 compression = runs.of([](const Collision&c) { return c.compression; });
  const Collision known = collision_by_energy();
  const Estimate per = quotient(time, compression);
  if (!(std::abs(time.value - known.contact_time) < 1e-7) ||
      !(std::abs(compression.value - known.compression) < 1e-7))
    throw Failure("the integrated collision disagrees with the conservation of energy");
  report.table("collision")
      .add({{"contact_time", "time for which the beads touch", time, "tau_h"},
            {"compression", "largest compression", compression, "delta"},
            {"for_076", "contact time that belongs to a compression of 0.76",
             Estimate{0.76 * per.value, 0.76 * per.error}, "tau_h"}});

  Table& cradles = report.table("cradle");
  const auto add_cradle = [&](const char* digits, double g, const Estimate& contact) {
    const double impact = cradle.lambda_5_2(g, contact.value);
    const double error = 5 * impact * contact.error / contact.value;
    cradles.add({{"digits", "digits of the contact time that are used", digits},
                 {"g", "acceleration of gravity", g, "m/s^2"},
                 {"impact", "lambda^(5/2), velocity of the dimensionless impact",
                  contact.is_exact ? exact(impact) : Estimate{impact, error}, "",
                  "from the contact time"}});
  };
  add_cradle("printed", 10, exact(2.43));
  add_cradle("printed", 9.81, exact(2.43));
  add_cradle("all", 9.81, time);
  add_cradle("all", 10, time);
}

/**
## The array, and others that one can build

In the array of section 3.6 the two times are of the same order, and $\lambda^{5/2}$ is small. Local oscillations are
faster than collisions if $\tau_c$ and $\tau_h$ are compared; compared by the period $2\pi\tau_c$ and the contact time
$2.44\,\tau_h$ they are not. The article means the former (`scale.faster`). It expects the beads to lose their energy in
some 10 ms: a disturbance then matters only if the fraction by which it grows in each period exceeds this period over
10 ms.

Its conclusion says for which sizes such breathers should be observable: beads of about 1 cm diameter, loads of about 1
N, beams of about 1 cm width. Beads and beams of section 3.6 have half of these sizes. We strike another array, with
these sizes and otherwise the same beams and materials, at 0.23 m/s, so that the strongest push at bead 80 is about 1 N.
There the DpS equation is more accurate than in section 3.6. This is due to the weaker impact: $\lambda^{5/2}$ is
proportional to $V$, and at 1 m/s it would be nearly that of section 3.6.

| array | article | section 3.6, 1 m/s | 1 cm, 0.23 m/s |
|---|---|---|---|
| $\tau_h$, ms | 0.047 | [0.0465](cell:array/tau_h) | |
| $\tau_c$, ms | 0.025 | [0.0252](cell:array/tau_c) | |
| $\lambda$ | 0.29 | [0.294](cell:array/lambda) | |
| $\lambda^{5/2}$ | | [0.0468](cell:arrays/array=section_3.6/impact) | [0.00883](cell:arrays/array=centimetres/impact) |
| growth in the period 0.15 ms | 0.015 | [0.015](cell:losses/period=printed/epsilon) | |
| strongest push at bead 80, N | 2.8, about 1 | [2.864](cell:arrays/array=section_3.6/load) | [1.012](cell:arrays/array=centimetres/load) |
| fraction of the energy in the packet there | | [0.437](cell:arrays/array=section_3.6/share) | [0.443](cell:arrays/array=centimetres/share) |
| excess of the deflection by the DpS equation | | [0.150](cell:arrays/array=section_3.6/deflection) | [0.0721](cell:arrays/array=centimetres/deflection) |
| excess of the speed | | [0.112](cell:arrays/array=section_3.6/speed) | [0.0529](cell:arrays/array=centimetres/speed) | */
void report_arrays(Report& report, const TwoRuns<Packet>& dps) {
  const Scales s = cantilevers.scales();
  report.table("array").add(
      {{"tau_h", "time scale of a contact", exact(s.tau_h(array_impact) * 1e3), "ms", "exact"},
       {"tau_c", "time scale of the wells", exact(s.tau_c() * 1e3), "ms", "exact"},
       {"lambda", "their ratio, squared", exact(s.lambda(array_impact)), "", "exact"},
       {"impact", "lambda^(5/2)", exact(std::pow(s.lambda(array_impact), 2.5)), "", "exact"}});
  Table& losses = report.table("losses");
  const double lifetime = 10;  // ms
  const auto add_loss = [&](const char* period, double ms) {
    losses.add({{"period", "period of the breather", period},
                {"epsilon", "growth in a period that has an effect over 10 ms",
                 exact(ms / lifetime), "", "exact"}});
  };
  add_loss("printed", 0.15);
  add_loss("of_the_wells", s.milliseconds(2 * std::numbers::pi));

  Table& table = report.table("arrays");
  const auto add = [&](const char* which, const CantileverArray& array, double velocity) {
    const Scales units = array.scales();
    const Compared c = compared(units.velocity(velocity), dps, report.quick);
    const double newton = units.unit_force();
    table.add({{"array", "which array", which},
               {"diameter", "of the beads", exact(2e2 * array.radius), "cm", "exact"},
               {"width", "of the beams", exact(1e2 * array.width), "cm", "exact"},
               {"velocity", "of the impact", velocity, "m/s"},
               {"impact", "lambda^(5/2)", exact(units.velocity(velocity)), "", "exact"},
               {"load", "strongest push at bead 80",
                Estimate{newton * c.push.value, newton * c.push.error}, "N"},
               {"share", "of the energy, around the packet at bead 80", c.share},
               {"deflection", "excess by the DpS equation", c.deflection},
               {"speed", "the same of the packet", c.speed},
               {"velocity_excess", "the same of the largest velocity of bead 80", c.velocity},
               {"ratio", "largest velocity over largest deflection of bead 80", c.ratio}});
  };
  add("section_3.6", cantilevers, array_impact);
  add("centimetres", CantileverArray{.width = 1e-2, .radius = 5e-3}, 0.23);
}

/**
## From materials to the constants

The article takes the constants of a beam from a textbook; sec35/constants.cpp integrates its equation, $EI\,u'''' =
\rho A\,\omega^2u$ with $u = u' = 0$ at the clamped end and $u' = 0$ at the middle, in 200 and in 400 steps. Replacing
the beam with its beads by a spring and one point mass costs 0.4 per cent of the frequency with our effective mass; the
printed 0.38, which is rounded, hides most of this.

| of a clamped beam | article | here |
|---|---|---|
| stiffness, in $EI/\ell^3$ | 192 | [192.00](cell:beam/stiffness) |
| frequency, in $(EI/\rho A)^{1/2}/\ell^2$ | 22.4 | [22.37](cell:beam/frequency) |
| effective mass, in masses of the beam | 0.38 | [0.3836](cell:beam/mass) |
| frequency, model over beam with two beads, 0.38 | 1 | [0.9989](cell:beam/model_over_decorated) |
| the same with 0.3836 | | [0.996](cell:beam/own_over_decorated) |

The coefficient of a contact is Hertz's, in the article's closed form
$$\gamma_n = \frac{E\sqrt{2R}}{3(1-\nu^2)}\,
\Bigl[\frac{2\tilde R_n\tilde R_{n+1}}{\tilde R_n+\tilde R_{n+1}}\Bigr]^{1/2}.$$
With the modulus of the beads, for which the article writes $\mathcal E$, it agrees with the integrated pressure of two
spheres for all pairs of radii (table `hertz`). It prints $E$, the modulus of the beams, with which $\gamma$ would be
[132](cell:hertz/first=1/second=1/with_beam) times as large and $\lambda$ would be 14.6 instead of 0.29; but its 0.29
follows from the beads' modulus. What is left out are the higher modes and the torsion of the beams, and all of a contact
beyond Hertz's static law. */
void reproduce(Report& report) {
  const TwoRuns<Packet> dps{packet_of_dps(1280, 1e-8),
                            packet_of_dps(2560, 1e-10)};  // samples, tolerance
  report_regime(report, dps);
  report_collision(report);
  report_arrays(report, dps);
  report_beam(report, cantilevers);
  report_hertz(report, cantilevers);
  report_schematic(report, cantilevers, cradle.length);
}

/**
## Statement by statement

<!-- statements -->
| statement | printed | here | verdict |
|---|---|---|---|
| `scale.contact_time`: duration of a two-bead collision in units of tau_h | 2.43 | 2.439 tau_h | reproduced |
| `scale.max_compression`: maximal compression in units of delta | 0.76 | 0.8286 delta | discrepant |
| `scale.cradle`: lambda^(5/2) of the desk-top Newton's cradle | 1.75e19 | 1.74986e19 | reproduced, assuming |
| `scale.dps_regime`: the DpS regime takes place when lambda^(5/2) is small | small | dps_regime.deflection (impact = 3), (impact = 10): 0.7673 < 0.8556 (the closest of 18) | holds |
| `scale.faster`: in the array of section 3.6 local oscillations are faster than binary collisions | faster | array.tau_c, array.tau_h: 0.02522 < 0.04652 | holds, assuming |
| `scale.cradle_far`: a Newton's cradle is extremely far from the DpS regime | extremely far | far.speed: 100 < 182671 | holds |
| `beam.stiffness`: clamped-clamped mid-point stiffness in units of E I / l^3 | 192 | 192.0 E I/l^3 | reproduced |
| `beam.frequency`: first bending frequency constant of the clamped-clamped beam | 22.4 | 22.37 (E I/(rho A))^(1/2)/l^2 | reproduced |
| `beam.mass`: effective mass over beam mass | 0.38 | 0.3836 mass of the beam | reproduced |
| `cantilever.gamma`: Hertzian stiffness of two equal beads: gamma = E sqrt(2R) / (3 (1 - nu^2)) | E sqrt(2R) / (3 (1 - nu^2)) | fails 1 of 2 comparisons; first hertz.with_beam (first = 1, second = 1) away from 1: 131.2 < 1e-06 | in part |
| `cantilever.eta`: beads of different radii: eta_n = [2 R_n R_(n+1) / (R_n + R_(n+1))]^(1/2) | [2 R_n R_(n+1) / (R_n + R_(n+1))]^(1/2) | hertz.printed (first = 0.5, second = 1) away from 1: 4.663e-15 < 1e-06 (the closest of 16) | holds |
| `cantilever.tau_h`: Hertz time at 1 m/s | 0.047 ms | 0.04652 ms | reproduced |
| `cantilever.tau_c`: local time scale | 0.025 ms | 0.02522 ms | reproduced |
| `cantilever.lambda`: ratio of Hertz to local stiffness | 0.29 | 0.2939 | reproduced |
| `cantilever.dps_valid`: the DpS approximation is valid in the homogeneous part of the cantilever array | valid | 0.1498 | quantified |
| `outlook.dominated`: dissipation (10 ms) destroys the breather before instabilities with epsilon below this show | 0.015 | 0.015 | reproduced |
| `outlook.ranges`: beads of about 1 cm diameter, loads of about 1 N and a cantilever width of about 1 cm are relevant for such breathers and for the DpS equation | relevant | arrays.share (array = centimetres): 0.1 < 0.4434; arrays.deflection (array = centimetres): 0.07206 < 0.1; arrays.speed (array = centimetres): 0.05287 < 0.1 | holds, assuming |
<!-- /statements -->

## Try it

**To change it.** `cradle`, `cantilevers` and `array_impact` are at the top; materials and dimensions are the members of
`CantileverArray` (cantilever.hpp), such as `.length = 30e-3`. Another law of contact is the third member of `Chain` in
`packet_of` and `collide`; then `collision_by_energy` has to change with it, or the program stops, and so has the DpS
equation, which nothing checks.

1. *Easy.* Strike the array at a tenth of the speed: `build/bin/sec35_scales scales --velocity 0.1` gives
   `lambda` = 0.11702 and `contact_time` = 1.79796e-4. Hint: $\tau_h$ goes like $V^{-1/5}$.
2. *Harder.* How hard must one strike for $\lambda = 1$? `build/bin/sec35_scales scales --velocity 21.35` gives
   `lambda` = 1.0000 and `lambda_5_2` = 1.0001. Hint: this is $\xi/\tau_c$, the unit of velocity of the chain. */
int main(int argc, char** argv) {
  return run({"sec35_scales", "3.5", "Scales of a cradle and of an array (section 3.5)", reproduce,
              commands<AllScales>()},
             argc, argv);
}
