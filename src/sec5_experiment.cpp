/**
# 5 What an experiment would see: damping

The conclusion of James, Kevrekidis and Cuevas (Physica D 251, 2013) wonders "if dissipation may overdamp the
dynamics and completely destroy the breathers". It expects that in 10 ms, the lifetime of breathers measured
by Boechler et al. (Phys. Rev. Lett. 104, 244302, 2010), the packet of an impact travels 20 sites and
oscillates 70 times, "provided this excitation persists in the presence of dissipation, with moderate changes
in velocity and frequency", and that static breathers die long before their weak instabilities are seen,
"as soon as $\epsilon < 0.015$".

We damp the array of section 3.6 and measure both.

![Ways, sights, decaying breathers and instabilities in a damped array.](fig:x26) */

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "lattice/numbers/parallel.hpp"
#include "report/program.hpp"
#include "sec5/array_units.hpp"
#include "sec5/decay.hpp"
#include "sec5/journey.hpp"

using namespace lattice;

/**
In short: damping of the beams is a clock that runs slower and slower. With an energy lifetime $\tau$ the
packet comes no farther than one without losses does in $4\tau$, its amplitude falls like $e^{-t/2\tau}$,
its speed like $e^{-t/4\tau}$, and its frequency tends to that of a beam. A law without free parameters
(journey.hpp) says so from a single run without losses, and the runs agree.

## Model

The array is that of Eq. (32) with equal beads, free ends and the losses of bench.hpp.

| symbol | program | meaning | unit |
|---|---|---|---|
| $V$ | `velocity` | impact velocity | m/s |
| $\tau = 1/\nu$ | `lifetime` | time in which a free oscillation of a beam loses its energy but for $1/e$ | ms |
| $\mathcal Q = \omega\tau$ | `quality` | quality factor of a beam | 1 |
| $e$ | `restitution` | of two cantilevers that collide at 1 m/s; it fixes $A$ of the contacts | 1 |
| $\sigma$, $\Lambda$ | `growth` | growth rate of the pinning pair, and its ratio to $\omega_b-1$ | 1/$\tau_c$ |

The article cites Carretero-González et al. (Phys. Rev. Lett. 102, 024102, 2009), who fit a power of the
relative velocity to pulses in chains without wells. We take the law of Kuwabara and Kono, which follows from
the viscosity of the material and has one constant, and fix it by the restitution that a drop test measures. */
constexpr double ten = 10;          // ms
constexpr std::size_t beams = 200;  // as in section 3.6
constexpr std::array<double, 2> steps{0.1, 0.05}, quick_steps{0.2, 0.1};

/**
## The packet after ten milliseconds

One run follows the packet contact by contact. Sites, oscillations, speed and period are measured as in
section 3.6, where the way without damping and that with a lifetime of 5 ms are found independently. */
Journey journey(double velocity, double lifetime, double contact, double ms, double step) {
  const ArrayUnits array;
  const Bench bench{Chain{beams}, {array.rate(lifetime), contact}};
  return follow_packet(bench, array.velocity(velocity), array.time(ms), beams - 1, step);
}

struct TwoJourneys {
  std::array<Journey, 2> runs;

  template <class Of>
  Estimate both(Of of) const {
    return compare(double(of(runs[0])), double(of(runs[1])));
  }
  Estimate of_way(double t, double Progressed::*what, double unit = 1) const {
    return both([&](const Journey& j) { return way_after(j, t).*what * unit; });
  }
};

TwoJourneys two_journeys(double velocity, double lifetime, double contact, double ms,
                         const std::array<double, 2>& h) {
  TwoJourneys out;
  for (std::size_t i : {0U, 1U}) out.runs[i] = journey(velocity, lifetime, contact, ms, h[i]);
  return out;
}

