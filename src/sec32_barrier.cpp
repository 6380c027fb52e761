/**
# 3.2 The Peierls-Nabarro barrier between two breathers

A breather that sits on a site can move to the next one only by way of a bond. As a function of the place of its
centre, its energy is the *Peierls-Nabarro potential*, of which the breathers around a site and around a bond are the
extrema, and their difference is the *barrier* $E_{PN} = E_{\rm site}-E_{\rm bond}$. Which of the two is the place of rest
depends on the effective mass: with a positive one a breather rests where the potential is low. That of the breathers of
section 3.3 is negative (`sec33_mobility`): they rest where the potential is high.

Section 3.2 of James, Kevrekidis and Cuevas (Physica D 251, 2013) finds that this potential is astonishingly flat:
$E_{PN} = 1.77\cdot10^{-11}$ at the frequency $\omega_b = 1.1$ in the linear well, and $10^{-14}$ to $10^{-15}$ near
$\omega_b = 1.01$ for each well; close to $10^{-4}$ at $\omega_b = 1.5$ for the anharmonicity $s = -1/6$. It says that the
barrier is by three to four orders smaller in the linear well than in the others at $\omega_b = 1.3$; that it increases
with the amplitude of the breather but remains very small; and that relative to the energy it is smallest in the linear
well. It does not say whether the last two statements are meant of the curves as a whole or of every frequency.

The article compares the two breathers at equal frequency; the comparison at equal *area* (defined below), which is the
one that a moving breather makes, it leaves for its numerical difficulties. This program does both, with signs, and
draws figure 07.

![Energy barrier between both families, for three wells.](fig:07) */

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "commands/one_barrier.hpp"
#include "lattice/numerics/parallel.hpp"
#include "lattice/orbits/breather.hpp"
#include "lattice/orbits/breather_pairs.hpp"
#include "report/program.hpp"
#include "sec3/branches.hpp"

using namespace lattice;

/**
## Model

The breathers are those of the previous chapter, periodic motions of frequency $\omega_b$ in the chain
of Eqs. (6) and (10) with $s = -1/6$, $0$ and $1$, called the soft, the linear and the hard well. Of
each we need the energy $\mathcal H$ and the area
$$\mathcal A = \int_0^{2\pi/\omega_b}\sum_n\dot y_n^2\,dt .$$
Why the area? A breather that drifts slowly along the chain keeps its action, not its frequency, and an
effective Hamiltonian for its position compares states of equal action; $\mathcal A$ is $2\pi$ times
that action. */
constexpr std::array<double, 3> wells{-1.0 / 6, 0, 1};
const std::array<std::string, 3> names{"soft", "linear", "hard"};

/// The modulus of a barrier, as the article has it.
Estimate size(const Estimate& e) {
  return {std::abs(e.value), e.error};
}

/**
## Method

The two energies agree to six digits and more, so each must be known to twelve if the barrier is to have six. Along a
family of periodic orbits $d\mathcal H = \omega_b\,d\mathcal A/2\pi$. We change the frequency of the site-centred
breather until the areas agree to first order, and convert what is left of their difference into energy; what we neglect
is of third order (breather.hpp). Every barrier is computed at two tolerances, and the change from one to the other is
its error. Where this error exceeds three parts in a thousand, we repeat the computation with 64-bit mantissas. The two
breathers of one frequency are called a *pair*. */
/// The pairs of each well.
std::vector<BreatherPairs> pairs_in_wells(int count) {
  std::vector<BreatherPairs> families;
  for (double s : wells)
    families.push_back(breather_pairs_at(s, pair_frequencies(s, count), measure));
  return families;
}

/**
Between neighbouring pairs of opposite sign a barrier vanishes, at equal frequency or at equal area. */
struct Zero {
  std::size_t well;
  Estimate BreatherPair::*gap;
  const BreatherPair *left, *right;
  Estimate omega{};
};

