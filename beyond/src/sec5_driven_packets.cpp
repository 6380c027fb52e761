/**
# 5 What a driven array sends out

An array that is shaken hard enough sends out packets, and so does one that is struck (section 3.4). Impacts were the
article's way to travelling breathers; exact ones exist too, in families. So what are the packets of a drive? Are they
those of an impact, and are they exact?

![What the packets of a drive are, against its strength.](fig:x29) */

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"
#include "sec5/driven_array.hpp"
#include "sec5/packet_members.hpp"
#include "sec5/travelling.hpp"

using namespace lattice;

/**
## Two numbers

The array is that of `sec5_driving`, beads in linear wells and a piston $a\sin\Omega t$ that touches the first of them,
$\Omega = 1+\delta$,
$$\ddot y_n+y_n+\nu\dot y_n = (y_{n-1}-y_n)_+^{3/2}-(y_n-y_{n+1})_+^{3/2},\qquad y_0 = a\sin\Omega t,$$
with $\nu = 0$ at first. If the piston is weak there is a *quiet* motion of its period that emits nothing. As $a$ grows
it ends in a *fold*, and beyond the array sends out packets. In the limit of small $\delta$ the fold is at $a =
8\tau_0^2\delta^2\max|u_0|$: the DpS equation, with its constant $\tau_0$, has static solutions $u_n$ that decay into
the chain from the displacement $u_0$ of the piston; followed from rest, $|u_0|$ grows up to a first maximum, and
$\max|u_0|$ means this one. The *strength* of a drive is its amplitude over this asymptotic threshold. At $\delta = 0.1$
the fold itself has the strength [1.1160](num:sec5_driving.fold_over_law_first_lossless), and with beams of the lifetime
10 ms [1.1167](num:sec5_driving.fold_over_law).

A travelling breather of the DpS equation has $A_n(t+T) = e^{i\varphi}A_{n-1}(t)$ with the shift time $T$ and the phase
$\varphi$ by which it turns from site to site. (In the frame of a free bead $z_n = y_n+i\dot y_n$ turns the other way,
by $\vartheta = -\varphi$, as in the chapter *What becomes of a packet*.) Exact ones have $\varphi = 0$ (type I) or a
vanishing sum $\sum A_n$ (type II). For other $\varphi$ one equation is left out, and what solves the others sheds a
weak tail; we call it a member, too. The two numbers determine a member: its amplitude scales like $T^{-2}$, and all
else depends on $\varphi$ only. In the chain $y_n = 2\epsilon\,\mathrm{Re}(A_ne^{it})$ repeats itself if
$e^{i(T+\varphi)} = 1$: the family that begins at $T = 2\pi k$ (chapter on families) has $\varphi = 2\pi k-T$, one curve
for each $k$ in the plane of the two numbers. A packet may lie between these curves; energy and width are interpolated
there, as if the two numbers determined them as they do in the DpS limit. */
// How they are measured
/**
We measure both numbers from bead to bead (packet_members.hpp). A packet is what lies within three sites of its peak.
Whenever its centre passes a bead we note the time and the seven $z_ne^{it}$ about it: $T$ is the mean time from one
bead to the next, and $\varphi$ the mean angle, between $-\pi$ and $\pi$, by which these seven numbers have turned back
from one bead to the next (back, because they turn like the conjugate of $A_n$). Energy and width are means over the
way, the width being the participation number of the energies of the seven sites. The packets are those of a piston that
begins at once, at $\delta = 0.1$, and that of an impact of 1 m/s.

| symbol | program | meaning | unit |
|---|---|---|---|
| $T$, $\varphi$ | `shift_time`, `phase` | time, and phase in the frame of a free bead, from site to site | $\tau_c$, 1 |
| $(T+\varphi)/2\pi$ | `family` | a whole number if the packet repeats itself one site further on | 1 |
| $Z$ | | sum of all $y_n+i\dot y_n$ of a breather; where it is zero nothing is left behind, whatever the phase | $\xi$ |

($\tau_c$ is the time unit of the array, in which a beam oscillates with the period $2\pi$, and $\xi$ its unit of
length.) Without losses we look at beads 12 to 28. With a lifetime of 10 ms the packets of a train catch up with the
first one, which has lost more (figure x28), and meet it between beads 20 and 30; so we look at beads 9 to 17. */
struct Packet {
  std::string name;
  double strength;  ///< amplitude of the piston over the asymptotic threshold; 0 for an impact
  double lifetime;  ///< ms; 0 without losses
  WatchedBeads stretch{};
  double delta = 0.1, ramp = 0, start = 0;  ///< of the drive, the last two in its periods
};

