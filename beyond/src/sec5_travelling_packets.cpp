/**
# 5 What becomes of a packet

An impact on a chain with linear wells sends out a packet that sheds a tail. Exact travelling breathers shed none, but
those that we know have isolated speeds: the shift time $T$, in which they move on by one site, is $2\pi k$ (type I), or
such that the sum of all $y_n+i\dot y_n$ vanishes (type II, chapter on exact travelling breathers). A packet that sheds
loses energy and slows down. Where does it go, and does an exact breather capture it on its way?

![The tail of an impact's packet falls, its speed does not lock.](fig:x22)

[](finding:travelling.packets) */

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "commands/dps_orbit.hpp"
#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"
#include "sec5/dps_travelling.hpp"
#include "sec5/long_run.hpp"
#include "sec5/travelling.hpp"
#include "sec5/type_one_line.hpp"

using namespace lattice;

/**
## Model

The chain is that of Eq. (9) with linear wells, struck at its first bead; its limit of small amplitude is
the DpS equation (12),
$$\ddot y_n + y_n = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2},\qquad
  2i\tau_0\dot A_n = D_n - D_{n-1},\quad D_n = (A_{n+1}-A_n)|A_{n+1}-A_n|^{1/2}.$$
A bead that has been passed oscillates freely, $z_n = y_n + i\dot y_n \propto e^{-it}$, with a constant amplitude. Two
numbers describe what a packet leaves behind: the amplitude $|z_n|$ and the angle $\vartheta$ by which the phase of
$z_n$ turns from one bead to the next, both seen at the same $t$. So $\vartheta$ is the phase from bead to bead in the
frame of a free bead, that is, of $z_ne^{it}$. For an exact orbit $\vartheta = T-2\pi k$, so that $\vartheta = 0$ means
type I. A packet need not be exact: its envelope may move on by one site in $T$ while the oscillation under it, its
*internal phase*, turns by an extra angle, $T-\vartheta$ modulo $2\pi$. Then $\vartheta$ and $T$ are independent, and
$\vartheta$ may tend to zero while $T/2\pi$ tends to a number that is not whole. Such a packet leaves nothing behind
either, but one site further on it is the same only up to a phase of its oscillation: it is quasi-periodic, and no exact
orbit in our sense. */
/// The same packet in two frames and with two steps.
struct TwoLongRuns {
  double velocity;
  LongRun coarse{}, fine{};
};

/**
A power law shows only over many sites, so we follow the packet in a frame that moves with it, and drop the beads far
behind (long_run.hpp). This is allowed because nothing of what is dropped catches up: without precompression there is no
sound, and a disturbance of size $\delta$ runs at a speed of the order $\delta^{1/2}$, more slowly than the packet. A
second frame, half as long again, and half the step give the errors. What we read off is noted at twelve sites to a
decade, equidistant in $\log n$; each of these is a *row*.

## The tail of a packet (figure x22)

How should the tail fall? In the frame of a free bead the pulses in the contacts turn by $\vartheta$ from site to site,
so that a bead keeps the amplitude $|z| = |1-e^{i\vartheta}|\,|g| \simeq |\vartheta|\,|g|$, where $g$ is the integral
$g(1)$ of the chapters before, and takes away the energy $|z|^2/2$. If the packet's own energy is linear in a small
$\vartheta$, $E \simeq E_\infty + b\,\vartheta$, then
$$b\,\frac{d\vartheta}{dn} = -\frac{g^2\vartheta^2}{2},\qquad \frac1\vartheta = \frac{g^2}{2b}\,n + \dots,$$
and $\vartheta$ and the tail fall like $1/n$, *provided that $g$ and $b$ tend to constants*. With $g$ and $b$
read off the run itself this is the balance of energy and always true; the law is tested by whether the
growth of $1/\vartheta$ becomes constant.

One quantity hardly changes on the way, the mean energy in the contacts. In the limit of small amplitude two quantities
are conserved separately, the norm $\sum|A_n|^2$, which is the energy of the wells, and the energy in the contacts, the
DpS Hamiltonian. The beads left behind take away norm, but hardly any energy of contacts, since neighbours oscillate
nearly alike. We therefore expect the contact energy to select the final speed. */
Line late_line(const std::vector<double>& x, const std::vector<double>& y, std::size_t skip) {
  const auto from = std::ptrdiff_t(skip);
  return fit_line({x.begin() + from, x.end()}, {y.begin() + from, y.end()});
}