std::vector<Zero> find_zeros(const std::vector<BreatherPairs>& families) {
  std::vector<Zero> zeros;
  for (std::size_t w = 0; w < families.size(); ++w)
    for (std::size_t k = 1; k < families[w].size(); ++k)
      for (auto gap : {&BreatherPair::equal_frequency, &BreatherPair::equal_area}) {
        const BreatherPair &a = families[w][k - 1], &b = families[w][k];
        if ((a.*gap).value * (b.*gap).value < 0) zeros.push_back({w, gap, &a, &b});
      }
  parallel_for("zeros", zeros.size(), [&](std::size_t i) {
    zeros[i].omega = frequency_of_zero(*zeros[i].left, *zeros[i].right, zeros[i].gap);
  });
  return zeros;
}

/**
## The barrier against frequency (figure 07)

The logarithmic scale of the figure hides what matters most: both barriers change their signs, and each of the dips
is a zero. The table therefore keeps the signs. [](finding:barrier.signs) In the linear well the first zero is at
[1.01462](num:sec32_barrier.zero_linear1) and the fifth at [1.29969](num:sec32_barrier.zero_linear5): the article's
barrier at $1.3$ is small because of that zero.

Why does it vanish at all? Along a family, $\mathcal L = \mathcal H-\omega_b\mathcal A/2\pi$ has the derivative
$-\mathcal A/2\pi$, so that $\mathcal H = \mathcal L-\omega_b\,d\mathcal L/d\omega_b$. Between the two breathers of one
frequency $\mathcal L$ differs by the barrier at equal area, $\tilde E_{PN}$, up to terms of second order in the
difference of the areas. Hence
$$E_{PN} \simeq -\omega_b^2\,\frac{d}{d\omega_b}\,\frac{\tilde E_{PN}}{\omega_b} .$$
So the barrier at equal frequency vanishes, to this order, where $\tilde E_{PN}/\omega_b$ has an extremum: at least once between any two
zeros of $\tilde E_{PN}$, and once before the first, because $\tilde E_{PN}\to0$ for $\omega_b\to1$. In the table
`sign_changes` the zeros of the two do alternate, in all three wells. Why $\tilde E_{PN}$ changes its own sign, that is,
why the potential of the centre turns upside down, so often in the soft well and only once in the hard one, we do not
know. */
void report_barriers(Report& report, const std::vector<BreatherPairs>& families) {
  // Pair by pair
  Table& table = report.table(
      "barriers", {number("s", "anharmonicity of the well"), number("omega", "frequency"),
                   estimate("energy_bond", "energy, bond-centred"),
                   estimate("equal_frequency", "E_site - E_bond at equal frequency"),
                   estimate("equal_area", "E_site - E_bond at equal area"),
                   number("size_frequency", "modulus of equal_frequency"),
                   number("size_area", "modulus of equal_area"),
                   number("relative", "size_frequency over energy_bond"),
                   count("wide", "1 where a 64-bit mantissa was needed")});
  for (const BreatherPairs& pairs : families)
    for (const BreatherPair& r : pairs)
      table.add({r.s, r.omega, r.energy[1], r.equal_frequency, r.equal_area,
                 std::abs(r.equal_frequency.value), std::abs(r.equal_area.value),
                 std::abs(r.equal_frequency.value) / r.energy[1].value, r.wide});
  if (report.quick) return;

  // The zeros; those at equal frequency also well by well
  Table& changes = report.table(
      "sign_changes", {number("s", "anharmonicity of the well"),
                       count("kind", "1 at equal frequency, 2 at equal area"),
                       estimate("omega", "where the barrier changes its sign", "", "its error")});
  std::array<std::vector<Estimate>, 3> found;
  for (const Zero& z : find_zeros(families)) {
    const bool frequency = z.gap == &BreatherPair::equal_frequency;
    changes.add({wells[z.well], frequency ? 1 : 2, z.omega});
    if (frequency) found[z.well].push_back(z.omega);
  }
  for (std::size_t w = 0; w < wells.size(); ++w)
    report.facts.add("zeros_" + names[w], exact(double(found[w].size())), "at equal frequency");
  const auto& [soft, linear, hard] = found;
  report.facts.add("zero_soft14", soft.at(13));
  report.facts.add("zero_linear1", linear.at(0));
  report.facts.add("zero_linear5", linear.at(4));
  report.facts.add("zero_hard1", hard.at(0));
  report.facts.add("zero_distance_130", {std::abs(linear[4].value - 1.3), linear[4].error});
}

