/**
# Appendix: numbers of other authors

A library for chains of beads should also reproduce numbers that other authors have printed. Here we compute some twenty
of them, for the classical system of this field, the chain *without* wells, and for relatives of the article's
equations. The list `paper/literature.ecsv` has the printed values, their sources and how we know them. Only a number
that we have read at its source, in text, data or abstract, gets a verdict; all of these are reproduced within what
their digits allow. A few that are often quoted, and whose source we could not open, stand beside ours as we remember
them, without a verdict.

![Numbers of other authors, and ours over them.](fig:x34)

The equations of this chapter are those of chain.hpp with $W = 0$ and all masses one, unless it says otherwise:
$$\ddot y_n = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2}.$$
The first bead gets an impact, $\dot y_1(0) = 1$. This is no restriction: with another impact velocity $v_0$ all
displacements grow like $v_0^{4/5}$, all times shrink like $v_0^{-1/5}$, and velocities are proportional to $v_0$. */

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "lattice/diagnostics/pulse.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/integrators/event_corrected.hpp"
#include "report/program.hpp"
#include "secB/alternating.hpp"
#include "secB/dimer_wave.hpp"
#include "secB/exponents.hpp"
#include "secB/solitary_wave.hpp"

using namespace lattice;

/**
## The pulse of an impact

Within some ten beads an impact turns into a solitary wave (solitary_wave.hpp), which takes nearly all of the energy
with it. Its shape has no parameter; the run only has to give its height. We record the velocity of two beads and take
the maximum of the parabola through the largest samples. */
Chain free_chain(std::size_t sites) {
  return {sites, None{}};
}

struct BeadVelocities {
  std::vector<double> t{};
  std::vector<std::vector<double>> v{};  ///< of each bead that is watched
  State<double> end{};
};

/// The velocities of `beads`, counted from one, in samples `sample` apart.
BeadVelocities watch_beads(std::size_t sites, double duration, double step, double sample,
                           const std::vector<std::size_t>& beads) {
  BeadVelocities out;
  out.v.resize(beads.size());
  out.end = struck(sites, 1);
  evolve(EventCorrected{step}, free_chain(sites), out.end, duration, sample,
         [&](const State<double>& now) {
           out.t.push_back(now.t);
           for (std::size_t k = 0; k < beads.size(); ++k) out.v[k].push_back(now.v[beads[k] - 1]);
         });
  return out;
}

/**
The error is that of the step and of the sampling together, and of the length of the run: whether the pulse still
changes between bead 40 and bead 80. The largest velocity is [0.682](num:secB_other_numbers.pulse_amplitude) times that
of the impact (printed where another program is validated: 0.68), and the pulse has
[0.994](num:secB_other_numbers.pulse_energy) of its energy (0.993662 in the data of a third program). The kinetic part
of the wave's own energy is [0.556](num:secB_other_numbers.pulse_kinetic), the 5/9 of Slepyan. */
Estimate pulse_amplitude() {
  const auto heights = [](double step) {
    const BeadVelocities run = watch_beads(100, 110, step, step, {40, 80});
    return std::pair(largest_modulus(run.t, run.v[0]), largest_modulus(run.t, run.v[1]));
  };
  const auto coarse = heights(0.04), fine = heights(0.02);
  const Estimate by_step = compare(coarse.second, fine.second);
  return {by_step.value, by_step.error + std::abs(fine.second - fine.first)};
}

/**
The wave itself is computed without a run, and from its integrals follows what else is printed. A wave of the amplitude
$V$ has the speed $c = (V/V_1)^{1/5}$ if $V_1$ is the largest velocity in the wave of speed one. In the long-wave theory
of Nesterenko $c = (4/5)^{2/5}V^{1/5}$, and the velocity is proportional to $\cos^4(\sqrt{2/5}\,\xi)$, five sites wide.
Sen and Manciu wrote the displacement as a $\tanh$ with the slope $C_1/2$ at the centre, so that $C_1 = 4V/(c\,A)$ with
the shift $A$ of every bead. We find $C_1 =$ [2.40](num:secB_other_numbers.sen_c1); theirs, as we remember it, is
2.39536, from a run that we do not know. The wave is slower than the long-wave theory by
[0.781](num:secB_other_numbers.pulse_slower) per cent and at half height narrower by
[12.7](num:secB_other_numbers.pulse_narrower) per cent; printed are "within 0.8" and 13. */
struct WaveNumbers {
  double crest, speed_deficit, half_deficit, width, share, c1, energy;
};

