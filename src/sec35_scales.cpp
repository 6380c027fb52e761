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
units of $\tau_c$. In the DpS regime $\lambda$ is small: contacts last for a considerable part of an oscillation.

![Newton's cradle and an array of clamped cantilevers decorated by beads. Drawn by fig01_two_chains.py: the sizes of the
table `schematic`.](fig:01)

The article finds that $\lambda^{5/2}$ is astronomical for a cradle and less than one for the stiff cantilevers of
section 3.6. */
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "commands/all_scales.hpp"
#include "lattice/diagnostics/pulse.hpp"
#include "lattice/dps/dps_impact.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/model/cantilever.hpp"
#include "lattice/numerics/parallel.hpp"
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
but no $g$; $g = 10$ m/s² gives its value. In every reading a collision is over long before a pendulum has moved.

| quantity | article | here |
|---|---|---|
| contact time, in $\tau_h$ | 2.43 | [2.439](cell:collision/contact_time) |
| largest compression, in $\delta$ | 0.76 | [0.829](cell:collision/compression) |
| $2^{-2/5}$ | | 0.758 |
| contact time with a compression of 0.76, in $\tau_h$ | | [2.237](cell:collision/for_076) |
| cradle: $\lambda^{5/2}$ with $g = 10$ m/s² and 2.43 | $1.75\cdot10^{19}$ | [1.74986e19](cell:cradle/digits=printed/g=10/impact) |
| the same with 9.81 m/s² | | [1.83582e19](cell:cradle/digits=printed/g=9.81/impact) |
| the same with all digits of the contact time | | [1.869e19](cell:cradle/digits=all/g=9.81/impact) |
| and with 10 m/s² | | [1.782e19](cell:cradle/digits=all/g=10/impact) | */
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
  add_cradle("all", 10, time);
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
is small. Local oscillations are faster by the time scales, $\tau_c < \tau_h$; a whole period, $2\pi\tau_c$, takes
longer than a contact, $2.44\,\tau_h$ (`scale.faster`). The beads lose their energy in some 10 ms. The article's
conclusion compares this with the growth of an instability: a disturbance that is multiplied by $1+\epsilon$ in each
period has an effect over a time of the order of the period over $\epsilon$. This is longer than the 10 ms if $\epsilon$
is less than the period over 10 ms. The printed period is 0.15 ms.

| impact of 1 m/s | article | here |
|---|---|---|
| $\tau_h$, ms | 0.047 | [0.0465](cell:array/tau_h) |
| $\tau_c$, ms | 0.025 | [0.0252](cell:array/tau_c) |
| $\lambda$ | 0.29 | [0.294](cell:array/lambda) |
| $\lambda^{5/2}$, the impact of the dimensionless chain | | [0.0468](cell:array/impact) |
| $\epsilon$ with the period 0.15 ms | 0.015 | [0.015](cell:losses/period=printed/epsilon) |
| $\epsilon$ with the period $2\pi\tau_c$ | | [0.0158](cell:losses/period=of_the_wells/epsilon) |

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
                {"epsilon", "growth in a period that has an effect over 10 ms",
                 exact(ms / lifetime), "", "exact"}});
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
## Two spheres touch

The coefficient $\gamma_n$ of a contact follows from the theory of elasticity. A pressure $p$ on the surface of a half
space presses it in by $\frac{1-\nu^2}{\pi\mathcal E}\int p\,d^2r'/|r-r'|$, with the Young modulus $\mathcal E$ and
Poisson's ratio $\nu$ of the beads. Hertz's pressure on a disc of radius $a$, $p_0(1-r^2/a^2)^{1/2}$, makes a hollow
that is a paraboloid. We integrate along all chords through a point of the disc, on which the pressure is half an
ellipse. */
/// How far, in units of a and of p_0 (1 - nu^2)/(pi E).
double pressed_in(double r, std::size_t points) {
  const auto weight = std::numbers::pi / double(points);
  double sum = 0;
  for (std::size_t i = 0; i < points; ++i)
    for (std::size_t j = 0; j < points; ++j) {
      const double across = r * std::sin(weight * double(i)), along = std::cos(weight * double(j));
      sum += weight * weight * (1 - across * across) * along * along;
    }
  return sum;
}

