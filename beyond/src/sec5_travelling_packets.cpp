/**
# 5 What becomes of a packet

Strike the first bead of a chain at rest. A packet of energy, about seven sites wide, runs along the chain: the
travelling breather of section 3.4 of James, Kevrekidis and Cuevas (Physica D 251, 2013). Every bead that it has passed
keeps oscillating weakly. So the packet loses energy, slows down and changes:

      passed beads oscillate                    the packet          at rest
       . . .  z(n-1)   z(n)  . . .     o  o  O  O  O  o  o     .   .   .   .
                 \_____/                    ---> X(t)
        phase turns by theta, amplitude |z(n)|

The same chain has exact travelling breathers, which leave nothing behind, but those that we know have isolated speeds
(`sec5_travelling_breathers`). Does one of them capture the packet? The article does not ask. Over 16,000 sites, in
linear wells, we find:

- No exact breather captures the packets of the two impacts that we follow.
- The tail weakens all the way, but more slowly than the $1/n$ of a simple energy balance. Its final law is open.
- Speed and energy approach a smooth line drawn through exact breathers, at a point where we know of none. The energy in
  the contacts, which hardly changes on the way, seems to select this point.
- At small amplitude the exact breathers tend to a travelling breather of the DpS equation (figure x23).

![The tail of an impact's packet weakens, and its speed and energy tend to the line through exact breathers. Drawn by
x22_tail_of_a_packet.py: `left` and `inverse_angle` against `site`, and `energy` against `turns`, from `courses`;
`energy` against `turns` from `line_of_type_one`.](fig:x22)

[](finding:travelling.packets)

## Model

The beads obey Eq. (9) with linear wells, and Eq. (26) strikes the first one; all quantities are dimensionless:
$$\ddot y_n + y_n = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2},\qquad
  y_n(0) = 0,\quad \dot y_n(0) = v_0\,\delta_{n,1}.$$
A bead that the packet has passed hardly feels its neighbours. It oscillates like $z_n = y_n+i\dot y_n\propto e^{-it}$,
and two numbers describe the tail: the amplitude $|z_n|$, and the angle $\vartheta$ by which the phase of $z_n$ turns
from one bead to the next, both read at the same time.

An exact travelling breather repeats itself one site further on after the *shift time* $T$, the inverse of its speed:
$y_n(t+T) = y_{n-1}(t)$. The contact forces cancel in $Z = \sum_n z_n$, so that $Z\propto e^{-it}$. The shift does not
change $Z$ either, hence $e^{-iT}Z = Z$. Either $T = 2\pi k$ with an integer $k$ (*type I*) or $Z = 0$ (*type II*). An
exact breather turns by $\vartheta = T$, modulo $2\pi$, from bead to bead. A packet need not do so: while its envelope
moves on by a site, its *internal phase* may turn by the extra angle $T-\vartheta$. If $\vartheta$ tends to zero at some
other $T$, nothing is left behind either, but one site further on the packet is the same only up to the phase of its
oscillation: it is quasi-periodic. */
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "commands/dps_orbit.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"
#include "sec5/dps_travelling.hpp"
#include "sec5/travelling.hpp"

using namespace lattice;

/**
## The experiment

Strike the chain and look at the packet once per unit of time. A power law shows only over many sites, so a frame of
sites moves with the packet: beads far behind are dropped, beads at rest come in ahead. Nothing that is dropped could
catch up, because without precompression there is no sound, and a disturbance of size $\delta$ travels at a speed of the
order $\delta^{1/2}$. The tail is read eleven sites behind the largest density, out of the packet's reach. A row is
written whenever the packet has come to the next of twelve sites to a decade; it has the means since the row before,
because energy and speed fluctuate with the internal oscillation. The run stops with an error if the front of the frame
moves, or if the energies of the frame and of all that was dropped do not add up to that of the impact. */
constexpr double two_pi = 2 * std::numbers::pi;

struct Frame {
  std::size_t sites, drop;  // how many beads it has, how many are dropped at a time
  double step;  // of the integrator, which has order six and corrects for contact events
};

/// A packet, row by row. Speed and energies are means since the row before.
struct PacketRow {
  double t, site, left, angle, speed, energy, contact;  // `left` is |z_n|, `angle` is theta
};
using Course = std::vector<PacketRow>;