std::vector<double> logs(std::vector<double> x) {
  for (double& value : x) value = std::log10(std::abs(value));
  return x;
}

/// What is read off one run.
struct TailReading {
  double exponent, energy_lost, contact_lost, contact_early, contact_late, speed, energy, contact;
  double early_growth, growth, early_pulse,
      pulse;           ///< of 1/angle per site; |g|, near site 300 and at the end
  double angle, turn;  ///< at the end, the latter of the internal phase
};

/**
Exponents are those of the last decade of sites. The growth of $1/\vartheta$ and $|g| = |z|/\vartheta$ are taken over
four rows, a third of a decade, from site 200 on and at the end. Final speed, energy and contact energy are
extrapolated to $\vartheta = 0$ by straight lines through the last half decade, six rows. How much this depends on the
stretch shows when `half` is changed to three rows or to a whole decade. */
TailReading read_off(const LongRun& c, std::size_t half = 6) {
  constexpr std::size_t decade = 12, few = 4;
  const std::size_t last = c.t.size() - 1, from = last - few;
  const auto growth = [&](std::size_t i, std::size_t j) {
    return (1 / c.angle[j] - 1 / c.angle[i]) / (c.site[j] - c.site[i]);
  };
  const auto pulse = [&](std::size_t i, std::size_t j) {
    return std::sqrt(c.left[i] / c.angle[i] * c.left[j] / c.angle[j]);
  };
  const auto lost = [&](const std::vector<double>& x) { return 1 - x[last] / x[last - decade]; };
  double early = 0, late = 0;
  for (std::size_t i = 0; i < 6; ++i) early += c.contact[4 + i] / 6;
  for (std::size_t i = 0; i < half; ++i) late += c.contact[last - i] / double(half);
  return {late_line(logs(c.site), logs(c.left), last - decade).slope,
          lost(c.energy),
          lost(c.contact),
          early,
          late,
          late_line(c.angle, c.speed, last - half).intercept,
          late_line(c.angle, c.energy, last - half).intercept,
          late_line(c.angle, c.contact, last - half).intercept,
          growth(decade, decade + few),
          growth(from, last),
          pulse(decade, decade + few),
          pulse(from, last),
          c.angle[last],
          1 / c.speed[last] - c.angle[last] - 2 * std::numbers::pi};
}

/**
So a final quantity has two errors, which are added: the difference of the two runs, and the largest difference that
another stretch makes.

The orbits of type I that we found are single points in the plane of speed and energy. We draw a smooth curve through
seven of them, the *line of type I* (type_one_line.hpp): between the orbits it holds no exact breather that we know, and
beyond $k = 1$ it is an extrapolation. If the final state is like an orbit of type I, the packet should lie on this line
at its own speed. Two impacts are followed: $v_0 = 0.66$, whose packet ends slower than the orbit $k = 1$, and 1.5,
whose packet ends faster. */
struct FinalState {
  TailReading coarse, fine, shorter, longer;

  explicit FinalState(const TwoLongRuns& p)
      : coarse(read_off(p.coarse)),
        fine(read_off(p.fine)),
        shorter(read_off(p.fine, 3)),
        longer(read_off(p.fine, 12)) {}
  /// `of` is a function of a reading.
  template <class Of>
  Estimate operator()(Of of) const {
    Estimate e = compare(of(coarse), of(fine));
    e.error += std::max(std::abs(of(shorter) - e.value), std::abs(of(longer) - e.value));
    return e;
  }
};