WaveNumbers wave_numbers(std::size_t points, std::size_t half_width) {
  const SolitaryWave w = solitary_wave(1.5, points, half_width);
  const double crest = w.velocity[0];
  const double long_wave = std::pow(0.8, 0.4) * std::pow(crest, 0.2);
  const double cosine_half = 2 * std::sqrt(2.5) * std::acos(std::pow(0.5, 0.25));
  return {crest,
          100 * (1 - 1 / long_wave),
          100 * (1 - w.width(0.5) / cosine_half),
          w.width(0.01),
          w.kinetic_share(),
          4 * crest / w.shift,
          2 * (w.kinetic + w.potential) / (crest * crest)};
}

/**
One of the sources gives the width at a hundredth of the peak as it was sampled: bead 31 of 60 steel beads of 10 mm,
sampled every 2 microseconds, with straight lines between the samples. Near the foot of the pulse the velocity falls by
half from sample to sample, and the straight line makes the pulse wider: [3.96](num:secB_other_numbers.sampled_width)
sites instead of [3.95](num:secB_other_numbers.pulse_width). The source has 3.96. */
double sampled_width(double step, double speed) {
  const double mass = 7780 * std::numbers::pi / 6 * 1e-6;
  const double stiffness = 4. / 3 * 203e9 / (2 * (1 - 0.3 * 0.3)) * std::sqrt(0.005 / 2);
  const double sample = 2e-6 / std::pow(mass / stiffness, 0.4);
  const BeadVelocities run = watch_beads(60, 60, step, sample, {31});
  const double crest = *std::max_element(run.v[0].begin(), run.v[0].end());
  return speed * time_above(run.t, run.v[0], 0.01 * crest);
}

void report_pulse(Report& report) {
  const WaveNumbers coarse = wave_numbers(16, 6), fine = wave_numbers(32, 6);
  const auto add = [&](const char* name, double WaveNumbers::*number, const char* unit = "") {
    report.facts.add(name, compare(coarse.*number, fine.*number), unit);
  };
  const Estimate amplitude = pulse_amplitude();
  report.facts.add("pulse_amplitude", amplitude, "impact velocity");
  add("pulse_slower", &WaveNumbers::speed_deficit, "%");
  add("pulse_narrower", &WaveNumbers::half_deficit, "%");
  add("pulse_width", &WaveNumbers::width, "sites");
  add("pulse_kinetic", &WaveNumbers::share);
  add("sen_c1", &WaveNumbers::c1);
  const double V = amplitude.value;
  report.facts.add("pulse_energy", {fine.energy * V * V, 2 * fine.energy * V * amplitude.error},
                   "energy of the impact");
  const double speed = std::pow(V / fine.crest, 0.2);
  report.facts.add("sampled_width", compare(sampled_width(0.04, speed), sampled_width(0.02, speed)),
                   "sites");
}

/**
## Rebounding beads

Behind the pulse one bead after the other loses its contacts and flies back, each more slowly than the one before, the
sixteenth by the factor [0.563](num:secB_other_numbers.fragment_ratio). Hinch and Saint-Jean described this
fragmentation of a line of balls in 1999; the six digits that we compare with are those of a run that was put online
with a program of Sokolow's, of 100 steel balls and with leapfrog steps of ten picoseconds. Its first ball later meets a
wall, and until then the chain is ours. Of the five balls that we compare, the velocities agree in all six digits. */
constexpr std::size_t fragments[]{1, 2, 4, 8, 16};
constexpr double struck_with = 0.099188;  // m/s

void report_fragments(Report& report) {
  const auto velocities = [](double step) { return watch_beads(60, 30, step, 30, {}).end.v; };
  const auto coarse = velocities(0.04), fine = velocities(0.02);
  for (std::size_t n : fragments)
    report.facts.add("fragment_" + std::to_string(n),
                     compare(struck_with * coarse[n - 1], struck_with * fine[n - 1]), "m/s");
  report.facts.add("fragment_ratio",
                   quotient(compare(coarse[15], fine[15]), compare(coarse[14], fine[14])));
}