Course follow(double v0, const Frame& frame, std::size_t rows) {
  const Chain chain{frame.sites};
  State<double> state(chain.sites);  // y_n = 0
  state.v[0] = v0;                   // Eq. (26)
  Course course;
  double begin_t = 0, begin_x = 0, energy = 0, contact = 0, samples = 0, dropped_energy = 0;
  for (std::size_t dropped = 0; course.size() < rows;) {
    evolve(EventCorrected{frame.step}, chain, state, 1, 1);
    const std::vector<double> e = energy_density(chain, state);  // Eq. (23)
    const auto peak = front_packet(e);  // the foremost site with the largest density of eleven
    if (!peak || *peak < 13) continue;
    if (std::abs(state.v.back()) > 1e-9 * v0) throw Failure("the packet outruns its frame");
    if (std::abs(total(e) + dropped_energy - v0 * v0 / 2) > 1e-4 * v0 * v0 / 2)
      throw Failure("the energy in and behind the frame is not that of the impact");
    // The packet has thirteen sites; its centre is that of Eq. (24)
    const double x = energy_centre(e, *peak) + double(dropped);
    for (std::size_t n = *peak - 6; n <= *peak + 6; ++n) {
      energy += e[n];
      contact += contact_energy(chain, state.y.data(), n + 1);  // of beads n and n + 1
    }
    ++samples;
    // A row, if it has come to the next site: what it leaves behind, and the means
    if (x >= 20 * std::pow(10.0, double(course.size()) / 12)) {
      const std::size_t n = *peak - 11;
      const std::complex<double> z(state.y[n], state.v[n]), behind(state.y[n - 1], state.v[n - 1]);
      course.push_back({state.t, x, std::abs(z), std::arg(z / behind),
                        (x - begin_x) / (state.t - begin_t), energy / samples, contact / samples});
      begin_t = state.t, begin_x = x, energy = contact = samples = 0;
    }
    if (*peak + 20 > chain.sites) {
      move_on(state, frame.drop), dropped += frame.drop;
      dropped_energy += total(e) - total(energy_density(chain, state));
    }
  }
  return course;
}

/**
Each impact is followed twice, the second time in a frame half as long again and with half the step. The difference is
the error, which includes what a frame cuts off. Figure x22 draws the rows as they are; only two columns need errors,
the others are means that fluctuate. */
constexpr std::array frames{Frame{64, 16, 0.2}, Frame{96, 16, 0.1}};

void report_courses(Report& report, const std::vector<double>& velocities,
                    const std::vector<TwoRuns<Course>>& runs) {
  const std::string two = "difference of two frames and steps";
  Table& table = report.table(
      "courses",
      {number("velocity", "velocity of the impact"), number("t", "time"),
       number("site", "centre of the packet", "site"), number("log_site", "log10 of site"),
       estimate("left", "amplitude of the bead left behind", "", two),
       number("log_left", "log10 of left"),
       estimate("angle", "phase difference between one bead left behind and the next", "",
                "against the largest: " + two),
       number("inverse_angle", "inverse of the angle"),
       number("speed", "mean speed since the previous row", "site per unit of time"),
       number("turns", "shift time over 2 pi"), number("energy", "mean energy of the packet"),
       number("contact", "mean contact energy of the packet")});
  for (std::size_t k = 0; k < runs.size(); ++k)
    for (std::size_t i = 0; i < runs[k].fine.size(); ++i) {
      const PacketRow &c = runs[k].coarse[i], &f = runs[k].fine[i];
      table.add({velocities[k], f.t, f.site, std::log10(f.site), compare(c.left, f.left),
                 std::log10(f.left), compare(c.angle, f.angle), 1 / f.angle, f.speed,
                 1 / (two_pi * f.speed), f.energy, f.contact});
    }
}