/**
The table compares with the law of the slow clock, for impacts of 0.5 to 1 m/s. Changes of speed and frequency
are those against the packet without losses at the same moment; a frequency is 1/period. */
Columns journey_columns() {
  return {number("velocity", "impact velocity", "m/s"),
          number("lifetime", "of the energy; 0: no damping", "ms"),
          estimate("sites", "travelled in 10 ms", "site"),
          number("sites_law", "the same from the slow clock", "site"),
          estimate("periods", "oscillations in 10 ms"),
          number("periods_law", "the same from the slow clock"),
          estimate("speed", "at 10 ms", "site/s", "difference of two resolutions; 0 at rest"),
          number("speed_law", "the same from the slow clock", "site/s"),
          estimate("frequency", "at 10 ms", "Hz"),
          number("frequency_law", "the same from the slow clock", "Hz"),
          number("ledger", "energy and losses against the energy at the start, relative")};
}

// Packets without losses first, with which the law of the slow clock begins
void report_journeys(Report& report) {
  const ArrayUnits array;
  const auto& h = report.quick ? quick_steps : steps;
  const double t10 = array.time(ten);
  const std::vector<double> velocities =
      report.quick ? std::vector{1.0} : std::vector{0.5, 0.7, 1.0};
  std::vector<TwoJourneys> free(velocities.size());
  parallel_for(free.size(),
               [&](std::size_t i) { free[i] = two_journeys(velocities[i], 0, 0, 13, h); });
  std::vector<std::array<double, 2>> points;
  for (std::size_t i = 0; i < velocities.size(); ++i)
    for (double life : {0.0, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0})
      points.push_back({double(i), life});
  Table& table = report.table("journeys", journey_columns());
  table.fill(points, [&](const std::array<double, 2>& p) {
    const auto i = std::size_t(p[0]);
    const TwoJourneys found = p[1] > 0 ? two_journeys(velocities[i], p[1], 0, 13, h) : free[i];
    const Progressed law = predicted_way(free[i].runs[1], array.rate(p[1]), t10);
    const auto hertz = [&](const Journey& j) {
      return array.per_second(1 / way_after(j, t10).period);
    };
    return Cells{velocities[i],
                 p[1],
                 found.of_way(t10, &Progressed::sites),
                 law.sites,
                 found.of_way(t10, &Progressed::oscillations),
                 law.oscillations,
                 found.of_way(t10, &Progressed::speed, array.per_second(1)),
                 array.per_second(law.speed),
                 found.both(hertz),
                 array.per_second(1 / law.period),
                 found.runs[1].ledger};
  });
}

/**
The facts hold the row of 1 m/s and 10 ms. Is the change of velocity *moderate*? After 10 ms the packet has
[0.833898](num:sec5_experiment.speed_share) of the speed of one without losses at the same moment; its
frequency differs by [0.01820](num:sec5_experiment.frequency_change). So yes, the packet would be seen:
[18.7717](num:sec5_experiment.sites_10ms) sites and [68.3171](num:sec5_experiment.periods_10ms) oscillations. */
void report_ten(Report& report) {
  const ArrayUnits array;
  const auto& h = report.quick ? quick_steps : steps;
  const double t10 = array.time(ten);
  std::array<TwoJourneys, 3> pairs;
  parallel_for(3, [&](std::size_t i) {
    pairs[i] = two_journeys(1, i == 0 ? 0 : i == 1 ? ten : ten / 2, 0, 13, h);
  });
  const auto &free = pairs[0], &found = pairs[1];
  const Estimate sites = found.of_way(t10, &Progressed::sites);
  const Estimate speed = found.of_way(t10, &Progressed::speed);
  const Estimate period = found.of_way(t10, &Progressed::period);
  report.facts.add("sites_10ms", sites, "sites");
  report.facts.add("sites_5ms", pairs[2].of_way(t10, &Progressed::sites), "sites");
  report.facts.add("periods_10ms", found.of_way(t10, &Progressed::oscillations));
  report.facts.add("speed_share", quotient(speed, free.of_way(t10, &Progressed::speed)));
  const Estimate slower = quotient(free.of_way(t10, &Progressed::period), period);
  report.facts.add("frequency_change", {1 - slower.value, slower.error});
  const double law = predicted_way(free.runs[1], array.rate(ten), t10).sites;
  report.facts.add("law_over_sites", {law / sites.value, sites.error / sites.value});
  report.facts.add("ledger_10ms", {found.runs[1].ledger, found.runs[0].ledger});
}