/**
After the impact with $v_0 = 0.66$ the tail does not fall with the exponent $-1$ within these sites, and the growth of
$1/\vartheta$ is not constant: it falls from [0.0094495](num:sec5_travelling_packets.angle_growth_early_v66) per site
beyond site 200 to [0.00208](num:sec5_travelling_packets.angle_growth_v66) at the end, while $|g|$ falls from
[0.0308411](num:sec5_travelling_packets.pulse_early_v66) to [0.01113](num:sec5_travelling_packets.pulse_v66). So the law
$1/n$ is not confirmed: if it holds at all, it does so only beyond the sites computed here. Should $g$ go on falling
with $\vartheta$, like $|\vartheta|^p$, at a constant $b$, then by the same balance $\vartheta$ falls like
$n^{-1/(1+2p)}$ and the tail like $n^{-(1+p)/(1+2p)}$, more slowly than $1/n$. Over the last decade of sites the tail
has the exponent [-0.72067](num:sec5_travelling_packets.tail_exponent_v66); but neither $p$ nor $b$, which is $g^2/2$
divided by the growth of $1/\vartheta$ per site, is constant there, so that this is no law. */
// What belongs to the last decade as it is has the difference of the two runs as its error
void report_tail(Quantities& facts, const FinalState& state) {
  const auto fact = [&](const std::string& what, double TailReading::*of,
                        const std::string& unit = "") {
    facts.add(what + "_v66", compare(state.coarse.*of, state.fine.*of), unit);
  };
  fact("tail_exponent", &TailReading::exponent);
  fact("angle_growth_early", &TailReading::early_growth,
       "of its inverse, per site, sites 200 to 431");
  fact("angle_growth", &TailReading::growth, "of its inverse, per site, at the end");
  fact("pulse_early", &TailReading::early_pulse, "|g(1)|, sites 200 to 431");
  fact("pulse", &TailReading::pulse, "|g(1)|, at the end");
  fact("energy_lost", &TailReading::energy_lost, "share, in the last decade of sites");
  fact("contact_energy_lost", &TailReading::contact_lost, "share, in the last decade of sites");
  fact("angle_end", &TailReading::angle, "at the end");
  fact("turn_end", &TailReading::turn, "of the internal phase from site to site, at the end");
  fact("contact_energy_early", &TailReading::contact_early, "mean, sites 43 to 113");
}

/**
The packet has lost the fraction [0.0171](num:sec5_travelling_packets.energy_lost_v66) of its energy in the last decade
of sites, but only [0.0026](num:sec5_travelling_packets.contact_energy_lost_v66) of its contact energy. To compare it
with the line we scale its speed: at small amplitude $E\propto c^4$, so that $cE^{-1/4}$ depends on the energy only as
far as the amplitude is not small. With $v_0 = 0.66$ it tends to the scaled speed $cE^{-1/4} =$
[0.25467](num:sec5_travelling_packets.final_scaled_speed_v66), where the line has
[0.25466](num:sec5_travelling_packets.type_one_scaled_speed_v66). Its contact energy was
[0.0135176](num:sec5_travelling_packets.contact_energy_early_v66) near site 100, is
[0.013349](num:sec5_travelling_packets.contact_energy_late_v66) at the end, tends to
[0.013329](num:sec5_travelling_packets.final_contact_energy_v66), and would be
[0.01333](num:sec5_travelling_packets.contact_energy_of_type_one_v66) on the line. The packet of $v_0 = 1.5$, beyond $k
= 1$, tends to [0.2312](num:sec5_travelling_packets.final_scaled_speed_v150) against
[0.2312](num:sec5_travelling_packets.type_one_scaled_speed_v150) and to
[0.08242](num:sec5_travelling_packets.final_contact_energy_v150) against
[0.0824](num:sec5_travelling_packets.contact_energy_of_type_one_v150). All four agree with the line within their errors,
which come mainly from the choice of the stretch. */
// On the line, between the orbits
/**
But the shift times to which they tend, $T/2\pi =$ [1.1566](num:sec5_travelling_packets.final_turns_v66) and
[0.847](num:sec5_travelling_packets.final_turns_v150), are not whole. So, from these two impacts, a packet seems to end
on the line of type I, at a place that its contact energy selects, but away from the orbits: none captures its internal
phase. (The orbits of type II found at such shift times have some ten times the packet's energy, figure x20.) The orbit
$k = 1$ holds that phase like a very weak pendulum: displaced a little, it swings by $2|\kappa|^{1/2}$, some $10^{-5}$,
per shift, $\kappa =$ [-8.8883e-11](num:sec5_travelling_breathers.kappa_k1_plus) (chapter on exact travelling
breathers). It could capture only a phase that turns not much faster. But the internal phase of the packet turns by
$T-\vartheta$, modulo $2\pi$, from one site to the next. Though $\vartheta$ has fallen to
[0.0197](num:sec5_travelling_packets.angle_end_v66) at the end, $T$ has grown beyond $2\pi$, so that this is
[0.8867](num:sec5_travelling_packets.turn_end_v66) there, more than ten thousand times as much, and still rising.
Whether another orbit captures the packet beyond these sites is not known. */
// The final state beside the line of the exact orbits at its own speed
void report_end(Quantities& facts, const std::string& name, const FinalState& state,
                const ExactLine& line) {
  using Reading = TailReading;
  const auto on_line = [&](const std::vector<double>& y, int power) {
    const double c = state.fine.speed, shorter = line.at(c, y, 1) * std::pow(c, power);
    Estimate e =
        state([&](const Reading& r) { return line.at(r.speed, y) * std::pow(r.speed, power); });
    e.error += std::abs(shorter - e.value);
    return e;
  };
  const auto fact = [&](const std::string& what, auto of) { facts.add(what + name, state(of)); };
  facts.add("final_speed" + name, state([](const Reading& r) { return r.speed; }),
            "site per unit of time");
  fact("final_energy", [](const Reading& r) { return r.energy; });
  fact("final_turns", [](const Reading& r) { return 1 / (2 * std::numbers::pi * r.speed); });
  fact("final_scaled_speed", [](const Reading& r) { return r.speed / std::pow(r.energy, 0.25); });
  facts.add("type_one_scaled_speed" + name, on_line(line.scaled_speed, 0));
  facts.add("contact_energy_late" + name, state([](const Reading& r) { return r.contact_late; }),
            "mean, last half decade of sites");
  fact("final_contact_energy", [](const Reading& r) { return r.contact; });
  facts.add("contact_energy_of_type_one" + name, on_line(line.scaled_contact, 5),
            "at the final speed");
}