/**
## The tail (figure x22)

How should the tail fall? The pulse of force in one contact gives a bead the complex amplitude
$g = \int e^{it}f(t)\,dt$, and that in the next contact takes it back, turned by $\vartheta$. So the bead keeps
$|z| = |1-e^{i\vartheta}|\,|g| \simeq |\vartheta|\,|g|$, and with it the energy $|z|^2/2$, which the packet loses. If
the packet's energy is linear in a small $\vartheta$, $E \simeq E_\infty + b\,\vartheta$, then
$$b\,\frac{d\vartheta}{dn} = -\frac{g^2\vartheta^2}2,\qquad \frac1\vartheta = \frac{g^2}{2b}\,n+\dots,$$
and $\vartheta$ and the tail fall like $1/n$, *provided that $g$ and $b$ tend to constants*. With $g$ and $b$ of the run
itself this is only the balance of energy. The law is tested by whether $|g|$ and the growth of $1/\vartheta$ per site
become constant.

They do not. After $v_0 = 0.66$ both fall all the way, and the tail has an exponent near $-0.7$. So the law $1/n$ is not
confirmed; if it holds at all, it does so only beyond the sites computed here. A pulse that goes on weakening makes the
tail fall more slowly. But no power of $\vartheta$ describes $g$ and $b$ over the last decade, so the measured exponent
is no law either.

| after $v_0 = 0.66$ | expected | here |
|---|---|---|
| exponent of the tail, last decade of sites | $-1$ | [-0.72067 ± 6e-5](num:sec5_travelling_packets.tail_exponent_v66) |
| growth of $1/\vartheta$ per site, sites 200 to 431 | | [0.0094495 ± 8e-7](num:sec5_travelling_packets.angle_growth_early_v66) |
| the same at the end | equal | [0.00208 ± 8e-5](num:sec5_travelling_packets.angle_growth_v66) |
| $\lvert g\rvert$, sites 200 to 431 | | [0.0308411 ± 5e-7](num:sec5_travelling_packets.pulse_early_v66) |
| the same at the end | equal | [0.01113 ± 2e-5](num:sec5_travelling_packets.pulse_v66) |
| share of its energy lost in the last decade of sites | | [0.0171 ± 0.0001](num:sec5_travelling_packets.energy_lost_v66) |
| share of its contact energy | less | [0.0026 ± 0.0001](num:sec5_travelling_packets.contact_energy_lost_v66) | */
constexpr std::size_t decade = 12, half = 6, third = 4;  // rows

/// The straight line through the last rows, `intervals` of them and one more.
template <class X, class Y>
Line late_line(const Course& c, std::size_t intervals, X x, Y y) {
  std::vector<double> xs, ys;
  for (std::size_t i = c.size() - 1 - intervals; i < c.size(); ++i)
    xs.push_back(std::invoke(x, c[i])), ys.push_back(std::invoke(y, c[i]));
  return fit_line(xs, ys);
}

double tail_exponent(const Course& c) {
  const auto site = [](const PacketRow& row) { return std::log10(row.site); };
  const auto left = [](const PacketRow& row) { return std::log10(row.left); };
  return late_line(c, decade, site, left).slope;
}

/// Growth of 1/theta per site, over the third of a decade that begins with row i.
double growth(const Course& c, std::size_t i) {
  return (1 / c[i + third].angle - 1 / c[i].angle) / (c[i + third].site - c[i].site);
}

/// |g| = |z|/theta on the same stretch.
double pulse(const Course& c, std::size_t i) {
  return std::sqrt(c[i].left / c[i].angle * c[i + third].left / c[i + third].angle);
}

/// The share lost in the last decade, of either energy.
double lost(const Course& c, double PacketRow::*energy) {
  return 1 - c.back().*energy / c[c.size() - 1 - decade].*energy;
}

/// The mean contact energy when the packet was young, rows 4 to 9.
double early_contact(const Course& c) {
  double mean = 0;
  for (std::size_t i = 4; i < 10; ++i) mean += c[i].contact / 6;
  return mean;
}

void report_tail(Quantities& facts, const TwoRuns<Course>& runs) {
  const std::size_t end = runs.fine.size() - 1 - third;
  const auto add = [&](const std::string& name, const std::string& unit, auto of) {
    facts.add(name + "_v66", runs.of(of), unit);
  };
  add("tail_exponent", "", tail_exponent);
  add("angle_growth_early", "of its inverse, per site, sites 200 to 431",
      [](const Course& c) { return growth(c, decade); });
  add("angle_growth", "of its inverse, per site, at the end",
      [=](const Course& c) { return growth(c, end); });
  add("pulse_early", "|g(1)|, sites 200 to 431", [](const Course& c) { return pulse(c, decade); });
  add("pulse", "|g(1)|, at the end", [=](const Course& c) { return pulse(c, end); });
  // What the packet loses, its phase, and the contact energy with which it began
  add("energy_lost", "share, in the last decade of sites",
      [](const Course& c) { return lost(c, &PacketRow::energy); });
  add("contact_energy_lost", "share, in the last decade of sites",
      [](const Course& c) { return lost(c, &PacketRow::contact); });
  add("angle_end", "at the end", [](const Course& c) { return c.back().angle; });
  add("turn_end", "of the internal phase from site to site, at the end",
      [](const Course& c) { return 1 / c.back().speed - c.back().angle - two_pi; });
  add("contact_energy_early", "mean, sites 43 to 113", early_contact);
}

/**
## The final speed and energy (figure x22)

At which speed and energy does the packet end? Against $\vartheta$ its speed and its energies are nearly straight lines.
We extrapolate them to $\vartheta = 0$ from the last half decade of sites. Shorter and longer stretches, a quarter of a
decade and a whole one, give other values; the largest difference is added to the error, and is most of it. */
struct EndState {
  double speed, energy, contact;  // where theta = 0
  double contact_late;            // mean over the stretch
};

