/**
# 1 The chain, and what this book asks of it

A Newton's cradle is a row of balls that touch. Lift the first one, let it fall, and a pulse runs through the row. Now
hold every ball in a well of its own, stiff enough to oscillate while the pulse is there: short strings, or elastic
beams in the place of strings. What travels then is not a pulse but a packet of oscillations, and what stands still may
be one, too: a *breather*.

![Energy of the beads after an impact without and with wells, and of a breather that stays where it is.](fig:x36)

This chapter introduces the chain, shows the three motions of the figure, and says what is hard about them, how the
other chapters hang together, and what they find. It needs nothing but mechanics. */

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "lattice/impact/impact.hpp"
#include "lattice/integrators/event_corrected.hpp"
#include "lattice/orbits/breather.hpp"
#include "report/program.hpp"

using namespace lattice;

/**
## Contact, wells, units

Two elastic spheres that overlap by $x$ repel with the force $\gamma\,x^{3/2}$, which is Hertz's law; spheres
that do not overlap do not act on each other, and none ever pulls. So a contact has no linear part: the gentler the
motion, the softer it is. The chain of James, Kevrekidis and Cuevas (Physica D 251, 2013) has such contacts between
neighbours and a well $W$ for every bead, Eq. (9):
$$\ddot y_n = -W'(y_n) + (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2},\qquad
  W(y) = \tfrac12y^2 + \tfrac s4\,y^4,$$
where $(x)_+$ is $x$ if positive and zero otherwise.
Lengths and times are measured such that the mass of a bead, the stiffness of its well and that of a contact are one; a
bead alone oscillates with the frequency one. The number $s$ makes the well harmonic ($s = 0$), hard ($s > 0$) or soft
($s < 0$). Everything in this book is said in these units, except where an experiment is meant
(cantilever.hpp converts). */
constexpr double velocity = 1.87, duration = 160;  // of the impacts; of all runs

/**
## What a breather is

A breather is a motion that repeats itself, with a frequency $\omega_b$, and is confined to a few beads. Contacts add a
repulsive force to the wells, so the breathers begin at $\omega_b = 1$, as small as one likes, and are found above it.
Nothing radiates them away: contacts have no linear part, so the chain at rest carries no small waves from bead to bead.
Far from the breather the beads overlap by less and less, contacts become ever softer there, and the amplitude of each
bead is about the power $3/2$ of that of the bead before, a decay faster than any exponential. There are two kinds of
them, symmetric about a bead (*site-centred*) or about a contact (*bond-centred*).

**Letters**, one meaning each where no chapter says otherwise:

| letter | meaning |
|---|---|
| $y_n$, $\dot y_n$, $n$ | displacement and velocity of bead $n$, counted from one |
| $s$; $\alpha$ | anharmonicity of the wells; exponent of the contact force, $3/2$ for spheres |
| $\omega_b$, $T_b = 2\pi/\omega_b$ | frequency and period of a breather |
| $e_n$, $\mathcal H$ | energy density, Eq. (23), and energy, Eq. (6) |
| $v_0$ | velocity of the struck bead |
| $\epsilon$, $\tau$, $A_n$, $\tau_0$ | small amplitude, slow time, complex amplitudes and time constant of the DpS equation |
| $\mu$, $\delta$ | frequency of a stationary state of that equation; distance $\omega_b-1$ |
| $\lambda$, $\kappa$ | Floquet multiplier, and $(\lambda+\lambda^{-1}-2)/4$ of a pair of them |
| $E_{PN}$ | Peierls–Nabarro barrier: energy of the site-centred breather minus that of the bond-centred one |
| $T$ | inverse speed of a travelling breather: the time after which the next site does the same | */
constexpr double omega_b = 1.1;

/**
## Three motions

The figure shows the energy density, Eq. (23). Without wells the impact turns into the solitary wave of Nesterenko, five
beads wide, which is gone after a moment. With harmonic wells each bead is pulled back and swings while the disturbance
passes: nearly half of the energy goes into a packet that oscillates while it travels, four times more slowly; the rest
stays near the struck end, and whether the packet ever settles is a question of section 5. The third motion is an exact
periodic orbit, found by Newton's method. */
constexpr std::size_t shown = 60;  // sites of the figure