void report_long_runs(Report& report, const std::vector<TwoLongRuns>& runs) {
  Table& table = report.table(
      "courses",
      {number("velocity", "of the impact"), number("t", "time"),
       number("site", "centre of the packet", "site"), number("log_site", "its log10"),
       estimate("left", "amplitude of the bead left behind", "",
                "difference of two frames and steps"),
       number("log_left", "log10 of the amplitude"),
       estimate("angle", "phase from one bead left behind to the next", "",
                "against the largest: difference of two frames and steps"),
       number("inverse_angle", "one over the angle"),
       number("speed", "mean speed since the last row", "site per unit of time"),
       number("turns", "shift time over 2 pi"), number("energy", "mean energy of the packet"),
       number("contact", "mean contact energy of the packet")});
  // The two columns that the figure draws have errors; the others are means that fluctuate
  for (const TwoLongRuns& p : runs)
    for (std::size_t i = 0; i < p.fine.t.size(); ++i) {
      const LongRun &f = p.fine, &c = p.coarse;
      table.add({p.velocity, f.t[i], f.site[i], std::log10(f.site[i]),
                 compare(c.left[i], f.left[i]), std::log10(f.left[i]),
                 compare(c.angle[i], f.angle[i]), 1 / f.angle[i], f.speed[i],
                 1 / (2 * std::numbers::pi * f.speed[i]), f.energy[i], f.contact[i]});
    }
}

/// The line as a curve in the plane of shift time and energy; beyond k = 1 it is extrapolated.
void report_line(Report& report, const ExactLine& line) {
  Table& table = report.table(
      "line_of_type_one", {count("exact", "1 for an orbit, 0 for a point between orbits"),
                           number("turns", "shift time over 2 pi"), number("energy", "energy")});
  const auto add = [&](int exact, double turns) {
    const double c = 1 / (2 * std::numbers::pi * turns);
    table.add({exact, turns, std::pow(c / line.at(c, line.scaled_speed), 4)});
  };
  for (int i = 0; i <= 40; ++i) add(0, 0.8 + 0.0125 * i);
  add(1, 1);
}