/**
Does $E_{PN}$ increase with the amplitude, as the article says? The amplitude increases with the frequency. The modulus
of the barrier does not increase everywhere, since it falls to nothing at each zero, but it does on the whole
(`pn.grows`): in all three wells each arch between two zeros is higher than the one before, and the largest barrier is
the last one.

Whether the barrier remains very small depends on the well, and on where one stops. At the upper ends of the curves it
is [0.000120789](num:sec32_barrier.end_barrier_soft) in the soft well,
[2.15053e-6](num:sec32_barrier.end_barrier_linear) in the linear one and [1.02025](num:sec32_barrier.end_barrier_hard)
in the hard one; in units of the energy the largest of all is [0.178214](num:pn.remains_small). At the lower ends all
are near [4.36384e-16](num:sec32_barrier.start_barrier_linear). So it remains very small in the soft and in the linear
well, and in the hard one it does not, if its branch is followed this far. */
void report_growth(Report& report, const std::vector<BreatherPairs>& families) {
  Estimate amplitudes{HUGE_VAL}, arches{HUGE_VAL}, end_over_before{HUGE_VAL}, largest{};
  for (std::size_t w = 0; w < families.size(); ++w) {
    std::vector<Estimate> amplitude, barrier;
    for (const BreatherPair& r : families[w]) {
      amplitude.push_back(r.amplitude[1]);
      barrier.push_back(r.equal_frequency);
      largest = larger(largest, size(quotient(r.equal_frequency, r.energy[1])));
    }
    const Arches here(barrier);
    amplitudes = smaller(amplitudes, least_ratio(amplitude));
    arches = smaller(arches, here.growth);
    end_over_before = smaller(end_over_before, here.end_over_before);
    report.facts.add("end_barrier_" + names[w], size(barrier.back()));
  }
  report.facts.add("start_barrier_linear", size(families[1].front().equal_frequency));
  report.facts.add("amplitude_least_growth", amplitudes);
  report.facts.add("arches_least_growth", arches);
  report.facts.add("end_over_highest_before", end_over_before);
  report.facts.add("largest_relative", largest, "relative");
}

/**
Is the linear well's barrier the smallest in units of the energy? The article says so after its comparison at $1.3$, of
a figure that shows the whole curves. The means of barrier over energy at the [55](num:sec32_barrier.frequencies_shared)
frequencies that all three wells share are [5e-8](num:sec32_barrier.relative_mean_linear) in the linear well,
[2.3e-7](num:sec32_barrier.relative_mean_soft) in the soft one and [0.0151](num:sec32_barrier.relative_mean_hard) in the
hard one (`pn.ratio_smallest`); at $1.3$ and at the upper ends of the curves it is the smallest, too. Frequency by
frequency, which is more than the sentence says, the linear well has the smallest ratio at
[50](num:sec32_barrier.linear_smallest_at) of these frequencies, and at the others at most
[1.33055](num:sec32_barrier.linear_over_soft_most) times that of the soft well. This bound holds at the frequencies of
the table only: in between, next to each zero of the soft barrier, up to the one at
[1.89803](num:sec32_barrier.zero_soft14), the ratio of the soft well is smaller by any factor. Towards $\omega_b=1$ the
three agree. */
/// Barriers in units of the energy, at the frequencies that all wells have in common.
std::vector<std::vector<Estimate>> shared_ratios(const std::vector<BreatherPairs>& families) {
  std::vector<std::vector<Estimate>> out(families.size());
  for (const BreatherPair& here : families[1]) {
    std::vector<Estimate> ratios;
    for (const BreatherPairs& pairs : families)
      for (const BreatherPair& r : pairs)
        if (std::abs(r.omega - here.omega) < 1e-9)
          ratios.push_back(size(quotient(r.equal_frequency, r.energy[1])));
    if (ratios.size() == families.size())
      for (std::size_t w = 0; w < ratios.size(); ++w) out[w].push_back(ratios[w]);
  }
  return out;
}

