/**
# 3.5 Physical scales of a cradle and of an array of cantilevers

In which real system can a travelling breather be seen? Following section 3.5 of James, Kevrekidis and Cuevas (Physica D
251, 2013) we compare two times, and derive every constant in SI units. Beads of mass $m$ that push on each other with
$\gamma x^{3/2}$ at the overlap $x$ and collide at the speed $V$ touch for a time of order $\tau_h$, and in a well of
stiffness $k$ each of them oscillates with the period $2\pi\tau_c$,
$$\tau_h = \Bigl(\frac{m^2}{\gamma^2V}\Bigr)^{1/5},\qquad \tau_c = \Bigl(\frac mk\Bigr)^{1/2}.$$
Their ratio is the only parameter of an impact, Eqs. (29) and (30),
$$\lambda = (\tau_c/\tau_h)^2,\qquad \dot y_1(0) = \lambda^{5/2} = (\tau_c/\tau_h)^5,$$
if lengths are measured in units of $\xi = (k/\gamma)^2$, at which well and contact are equally strong, and times in
units of $\tau_c$. A travelling breather needs a small $\lambda$: contacts must last for a considerable part of an
oscillation.

![Newton's cradle and an array of clamped cantilevers decorated by beads. Drawn by fig01_two_chains.py: the sizes of the
table `schematic`.](fig:01)

The article finds that $\lambda^{5/2}$ is astronomical for a cradle and less than one for the stiff cantilevers of
section 3.6. */
#include <cmath>
#include <numbers>

#include "commands/all_scales.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/model/cantilever.hpp"
#include "report/program.hpp"
#include "sec35/collision.hpp"

using namespace lattice;

/**
## The experiment: two beads collide

All scales follow from the collision of two free beads. Bead 1 runs into bead 2, which is at rest, with $V=1$ in units
in which $m=\gamma=1$; then times are in units of $\tau_h$ and lengths in units of $\delta = (mV^2/\gamma)^{2/5}$. The
masses are equal, so the beads exchange their velocities. After the contact bead 1 is at rest, and the centre of mass,
at the speed $V/2$, has carried it as far as $t_c/2$: this gives the contact time $t_c$ without event location. The
compression is largest at $t_c/2$. */
Collision collide(double step) {
  const Chain beads{2, None{}};  // no wells
  State<double> state(2);
  state.v[0] = 1;
  State<double> middle = state;
  evolve(EventCorrected{step}, beads, state, 4, 4);  // it is over at t = 2.44
  const double contact_time = 2 * state.y[0];
  evolve(EventCorrected{step}, beads, middle, contact_time / 2, contact_time / 2);
  return {contact_time, middle.y[0] - middle.y[1]};
}