void report_packets(Report& report, std::size_t rows) {
  std::vector<TwoLongRuns> runs{{0.66}, {1.5}};
  if (report.quick) runs.resize(1);
  parallel_for(2 * runs.size(), [&](std::size_t i) {
    TwoLongRuns& p = runs[i / 2];
    if (i % 2)
      p.fine = long_run(p.velocity, {96, 16, 0.1}, rows);
    else
      p.coarse = long_run(p.velocity, {}, rows);
  });
  const ExactLine line = exact_line();
  report_tail(report.facts, FinalState(runs[0]));
  for (const TwoLongRuns& p : runs)
    report_end(report.facts, "_v" + short_text(100 * p.velocity), FinalState(p), line);
  report_long_runs(report, runs);
  report_line(report, line);
}

/**
## The limit of small amplitude (figure x23)

Do exact travelling breathers survive in the limit of small amplitude? There they are orbits of the DpS equation
(dps_travelling.hpp), and the same two conditions hold. Since $A_n$ may be multiplied by any constant phase factor,
nothing pins the internal phase in this limit: an orbit of type I is one of a whole circle of orbits, and the two signs
of the chain are two of them. A travelling breather is now $A_n(\tau+\tau_T) = e^{i\varphi}A_{n-1}(\tau)$, where the
phase of $A_n$ turns the other way than that of $z_n$, $\varphi = -\vartheta$. The sum $\sum A_n$ is conserved, so that
$\varphi = 0$ (type I) or $\sum A_n = 0$ (type II). Panel (a) of figure x23 shows the orbit of type I beside a struck
packet at two sites, scaled to the same shift time. We follow its family with $\varphi$ (panel b); as in the chain one
equation is left out, and $V = \sum A_n/i$ shows what is missed.

From $\varphi = 0$ to 3 this $V$ becomes ever smaller, but does not change its sign: on this stretch we find no orbit of
type II, although the chain's families from $k = 1$ to 4 have them. Relative to the root of the norm, $|V|$ is
[0.117175](num:sec5_travelling_packets.dps_sum) at $\varphi = 0$, [0.0138902](num:sec5_travelling_packets.dps_sum_half)
at 0.5 and on the other side, which is that of impacts, [0.271304](num:sec5_travelling_packets.dps_sum_impact) at
$-0.25$. */
std::vector<DpsMember> dps_family(double tolerance, double to, double step) {
  DpsTravelling problem;
  problem.tolerance = tolerance;
  std::vector<DpsMember> all{dps_member(problem, cut_dps_packet(40, problem.half_length))};
  for (int i = 1; std::abs(i * step) <= std::abs(to) + 1e-9; ++i) {
    problem.phase = i * step;
    Vector<double> guess = all.back().x;
    if (i > 1) guess += all.back().x - all[std::size_t(i) - 2].x;
    all.push_back(dps_member(problem, guess));
  }
  return all;
}

/**
The chain's orbits of type I should tend to the DpS orbit as $k \to \infty$, with corrections in $1/k$. So
we compute slow ones and extrapolate by a parabola in $1/k$ through the last three, with and without the slowest orbit.

To compare we need energy and speed of the DpS orbit, whose shift takes the slow time $\tau_T$. With $y_n =
2\epsilon\,\mathrm{Re}(A_ne^{it})$ they are $E = 2\epsilon^2\sum|A_n|^2$ and $c = \epsilon^{1/2}/\tau_T$, so that
$E/c^4$ does not depend on $\epsilon$. Extrapolated from $k \le 20$ to small amplitude, $E/c^4$ of the chain's orbits
tends to [65.56](num:sec5_travelling_packets.limit_of_type_one), and that of the DpS orbit is
[65.5523](num:sec5_travelling_packets.dps_energy_over_c4), which means $cE^{-1/4} =$
[0.351441](num:sec5_travelling_packets.dps_scaled_speed). */
struct SmallOrbit {
  std::size_t k;
  int sign;
  Estimate scaled;  ///< energy over the fourth power of the speed
};

std::vector<SmallOrbit> small_orbits(int sign, std::size_t slowest) {
  std::vector<SmallOrbit> list;
  TypeOneOrbits orbits(sign);
  for (std::size_t k : {5, 6, 8, 10, 15, 20, 30, 40, 60}) {
    if (k > slowest) break;
    const Estimate e = energy_of_type_one(k, orbits.orbit_at(k));
    const double scale = std::pow(2 * std::numbers::pi * double(k), 4);
    list.push_back({k, sign, {e.value * scale, e.error * scale}});
  }
  return list;
}