std::vector<Packet> packets(bool quick) {
  if (quick) return {{"drive", 1.3, 0}, {"impact", 0, 0}};
  return {{"drive", 1.3, 0},
          {"drive_weak", 1.15, 0},
          {"drive_strong", 1.6, 0},
          {"drive_third", 1.3, 0, {12, 28, 3}},
          {"drive_lossy", 1.3, 10, {9, 17}},
          {"impact", 0, 0},
          {"impact_far", 0, 0, {44, 60}},
          {"impact_lossy", 0, 10, {9, 17}}};
}

Traveller packet_seen(const Packet& p, double step, const WatchedBeads& stretch) {
  const double omega = 1 + p.delta, period = 2 * std::numbers::pi / omega;
  const double long_enough = 300 / p.delta + p.ramp * period;
  ArraySetup setup;
  setup.lifetime = p.lifetime;
  const auto by = p.strength > 0 ? Drive::By::piston : Drive::By::nothing;
  const double a = p.strength * threshold_law(Drive::By::piston, omega);
  // So long that earlier packets are not back from the far end before the fifth has passed
  State<double> start(2 * ArraySetup::sites);
  start.t = p.start * period;
  if (p.strength == 0) start.v[0] = setup.velocity(1);
  return traveller_on(setup.driven(by, omega, a, 0, p.ramp * period, start.y.size()), start,
                      long_enough, step, stretch);
}

/**
The oscillation within a packet makes all means fluctuate, and a packet changes on its way. So each packet is measured
four times, in four *looks*: on the whole stretch; on a stretch that begins two beads later, with twice the step; and on
either half of the stretch. The first look gives the value. Its error (the tables' *spread*) is the larger of two
numbers, the difference between the first two looks, and half of the difference between the last two. */
struct Looks {
  Traveller fine, coarse, before, after;

  /// A function of the packet, with the larger of the two differences.
  template <class Of>
  Estimate operator()(Of of) const {
    Estimate e = compare(of(coarse), of(fine));
    const double halves = std::abs(of(after) - of(before)) / 2;
    if (std::isnan(halves) || halves > e.error) e.error = halves;
    return e;
  }
};

Looks look_at(const Packet& p) {
  const auto [from, to, which] = p.stretch;
  const std::size_t middle = (from + to) / 2;
  return {packet_seen(p, 0.1, p.stretch), packet_seen(p, 0.2, {from + 2, to, which}),
          packet_seen(p, 0.1, {from, middle, which}), packet_seen(p, 0.1, {middle, to, which})};
}

double phase_of(const Traveller& p) {
  return p.phase;
}

double family_of(const Traveller& p) {
  return (p.shift_time + p.phase) / (2 * std::numbers::pi);
}