/**
Steps of 0.1 and 0.05 give the error. The independent route is the conservation of energy (collision.hpp): all energy of
the relative motion, $\frac14mV^2$, is in the contact, $\frac25\gamma\,x^{5/2}$, when $x = (5/8)^{2/5}\,\delta$. The
program stops unless both agree to $10^{-7}$.

The contact time is the printed one, truncated to two decimals. The largest compression differs; the article quotes both
from other works. With the reduced mass $\mu = \frac12m$ it is $(\mu V^2/K)^{2/5}$, $K = \frac45\gamma$. A possible
cause of the quoted 0.76 is $\gamma$ in place of $K$, which gives $2^{-2/5}\,\delta$. At given $V$ the contact time is
proportional to the compression, so 0.76 would give a value eight per cent below 2.43.

A cradle with strings of length $L$ has $\tau_c^2 = L/g$. A collision of steel balls was measured to take 0.077 ms,
which is the contact time. As $\lambda^{5/2} = (L/g\tau_h^2)^{5/2}$ contains the fifth power of $\tau_h$, an error of
one per cent in the contact time becomes five per cent, and rounding matters. The article prints $L = 0.5$ m and 2.43,
but no $g$; $g = 10$ m/s² gives its value. Either way a collision is over long before a pendulum has moved, and no
breather travels there.

| quantity | article | here |
|---|---|---|
| contact time, in $\tau_h$ | 2.43 | [2.439](cell:collision/contact_time) |
| largest compression, in $\delta$ | 0.76 | [0.829](cell:collision/compression) |
| $2^{-2/5}$ | | 0.758 |
| contact time with a compression of 0.76, in $\tau_h$ | | [2.237](cell:collision/for_076) |
| cradle: $\lambda^{5/2}$ with $g = 10$ m/s² and 2.43 | $1.75\cdot10^{19}$ | [1.74986e19](cell:cradle/digits=printed/g=10/impact) |
| the same with 9.81 m/s² | | [1.83582e19](cell:cradle/digits=printed/g=9.81/impact) |
| the same with all digits of the contact time | | [1.869e19](cell:cradle/digits=all/impact) | */
void report_collision(Report& report) {
  const double step = report.quick ? 0.2 : 0.1;
  const TwoRuns<Collision> runs{collide(step), collide(step / 2)};
  const Estimate time = runs.of([](const Collision&c) { return c.contact_time; }),
                 compression = runs.of([](const Collision&c) { return c.compression; });
  const Collision known = collision_by_energy();
  if (!(std::abs(time.value - known.contact_time) < 1e-7) ||
      !(std::abs(compression.value - known.compression) < 1e-7))
    throw Failure("the integrated collision disagrees with the conservation of energy");
  Estimate for_076 = quotient(time, compression);
  for_076.value *= 0.76, for_076.error *= 0.76;
  report.table("collision")
      .add({{"contact_time", "time for which the beads touch", time, "tau_h"},
            {"compression", "largest compression", compression, "delta"},
            {"for_076", "contact time that belongs to a compression of 0.76", for_076, "tau_h"}});
  Table& cradles = report.table("cradle");
  const auto add_cradle = [&](const char* digits, double g, const Estimate& contact) {
    const double impact = cradle(g, contact.value);
    cradles.add({{"digits", "digits of the contact time that are used", digits},
                 {"g", "acceleration of gravity", g, "m/s^2"},
                 {"impact", "lambda^(5/2), velocity of the dimensionless impact",
                  contact.is_exact ? exact(impact)
                                   : Estimate{impact, 5 * impact * contact.error / contact.value},
                  "", "from the contact time"}});
  };
  add_cradle("printed", 10, exact(2.43));
  add_cradle("printed", 9.81, exact(2.43));
  add_cradle("all", 9.81, time);
}

/**
## The beam

The article replaces a beam of length $\ell$ by a spring and a point mass, with factors printed to two or three digits.
We compute these factors. We integrate $u'''' = x^4u$ for the deflection $u$, where $x$ is now the wavenumber times
$\ell$, along half of the beam, from the clamped end, where $u = u' = 0$, to the middle, where $u' = 0$ by symmetry
(cantilever.hpp), in 200 and in 400 steps. For a static load at the middle $x = 0$ and the solution is a cubic, which
the Runge–Kutta method reproduces exactly. The condition $\cos x\cosh x = 1$ checks the frequency independently.
Replacing beam and beads by one point mass changes the frequency by a thousandth.

| of a clamped beam | article | here |
|---|---|---|
| stiffness, in $EI/\ell^3$ | 192 | [192.00](cell:beam/stiffness) |
| frequency $x^2$, in $(EI/\rho A)^{1/2}/\ell^2$ | 22.4 | [22.37](cell:beam/frequency) |
| effective mass, in masses of the beam | 0.38 | [0.3836](cell:beam/mass) |
| frequency, model over decorated beam | 1 | [0.9989](cell:beam/model_over_decorated) |

Here $EI$ is the bending stiffness and $\rho A$ the mass per length. */
void report_beam(Report& report, const CantileverArray& array) {
  const auto both = [](auto of) { return compare(of(200), of(400)); };
  const double x = clamped_root(), by_shooting = ClampedBeam{}.wavenumber();
  const auto mass = [](double root) { return 192 / (root * root * root * root); };
  const double load = 2 * array.bead_mass() / array.beam_mass();
  const double model = std::sqrt(192 * array.beam_mass() / array.mass());
  const auto over_decorated = [&](std::size_t steps) {
    const double root = ClampedBeam{steps, load}.wavenumber();
    return model / (root * root);
  };
  report.table("beam").add(
      {{"stiffness", "force at the middle over its deflection",
        both([](std::size_t steps) { return ClampedBeam{steps}.stiffness(0); }), "E I/l^3"},
       {"frequency", "lowest frequency, the square of the wavenumber",
        compare(by_shooting * by_shooting, x * x), "(E I/(rho A))^(1/2)/l^2",
        "shooting against cos x cosh x = 1"},
       {"mass", "mass with which the spring has this frequency",
        compare(mass(by_shooting), mass(x)), "mass of the beam",
        "shooting against cos x cosh x = 1"},
       {"model_over_decorated", "frequency of spring and mass over that of the beam with two beads",
        both(over_decorated)}});
}