/// The value at 1/k = 0 of the parabola through three orbits, the last of which is `last`.
double limit_of(const std::vector<SmallOrbit>& list, std::size_t last) {
  double sum = 0;
  for (std::size_t i = last - 2; i <= last; ++i) {
    double w = list[i].scaled.value;
    for (std::size_t j = last - 2; j <= last; ++j)
      if (j != i) w *= double(list[i].k) / (double(list[i].k) - double(list[j].k));
    sum += w;
  }
  return sum;
}

// Both signs agree far better with each other than with the limit
void report_small_orbits(Report& report, const std::vector<std::vector<SmallOrbit>>& lists) {
  Table& table = report.table(
      "small_orbits", {count("k", "oscillations a site"), count("sign", "of the central velocity"),
                       number("inverse_k", "1 / k"),
                       estimate("scaled_energy", "energy over the fourth power of the speed", "",
                                "difference of two computations")});
  for (const auto& list : lists)
    for (const SmallOrbit& o : list) table.add({o.k, o.sign, 1 / double(o.k), o.scaled});
}

void report_small(Report& report, std::size_t slowest) {
  std::vector<std::vector<SmallOrbit>> lists(2);
  parallel_for(2, [&](std::size_t i) { lists[i] = small_orbits(i == 0 ? 1 : -1, slowest); });
  const std::size_t last = lists[0].size() - 1;
  report.facts.add("limit_of_type_one",
                   compare(limit_of(lists[0], last - 1), limit_of(lists[0], last)),
                   "of energy over the fourth power of the speed");
  report_small_orbits(report, lists);
}

double relative_sum(const DpsMember& m) {
  return std::abs(m.V) / std::sqrt(m.norm);
}

void report_dps(Report& report, const DpsMember& coarse, const DpsMember& fine) {
  const double time = DpsTravelling::shift_time;
  const auto constant = [&](const DpsMember& m) { return 2 * m.norm * std::pow(time, 4); };
  const auto speed = [&](const DpsMember& m) { return 1 / time / std::pow(2 * m.norm, 0.25); };
  report.facts.add("dps_energy_over_c4", compare(constant(coarse), constant(fine)));
  report.facts.add("dps_scaled_speed", compare(speed(coarse), speed(fine)));
  report.facts.add("dps_residual", compare(coarse.residual, fine.residual));
}

/**
## What this means for the article

The article calls the computation of exact travelling breathers by Newton's method an open problem; it works. In the
chain with linear wells those that we find repeat themselves from site to site and have isolated shift times, at which
the rotation of $\sum(y_n+i\dot y_n)$ allows them: multiples of $2\pi$, and times at which the sum vanishes. At small
amplitude they tend to a travelling breather of the DpS equation. In linear wells packets of two impacts approach the
line that joins the exact orbits, without being captured by any within 16,000 sites, and shed a tail that becomes weaker
and weaker. The reversal of direction at $s > 0$ is not explained by the exact orbits that we know. */
void report_dps_family(Report& report, const std::vector<DpsMember>& coarse,
                       const std::vector<DpsMember>& fine) {
  Table& table =
      report.table("dps_family", {number("phase", "angle from site to site"),
                                  estimate("V", "sum of the amplitudes over i", "",
                                           "against the largest V: difference of two tolerances"),
                                  number("log_V", "log10 of |V| over the root of the norm"),
                                  number("norm", "norm"), number("energy", "energy")});
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const DpsMember& m = fine[i];
    table.add({m.phase, compare(coarse[i].V, m.V), std::log10(std::max(relative_sum(m), 1e-16)),
               m.norm, m.energy});
  }
  for (const auto& [name, i] : {std::pair{"dps_sum", 0U}, {"dps_sum_half", 5U}})
    report.facts.add(name, compare(relative_sum(coarse[i]), relative_sum(fine[i])));
}