/**
Both impacts are followed twice, with different steps whose end states agree to a millionth (refinement.hpp). A packet is
the foremost eleven sites that hold at least a hundredth of the energy (observe.hpp); it is measured from site 20 on.
The pulse moves by [0.952600](num:sec1_the_chain.pulse_speed) sites in the unit of time and the packet by
[0.2445](num:sec1_the_chain.packet_speed), and of the impact's energy they carry
[0.993661](num:sec1_the_chain.pulse_share) and [0.462769](num:sec1_the_chain.packet_share). */
double every(const Report& report) {
  return report.quick ? 4 : 1;  // time between two rows of the map
}

struct Struck {
  const char* name;
  Well well;
};

void strike_both(Report& report, Table& map) {
  for (const Struck& one : {Struck{"pulse", None{}}, Struck{"packet", Harmonic{}}}) {
    const Impact impact = on_long_chain({velocity, {.well = one.well}, duration, 0.5});
    const auto runs =
        refined(1e-6, [&](const EventCorrected& method) { return strike(method, impact); });

    // How fast the foremost packet is, and what it carries when it passes site 40
    const Path &coarse = runs.coarse.path, &fine = runs.fine.path;
    const auto share = [](const Path& path) {
      return path.energy_at(40) / (velocity * velocity / 2);
    };
    report.facts.add(std::string(one.name) + "_speed",
                     compare(packet_speed(coarse), packet_speed(fine)), "sites per time");
    report.facts.add(std::string(one.name) + "_share", compare(share(coarse), share(fine)),
                     "energy of the impact");

    // The map of figure x36
    strike(EventCorrected{0.05}, impact,
           [&](const State<double>& now, const std::vector<double>& e) {
             if (std::fmod(now.t, every(report)) == 0)
               for (std::size_t n = 0; n < shown; ++n) map.add({one.name, now.t, n + 1, e[n]});
           });
  }
}

/**
The breather of $\omega_b = 1.1$ around a site fits into some ten beads; the others, up to the end of the chain, are
practically at rest. After [28](num:sec1_the_chain.periods) periods the beads have the energies that they had at the
start, up to [9e-12](num:sec1_the_chain.change) of the largest. */
void keep_one(Report& report, Table& map) {
  const auto problem = breather_problem(Centre::site, omega_b, 0, 31);
  const Orbit<double> orbit = find_breather(problem);
  const double periods = std::floor(duration / orbit.period());
  const auto change = [&](double step) {
    State<double> state = orbit.start;
    const auto before = energy_density(problem.chain, state);
    evolve(EventCorrected{step}, problem.chain, state, periods * orbit.period(), duration);
    const auto after = energy_density(problem.chain, state);
    double most = 0;
    for (std::size_t n = 0; n < before.size(); ++n)
      most = std::max(most, std::abs(after[n] - before[n]));
    return most / *std::max_element(before.begin(), before.end());
  };
  report.facts.add("periods", exact(periods));
  report.facts.add("change", compare(change(0.05), change(0.025)), "largest energy density");

  // The map again, with the centre where the figure has room for it
  State<double> state = orbit.start;
  evolve(EventCorrected{0.05}, problem.chain, state, duration, every(report),
         [&](const State<double>& now) {
           const auto e = energy_density(problem.chain, now);
           for (std::size_t n = 0; n < e.size(); ++n) map.add({"breather", now.t, n + 1, e[n]});
         });
}