void report_ratios(Report& report, const std::vector<BreatherPairs>& families) {
  const auto ratios = shared_ratios(families);
  for (std::size_t w = 0; w < ratios.size(); ++w)
    report.facts.add("relative_mean_" + names[w], mean_size(ratios[w]));

  // Frequency by frequency
  int least = 0;
  Estimate over_soft{};
  for (std::size_t k = 0; k < ratios[1].size(); ++k) {
    const Estimate &soft = ratios[0][k], &linear = ratios[1][k], &hard = ratios[2][k];
    least += linear.value < soft.value && linear.value < hard.value;
    over_soft = larger(over_soft, quotient(linear, soft));
  }
  report.facts.add("linear_smallest_at", exact(least), "frequencies");
  report.facts.add("frequencies_shared", exact(double(ratios[1].size())), "frequencies");
  report.facts.add("linear_over_soft_most", over_soft);
}

/**
## Five frequencies to all digits

The article speaks of single frequencies, so these pairs are computed in extended precision throughout. Close to
$\omega_b = 1$, with $\delta = \omega_b-1$, the amplitude goes like $\delta^2$ (Eq. (20)) and all energies follow the DpS
scaling $\mathcal H = e\,\delta^4$, with an $e$ that differs slightly from one breather to the other. Then
$d\mathcal H = \omega_b\,d\mathcal A/2\pi$ gives $\mathcal A/2\pi = e\,\delta^4-\frac45e\,\delta^5$, hence
$\mathcal H = \mathcal A/2\pi+\frac45e\,\delta^5$. At equal area $e\,\delta^4$ is the same for both breathers, and the
one with the larger $e$ has a $\delta$ that is smaller by a quarter of the relative difference: the barrier at equal
area is $-\delta/5$ times the one at equal frequency, smaller by orders of magnitude, and of the opposite sign. At
$\omega_b = 1.001$ the computed ratio divided by this prediction is [1.01843](num:sec32_barrier.equal_area_law). */
const std::pair<double, const char*> key_frequencies[] = {
    {1.001, "1001"}, {1.01, "101"}, {1.1, "110"}, {1.3, "130"}, {1.5, "150"}};

/// Both breathers of a frequency, from the pairs beside it where there are any.
BreatherPair key_pair(const BreatherPairs& pairs, double s, double omega) {
  const auto right = std::find_if(pairs.begin(), pairs.end(),
                                  [&](const BreatherPair& r) { return r.omega > omega; });
  if (right != pairs.begin() && right != pairs.end())
    return pair_between(*std::prev(right), *right, omega);
  BreatherPair pair{s, omega};
  for (int k : {0, 1}) pair.orbit[k] = find_breather(problem_of(both_centres[k], omega, s));
  return pair;
}

BreatherPairs key_pairs(const std::vector<BreatherPairs>& families, bool quick) {
  const std::size_t count = std::size(key_frequencies);
  BreatherPairs pairs(std::size(wells) * count);
  parallel_for(pairs.size(), [&](std::size_t i) {
    const std::size_t w = i / count;
    pairs[i] = key_pair(families[w], wells[w], key_frequencies[i % count].first);
    quick ? measure_in<double>(pairs[i]) : measure_in<Wide>(pairs[i]);
  });
  return pairs;
}