EndState end_state(const Course& c, std::size_t rows = half) {
  const auto limit = [&](double PacketRow::*of) {
    return late_line(c, rows, &PacketRow::angle, of).intercept;
  };
  double late = 0;
  for (std::size_t i = 1; i <= rows; ++i) late += c[c.size() - i].contact / double(rows);
  return {limit(&PacketRow::speed), limit(&PacketRow::energy), limit(&PacketRow::contact), late};
}

template <class Of>
Estimate extrapolated(const TwoRuns<Course>& runs, Of of) {
  Estimate e = runs.of([&](const Course& c) { return of(end_state(c)); });
  const double shorter = of(end_state(runs.fine, 3)), longer = of(end_state(runs.fine, decade));
  e.error += std::max(std::abs(shorter - e.value), std::abs(longer - e.value));
  return e;
}

/**
We compare the end with exact breathers. Those of type I are single points in the plane of speed and energy. Through
seven of them, $k = 1$ to 7, we draw a smooth curve, the *line of type I*: between the points it holds no exact breather
that we know, and beyond $k = 1$ it is an extrapolation. Two quantities change little along it. At small amplitude the
speed $c$ scales like $E^{1/4}$, so one is the *scaled speed* $cE^{-1/4}$; the other is the mean contact energy over
$c^5$. The curve is the polynomial through all seven points. What the slowest one changes is added to the error. */
struct TypeOneLine {
  std::vector<double> speed{}, scaled_speed{}, scaled_contact{};  // k = 7 to 1

  /// Lagrange's polynomial for `y` at the speed c, through all points from number `from` on.
  double at(double c, const std::vector<double>& y, std::size_t from = 0) const {
    double sum = 0;
    for (std::size_t i = from; i < y.size(); ++i) {
      double w = y[i];
      for (std::size_t j = from; j < y.size(); ++j)
        if (j != i) w *= (c - speed[j]) / (speed[i] - speed[j]);
      sum += w;
    }
    return sum;
  }
};

TypeOneLine line_of_type_one() {
  TypeOneLine line;
  TypeOneOrbits orbits(1);
  for (std::size_t k : {7, 6, 5, 4, 3, 2, 1}) {
    const Orbit<double> orbit = orbits.orbit_at(k);
    const double time = two_pi * double(k), c = 1 / time;
    const Chain chain{24};
    State<double> state = embed(orbit.start, chain.sites, 0);
    // The mean contact energy over a shift
    const std::size_t samples = 400 * k;
    double contact = 0;
    evolve(EventCorrected{0.1}, chain, state, TimeGrid{time, samples, 1},
           [&](const State<double>& now) {
             for (std::size_t i = 1; i < chain.sites; ++i)
               if (now.t > 0) contact += contact_energy(chain, now.y.data(), i) / double(samples);
           });
    line.speed.push_back(c), line.scaled_speed.push_back(c / std::pow(orbit.energy, 0.25));
    line.scaled_contact.push_back(contact / std::pow(c, 5));
  }
  return line;
}