/// The force between two beads of the array over (their approach)^(3/2), in N/m^(3/2), for a contact disc of 0.1 mm.
double hertz(const CantileverArray& array, double first, double second, std::size_t points) {
  const double a = 1e-4, soft = (1 - array.nu * array.nu) / (std::numbers::pi * array.bead_modulus);
  const double curved = (1 / first + 1 / second) / array.radius, middle = pressed_in(0, points);
  const auto pressure = [&](double r) {  // with which both hollows make room for both spheres
    return r * r * a * curved / 2 / (2 * soft * (middle - pressed_in(r, points)));
  };
  if (std::abs(pressure(0.25) / pressure(0.75) - 1) > 1e-12)
    throw Failure("Hertz's pressure does not fit to spheres");
  const double force = 2 * std::numbers::pi / 3 * a * a * pressure(0.5),
               approach = 2 * soft * a * pressure(0.5) * middle;
  return force / (approach * std::sqrt(approach));
}

/**
The article gives the result in closed form,
$$\gamma_n = \frac{E\sqrt{2R}}{3(1-\nu^2)}\,
\Bigl[\frac{2\tilde R_n\tilde R_{n+1}}{\tilde R_n+\tilde R_{n+1}}\Bigr]^{1/2}.$$
With the beads' modulus it is right for all pairs of radii. It prints $E$, the modulus of the beams in that section; its
$\lambda$ has the modulus of the beads.

| coefficient of the article over ours | with the beads' modulus | with the beams' |
|---|---|---|
| two beads of the usual size | [1.0000](cell:hertz/first=1/second=1/printed) | [132.2](cell:hertz/first=1/second=1/with_beam) |
| 0.5 radii at 2.5 radii | [1.0000](cell:hertz/first=0.5/second=2.5/printed) | | */
void report_hertz(Report& report, const CantileverArray& array) {
  Table& table = report.table("hertz");
  const double radii[] = {0.5, 1, 1.6, 2.5};
  for (double first : radii)
    for (double second : radii) {
      const Estimate ours =
          compare(hertz(array, first, second, 16), hertz(array, first, second, 32));
      const double eta = std::sqrt(2 * first * second / (first + second));
      const auto over = [&](double modulus) {
        return quotient(exact(array.gamma(modulus) * eta), ours);
      };
      table.add({{"first", "radius of a bead over the usual one", first},
                 {"second", "that of the bead which it touches", second},
                 {"printed", "the article's coefficient over Hertz's, with the beads' modulus",
                  over(array.bead_modulus)},
                 {"with_beam", "the same with the beams' modulus", over(array.beam_modulus)}});
    }
}

/**
## When does the DpS equation describe an impact?

When $\lambda^{5/2}$ is small, says the article. We strike chains of harmonic wells, Eq. (30), and the DpS chain,
Eq. (25), with $\epsilon = \lambda^{5/2}/2$, and compare their packets: the largest deflection $2\epsilon\,|A_{80}|$ of
bead 80, and the speed between sites 20 and 60. The run of the chain ends when the packet is at site 95 of 150. */
struct Packet {
  double deflection, velocity, push;  // the largest ones of bead 80
  double half_way;                    // deflection of bead 40
  double speed, share;                // share of the energy, when the packet is at bead 80
};