/**
These pairs are those of the article's numbers. At $1.1$ in the linear well it prints $1.77\cdot10^{-11}$, and we
find [1.62422e-11](num:pn.omega11). At $1.5$ in the soft well we find
[7.57142e-8](num:pn.omega15) instead of $10^{-4}$; neither the equal area,
[7.43890e-10](num:sec32_barrier.equal_area_soft_150), nor the unit of the energy brings it nearer. The hard well has
[-8.64349e-5](num:sec32_barrier.equal_frequency_hard_150) there, and the printed value probably belongs to it.

At $1.3$ the soft barrier is [857.526](num:pn.harmonic_ratio) times the linear one, and the hard barrier is
[24934.6](num:sec32_barrier.harmonic_ratio_hard) times the linear one: three to four orders, as printed. But this says
little, since $1.3$ is only [0.000307365](num:sec32_barrier.zero_distance_130) away from a zero of the linear barrier, at
which the ratio is infinite. At the neighbouring pairs of the table, a sixtieth below and above, the soft barrier is
[10.684](num:sec32_barrier.harmonic_ratio_below) and [21.270](num:sec32_barrier.harmonic_ratio_above) times the linear
one. */
void report_key(Report& report, const BreatherPairs& pairs) {
  // Both barriers, well by well
  const std::size_t count = std::size(key_frequencies);
  const auto pair = [&](std::size_t w, std::size_t k) { return pairs[w * count + k]; };
  for (std::size_t w = 0; w < wells.size(); ++w)
    for (std::size_t k = 1; k < count; ++k) {
      const std::string name = "_" + names[w] + "_" + key_frequencies[k].second;
      report.facts.add("equal_frequency" + name, pair(w, k).equal_frequency);
      report.facts.add("equal_area" + name, pair(w, k).equal_area);
    }
  for (std::size_t k : {0U, 1U})
    report.facts.add(k ? "energy_110_bond" : "energy_110_site", pair(1, 2).energy[k]);

  // Near the linear limit the ratio of the two is predicted
  const BreatherPair limit = pair(1, 0);
  const Estimate law = quotient(limit.equal_area, limit.equal_frequency);
  const double size_of_law = (limit.omega - 1) / 5;
  report.facts.add("equal_area_law", {law.value / -size_of_law, law.error / size_of_law});

  // How much smaller than the others is the linear well's barrier at 1.3?
  for (std::size_t w : {0U, 2U})
    report.facts.add("harmonic_ratio_" + names[w],
                     quotient(size(pair(w, 3).equal_frequency), size(pair(1, 3).equal_frequency)));
}

/// How many times larger the soft barrier is than the linear one, at the pairs on either side of 1.3.
void report_beside(Report& report, const std::vector<BreatherPairs>& families) {
  const auto near = [](const BreatherPairs& pairs, double omega) {
    return size(std::find_if(pairs.begin(), pairs.end(), [&](const BreatherPair& r) {
                  return std::abs(r.omega - omega) < 1e-9;
                })->equal_frequency);
  };
  for (const auto& [name, omega] : {std::pair{"harmonic_ratio_below", 1.3 - 1.0 / 60},
                                    {"harmonic_ratio_above", 1.3 + 1.0 / 60}})
    report.facts.add(name, quotient(near(families[0], omega), near(families[1], omega)));
}

/**
## The end of the soft branches

How far do the branches go? In the soft well the families do not reach $\omega_b = 2$: they turn back at a
fold, where the stiffening contacts and the softening well balance, at
[1.91163](num:sec32_barrier.fold_soft_site) (site) and [1.91172](num:sec32_barrier.fold_soft_bond) (bond).
Two runs with different step lengths locate each. */
void report_folds(Report& report, const BreatherPair& last) {
  const auto fold = [&](Centre centre, const Orbit<double>& orbit) {
    return fold_of(problem_of(centre, last.omega, last.s), orbit);
  };
  report.facts.add("fold_soft_site", fold(Centre::site, last.orbit[0]));
  report.facts.add("fold_soft_bond", fold(Centre::bond, last.orbit[1]));
}