/**
## Against the families of travelling breathers

If the packet is such a breather its energy and width are no longer free: they must be those that the families have at
its shift time and phase. So the ratios of both have to be one, and nothing is fitted. For $(T+\varphi)/2\pi$ from 2 to
5 and $\varphi$ from -0.4 to 0.75 the members of the families are joined by polynomials; beyond there is no ratio. The
errors contain the change that is made by leaving out the farthest members. For comparison we also ask for the orbit of
type I, whose phase is zero, with the speed of the packet. */
class Families {
 public:
  /// Whether the packet lies between the members that we have.
  bool cover(const Traveller& p) const {
    const double k = family_of(p);
    return k >= fastest && k <= slowest && p.phase >= phases.front() && p.phase <= phases.back();
  }
  /// What they cover, in words.
  std::string range() const {
    const auto between = [](const char* name, double a, double b) {
      return name + short_text(a) + " to " + short_text(b);
    };
    return between("the members that we have: family ", fastest, slowest) +
           between(", phase ", phases.front(), phases.back());
  }
  /// Energy or width of a packet over that of the breather with its shift time and phase; nan beyond the members.
  double over(const Traveller& p, double Traveller::*of, std::size_t left_out = 0) const {
    if (!cover(p)) return std::numeric_limits<double>::quiet_NaN();
    return p.*of / (member_like(members_, p, left_out).*of);
  }
  /// The same for all looks, with the share `own` of the phase.
  Estimate ratio(const Looks& looks, double Traveller::*of, double own = 1) const {
    const auto with = [&](Traveller p, std::size_t left_out) {
      p.phase *= own;
      return over(p, of, left_out);
    };
    Estimate e = looks([&](const Traveller& p) { return with(p, 0); });
    e.error += std::abs(with(looks.fine, 1) - e.value);
    return e;
  }
  /// By what a ratio would be multiplied if the phase were larger by `wrong`.
  Estimate mistimed(const Looks& looks, double Traveller::*of, double wrong) const {
    return looks([&](const Traveller& p) {
      Traveller later = p;
      later.phase += wrong;
      return over(later, of) / over(p, of);
    });
  }

 private:
  static constexpr std::size_t fastest = 2, slowest = 5;
  const std::vector<double> phases{-0.4, -0.2, 0, 0.25, 0.5, 0.75};
  MemberGrid members_ = member_grid(fastest, slowest, phases);
};

/**
The energies agree with those of the families. [](finding:driving.packets) The first packet of a drive of strength 1.3
has the ratio [0.999](num:sec5_driven_packets.energy_ratio_drive), the third one of this train
[1.001](num:sec5_driven_packets.energy_ratio_drive_third), the first one with losses
[1.01](num:sec5_driven_packets.energy_ratio_drive_lossy). In the whole table `strengths` the ratio farthest from one is
[1.009](num:sec5_driven_packets.energy_ratio_worst), though at the two strongest drives it is uncertain by more than one
per cent, as the four looks differ (figure x29). After an impact, where the packet still sheds a tail, the ratio is
[1.009](num:sec5_driven_packets.energy_ratio_impact) on beads 12 to 28 and
[1.00](num:sec5_driven_packets.energy_ratio_impact_far) on beads 44 to 60. This tests one combination of $T$ and
$\varphi$: a phase that is wrong by a tenth would multiply the ratio by
[0.8636](num:sec5_driven_packets.energy_ratio_mistimed), but an error in time is hardly seen: a packet that is timed too
late by $\Delta$ from site to site has $T$ too large by $\Delta$ and, as it oscillates faster than a free bead by about
$\delta = 0.1$, $\varphi$ too large by about $0.1\,\Delta$; the energy goes like $T^{-4}$ at a given phase, and the two
changes nearly cancel. So only a combination is tested, about $\varphi-\delta\,T$, and neither number alone. The width
tests little ([0.9938](num:sec5_driven_packets.width_ratio_mistimed) for such a phase); without losses the ratio
farthest from one is [0.986](num:sec5_driven_packets.width_ratio_worst), for the impact with losses it is
[1.05](num:sec5_driven_packets.width_ratio_impact_lossy).

So the phase matters: compared with a breather of type I of the same speed, whose phase is zero, the drive's packet has
[2.25](num:sec5_driven_packets.type_one_ratio_drive) times the energy, and that of the impact
[0.63](num:sec5_driven_packets.type_one_ratio_impact) times. */
void report_packets(Report& report, const Families& families) {
  const std::vector<Packet> all = packets(report.quick);
  std::vector<Looks> looks(all.size());
  parallel_for(all.size(), [&](std::size_t i) { looks[i] = look_at(all[i]); });
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto fact = [&](const char* what, const Estimate& e) {
      report.facts.add(what + ("_" + all[i].name), e);
    };
    fact("phase", looks[i](phase_of));
    fact("family", looks[i](family_of));
    fact("energy_ratio", families.ratio(looks[i], &Traveller::energy));
    fact("width_ratio", families.ratio(looks[i], &Traveller::width));
    fact("type_one_ratio", families.ratio(looks[i], &Traveller::energy, 0));
  }
  // How sharp is the test?
  const double wrong = 0.1;
  report.facts.add("energy_ratio_mistimed", families.mistimed(looks[0], &Traveller::energy, wrong));
  report.facts.add("width_ratio_mistimed", families.mistimed(looks[0], &Traveller::width, wrong));
}