/**
One impact gives a packet that ends slower than the orbit $k = 1$, the other one that ends faster. Both end on the line,
in scaled speed and in contact energy, within their errors. Why at these points? At small amplitude two quantities are
conserved separately: the norm $\sum|A_n|^2$, which is the energy of the wells, and the DpS Hamiltonian, the energy in
the contacts. The beads left behind take away norm but hardly any contact energy, because neighbours oscillate nearly
alike. The packet loses far less of its contact energy than of its energy. So we expect that the contact energy, which
the packet has from early on, selects the point.

But the shift times there are not multiples of $2\pi$: no exact breather has captured the internal phase. (The orbits of
type II at such shift times have some ten times the energy, figure x20.) Could one still do so, farther out? The orbit
$k = 1$ pins its phase like a very weak pendulum. Displaced a little, the phase swings by $2|\kappa|^{1/2}$ per shift,
some $10^{-5}$, and only a phase that turns not much faster could be captured. That of the weaker packet turns by
$T-\vartheta$, modulo $2\pi$, which is more than ten thousand times as much at the end, and rising. Another
program, with Yoshida's splitting of order six, followed both packets ten times as far and saw no capture; what happens
farther out is not known.

| at the end | exact, or on the line | here |
|---|---|---|
| $T/2\pi$ after $v_0 = 0.66$ | whole | [1.1566 ± 0.0003](num:sec5_travelling_packets.final_turns_v66) |
| after $v_0 = 1.5$ | whole | [0.847 ± 0.001](num:sec5_travelling_packets.final_turns_v150) |
| $cE^{-1/4}$ after $v_0 = 0.66$ | [0.25466 ± 2e-5](num:sec5_travelling_packets.type_one_scaled_speed_v66) | [0.25467 ± 3e-5](num:sec5_travelling_packets.final_scaled_speed_v66) |
| after $v_0 = 1.5$ | [0.2312 ± 0.0001](num:sec5_travelling_packets.type_one_scaled_speed_v150) | [0.2312 ± 0.0002](num:sec5_travelling_packets.final_scaled_speed_v150) |
| contact energy after $v_0 = 0.66$ | [0.01333 ± 2e-5](num:sec5_travelling_packets.contact_energy_of_type_one_v66) | [0.013329 ± 4e-6](num:sec5_travelling_packets.final_contact_energy_v66) |
| the same near site 100 | | [0.0135176 ± 2e-8](num:sec5_travelling_packets.contact_energy_early_v66) |
| the same in the last half decade | | [0.013349 ± 1e-5](num:sec5_travelling_packets.contact_energy_late_v66) |
| after $v_0 = 1.5$ | [0.0824 ± 0.0007](num:sec5_travelling_packets.contact_energy_of_type_one_v150) | [0.08242 ± 6e-5](num:sec5_travelling_packets.final_contact_energy_v150) |
| $\vartheta$ at the last site, $v_0 = 0.66$ | 0 | [0.0197 ± 0.0002](num:sec5_travelling_packets.angle_end_v66) |
| turn of the internal phase there | 0 | [0.8867 ± 0.0001](num:sec5_travelling_packets.turn_end_v66) |
| $\kappa$ of the orbit $k = 1$ | | [-8.8883e-11 ± 3e-15](num:sec5_travelling_breathers.kappa_k1_plus) | */
void report_end(Quantities& facts, const std::string& name, const TwoRuns<Course>& runs,
                const TypeOneLine& line) {
  const auto add = [&](const std::string& what, const std::string& unit, auto of) {
    facts.add(what + name, extrapolated(runs, of), unit);
  };
  // On the line at the packet's own speed, by seven orbits and by six
  const auto add_line = [&](const std::string& what, const std::string& unit,
                            const std::vector<double>& y, int power) {
    const auto on_line = [&](double c, std::size_t from) {
      return line.at(c, y, from) * std::pow(c, power);
    };
    Estimate e = extrapolated(runs, [&](const EndState& end) { return on_line(end.speed, 0); });
    e.error += std::abs(on_line(end_state(runs.fine).speed, 1) - e.value);
    facts.add(what + name, e, unit);
  };
  add("final_speed", "site per unit of time", [](const EndState& end) { return end.speed; });
  add("final_energy", "", [](const EndState& end) { return end.energy; });
  add("final_turns", "", [](const EndState& end) { return 1 / (two_pi * end.speed); });
  add("final_scaled_speed", "",
      [](const EndState& end) { return end.speed / std::pow(end.energy, 0.25); });
  add_line("type_one_scaled_speed", "", line.scaled_speed, 0);
  add("contact_energy_late", "mean, last half decade of sites",
      [](const EndState& end) { return end.contact_late; });
  add("final_contact_energy", "", [](const EndState& end) { return end.contact; });
  add_line("contact_energy_of_type_one", "at the final speed", line.scaled_contact, 5);
}

// The line as a curve in the plane of shift time and energy
void report_line(Report& report, const TypeOneLine& line) {
  Table& table = report.table(
      "line_of_type_one", {count("exact", "1: an orbit, 0: a point between orbits"),
                           number("turns", "shift time over 2 pi"), number("energy", "energy")});
  const auto add = [&](int exact, double turns) {
    const double c = 1 / (two_pi * turns);
    table.add({exact, turns, std::pow(c / line.at(c, line.scaled_speed), 4)});
  };
  for (int i = 0; i <= 40; ++i) add(0, 0.8 + 0.0125 * i);
  add(1, 1);
}

void report_packets(Report& report) {
  const std::vector<double> impacts = report.quick ? std::vector{0.66} : std::vector{0.66, 1.5};
  std::vector<TwoRuns<Course>> runs(impacts.size());
  parallel_for(2 * impacts.size(), [&](std::size_t i) {
    (i % 2 ? runs[i / 2].fine : runs[i / 2].coarse) =
        follow(impacts[i / 2], frames[i % 2], report.quick ? 24 : 36);
  });
  const TypeOneLine line = line_of_type_one();
  report_tail(report.facts, runs[0]);
  for (std::size_t k = 0; k < runs.size(); ++k)
    report_end(report.facts, "_v" + short_text(100 * impacts[k]), runs[k], line);
  report_courses(report, impacts, runs);
  report_line(report, line);
}