/**
## The array (figure 1) and its losses

In the article's array the two times are of the same order and the impact of the dimensionless chain, $\lambda^{5/2}$,
is small: breathers can travel. The beads lose their energy in some 10 ms. The article's conclusion compares this with
the growth of an instability: a disturbance that is multiplied by $1+\epsilon$ in each period stays unobserved if it
grows by less than a factor of $e$ in that time; the limit is $(1+\epsilon)^{10/0.15} = e$ with the printed period of
0.15 ms.

| impact of 1 m/s | article | here |
|---|---|---|
| $\tau_h$, ms | 0.047 | [0.0465](cell:array/tau_h) |
| $\tau_c$, ms | 0.025 | [0.0252](cell:array/tau_c) |
| $\lambda$ | 0.29 | [0.294](cell:array/lambda) |
| $\lambda^{5/2}$, the impact of the dimensionless chain | | [0.0468](cell:array/impact) |
| $\epsilon$ with the period 0.15 ms | 0.015 | [0.0151](cell:losses/period=printed/epsilon) |
| $\epsilon$ with the period $2\pi\tau_c$ | | [0.016](cell:losses/period=of_the_wells/epsilon) |

Figure 1 is drawn to scale. The two beads of each cantilever touch those of its neighbours, so the pitch is one
thickness and four radii. The cradle's string has the length of this section; the size of its beads is not given, and we
choose it. */
void report_array(Report& report, const CantileverArray& array) {
  const Scales s = array.scales();
  const double velocity = 1;  // m/s
  report.output.add("scales", AllScales{velocity}.table());
  report.table("array").add(
      {{"tau_h", "time scale of a contact", exact(s.tau_h(velocity) * 1e3), "ms", "exact"},
       {"tau_c", "time scale of the wells", exact(s.tau_c() * 1e3), "ms", "exact"},
       {"lambda", "their ratio, squared", exact(s.lambda(velocity)), "", "exact"},
       {"impact", "lambda^(5/2)", exact(std::pow(s.lambda(velocity), 2.5)), "", "exact"}});
  Table& losses = report.table("losses");
  const double lifetime = 10;  // ms
  const auto add = [&](const char* period, double ms) {
    losses.add({{"period", "period of the breather", period},
                {"epsilon", "growth in a period that is a factor of e in 10 ms",
                 exact(std::expm1(ms / lifetime)), "", "exact"}});
  };
  add("printed", 0.15);
  add("of_the_wells", s.milliseconds(2 * std::numbers::pi));

  // What the drawing needs
  Table& drawn = report.table(
      "schematic", {label("id", "part of the figure"), label("parameter", "name of the dimension"),
                    number("value", "value of the dimension"), label("unit", "unit of the value")});
  drawn.add({"cradle", "string_length", 0.5, "m"});
  drawn.add({"cradle", "beads_drawn", 5.0, ""});
  drawn.add({"cradle", "bead_radius_drawn", 0.04, "m"});
  for (const auto& [name, unit, value] : given_scales(array))
    drawn.add({"cantilever", name, value, unit});
  drawn.add({"cantilever", "beads_per_cantilever", 2.0, ""});
  drawn.add({"cantilever", "pitch", array.thickness + 4 * array.radius, "m"});
  drawn.add({"cantilever", "cantilevers_drawn", 5.0, ""});
}