/**
## How accurate the printed 1.77e-11 is

The article prints its own accuracy: for one breather Newton's method left a residual of $1.5\cdot10^{-9}$. By how
much may the energy be wrong then? An exact breather of a slightly different frequency, $\omega_b+\delta\omega$, leaves
such a residual, too, because its phase is wrong at $T_b$, and its energy is wrong by $\mathcal H'(\omega_b)\,\delta\omega$.
A residual of the printed size corresponds to an energy of
[1.59887e-12](num:sec32_barrier.hidden_energy) for one breather, and the printed barrier exceeds ours by
[1.45775e-12](num:sec32_barrier.printed_excess). So the two agree within the accuracy of the article, and ours is the
more accurate value. */
void report_printed(Report& report, const Estimate& barrier) {
  report.facts.add("hidden_energy",
                   compare(hidden_energy(1.5e-9, 2e-6), hidden_energy(1.5e-9, 1e-6)));
  report.facts.add("printed_excess", Estimate{1.77e-11 - barrier.value, barrier.error});
}

/**
## What goes beyond the article

Neither barrier has a fixed sign. Where the one at equal area vanishes, the two breathers exchange their stability: in
the linear well the site-centred and the bond-centred breather do so at six close pairs of frequencies, and between the
two of each pair lies a zero of this barrier (`sec33_between`; those of the first pair cannot be told apart).
[](finding:barrier.equal_area) At $1.1$ the bond is the stable centre although at equal area its energy is the higher
one, because the effective mass is negative (`sec33_mobility`). Near a zero of the barrier at equal frequency the one at
equal area is not the smaller one: at $1.3$ it is [-5.22284e-12](num:sec32_barrier.equal_area_linear_130) against
[-4.89194e-12](num:sec32_barrier.equal_frequency_linear_130).

## Differences and limits

The article does not say how far in frequency its soft and hard branches go. Ours end at $\omega_b = 2$,
those of the soft well at $1.9$, just before their folds, which we locate but do not pass. The barrier says
nothing about the potential between the two breathers, which may have further extrema: `sec33_between` looks for
breathers without symmetry there. */
void reproduce(Report& report) {
  report.output.note("tolerance", "flow to 128 and 2048 roundings of the type");
  const auto families = pairs_in_wells(report.quick ? 10 : 60);
  report_barriers(report, families);
  report_growth(report, families);
  report_ratios(report, families);
  const BreatherPairs key = key_pairs(families, report.quick);
  report_key(report, key);
  report_folds(report, families[0].back());
  if (report.quick) return;
  report_beside(report, families);
  report_printed(report, key[std::size(key_frequencies) + 2].equal_frequency);
}

/**
## Try it

1. *Easy.* A pendulum instead of the soft well: `build/bin/sec32_barrier barrier --omega 1.1 --well pendulum` gives
   `equal_frequency` = 3.59543777e-11, nearly the barrier of the soft well at this frequency.
   Hint: $1-\cos y = \frac12y^2-\frac1{24}y^4+\dots$, and the amplitude of the breather is a hundredth.
2. *Easy.* Next to a zero: `build/bin/sec32_barrier barrier --omega 1.01462` gives `equal_area` = -1.86531e-17, some two
   hundred times the modulus of `equal_frequency`. Which of the two decides where the breather rests?
   Hint: a breather that moves keeps its action. Its potential does not vanish here.
3. *Harder.* Contacts whose force grows with the square of the overlap:
   `build/bin/sec32_barrier barrier --omega 1.001 --contact power --alpha 2` gives `equal_area` = -1.994595e-13. Divide it by
   `equal_frequency`: what becomes of the factor $-\delta/5$?
   Hint: with the exponent $\alpha$ the DpS scaling is $\mathcal H = e\,\delta^p$, $p = 2/(\alpha-1)$; repeat the
   derivation with this $p$.
4. *Open.* Follow the soft branch through its fold up to the maximum of the well's potential.
5. *Open.* Other exponents of the contact: is there one, between those of `secB_other_numbers`, for which the barrier
   vanishes altogether?

## With your own parameters

`sec32_barrier barrier` prints both barriers with your own parameters (one_barrier.hpp). */
int main(int argc, char** argv) {
  return run({"sec32_barrier", "3.2", "The barrier between two breathers (section 3.2)", reproduce,
              commands<OneBarrier>()},
             argc, argv);
}