/**
## The limit of small amplitude (figure x23)

Do exact travelling breathers survive at small amplitude? With $y_n = 2\epsilon\,\mathrm{Re}\,[A_ne^{it}]$ and the slow
time $\tau = \epsilon^{1/2}t$ the chain obeys the DpS equation (12),
$$2i\tau_0\dot A_n = D_n-D_{n-1},\qquad D_n = (A_{n+1}-A_n)|A_{n+1}-A_n|^{1/2}.$$
A travelling breather is now $A_n(\tau+\tau_T) = e^{i\varphi}A_{n-1}(\tau)$ with $\varphi = -\vartheta$. The sum
$\sum A_n$ is conserved, so that either $\varphi = 0$ (type I) or $\sum A_n = 0$ (type II). But $A_n$ may be multiplied
by any constant phase factor, so nothing pins the internal phase here.

The equation has no scale of its own, and we choose $\tau_T = 2\pi$. Newton's method looks for fields on the sites $-8$
to 9 with the symmetry $A_n(\tau) = -\bar A_{-n}(-\tau)$, for which half a shift is enough. With
$w_n = e^{-i\varphi/2}A_n(\tau_T/2)$ the equations are
$$\mathrm{Re}\,(w_n+w_{1-n}) = 0,\qquad \mathrm{Im}\,(w_n-w_{1-n}) = 0,\qquad n = 1,\dots,9.$$
The equations of the first kind add up to $V\sin(\varphi/2) = 0$, where $\sum A_n(0) = iV$. We leave out one of them and
find a solution for every $\varphi$ that we try; $V$ shows what is missed (dps_travelling.hpp). The first guess is the
packet of an impact on a DpS chain, isolated at site 40. At $\varphi = 0$, where the solution is exact, a whole shift
without the symmetry must confirm it.

![The travelling breather of the DpS equation, its family, and the limit of the chain's orbits of type I. Drawn by
x23_dps_travelling.py: `modulus`, `early` and `late` against `n` from `dps_profiles`, `log_V` against `phase` from
`dps_family`, `scaled_energy` against `inverse_k` from `small_orbits`.](fig:x23) */
using DpsFamily = std::vector<DpsMember>;

void check_shift(const DpsTravelling& problem, const Field& field) {
  Field later = field;
  problem.flow(later, problem.shift_time);
  for (std::size_t n = 1; n < field.size(); ++n)
    if (!(std::abs(later[n] - field[n - 1]) < 1e-12)) throw Failure("no travelling breather");
}

DpsFamily dps_family(double tolerance, double to, double step) {
  DpsTravelling problem;
  problem.tolerance = tolerance;
  DpsFamily all{dps_member(problem, cut_dps_packet(40, problem.half_length))};
  check_shift(problem, all.front().field);
  for (int i = 1; std::abs(i * step) <= std::abs(to) + 1e-9; ++i) {
    problem.phase = i * step;
    Vector<double> guess = all.back().x;
    if (i > 1) guess += all.back().x - all[std::size_t(i) - 2].x;
    all.push_back(dps_member(problem, guess));
  }
  return all;
}

/**
The breather of type I looks like the packet of an impact, which at site 100 comes closer to it than at site 20. Along
the family $|V|$ falls by orders of magnitude up to $\varphi = 3$ but does not change its sign, so that we find no orbit
of type II on this stretch. The chain's families from $k = 1$ to 4 have them (`sec5_travelling_families`). Packets of
impacts are on the other side, at negative $\varphi$, and there $|V|$ grows.

| $\lvert\sum A_n\rvert$ over $(\sum\lvert A_n\rvert^2)^{1/2}$ | expected | here |
|---|---|---|
| $\varphi = 0$ | | [0.117175 ± 3e-15](num:sec5_travelling_packets.dps_sum) |
| $\varphi = 0.5$ | 0, if of type II | [0.0138902 ± 8e-16](num:sec5_travelling_packets.dps_sum_half) |
| $\varphi = -0.25$ | 0, if of type II | [0.271304 ± 6e-15](num:sec5_travelling_packets.dps_sum_impact) | */
double relative_sum(const DpsMember& m) {
  return std::abs(m.V) / std::sqrt(m.norm);
}