/**
## Does a drive lock its packets to an exact breather?

An exact breather is the same again one site further on, $(T+\varphi)/2\pi$ being a whole number, and leaves nothing
behind, $\varphi$ or the sum $Z$ being zero. How do the two numbers follow the strength of the drive? The table
`strengths` has the first packet of seventeen drives without losses. Between two of them we interpolate to find where
the phase changes its sign and where $(T+\varphi)/2\pi$ is a whole number. A drive that locked its packets to an exact
breather would keep this number at a whole value over a range of strengths; so we also ask for the
smallest difference between neighbours, in units of the sum of their spreads. */
struct LevelCrossing {
  Estimate strength, slope;
};

/// Where `y` last passes `level` as the strength `x` grows, and its slope there.
LevelCrossing last_crossing(const std::vector<double>& x, const std::vector<Estimate>& y,
                            double level) {
  for (std::size_t k = x.size() - 1; k > 0; --k) {
    const Estimate &here = y[k], &before = y[k - 1];
    if ((here.value - level) * (before.value - level) > 0) continue;
    const double apart = x[k] - x[k - 1], slope = (here.value - before.value) / apart;
    return {
        {x[k] + (level - here.value) / slope, std::max(here.error, before.error) / std::abs(slope)},
        {slope, (here.error + before.error) / apart}};
  }
  throw Failure("strengths of the drive: the level " + short_text(level) + " is passed nowhere");
}

/// The phase of the first orbit of type II on the family of k.
double phase_of_type_two(std::size_t k, double step) {
  const double begin = 2 * std::numbers::pi * double(k);
  const auto members = follow_family(Staircase(1).reach(k), begin - 1, step);
  for (std::size_t i = 1; i < members.size(); ++i)
    if (velocity_sum(members[i - 1]) * velocity_sum(members[i]) < 0)
      return begin - shift_time(type_two(members[i - 1], members[i]));
  throw Failure("no orbit of type II near that of type I");
}

/// The smallest step from one to the next over the sum of their errors.
double least_change(const std::vector<Estimate>& y) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < y.size(); ++k)
    least = std::min(least, std::abs(y[k].value - y[k - 1].value) / (y[k].error + y[k - 1].error));
  return least;
}

/// Whichever ratio is farthest from one.
Estimate farthest(const std::vector<Estimate>& ratio) {
  return *std::max_element(ratio.begin(), ratio.end(), [](const Estimate& a, const Estimate& b) {
    return std::abs(a.value - 1) < std::abs(b.value - 1);
  });
}