/**
## How far a sensor sees

A laser vibrometer resolves a velocity, and the packet is seen as far as the beads move faster. The chart holds
this place for three resolutions and lifetimes up to 20 ms, on 200 cantilevers; from 50 ms on the packet of
1 m/s reaches the end of the array. With a lifetime of 10 ms the best sensor sees
[81.2795](num:sec5_experiment.seen_best) sites and one a hundred times coarser
[47.3130](num:sec5_experiment.seen_coarse). A better sensor gains so little because the packet does not only fade: it
comes to a stop. */
constexpr std::array<double, 3> resolutions{1e-3, 1e-2, 1e-1};  // m/s

void report_sights(Report& report) {
  const ArrayUnits array;
  const auto& h = report.quick ? quick_steps : steps;
  const std::vector<double> lives =
      report.quick ? std::vector{1.0, 2.0} : std::vector{1.0, 2.0, 3.0, 5.0, 7.0, 10.0, 14.0, 20.0};
  std::vector<TwoJourneys> found(lives.size());
  Journey free;
  parallel_for(2 * lives.size() + 1, [&](std::size_t i) {
    // An amplitude falls by a factor of 500 in 12.5 lifetimes
    if (i == 2 * lives.size())
      free = journey(1, 0, 0, report.quick ? 10 : 85, h[1]);
    else
      found[i / 2].runs[i % 2] = journey(1, lives[i / 2], 0, 12.5 * lives[i / 2], h[i % 2]);
  });
  Table& table = report.table(
      "sights", {number("lifetime", "of the energy", "ms"),
                 number("resolution", "velocity that the sensor resolves", "m/s"),
                 estimate("seen", "place where the packet falls below the resolution", "site"),
                 number("seen_law", "the same from the slow clock", "site")});
  for (std::size_t i = 0; i < lives.size(); ++i)
    for (double r : resolutions) {
      const double v = array.velocity(r);
      const Estimate seen = found[i].both([&](const Journey& j) { return seen_until(j, v); });
      table.add({lives[i], r, seen, predicted_sight(free, array.rate(lives[i]), v)});
      if (lives[i] == ten && r == resolutions.front()) report.facts.add("seen_best", seen, "sites");
      if (lives[i] == ten && r == resolutions.back())
        report.facts.add("seen_coarse", seen, "sites");
    }
}

/**
## Losses in the contacts

Viscous contacts damp the packet while it moves and not a beam that swings alone. We give the restitution that two
cantilevers would show if they met at 1 m/s without their springs. With 0.9 and beams without losses the packet
covers [14.5719](num:sec5_experiment.sites_restitution_90) sites in 10 ms, fewer than with elastic contacts and a
lifetime of 5 ms, [17.0208](num:sec5_experiment.sites_5ms): whoever builds the array should look for beads with a
high restitution as much as for good clamps. */
void report_contacts(Report& report) {
  const ArrayUnits array;
  const auto& h = report.quick ? quick_steps : steps;
  const double t10 = array.time(ten);
  const std::vector<double> values =
      report.quick ? std::vector{0.9} : std::vector{0.98, 0.95, 0.9, 0.8};
  Table& table = report.table(
      "contacts",
      {number("restitution", "of two cantilevers at 1 m/s"),
       number("contact", "the time A of the contacts' law", "us"),
       estimate("sites", "travelled in 10 ms without damping of the beams", "site"),
       estimate("periods", "oscillations in 10 ms"), estimate("speed", "at 10 ms", "site/s"),
       number("ledger", "energy and losses against the energy at the start, relative")});
  Estimate quoted{};
  table.fill(values, [&](double e) {
    const double contact = contact_loss(e, array.velocity(1));
    const TwoJourneys found = two_journeys(1, 0, contact, 13, h);
    if (e == 0.9) quoted = found.of_way(t10, &Progressed::sites);
    return Cells{e,
                 array.milliseconds(contact) * 1e3,
                 found.of_way(t10, &Progressed::sites),
                 found.of_way(t10, &Progressed::oscillations),
                 found.of_way(t10, &Progressed::speed, array.per_second(1)),
                 found.runs[1].ledger};
  });
  report.facts.add("sites_restitution_90", quoted, "sites");
}