void report_dps_family(Report& report, const TwoRuns<DpsFamily>& family) {
  Table& table = report.table(
      "dps_family", {number("phase", "phase advance from site to site"),
                     estimate("V", "V: the sum of the amplitudes, divided by i", "",
                              "against the largest V: difference of two tolerances"),
                     number("log_V", "log10 of |V| divided by the square root of the norm"),
                     number("norm", "norm"), number("energy", "energy")});
  for (std::size_t i = 0; i < family.fine.size(); ++i) {
    const DpsMember& m = family.fine[i];
    table.add({m.phase, compare(family.coarse[i].V, m.V),
               std::log10(std::max(relative_sum(m), 1e-16)), m.norm, m.energy});
  }
  const auto sum_at = [&](std::size_t i) {
    return family.of([=](const DpsFamily& all) { return relative_sum(all[i]); });
  };
  report.facts.add("dps_sum", sum_at(0));
  report.facts.add("dps_sum_half", sum_at(5));
}

// The exact profile, and that of the packet of an impact, isolated at two sites and scaled to the same shift time
void report_dps_profiles(Report& report, const DpsMember& exact) {
  Table& table = report.table(
      "dps_profiles", {count("n", "site", "site"), number("re", "real part of the exact breather"),
                       number("im", "imaginary part of the exact breather"),
                       number("modulus", "modulus of the exact breather"),
                       number("early", "modulus of the packet at site 20"),
                       number("late", "modulus of the packet at site 100")});
  const DpsTravelling problem;
  const std::size_t L = problem.half_length;
  const Field early = problem.expand(cut_dps_packet(20, L)),
              late = problem.expand(cut_dps_packet(100, L));
  for (std::size_t j = 0; j <= 2 * L; ++j) {
    const auto a = exact.field[j];
    table.add({long(j) - long(L), a.real(), a.imag(), std::abs(a), std::abs(early[j]),
               std::abs(late[j])});
  }
}

/**
The chain's orbits of type I should tend to this breather as $k\to\infty$. Its energy is $E = 2\epsilon^2\sum|A_n|^2$
and its speed $c = \epsilon^{1/2}/\tau_T$, so that $E/c^4$ does not depend on $\epsilon$. We compute $E/c^4$ for slower
and slower orbits, for both signs of their central velocity, and extrapolate by the parabola in $1/k$ through the last
three. Without the slowest orbit it gives the error. Each orbit is found twice, the second time at eight times the
tolerance from a disturbed guess. The two signs agree far better with each other than with the limit. Chain and DpS
equation are computed by different integrators and different equations, and agree:

| limit of small amplitude | DpS equation | chain, $k\to\infty$ |
|---|---|---|
| $E/c^4$ | [65.5523 ± 8e-13](num:sec5_travelling_packets.dps_energy_over_c4) | [65.56 ± 0.01](num:sec5_travelling_packets.limit_of_type_one) |
| $cE^{-1/4}$ | [0.351441 ± 1e-15](num:sec5_travelling_packets.dps_scaled_speed) | | */
std::vector<Estimate> scaled_energies(int sign, const std::vector<std::size_t>& ks) {
  std::vector<Estimate> list;
  TypeOneOrbits orbits(sign);
  for (std::size_t k : ks) {
    const Estimate e = energy_of_type_one(k, orbits.orbit_at(k));
    const double scale = std::pow(two_pi * double(k), 4);  // 1 / c^4
    list.push_back({e.value * scale, e.error * scale});
  }
  return list;
}

/// The value at 1/k = 0 of the parabola through three orbits, the last of which is `last`.
double limit_of(const std::vector<std::size_t>& ks, const std::vector<Estimate>& scaled,
                std::size_t last) {
  double sum = 0;
  for (std::size_t i = last - 2; i <= last; ++i) {
    double w = scaled[i].value;
    for (std::size_t j = last - 2; j <= last; ++j)
      if (j != i) w *= double(ks[i]) / (double(ks[i]) - double(ks[j]));
    sum += w;
  }
  return sum;
}

void report_small_orbits(Report& report) {
  std::vector<std::size_t> ks{5, 6, 8};
  if (!report.quick) ks.insert(ks.end(), {10, 15, 20});
  const int signs[] = {1, -1};
  std::array<std::vector<Estimate>, 2> scaled;
  parallel_for(2, [&](std::size_t i) { scaled[i] = scaled_energies(signs[i], ks); });
  const std::size_t last = ks.size() - 1;
  report.facts.add("limit_of_type_one",
                   compare(limit_of(ks, scaled[0], last - 1), limit_of(ks, scaled[0], last)),
                   "of energy over the fourth power of the speed");
  Table& table = report.table(
      "small_orbits", {count("k", "oscillations per site"),
                       count("sign", "sign of the central velocity"), number("inverse_k", "1 / k"),
                       estimate("scaled_energy", "energy divided by the fourth power of the speed",
                                "", "difference of two computations")});
  for (std::size_t i : {0, 1})
    for (std::size_t j = 0; j <= last; ++j)
      table.add({ks[j], signs[i], 1 / double(ks[j]), scaled[i][j]});
}