Packet packet_of(double impact, double step) {
  const double faster = std::pow(impact, 0.2);  // collisions shorten like tau_h
  step /= std::max(1.0, faster);
  Impact blow{impact, Chain{150}, 95 / std::min(0.1 * std::sqrt(impact), 0.3 * faster), step};
  blow.until = 95;
  std::vector<double> t, half, y, v, push;
  const auto watch = [&](const State<double>& now, const auto&) {
    t.push_back(now.t);
    half.push_back(now.y[39]), y.push_back(now.y[79]), v.push_back(now.v[79]);
    push.push_back(contact_push(blow.chain, now.y.data(), 80));
  };
  const ImpactRun run = strike(EventCorrected{step}, blow, watch);
  return {largest_modulus(t, y),        largest_modulus(t, v),
          largest_modulus(t, push),     largest_modulus(t, half),
          run.path.line(20, 60)->slope, run.path.energy_at(80) / (impact * impact / 2)};
}

/// The same of the DpS chain in its own units, so that one run serves all impacts.
TwoRuns<Packet> packet_of_dps() {
  const Dps dps{150};
  TwoRuns<Packet> runs{};
  parallel_for(2, [&](std::size_t k) {
    std::vector<double> at, half, amplitude;
    const auto watch = [&](double now, const Field& field) {
      at.push_back(now);
      half.push_back(std::abs(field[39])), amplitude.push_back(std::abs(field[79]));
    };
    const DpsOutcome out =
        follow_dps(dps, dps_impact(dps.sites), 320, k ? 2560 : 1280, k ? 1e-10 : 1e-8, watch);
    const double most = largest_modulus(at, amplitude);
    Packet& one = k ? runs.fine : runs.coarse;
    one.deflection = one.velocity = most;
    one.half_way = largest_modulus(at, half), one.speed = out.path.line(20, 60)->slope;
  });
  return runs;
}

struct Compared {
  Estimate deflection, half_way, velocity, speed, push, share;
};

Compared compared(double impact, const TwoRuns<Packet>& dps, bool quick) {
  const double step = quick ? 0.2 : 0.1, eps = impact / 2;
  const TwoRuns<Packet> chain{packet_of(impact, step), packet_of(impact, step / 2)};
  const auto excess = [&](double Packet::*of, double unit) {
    const auto number = [&](const Packet& p) { return p.*of; };
    const Estimate ratio = quotient(dps.of(number), chain.of(number));
    return Estimate{unit * ratio.value - 1, unit * ratio.error};
  };
  return {excess(&Packet::deflection, 2 * eps),
          excess(&Packet::half_way, 2 * eps),
          excess(&Packet::velocity, 2 * eps),
          excess(&Packet::speed, std::sqrt(eps)),
          chain.of([](const Packet& p) { return p.push; }),
          chain.of([](const Packet& p) { return p.share; })};
}

/**
The packet of the DpS equation is too high and too fast, by a fraction that falls nearly like $\lambda^{5/4}$, the order
of the terms that the equation leaves out (`sec31_dps_limit`). It is a few per cent at $10^{-3}$, a half at one. The
array of section 3.6 is in between. The article calls the approximation valid there and gives no accuracy. The largest
velocity of the bead agrees far better than its deflection.

| $\lambda^{5/2}$ | excess of the deflection | at bead 40 | of the speed | of the bead's velocity |
|---|---|---|---|---|
| $10^{-3}$ | [0.0253](cell:dps_regime/impact=1e-3/deflection) | [0.0244](cell:half_way) | [0.0187](cell:speed) | |
| $10^{-2}$ | [0.0775](cell:dps_regime/impact=0.01/deflection) | [0.0720](cell:half_way) | [0.0560](cell:speed) | |
| array of section 3.6 | [0.150](statement:cantilever.dps_valid) | | [0.112](cell:arrays/array=section_3.6/speed) | [0.0115](cell:velocity_excess) |
| 1 | [0.495](cell:dps_regime/impact=1/deflection) | [0.484](cell:half_way) | [0.379](cell:speed) | |
| $1.75\cdot10^{19}$, the cradle | | | [1.827e5](cell:far/speed) | |

In the cradle the DpS equation would make the packet faster by five orders of magnitude. */
void report_regime(Report& report, const TwoRuns<Packet>& dps) {
  const auto row = [&](double impact) {
    const Compared c = compared(impact, dps, report.quick);
    return Row{{"impact", "lambda^(5/2), velocity of the dimensionless impact", impact},
               {"deflection", "of bead 80 by the DpS equation, over that in the chain, less one",
                c.deflection},
               {"half_way", "of bead 40, likewise", c.half_way},
               {"speed", "of the packet between sites 20 and 60, likewise", c.speed}};
  };
  report.table("dps_regime")
      .fill(std::vector{1e-3, 3e-3, 0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0}, row, "DpS regime");
  report.table("far").add(Row{{"impact", "of the article's cradle", 1.75e19},
                              {"speed", "of the DpS packet, over that in the chain, less one",
                               compared(1.75e19, dps, report.quick).speed}});
}