/**
## Alternating masses

In a dimer chain the pulse loses energy to the light beads, but at particular mass ratios it does not: Jayaprakash,
Starosvetsky and Vakakis found a sequence of them. A run approaches them slowly. We solve the equations of the wave
itself, in which the mass ratio is an unknown and the condition that both kinds of beads are at rest behind it one of
the equations (dimer_wave.hpp), from the pulse of a run near each ratio, on two grids. They are the four numbers that we
remember of that article, to all its digits.

| without loss | mass ratio |
|---|---|
| 1 | [0.342846 ± 5e-7](num:secB_other_numbers.dimer_1) |
| 2 | [0.154752 ± 4e-7](num:secB_other_numbers.dimer_2) |
| 3 | [0.0901278 ± 5e-7](num:secB_other_numbers.dimer_3) |
| 4 | [0.0615021 ± 8e-7](num:secB_other_numbers.dimer_4) | */
constexpr double near_ratio[]{0.343, 0.155, 0.09, 0.0615};

void report_dimers(Report& report) {
  for (std::size_t k = 0; k < std::size(near_ratio); ++k) {
    const auto ratio = [&](std::size_t steps) {
      return dimer_wave(passing_pulse(near_ratio[k], steps)).mass_ratio;
    };
    report.facts.add("dimer_" + std::to_string(k + 1), compare(ratio(40), ratio(80)));
  }
}

/**
## Alternating exponents

The same happens in a chain of equal beads whose contacts alternate between two exponents (alternating.hpp). Kekić, who
studied such chains in his thesis, writes exponents of the potential energy and names two pairs for which the leading
pulse keeps its energy, 5/2 with 2.635 and 4 with 5.0. His unit of length follows from the impact of 0.11 m/s. The loss
has its minimum, zero, at [2.64](num:secB_other_numbers.exponent_hertz) and
[5.01](num:secB_other_numbers.exponent_four). */
void report_alternating(Report& report) {
  // His steel beads, and the unit of length (m v^2 / (a A))^(1/a) with the exponent a and the strength A of the energy
  const double A = 0.4 * std::sqrt(0.002) / (1.5 * (1 - 0.3 * 0.3) / 2.26e11), m = 2.05e-3;
  const double v = 1e-7 / std::sqrt(m / (1e9 * 2.5));
  const auto find = [&](double a, double low, double high, std::size_t to, double tolerance) {
    const double length = std::pow(m * v * v / (a * A), 1 / a);
    return 1 + lossless_exponent({a - 1, low - 1, length}, low - 1, high - 1, 71, to, tolerance);
  };
  report.facts.add("exponent_hertz",
                   compare(find(2.5, 2.63, 2.64, 101, 1e-9), find(2.5, 2.633, 2.637, 121, 1e-11)));
  report.facts.add("exponent_four",
                   compare(find(4, 4.9, 5.1, 101, 1e-9), find(4, 4.95, 5.05, 121, 1e-11)));
}