/**
## Static breathers that die

Both breathers of section 3.2 are let go at $\omega_b = 1.1$ in a damped chain with linear wells. They follow
their branch: at each moment the energy is that of the exact breather with the frequency of that moment, and
its area has decayed as friction prescribes (decay.hpp). They do not leave it, the differences being
[0.0006](num:sec5_experiment.off_the_branch_site) of the energy at most, and they do not move: the centre of the
energy, which counts a contact for the bead before it, shifts by [0.01188](num:sec5_experiment.drift_site) sites. */
constexpr double released_at = 1.1;

struct Released {
  Orbit<double> orbit;
  Chain chain;

  explicit Released(Centre centre) : orbit(breather_at(centre, released_at)) {
    chain = breather_problem<double>(centre, released_at, 0.0, orbit.start.y.size()).chain;
  }
  Decay decay(double nu, double lifetimes, double step) const {
    return let_decay(orbit, chain, nu, lifetimes / nu, step);
  }
};

void report_decay(Report& report) {
  const ArrayUnits array;
  const double nu = array.rate(ten);
  const auto& h = report.quick ? quick_steps : steps;
  Table& table = report.table(
      "decay", {count("bond", "1 around a bond, 0 around a site"), number("t", "time", "ms"),
                estimate("frequency", "of the decaying breather, over that of a beam"),
                estimate("energy", "mean over a period", "J"),
                number("energy_branch", "of the exact breather with this frequency", "J"),
                number("area_law", "area of that breather over what friction prescribes")});

  // At five moments of its decay a breather is compared with the exact one of its frequency
  std::array<double, 2> worst{};
  std::array<Estimate, 2> drift;
  for (Centre centre : {Centre::site, Centre::bond}) {
    const Released from(centre);
    std::array<Decay, 2> runs;
    parallel_for(2, [&](std::size_t i) { runs[i] = from.decay(nu, 2, h[i]); });
    const bool bond = centre == Centre::bond;
    const double unit = array.scales.unit_energy();
    for (double share : {0.02, 0.25, 0.5, 0.75, 0.98}) {
      const auto at = [&](const Decay& d) {
        return d.moments[std::size_t(share * double(d.moments.size()))];
      };
      const DecayMoment coarse = at(runs[0]), fine = at(runs[1]);
      const auto same = breather_at(centre, fine.omega);
      table.add({bond, array.milliseconds(fine.t), compare(coarse.omega, fine.omega),
                 compare(coarse.energy * unit, fine.energy * unit), same.energy * unit,
                 same.area / (from.orbit.area * std::exp(-nu * fine.t))});
      worst[bond] = std::max(worst[bond], std::abs(fine.energy / same.energy - 1));
    }
    drift[bond] = compare(runs[0].drift, runs[1].drift);
  }
  for (bool bond : {false, true}) {
    const std::string name = bond ? "_bond" : "_site";
    report.facts.add("off_the_branch" + name, {worst[bond], worst[bond]});
    report.facts.add("drift" + name, drift[bond], "sites");
  }
}