void report_strengths(Report& report, const Families& families) {
  std::vector<double> strengths{1.05, 1.1, 1.15, 1.2,  1.22, 1.24, 1.26, 1.3, 1.35,
                                1.4,  1.5, 1.6,  1.65, 1.7,  1.8,  2.0,  2.4};
  if (report.quick) strengths = {1.1, 1.3, 2.0};

  // Four looks at the first packet of every drive
  std::vector<Estimate> phase(strengths.size()), family = phase, energy = phase, width = phase;
  parallel_for(strengths.size(), [&](std::size_t i) {
    const Looks looks = look_at({"", strengths[i], 0});
    phase[i] = looks(phase_of), family[i] = looks(family_of);
    energy[i] = families.ratio(looks, &Traveller::energy);
    width[i] = families.ratio(looks, &Traveller::width);
  });
  const auto seen = [](const std::string& name, const std::string& meaning) {
    return Columns{number(name, meaning), number(name + "_spread", "largest difference of looks")};
  };
  Table& table = report.table(
      "strengths",
      {number("strength", "amplitude of the piston over the asymptotic threshold"),
       seen("phase", "from site to site"), seen("family", "shift time and phase over 2 pi"),
       seen("energy_ratio", "energy over that of the family's member"),
       seen("width_ratio", "width over that of the family's member")});
  for (std::size_t i = 0; i < strengths.size(); ++i)
    table.add({strengths[i], phase[i], family[i], energy[i], width[i]});

  // Where the phase changes its sign and the number is whole
  report.facts.add("phase_weakest", phase.front());
  report.facts.add("phase_zero_at", last_crossing(strengths, phase, 0).strength);
  if (report.quick) return;
  for (int whole : {4, 3}) {
    const LevelCrossing there = last_crossing(strengths, family, whole);
    report.facts.add("family_at_" + std::to_string(whole), there.strength);
    report.facts.add("family_slope_at_" + std::to_string(whole), there.slope);
    report.facts.add("phase_at_" + std::to_string(whole),
                     look_at({"", there.strength.value, 0})(phase_of));
  }
  report.facts.add("phase_type_two_4",
                   compare(phase_of_type_two(4, 0.2), phase_of_type_two(4, 0.1)));
  report.facts.add("family_least_change", exact(least_change(family)), "sum of two spreads");
  report.facts.add("energy_ratio_worst", farthest(energy));
  report.facts.add("width_ratio_worst", farthest(width));
}

/**
The two weakest drives, of strength 1.05 and 1.1, lie below the fold: their packets belong to the onset, and a drive
that rose slowly would send none. The phases of the first packets rise from
[0.630](num:sec5_driven_packets.phase_weakest) at 1.05 to [0.680](num:sec5_driven_packets.phase_drive_weak) at 1.15 and
then fall, through zero at [1.77](num:sec5_driven_packets.phase_zero_at); that of an impact is
[-0.26](num:sec5_driven_packets.phase_impact). So the packets of drives and impacts have the energy of one kind of
breather, but those of the weaker drives and that of the impact lie on opposite sides of type I, whose phase is zero. A
packet is exact if $(T+\varphi)/2\pi$ is whole and the sites behind stay at rest, as for type I or where $Z = 0$. The
drives at 1.15,
1.3 and 1.6 have $(T+\varphi)/2\pi =$ [4.122](num:sec5_driven_packets.family_drive_weak),
[3.81](num:sec5_driven_packets.family_drive) and [3.06](num:sec5_driven_packets.family_drive_strong). The number is 4 at
[1.230](num:sec5_driven_packets.family_at_4) and 3 at [1.63](num:sec5_driven_packets.family_at_3), where its slopes are
[-3.2](num:sec5_driven_packets.family_slope_at_4) and [-1.8](num:sec5_driven_packets.family_slope_at_3). From each of
the seventeen strengths to the next it changes by more than the spreads of both, at least by
[1.58478](num:sec5_driven_packets.family_least_change) times their sum. So no locking is seen, and a plateau could only
hide between two neighbouring strengths. And at no strength do we see both conditions met. The number is 3 at 1.63,
where the phase is still [0.077](num:sec5_driven_packets.phase_at_3), and the phase is zero at 1.77, where the number is
no longer whole. The number is 4 at 1.23, where the phase is [0.608](num:sec5_driven_packets.phase_at_4); on the family
of $k = 4$ the nearest orbit of type II, where $Z = 0$, has the phase
[0.582817](num:sec5_driven_packets.phase_type_two_4). Both differences are many times the spread of the phase. So we see
no packet that is exact, but those at 1.23 and at 1.63 nearly are. */
// Early and late
/**
## Does a packet stay the same?

A packet that sheds a tail changes its phase: from beads 12 to 24 to beads 30 to 42 that of an impact by
[0.08](num:sec5_driven_packets.phase_change_impact). The change of a drive's,
[-0.02](num:sec5_driven_packets.phase_change_drive), is not resolved, although its phase is the larger one. It need not
shed as much: what is left behind is $\lvert1-e^{i\varphi}\rvert\,\lvert Z\rvert$ (chapter on families), and in the DpS
limit $|Z|$, over the root of the norm, falls from [0.117175](num:sec5_travelling_packets.dps_sum) at type I to
[0.0138902](num:sec5_travelling_packets.dps_sum_half) at $\varphi = 0.5$, whereas it rises to
[0.271304](num:sec5_travelling_packets.dps_sum_impact) at $-0.25$. */
Estimate phase_change(double strength) {
  const Estimate early = look_at({"", strength, 0, {12, 24}})(phase_of),
                 late = look_at({"", strength, 0, {30, 42}})(phase_of);
  return {late.value - early.value, late.error + early.error};
}