/**
## Any exponent of the contact

James and Starosvetsky (2013) proved that the DpS equation has breathers around a site and around a bond for every
exponent $\alpha > 1$ of the contact force, and that they become Gaussian as $\alpha \to 1$. Which one is stable? We
compute both from $\alpha = 1.1$ to 4 (secB/exponents.hpp). A breather $u_ne^{i\mu t}$ is unstable if the second
eigenvalue $m_2$ of the matrix of section 3.3 exceeds $\mu/\alpha$. At every exponent that we computed the one around a
bond is spectrally stable and the one around a site is not, with a margin $m_2/\mu-1/\alpha$ that grows from
[2.63e-28](num:secB_other_numbers.margin_site_110) over [4.85e-6](num:secB_other_numbers.margin_site_150) for spheres to
[0.0955](num:secB_other_numbers.margin_site_400). The sign of so small a margin is trusted because quadruple precision
and fifty digits agree on it. At all of these exponents each margin has the same sign, and so has the difference of the
norms; we do not know what happens between them. Anharmonic wells exchange stability in the chain; in the limit of small
amplitude the exponent of the contact, as far as we computed, does not.

![Which static DpS breather is stable, and by how much, against the exponent of the contact.](fig:x35)

As $\alpha \to 1$ the profile becomes wide, and a sum over the sites depends on where its centre is only through the
Fourier component $e^{2\pi ix}$ of the profile: so the two become alike like $e^{-c/(\alpha-1)}$. The Gaussian's width
alone would give $c = \pi^2/2$; the profile farther out gives [6.49](num:secB_other_numbers.alike_expected), by the
argument of secB/exponents.hpp. Between $\alpha = 1.1$ and 1.12 the logarithm of the norms' difference falls by
[6.45](num:secB_other_numbers.alike_rate) for each unit of $1/(\alpha-1)$, and between 1.2 and 1.3 by
[6.43](num:secB_other_numbers.alike_rate_far): the rate approaches $c$ slowly, as a power in front would make it do, and
both are far from $\pi^2/2$. */
void report_exponents(Report& report) {
  std::vector<double> alphas{1.3, 1.5, 2, 3, 4};
  if (!report.quick)
    alphas = {1.1, 1.12, 1.16, 1.2,  1.25, 1.3,  1.4, 1.5,  1.6, 1.8,
              2,   2.25, 2.5,  2.75, 3,    3.25, 3.5, 3.75, 4};
  const std::vector<OfExponent> rows = scan_exponents(alphas);
  Table& table = report.table("exponents");
  for (const OfExponent& row : rows)
    table.add({{"alpha", "exponent of the contact force", row.alpha},
               {"norm_difference", "N_bond / N_site - 1", row.norm_difference},
               {"margin_site", "m_2 / mu - 1 / alpha around a site, unstable if positive",
                row.site.margin},
               {"margin_bond", "m_2 / mu - 1 / alpha around a bond, unstable if positive",
                row.bond.margin},
               {"rate_site", "growth rate divided by mu around a site", row.site.rate},
               {"rate_bond", "frequency of the translational pair divided by mu around a bond",
                row.bond.rate}});

  const auto at = [&](double alpha) {
    return *std::find_if(rows.begin(), rows.end(),
                         [&](const OfExponent& row) { return row.alpha == alpha; });
  };
  report.facts.add("margin_site_150", at(1.5).site.margin);
  report.facts.add("margin_site_400", at(4).site.margin);
  if (report.quick) return;
  report.facts.add("margin_site_110", at(1.1).site.margin);

  // How fast both become alike, and how fast they should
  const auto rate = [&](double a, double b) {
    const Estimate one = at(a).norm_difference, two = at(b).norm_difference,
                   apart = quotient(two, one);
    const double run = 1 / (a - 1) - 1 / (b - 1);
    return Estimate{std::log(apart.value) / run, apart.error / apart.value / run};
  };
  report.facts.add("alike_rate", rate(1.1, 1.12));
  report.facts.add("alike_rate_far", rate(1.2, 1.3));
  report.facts.add("alike_expected", pinning_exponent());
}

/**
## Differences and limits

For $C_1$ and the mass ratios, whose sources we could not read, we compare what we remember and give no verdict; a
number behind a paywall may be misremembered. Some of the values that we read have only two digits, and a run of another
program contains the errors of its own step and sampling. An agreement of printed digits says that two computations
solve the same equations, not that a chain of real balls does. The stability of the last section is that of the DpS
equation, the limit of small amplitudes, at the exponents computed and not between them; of the chain itself we know
only what other chapters compute. */
void reproduce(Report& report) {
  report_pulse(report);
  report_fragments(report);
  report_dimers(report);
  report_alternating(report);
  report_exponents(report);
}

/**
## Try it

1. *Easy.* A harder impact makes a faster pulse: by how much?
   `build/bin/sec34_impact run --well none --velocity 2` gives `speed` = 0.965491.
   Hint: divide by $2^{1/5}$ and compare with another velocity.
2. *Easy.* Which fraction of the energy does the pulse take along?
   `build/bin/sec34_impact run --well none` gives `packet_energy_fraction` = 0.9936610.
   Hint: try another velocity. Why can it not matter, and where is the rest?
3. *Harder.* Does the exponent alone exchange the two breathers in the chain, beyond the limit of small amplitude?
   `build/bin/sec32_barrier barrier --contact power --alpha 2` gives `equal_area` = 3.55070e-8, and
   `build/bin/sec32_barrier barrier --contact power --alpha 2 --omega 1.05` gives `equal_area` = -9.12675e-11.
   Hint: the sign at small $\omega_b-1$ is that of the DpS equation. Find the frequency at which the barrier vanishes.
4. *Open.* Along which curve of exponent and frequency does that barrier vanish?
5. *Open.* From which run did Sen and Manciu take their $C_1$? */
int main(int argc, char** argv) {
  return run({"secB_other_numbers", "B", "Numbers of other authors (appendix)", reproduce}, argc,
             argv);
}