/**
## When would the instability show?

The article compares one growth rate with one lifetime: an instability is hidden if $1+\epsilon$ does not grow
by a factor of $e$ in 10 ms, that is for $\epsilon < 0.015$ (`outlook.dominated`). With the printed period of 0.15 ms
$(1+\epsilon)^{10/0.15} = e$ gives [0.0151131](num:outlook.dominated), with $2\pi\tau_c$
[0.0159718](num:sec5_experiment.epsilon_e_fold). */
void report_bound(Report& report) {
  const double linear_period = ArrayUnits{}.milliseconds(2 * std::numbers::pi);
  report.results.add("outlook.dominated", exact(std::expm1(0.15 / ten)));
  report.facts.add("epsilon_e_fold", exact(std::expm1(linear_period / ten)));
}

/**
But a breather that loses energy moves along its branch, and its instability with it (decay.hpp). If the growth rate were proportional to $\omega_b-1$, as in the
DpS limit, it would have four lifetimes, and the bound would be
[0.00360776](num:sec5_experiment.epsilon_hidden_dps). In the chain the breather around a site passes stretches on
which it is stable, and the bound becomes [0.00557](num:sec5_experiment.epsilon_hidden). Both are far above the
$10^{-3}$ that the article gives for the instabilities of its section 3.3, so that for this breather, in linear wells
and with $\omega_b=1.1$ at the start, the conclusion stands. We have not damped others; in hard wells instabilities
are much larger (sec33_between.cpp). Turned round, with the multipliers of section 3.3, an
$e$-fold growth needs the quality factor [1.132e4](num:sec5_experiment.quality_e), a lifetime of
[259.5](num:sec5_experiment.lifetime_e) ms, if the breather starts at $\omega_b = 1.1$. A deviation of one per
cent of a site becomes half a site in a chain with [1195](num:sec5_experiment.lifetime_seen) ms: it has to
grow by a factor of 100, because half of a shift belongs to the decaying direction.

The members of the branch are equidistant in $\ln(\omega_b-1)$, from 1.01 on, so that one of them is at 1.1; the
coarse integral takes every second one and begins higher. The table begins at 1.087, where the two agree to
one per cent; from there down to 1.018 the breather is stable. */
constexpr std::size_t per_decade = 32;

std::vector<Member> branch_members(std::size_t count, std::size_t each) {
  std::vector<Member> out(count);
  parallel_for("breathers", count, [&](std::size_t k) {
    const double part = double(k * each) / double(per_decade);
    out[k] = member_at(Centre::site, 1 + 0.01 * std::pow(10, part), 0);
  });
  return out;
}

void report_instability(Report& report) {
  const ArrayUnits array;
  const std::size_t each = report.quick ? 4 : 1;
  const double limit = dps_growth(Centre::site);
  const auto members = branch_members(40 / each + 1, each);
  Table& table = report.table(
      "instability", {number("omega", "frequency at the start, over that of a beam"),
                      number("epsilon", "unstable Floquet multiplier minus one; 0: stable"),
                      number("scaled_growth", "growth rate over omega - 1"),
                      estimate("quality_e", "quality factor for an e-fold growth before the end"),
                      estimate("lifetime_e", "the lifetime that belongs to it", "ms")});
  for (std::size_t k = report.quick ? 8 : 30; k < members.size(); k += 2) {
    // The fine integral, and one from every second member
    const std::vector<Member> fine(members.begin(), members.begin() + std::ptrdiff_t(k) + 1);
    std::vector<Member> coarse;
    for (std::size_t i = 2; i <= k; i += 2) coarse.push_back(members[i]);
    const Estimate rate = compare(growth_times_rate(coarse, limit), growth_times_rate(fine, limit));
    const Member& start = members[k];
    const Estimate life = quotient(exact(array.milliseconds(1)), rate);
    const Estimate quality = quotient(exact(start.omega), rate);
    table.add(
        {start.omega, start.multiplier() - 1, start.growth / (start.omega - 1), quality, life});
    if (std::abs(start.omega - released_at) > 1e-9) continue;

    // What ten milliseconds hide: the multiplier that grows e-fold, in the chain and in the DpS limit
    const double nu = array.rate(ten), turn = 2 * std::numbers::pi / start.omega;
    const Member loose = member_at(Centre::site, start.omega, 0, false);
    const Estimate share = quotient(exact(start.growth * nu * turn), rate);
    report.facts.add("epsilon", compare(loose.multiplier() - 1, start.multiplier() - 1));
    report.facts.add("epsilon_hidden",
                     {std::expm1(share.value), share.error * std::exp(share.value)});
    report.facts.add("epsilon_hidden_dps", exact(std::expm1(nu * turn / 4)));
    report.facts.add("quality_e", quality);
    report.facts.add("lifetime_e", life, "ms");
    report.facts.add("lifetime_seen", {life.value * std::log(100), life.error * std::log(100)},
                     "ms");
  }
}