/**
## What decides the phase?

Is it how the drive begins? We begin at another phase of the piston, or let its amplitude grow during twenty or eighty
periods, at four strengths: if the onset decided, these phases would differ as those of different strengths do. With
other frequencies we ask whether the strength is all that matters, as in the DpS limit, where $\delta$ is only a scale.

The onset does not decide: of the twelve changes of the onset none shifts the phase by more than
[0.1](num:sec5_driven_packets.phase_by_onset), and at the strength 1.77 it stays near zero. Nor is the strength all that
matters: from $\delta = 0.05$ to 0.2 the phase changes by [0.24](num:sec5_driven_packets.phase_by_delta) or more at each
of the four strengths, so that the strength with the phase zero belongs to $\delta = 0.1$. What does decide the phase is
open. */
void report_phases(Report& report) {
  const double delta = 0.1;
  struct Kind {
    std::string name;
    double delta, ramp, start;
  };
  const std::vector<Kind> kinds{
      {"at once", delta, 0, 0},        {"quarter period later", delta, 0, 0.25},
      {"in 20 periods", delta, 20, 0}, {"in 80 periods", delta, 80, 0},
      {"at once", 0.05, 0, 0},         {"at once", 0.2, 0, 0}};
  const std::vector<double> strengths =
      report.quick ? std::vector{1.3} : std::vector{1.15, 1.3, 1.6, 1.77};
  const std::size_t per = kinds.size();
  std::vector<Estimate> phase(strengths.size() * per);
  parallel_for(phase.size(), [&](std::size_t i) {
    const Kind& k = kinds[i % per];
    phase[i] = look_at({"", strengths[i / per], 0, {}, k.delta, k.ramp, k.start})(phase_of);
  });
  Table& table = report.table(
      "phases",
      {number("strength", "amplitude of the piston over the asymptotic threshold"),
       label("onset", "how the drive begins"),
       number("delta", "distance from the beams' frequency"), number("phase", "from site to site"),
       number("phase_spread", "largest difference of looks")});
  // The farthest from the drive that begins at once, and the nearest two of the other frequencies
  Estimate by_onset{0, 0}, by_delta{std::numeric_limits<double>::infinity(), 0};
  for (std::size_t i = 0; i < phase.size(); ++i) {
    const Kind& k = kinds[i % per];
    table.add({strengths[i / per], k.name, k.delta, phase[i]});
    const auto change = [&](const Estimate& from) {
      return Estimate{std::abs(phase[i].value - from.value), phase[i].error + from.error};
    };
    if (k.delta == delta) by_onset = larger(by_onset, change(phase[i / per * per]));
    if (k.delta == 0.2) by_delta = smaller(by_delta, change(phase[i - 1]));
  }
  report.facts.add("phase_by_onset", by_onset);
  report.facts.add("phase_by_delta", by_delta);
}