/**
## Differences and limits

Hertz's coefficient needs the Young modulus of the beads, $\gamma = \mathcal E\sqrt{2R}/(3(1-\nu^2))$ with their radius
$R$ and Poisson's ratio $\nu$; the article prints the symbol of the beam's, which would give a $\lambda$ of 14.6
(`scales` prints it). A beam is described by the deflection of its middle: its higher modes, its torsion and all effects
of a contact beyond Hertz's static law are neglected. */
void reproduce(Report& report) {
  const CantileverArray array;
  report_collision(report);
  report_beam(report, array);
  report_array(report, array);
}

/**
## Statement by statement

<!-- statements -->
| statement | printed | here | verdict |
|---|---|---|---|
| `scale.contact_time`: duration of a two-bead collision in units of tau_h | 2.43 | 2.439 tau_h | reproduced |
| `scale.max_compression`: maximal compression in units of delta | 0.76 | 0.8286 delta | discrepant |
| `scale.cradle`: lambda^(5/2) of the desk-top Newton's cradle | 1.75e19 | 1.74986e19 | reproduced, assuming |
| `beam.stiffness`: clamped-clamped mid-point stiffness in units of E I / l^3 | 192 | 192.0 E I/l^3 | reproduced |
| `beam.frequency`: first bending frequency constant of the clamped-clamped beam | 22.4 | 22.37 (E I/(rho A))^(1/2)/l^2 | reproduced |
| `beam.mass`: effective mass over beam mass | 0.38 | 0.3836 mass of the beam | reproduced |
| `cantilever.tau_h`: Hertz time at 1 m/s | 0.047 ms | 0.04652 ms | reproduced |
| `cantilever.tau_c`: local time scale | 0.025 ms | 0.02522 ms | reproduced |
| `cantilever.lambda`: ratio of Hertz to local stiffness | 0.29 | 0.2939 | reproduced |
| `outlook.dominated`: dissipation (10 ms) destroys the breather before instabilities with epsilon below this show | 0.015 | 0.01511 | reproduced |
<!-- /statements -->

## Try it

**To change it.** The array's dimensions and materials are the members of `CantileverArray` (cantilever.hpp), the cradle
is `cradle(g, contact_time)` (sec35/collision.hpp). Another law of contact is the third member of `Chain` in `collide`,
and the integral in `collision_by_energy`. The tests of these headers then fail.

1. *Easy.* Strike the array at a tenth of the speed: `build/bin/sec35_scales scales --velocity 0.1` gives
   `lambda` = 0.11702 and `contact_time` = 1.79796e-4. Hint: $\tau_h$ goes like $V^{-1/5}$.
2. *Harder.* How hard must one strike for $\lambda = 1$? `build/bin/sec35_scales scales --velocity 21.35` gives
   `lambda` = 1.0000 and `lambda_5_2` = 1.0001. Hint: this is $\xi/\tau_c$, the unit of velocity of the chain.

`scales` prints all constants for your own impact (commands/all_scales.hpp). */
int main(int argc, char** argv) {
  return run({"sec35_scales", "3.5", "Scales of a cradle and of an array (section 3.5)", reproduce,
              commands<AllScales>()},
             argc, argv);
}