/**
## What is hard about it

Four things make these motions hard to compute, and most of this book's methods are answers to one of them.

| difficulty | what goes wrong | what we do | where |
|---|---|---|---|
| contact events | the force has no second derivative where a contact opens or closes: integrators of high order lose it, their tangent maps even more | event location for orbits, exact impulses for long runs | `secA_integrators`, event_driven.hpp, event_corrected.hpp |
| near-degeneracy | a breather can be shifted in time for nothing and along the chain for almost nothing: Newton's matrix is nearly singular, and four multipliers lie next to $+1$, where an error $\eta$ moves them by about $\sqrt\eta$ | symmetries remove both directions; $\kappa$ in the place of $\lambda$ | `sec32_newton_breathers`, floquet.hpp, `sec33_multiplier_errors` |
| cancellation | two energies agree to six digits or more in the linear well, and their difference is the barrier | both orbits in extended precision, their energies from two tolerances | `sec32_barrier` |
| chaos | late fates of packets in hard wells depend on the last digit of the start | two runs that agree, or a count over many runs | `sec34_boomeron`, `sec34_boomeron_why` |

## How the chapters depend on each other

A chapter needs those to the left of it, and the headers that it names. `[2]` is in the second volume, beyond the article.

    sec1 -- sec31 DpS limit -- sec32 static breathers -- sec32 barrier -- sec33 stability -- sec33 mobility
       |         |                 (DpS and chain)                            +-- [2] sec33 between
       |         |                                                            +-- [2] sec33 multiplier errors
       |         |                                                            +-- sec33 stability, DpS
       |         +-- sec34 impact, gentle -- sec34 impact, strong -- sec34 turning -- [2] which, why
       |         |            |                    +-- sec34 kink
       |         |            |                    +-- [2] secB numbers of other authors
       |         |            +-- sec35 scales -- sec36 array -- [2] experiment, driving -- [2] driven packets
       |         +-- sec4 precompression -- [2] growth
       |         +-- [2] travelling breathers -- [2] families -- [2] what becomes of a packet
       |                      +-- [2] kernel equation -- [2] enclosures
       +-- sec2 no breathers without wells
       +-- secA integrators */
Table& report_motions(Report& report) {
  return report.table("motions", {label("motion", "pulse, packet or breather"), number("t", "time"),
                                  count("n", "site", "site"), number("e", "energy density")});
}

/**
## What is found

Most of the article survives: breathers, packets that turn round, scales. Some delicate numbers do not: a breather of
frequency 1.1 is depinned by a kick of the size $c =$ [4.4518e-6](num:moving.c_threshold), not $6.19\cdot10^{-6}$, and
the breathers around site and bond exchange their stability at almost the same $s$, [0.152520](num:floquet.s0_bond), not
at 0.26 and 0.05 (*Published against reproduced* has every claim). Of what we found besides, three sentences; the
page *What we found* has all, with what was tried to refute them. In these sentences $c$ is the root of the summed
squares of the velocities that a kick adds, and *equal area* means equal action of the two breathers.

- **Static breathers.** [](finding:barrier.signs)
- **Mobility.** [](finding:depinning.law)
- **Integrators.** [](finding:integrators.order)

Why packets turn round, which travelling breathers are exact, and what a driven array does is asked in the second volume. */
void reproduce(Report& report) {
  Table& map = report_motions(report);
  strike_both(report, map);
  keep_one(report, map);
}

/**
## Try it

1. *Easy.* The packet of a harder impact is faster: `build/bin/sec34_impact run --velocity 2` gives `speed` = 0.23844,
   `build/bin/sec34_impact run --velocity 4` gives `speed` = 0.30715. By which power of the impact does it grow? Hint:
   for gentle impacts the power is one half (sec34_dps_impact), without wells a fifth.
2. *Easy.* Take the wells away: `build/bin/sec34_impact run --well none` gives `speed` = 0.952600 and
   `packet_energy_fraction` = 0.993661. Hint: nothing holds a bead back any more, and what is pushed pushes on.
3. *Harder.* A breather of frequency 1.5: `build/bin/sec32_newton_breathers breather --omega 1.5` gives `amplitude` =
   0.394328. How does the amplitude grow with the frequency? Hint: in the limit of small amplitudes like
   $(\omega_b-1)^2$; compare with $\omega_b = 1.1$, and with 1.05.
4. *Open.* What do several beads send out that are struck at the same time: one packet, or several? Nobody here has
   looked. */
int main(int argc, char** argv) {
  return run({"sec1_the_chain", "1", "The chain, and what this book asks of it", reproduce}, argc,
             argv);
}