/**
## With your own parameters

`sec5_driven_packets packet --strength 1.3` tells what the first packet of a drive is. */
struct OnePacket {
  static constexpr Title title{"packet", "what a packet of a driven or struck array is"};
  double strength = 1.3, lifetime = 0;
  std::size_t which = 1, from = 12, beads = 16;

  void parameters(Parameters& p) {
    p.add("strength", strength,
          "amplitude of the piston over the asymptotic threshold; 0: an impact of 1 m/s", {0, 2.4});
    p.add("lifetime", lifetime, "of the energy of a beam, in ms; 0: no losses", {0, 1e6, "ms"});
    p.add("which", which, "packet that comes to the first bead", {1, 5});
    p.add("from", from, "first bead of the stretch on which it is measured", {5, 70});
    p.add("beads", beads, "length of the stretch", {8, 40});
  }
  Table table() const {
    const Looks looks = look_at({"", strength, lifetime, {from, from + beads, which}});
    const Families families;
    const std::string beyond = "at least one of four looks lies outside of " + families.range();
    Answers q;
    q.add("shift_time", looks([](const Traveller& p) { return p.shift_time; }), "tau_c",
          "time from site to site");
    q.add_small("phase", looks(phase_of), "",
                "phase from site to site, in the frame of a free bead");
    q.add("family", looks(family_of), "",
          "shift time and phase over 2 pi, a whole number for an exact breather");
    q.add("energy", looks([](const Traveller& p) { return p.energy; }), "units of the chain",
          "geometric mean in time of the energy on the seven sites about the peak");
    q.add("energy_ratio", families.ratio(looks, &Traveller::energy), "",
          "energy over that of the family's member with this shift time and phase", beyond);
    q.add("width_ratio", families.ratio(looks, &Traveller::width), "",
          "mean participation number of these sites over that of the same member", beyond);
    return q.table;
  }
};

/**
## Differences and limits

The measurement is tested (tests/driven.cpp): an exact breather that is put into a chain is found to have its own shift
time, phase and energy, and two packets close together, of which now one and now the other has more energy, are told
apart. Shift time and phase come from stretches of eight to sixteen beads: what happens within one bead, or after a
hundred, they do not tell. Except in the last table, all drives have one frequency, $\delta = 0.1$, and begin at once.
*/
void reproduce(Report& report) {
  const Families families;
  report_packets(report, families);
  report_strengths(report, families);
  report.facts.add("phase_change_drive", phase_change(1.3));
  report.facts.add("phase_change_impact", phase_change(0));
  report_phases(report);
}

/**
## Try it

1. *Easy.* Which drive sends a packet that nearly repeats itself one site further on?
   `build/bin/sec5_driven_packets packet --strength 1.63` gives `family` = 2.997.
   Hint: 3 is within the error, and the phase is small, too. Then try 1.6 and 1.7, on either side of it.
2. *Easy.* An impact's packet sheds a tail. What is its phase thirty beads later?
   `build/bin/sec5_driven_packets packet --strength 0 --from 44` gives `phase` = -0.17.
   Hint: on beads 12 to 28 it is larger in modulus. In the chapter on packets the phase goes to zero; here one sees how
   slowly.
3. *Harder.* Is a packet that loses energy still a breather of the family?
   `build/bin/sec5_driven_packets packet --lifetime 10 --from 9 --beads 8` gives `energy_ratio` = 1.01.
   Hint: shift time and phase change on the way, and the energy with them. The ratio compares all three at the same place.
4. *Open.* Which law gives the phase of a driven packet as a function of strength and frequency?
5. *Open.* Is there a drive, of another frequency or with a second tone, whose packets are exact?
6. *Open.* Does a driven packet whose number is not whole shed a tail for ever, or does its number settle at a whole one? */
int main(int argc, char** argv) {
  return run({"sec5_driven_packets", "5", "What a driven array sends out (section 5)", reproduce,
              commands<OnePacket>()},
             argc, argv);
}