/**
## Arrays that one can build

The article's conclusion gives ranges: beads of about 1 cm diameter, loads of about 1 N, beams of about 1 cm width. It
deems them relevant for such breathers and for the DpS equation. The beads and beams of section 3.6 have half of these
sizes. We strike another array, with these sizes and otherwise the beams and materials of section 3.6, at 0.23 m/s, so
that the strongest push at bead 80 is about 1 N. There the DpS equation is more accurate than in section 3.6.

| array | section 3.6 | 1 cm |
|---|---|---|
| strongest push at bead 80, N | [2.864](cell:arrays/array=section_3.6/load) | [1.012](cell:arrays/array=centimetres/load) |
| $\lambda^{5/2}$ | [0.0468](cell:arrays/array=section_3.6/impact) | [0.00883](cell:arrays/array=centimetres/impact) |
| share of the energy in the packet at bead 80 | [0.437](cell:arrays/array=section_3.6/share) | [0.443](cell:arrays/array=centimetres/share) |
| excess of the deflection by the DpS equation | [0.150](cell:arrays/array=section_3.6/deflection) | [0.0721](cell:arrays/array=centimetres/deflection) |
| excess of the speed | [0.112](cell:arrays/array=section_3.6/speed) | [0.0529](cell:arrays/array=centimetres/speed) | */
void report_arrays(Report& report, const TwoRuns<Packet>& dps) {
  Table& table = report.table("arrays");
  const auto add = [&](const char* which, const CantileverArray& array, double velocity) {
    const Scales s = array.scales();
    const Compared c = compared(s.velocity(velocity), dps, report.quick);
    table.add({{"array", "which array", which},
               {"diameter", "of the beads", exact(2e2 * array.radius), "cm", "exact"},
               {"width", "of the beams", exact(1e2 * array.width), "cm", "exact"},
               {"velocity", "of the impact", velocity, "m/s"},
               {"impact", "lambda^(5/2)", exact(s.velocity(velocity)), "", "exact"},
               {"load", "strongest push at bead 80",
                Estimate{s.unit_force() * c.push.value, s.unit_force() * c.push.error}, "N"},
               {"share", "of the energy, around the packet at bead 80", c.share},
               {"deflection", "excess by the DpS equation", c.deflection},
               {"speed", "the same of the packet", c.speed},
               {"velocity_excess", "the same of the largest velocity of bead 80", c.velocity}});
  };
  CantileverArray large;
  large.radius = 5e-3, large.width = 1e-2;
  add("section_3.6", CantileverArray{}, 1);
  add("centimetres", large, 0.23);
}

/**
## Differences and limits

With the beams' modulus in Hertz's coefficient $\lambda$ would be 14.6 (`scales` prints it). A beam is described by the
deflection of its middle: its higher modes, its torsion and all effects of a contact beyond Hertz's static law are
neglected. */
void reproduce(Report& report) {
  const CantileverArray array;
  report_collision(report);
  report_beam(report, array);
  report_array(report, array);
  report_hertz(report, array);
  const TwoRuns<Packet> dps = packet_of_dps();
  report_regime(report, dps);
  report_arrays(report, dps);
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