// Beside the exact profile that of a struck packet, cut out at site 20 and at site 100 and scaled to the same shift time
void report_dps_profiles(Report& report, const DpsMember& exact, std::size_t half_length) {
  Table& table = report.table(
      "dps_profiles", {count("n", "site", "site"), number("re", "real part, exact"),
                       number("im", "imaginary part, exact"), number("modulus", "modulus, exact"),
                       number("early", "modulus of the packet at site 20"),
                       number("late", "modulus of the packet at site 100")});
  const DpsTravelling problem;
  const Field early = problem.expand(cut_dps_packet(20, half_length)),
              late = problem.expand(cut_dps_packet(100, half_length));
  for (std::size_t j = 0; j <= 2 * half_length; ++j) {
    const auto a = exact.field[j];
    table.add({long(j) - long(half_length), a.real(), a.imag(), std::abs(a), std::abs(early[j]),
               std::abs(late[j])});
  }
}

/**
## What is proved, what is computed, what is conjectured

*Proved*: in the linear well an exact travelling breather whose sum $Z$ converges absolutely has $T = 2\pi k$
or $Z = 0$; pulses *that repeat themselves exactly* leave behind the amplitude $|1-e^{-iT}|\,|g(1)|$ (those of
a packet repeat themselves only nearly); the equation left out of a family is $V\sin(T/2) = 0$; no localized orbit
repeats itself with the opposite sign after one site (in symmetric wells). There is an orbit of type I for
every $k$ (chapter on the kernel equation), and for $k = 1$ there are two (chapter on enclosures).

*Computed*: the orbits of type I, two for each $k$ that was tried, and those of type II, to the residuals
stated; their folds in $s$; the multipliers; the limit of small amplitude. A computation to seventeen
digits is no proof that an orbit exists: those of type II, and all in other wells, are computed only.

*Conjectured*: that there are two for every $k \ge 2$; that what pins the phase decreases with $k$ faster than
any power of $1/k$.

*Open*: how the tail of a packet falls in the end; whether an exact orbit captures a packet later than we follow these
two; whether there are orbits that repeat themselves only after several sites; a proof for type II. */
void reproduce(Report& report) {
  const bool quick = report.quick;
  report_packets(report, quick ? 24 : 36);
  report_small(report, quick ? 8 : 20);
  std::vector<std::vector<DpsMember>> family(4);
  parallel_for(4, [&](std::size_t i) {
    const double tolerance = i % 2 ? 1e-13 : 1e-12;
    family[i] =
        i < 2 ? dps_family(tolerance, quick ? 1 : 3, 0.1) : dps_family(tolerance, -0.25, -0.05);
  });
  report_dps(report, family[0].front(), family[1].front());
  report_dps_family(report, family[0], family[1]);
  report.facts.add("dps_sum_impact",
                   compare(relative_sum(family[2].back()), relative_sum(family[3].back())));
  report_dps_profiles(report, family[1].front(), DpsTravelling{}.half_length);
}

/**
## Try it

1. *Easy.* Twice the speed: which norm?
   `build/bin/sec5_travelling_packets orbit --time 3.141592653589793` gives `norm` = 0.336479.
   Hint: the DpS equation scales, $A\propto T^{-2}$. Which power of the speed is the energy $2\epsilon^2\sum|A_n|^2$?
2. *Easy.* Does it scale in the same way with another contact?
   `build/bin/sec5_travelling_packets orbit --alpha 2 --time 3.141592653589793` gives `amplitude` = 0.484613.
   Hint: with forces of degree $\alpha$ both sides of the equation agree if $A\propto T^{-1/(\alpha-1)}$; halve the
   speed and see.
3. *Harder.* By how much does a member with the phase $\varphi = 0.1$ miss itself after one shift?
   `build/bin/sec5_travelling_packets orbit --phase 0.1` gives `residual` = 0.005124.
   Hint: one equation is left out, and missed by $V\sin(\varphi/2)$; the field misses itself by a little less. What
   happens at $\varphi = 0.2$ and at 0.5, where $V$ is smaller?
4. *Open.* Damp the chain slightly: does a packet pass along the line of type I, and does it stop at some $k$?
5. *Open.* Strike the first bead a second time such that $Z$ becomes zero: does the packet then shed less from the start? */
int main(int argc, char** argv) {
  return run({"sec5_travelling_packets", "5", "What becomes of a packet (section 5)", reproduce,
              commands<DpsOrbit>()},
             argc, argv);
}