void report_dps(Report& report) {
  // The family in both directions, each at two tolerances of the integrator
  TwoRuns<DpsFamily> family, to_impacts;
  parallel_for(4, [&](std::size_t i) {
    TwoRuns<DpsFamily>& both = i < 2 ? family : to_impacts;
    const double tolerance = i % 2 ? 1e-13 : 1e-12;
    (i % 2 ? both.fine : both.coarse) = i < 2 ? dps_family(tolerance, report.quick ? 1 : 3, 0.1)
                                              : dps_family(tolerance, -0.25, -0.05);
  });
  // At phi = 0: energy and speed for any epsilon
  const double time = DpsTravelling::shift_time;
  report.facts.add("dps_energy_over_c4", family.of([=](const DpsFamily& all) {
    return 2 * all.front().norm * std::pow(time, 4);
  }));
  report.facts.add("dps_scaled_speed", family.of([=](const DpsFamily& all) {
    return 1 / time / std::pow(2 * all.front().norm, 0.25);
  }));
  report_dps_family(report, family);
  report.facts.add("dps_sum_impact",
                   to_impacts.of([](const DpsFamily& all) { return relative_sum(all.back()); }));
  report_dps_profiles(report, family.fine.front());
}

/**
## Proved, computed and conjectured

The article calls the computation of exact travelling breathers by Newton's method an open problem. It works. This
chapter and those on exact travelling breathers lead to the following.

*Proved*, in the linear well: an exact travelling breather whose sum $Z$ converges absolutely has $T = 2\pi k$ or
$Z = 0$. Pulses that repeat themselves exactly leave behind the amplitude $|1-e^{-iT}|\,|g|$. The equation left out of a
family is $V\sin(T/2) = 0$. No localized orbit repeats itself with the opposite sign after one site, in any symmetric
well. There is an orbit of type I for every $k$ (`sec5_kernel_equation`), and for $k = 1$ there are two
(`sec5_enclosures`).

*Computed*: the orbits of type I, two for each $k$ that was tried, and those of type II, to the residuals stated; their
folds in $s$; the multipliers; the limit of small amplitude. A small residual is no proof that an orbit exists: those of
type II, and all in other wells, are computed only.

*Conjectured*: there are two orbits for every $k\ge2$; the pinning of the phase decreases with $k$ faster than any power
of $1/k$.

*Open*: how the tail of a packet falls in the end; whether an exact orbit captures a packet later than we follow these
two; whether there are orbits that repeat themselves only after several sites; a proof for type II. The reversal of
direction at $s > 0$ is not explained by the exact orbits that we know.

**To change it.** Other impacts are the list in `report_packets`, their frames `frames`. Wells are the second member of
`Chain` in `follow`, but then the frequency of a passed bead depends on its amplitude, and $\vartheta$ means less.
Another reading of the tail is a member of `PacketRow` and a column in `report_courses`. The stretches of fits are
`decade`, `half` and `third`. The figures read columns by name. */
void reproduce(Report& report) {
  report_packets(report);
  report_small_orbits(report);
  report_dps(report);
}

/**
## Try it

1. *Easy.* What is the norm at twice the speed?
   `build/bin/sec5_travelling_packets orbit --time 3.141592653589793` gives `norm` = 0.336479.
   Hint: the DpS equation scales, $A\propto T^{-2}$. Which power of the speed is the energy $2\epsilon^2\sum|A_n|^2$?
2. *Easy.* Does another contact scale in the same way?
   `build/bin/sec5_travelling_packets orbit --alpha 2 --time 3.141592653589793` gives `amplitude` = 0.484613.
   Hint: with forces of degree $\alpha$ both sides of the equation agree if $A\propto T^{-1/(\alpha-1)}$; halve the
   speed and see.
3. *Harder.* By how much does a member with the phase $\varphi = 0.1$ miss itself after one shift?
   `build/bin/sec5_travelling_packets orbit --phase 0.1` gives `residual` = 0.005124.
   Hint: one equation is left out, and missed by $V\sin(\varphi/2)$; the field misses itself by a little less. What
   happens at $\varphi = 0.2$ and at 0.5, where $V$ is smaller?
4. *Open.* Damp the chain slightly. Does a packet pass along the line of type I, and does it stop at some $k$?
5. *Open.* Strike the first bead a second time such that $Z$ becomes zero. Does the packet then radiate less from the
   start?

The command is explained in dps_orbit.hpp. */
int main(int argc, char** argv) {
  return run({"sec5_travelling_packets", "5", "What becomes of a packet (section 5)", reproduce,
              commands<DpsOrbit>()},
             argc, argv);
}