/**
## One packet with your own damping

`sec5_experiment damped --velocity 1 --lifetime 10` measures one packet; `--restitution 0.9` adds losses in
the contacts. */
struct DampedArray {
  static constexpr Title title{"damped", "the packet of an impact on a damped array, after 10 ms"};
  double velocity = 1, lifetime = 10, restitution = 1;

  void parameters(Parameters& p) {
    p.add("velocity", velocity, "impact velocity in m/s", {0.1, 2, "m/s"});
    p.add("lifetime", lifetime, "of the energy of a beam that swings freely, in ms",
          {0.5, 1e6, "ms"});
    p.add("restitution", restitution, "of two cantilevers that meet at 1 m/s", {0.5, 1});
  }
  Table table() const {
    const ArrayUnits array;
    const double t10 = array.time(ten), contact = contact_loss(restitution, array.velocity(1));
    const TwoJourneys found = two_journeys(velocity, lifetime, contact, 16, {0.05, 0.025});
    const double per_second = array.per_second(1);
    Answers q;
    q.add("sites_10ms", found.of_way(t10, &Progressed::sites), "sites",
          "way of the packet from the first contact in the 10 ms after the impact");
    q.add("periods_10ms", found.of_way(t10, &Progressed::oscillations), "",
          "oscillations of the packet on this way");
    q.add_small("speed", found.of_way(t10, &Progressed::speed, per_second), "sites/s",
                "speed of the packet after 10 ms, over its last five sites; 0 if it has stopped");
    q.add("period", found.of_way(t10, &Progressed::period, array.milliseconds(1)), "ms",
          "period of the packet's oscillation after 10 ms");
    q.add_small(
        "ledger", found.both([](const Journey& j) { return j.ledger; }), "",
        "energy and losses less the energy of the impact, relative to it: zero but for errors");
    q.add("slowest_clock", exact(array.milliseconds(slow_clock(array.rate(lifetime), t10))), "ms",
          "what the slow clock shows after 10 ms: undamped beams would bring the packet as far in "
          "it");
    return q.table;
  }
};

/**
A full run follows the chapter. */
void reproduce(Report& report) {
  report_ten(report);
  report_journeys(report);
  report_sights(report);
  report_contacts(report);
  report_decay(report);
  report_bound(report);
  report_instability(report);
}

/**
## Checks, differences and limits

Energy and losses are booked in every step and stay constant to within
[5e-11](num:sec5_experiment.ledger_10ms) of the energy of the impact. The sites at a lifetime of 5 ms are those
of section 3.6, where another program with another stepper finds them.

The slow clock is exact in the DpS limit only; for the packet of 1 m/s its way of 10 ms is off by the factor
[0.991322](num:sec5_experiment.law_over_sites). The article's lifetime may be meant for the energy or for the
amplitude, which is twice as long; all lifetimes here are those of the energy. What a clamped beam loses to the
ground is not computed but given, and friction between beam and clamp, which is not linear, is left out.

## Extensions

- What does the slow clock become where contacts lose energy? Their share depends on the amplitude.
- At which quality factor would the array show the boomeron of hard wells?
- Which beam and clamp have a lifetime of 10 ms? */
int main(int argc, char** argv) {
  return run({"sec5_experiment", "5", "What an experiment would see: damping (section 5)",
              reproduce, commands<DampedArray>()},
             argc, argv);
}
