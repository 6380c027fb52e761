/**
# 1 The chain: an impact, a breather and its stability

How does energy move in a Newton's cradle whose balls are held so stiffly, by short strings or by elastic beams, that
each oscillates while a pulse passes? James, Kevrekidis and Cuevas (Physica D 251, 2013) find packets of oscillations
that travel, packets that turn round, and packets that stay in place, the *breathers*. This chapter computes one of each
from the equation of motion, by the plainest methods: Verlet's for the motion, Newton's for the breather, differences
for its stability. In linear wells a packet travels at [0.1878](cell:travelling/speed) sites per unit of time; in hard
wells one turns round at site [20.1](cell:turning/site). The breather is unstable, but barely: its multipliers lie on
the unit circle, except a pair next to $+1$ that makes a disturbance grow by 0.02 per cent in a period.

![A packet that travels, one that turns round, a breather, and its Floquet multipliers.](fig:x36)

The code needs the C++ standard library and Eigen. Of our own library it uses what writes tables, and
`compare(coarse, fine)`: the finer value, with its difference from the coarser one as error.

<!-- head -->
`build/bin/sec1_the_chain` computes this chapter in less than 1 s on two cores and writes 8 tables to
`build/data/sec1_the_chain`. Its figures: `make x36`, `make x40`.
<!-- /head --> */

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "report/program.hpp"
#include "sec1/tail.hpp"

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using namespace lattice;

/**
## The equation of motion

Two elastic spheres that overlap by $x$ repel with the force $\gamma\,x^{3/2}$, which is Hertz's law; spheres that do
not overlap exert no force, and none ever attracts. So a contact has no linear part: the smaller the motion, the softer
the contact. The chain has such contacts between neighbours and an on-site potential, or well, $W$ for every bead,
Eqs. (9) and (10) of the article:
$$\ddot y_n = -W'(y_n) + (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2},\qquad
  W(y) = \tfrac12y^2 + \tfrac s4\,y^4,$$
where $(x)_+$ is $x$ if positive and zero otherwise. In our units the mass of a bead, the stiffness of its well and that
of a contact are one; a bead alone oscillates at frequency one. The number $s$ makes the well linear ($s = 0$), hard
($s > 0$) or soft ($s < 0$). These units are used throughout, except for experiments (cantilever.hpp converts). */
struct Chain {
  Index sites;
  double s = 0;          // anharmonicity of the wells
  double stiffness = 1;  // of the wells; 0 for a chain without them

  double well(double y) const { return stiffness * y * y / 2 + s * y * y * y * y / 4; }  // W
  double well_force(double y) const { return -stiffness * y - s * y * y * y; }           // -W'
};

// Hertz's law: the force between two beads that overlap by x
double push(double x) {
  return x > 0 ? x * std::sqrt(x) : 0;
}

VectorXd acceleration(const Chain& chain, const VectorXd& y) {
  VectorXd a(chain.sites);
  for (Index n = 0; n < chain.sites; ++n) a[n] = chain.well_force(y[n]);
  for (Index n = 1; n < chain.sites; ++n) {
    const double force = push(y[n - 1] - y[n]);
    a[n - 1] -= force;
    a[n] += force;
  }
  return a;
}

/**
## The experiments

We strike the first bead of a chain at rest with the velocity $v_0$, Eq. (26), and observe the motion every 0.2 units of
time, about 30 times in an oscillation. Verlet's method gives the beads half a kick, moves them, and gives them the
other half. Like the equation it is symplectic and reversible. Ahead of a packet the displacements fall off so fast that
after some 15 beads they underflow to zero, so the length of the chain does not matter as long as its last bead has not
moved. The breather comes later; its chain and frequency stand here with the others. */
struct Impact {
  Chain chain;
  double v0, time;  // impact velocity; for how long we follow it
};
const Impact travelling{.chain = {.sites = 100, .s = 0}, .v0 = 1, .time = 350};
const Impact turning{.chain = {.sites = 100, .s = 1}, .v0 = 1.9, .time = 900};
constexpr double step_length = 0.02, every = 0.2;    // h, and time between observations
constexpr Index half_width = 5;                      // of the sites that belong to a packet
constexpr double fit_from = 20, fit_to = 60;         // sites between which the speed is fitted
constexpr double smoothing = 15;                     // time over which a turning path is averaged
constexpr double tail_from = 200, tail_until = 206;  // when the tail of a packet is observed

struct Breather {
  Chain chain;
  double omega_b;

  double period() const { return 2 * std::numbers::pi / omega_b; }
};
const Breather standing{.chain = {.sites = 11, .s = 0}, .omega_b = 1.1};
constexpr int steps_per_period = 800;  // a multiple of 160
constexpr double difference = 1e-6;    // for derivatives, relative to the largest displacement

struct State {
  VectorXd y, v;
};

State after(const Chain& chain, State now, double time, int steps) {
  const double h = time / steps;
  for (int k = 0; k < steps; ++k) {
    now.v += h / 2 * acceleration(chain, now.y);
    now.y += h * now.v;
    now.v += h / 2 * acceleration(chain, now.y);
  }
  return now;
}

// Shows time and state to `observe`, until this returns false
template <class Observe>
void strike(const Impact& impact, double h, Observe observe) {
  const Index sites = impact.chain.sites;
  State now{VectorXd::Zero(sites), VectorXd::Zero(sites)};
  now.v[0] = impact.v0;
  const int observations = int(std::lround(impact.time / every));
  for (int k = 1; k <= observations; ++k) {
    now = after(impact.chain, now, every, int(std::lround(every / h)));
    if (now.v[sites - 1] != 0) throw Failure("the motion has reached the far end");
    if (!observe(k * every, now)) return;
  }
}

/**
## Where the packet is

The energy of a bead is its kinetic energy, that of its well and that of the contact to its right, Eq. (23). These
densities $e_n$ add up to the energy $\mathcal H$ of the chain, Eq. (6), which the motion conserves. The centre of a
packet is $X = \sum n\,e_n/\sum e_n$ over the eleven sites around its largest energy, Eq. (24), as far as the chain has
them. Bead `n` of the code has the number $n+1$, so that the first is number one. */
VectorXd energy_density(const Chain& chain, const State& now) {
  VectorXd e(chain.sites);
  for (Index n = 0; n < chain.sites; ++n) {
    e[n] = now.v[n] * now.v[n] / 2 + chain.well(now.y[n]);
    if (n + 1 == chain.sites) continue;
    const double overlap = now.y[n] - now.y[n + 1];
    e[n] += 0.4 * overlap * push(overlap);
  }
  return e;
}

double packet_centre(const Chain& chain, const State& now) {
  const VectorXd e = energy_density(chain, now);
  Index peak = 0;
  e.maxCoeff(&peak);
  const Index first = std::max<Index>(0, peak - half_width),
              last = std::min(e.size() - 1, peak + half_width);
  double moment = 0, weight = 0;
  for (Index n = first; n <= last; ++n) {
    moment += double(n + 1) * e[n];
    weight += e[n];
  }
  return moment / weight;
}

// The speed is the slope of a least-squares line through X(t) between two sites
double packet_speed(const Impact& impact, double h) {
  std::vector<double> t, x;
  double X = 0;
  strike(impact, h, [&](double time, const State& now) {
    X = packet_centre(impact.chain, now);
    if (X >= fit_from && X <= fit_to) {
      t.push_back(time);
      x.push_back(X);
    }
    return X <= fit_to;
  });
  if (X <= fit_to) throw Failure("the packet does not get through the sites of the fit");
  const VectorXd T = Eigen::Map<VectorXd>(t.data(), Index(t.size())),
                 sites = Eigen::Map<VectorXd>(x.data(), Index(x.size()));
  const VectorXd from_mean = T.array() - T.mean();
  return from_mean.dot(sites) / from_mean.squaredNorm();
}

/**
## A packet that turns round

In hard wells a packet slows down, turns and comes back, though all beads and wells are alike; sec34_boomeron.cpp
follows it. Its centre swings, because its beads oscillate; averaging over 15 units of time, about four of their
periods, removes that. The turning point is the furthest of these means, and the run ends when the packet is five sites
behind it. */
struct Turn {
  double site = 0, time = 0;
};

Turn turning_point(const Impact& impact, double h) {
  const std::size_t samples = std::size_t(std::lround(smoothing / every));
  std::vector<double> x;
  Turn turn;
  double mean = 0;
  strike(impact, h, [&](double time, const State& now) {
    x.push_back(packet_centre(impact.chain, now));
    if (x.size() < samples) return true;
    mean = 0;
    for (std::size_t k = 1; k <= samples; ++k) mean += x[x.size() - k] / double(samples);
    if (mean > turn.site) turn = {mean, time - every * double(samples - 1) / 2};
    return mean > turn.site - half_width;
  });
  if (mean > turn.site - half_width) throw Failure("the packet has not come back");
  return turn;
}

/**
## A breather

A breather is a time-periodic motion, with frequency $\omega_b$ and period $T_b = 2\pi/\omega_b$, that is confined to a
few beads. Breathers are known best from chains of weakly coupled oscillators, where they are continued from the
*anticontinuous limit*, in which nothing is coupled (MacKay and Aubry 1994; review: Flach and Gorbach 2008). Here a bead
alone oscillates at frequency one, and a contact, which pushes it back as the well does, raises the frequency: breathers
have $\omega_b > 1$, and those near one are small. (At small amplitudes this holds in hard and soft wells too: the push
grows with the power $3/2$, the anharmonic force with the power 3.) They do not radiate, since contacts without a linear
part carry no linear waves. There are two kinds, symmetric about a bead (*site-centred*) or a contact (*bond-centred*).

How does one find a site-centred one? Let it start from rest, so that it is even in time. Contacts push and do not pull:
a reflection of the chain turns each overlap into a gap, and only if the displacements change sign as well is it an
overlap again. So the mirror image with the sign changed is a motion of the chain too. The site-centred breather is its
own image half a period later, $y_n(t+T_b/2) = -y_{-n}(t)$. Both symmetries together give conditions after a *quarter*
of the period,
$$y_n + y_{-n} = 0,\qquad \dot y_n - \dot y_{-n} = 0 \qquad\text{at } t = T_b/4,$$
one equation per bead for the unknown positions $y_n(0)$. Here $n$ counts from the central bead. */
State at_rest(const VectorXd& y) {
  return {y, VectorXd::Zero(y.size())};
}

VectorXd residual(const Breather& b, const VectorXd& y, int steps) {
  const State end = after(b.chain, at_rest(y), b.period() / 4, steps / 4);
  VectorXd r(b.chain.sites);
  for (Index n = 0; n < b.chain.sites; ++n) {
    const Index mirror = b.chain.sites - 1 - n;
    const bool left = n <= mirror;  // the first condition, with the centre; on the right the second
    r[n] = left ? end.y[n] + end.y[mirror] : end.v[n] - end.v[mirror];
  }
  return r;
}

/**
Newton's method needs a guess. Small breathers obey the discrete $p$-Schrödinger (DpS) equation of section 3.1. From it
the article derives a profile of known size, Eqs. (18) to (20): $y_n(0) = 2\epsilon\,(-1)^n\,[g(n+\frac12)+
g(n-\frac12)]$ with $g(x) = (\frac3{10})^3\cos^6(x/3)$ and $\epsilon = (2\tau_0(\omega_b-1))^2$. */
VectorXd guess(const Breather& b) {
  const double tau_0 = 5 * std::pow(std::tgamma(0.25), 2) / (24 * std::sqrt(std::numbers::pi));
  const double eps = std::pow(2 * tau_0 * (b.omega_b - 1), 2);
  const auto g = [](double x) {
    const double edge = 1.5 * std::numbers::pi;
    return std::abs(x) < edge ? 0.027 * std::pow(std::cos(x / 3), 6) : 0.0;
  };
  VectorXd y(b.chain.sites);
  for (Index i = 0; i < b.chain.sites; ++i) {
    const Index n = i - b.chain.sites / 2;
    y[i] = 2 * eps * (n % 2 == 0 ? 1 : -1) * (g(double(n) + 0.5) + g(double(n) - 0.5));
  }
  return y;
}

// Newton's method; each column of the derivative is a difference of two residuals
VectorXd find_breather(const Breather& b, int steps) {
  VectorXd y = guess(b);
  const double size = y.cwiseAbs().maxCoeff(), small = difference * size;
  for (int k = 0; k < 10; ++k) {
    const VectorXd r = residual(b, y, steps);
    if (r.cwiseAbs().maxCoeff() < 1e-12 * size) return y;
    MatrixXd derivative(b.chain.sites, b.chain.sites);
    for (Index n = 0; n < b.chain.sites; ++n) {
      VectorXd near = y;
      near[n] += small;
      derivative.col(n) = (residual(b, near, steps) - r) / small;
    }
    y -= derivative.partialPivLu().solve(r);
  }
  throw Failure("Newton's method does not converge");
}

/**
## Is it stable?

In one period a small disturbance of the breather is multiplied by the *monodromy* matrix, whose eigenvalues are the
Floquet multipliers $\lambda$. If one lies outside the unit circle, some disturbance grows. The columns of the matrix
are again differences. The equation is Hamiltonian and real, so $1/\lambda$ and the complex conjugate are multipliers
too. One pair is exactly $+1$, because the breather may be shifted in time. Another, the *pinning pair*, is very close
to it, because the breather may almost be shifted along the chain; disturbances of this kind set breathers in motion
(Chen, Aubry and Tsironis 1996).

| multipliers, by their distance from $+1$ | first and second | third and fourth | fifth and sixth |
|---|---|---|---|
| distance | [0.000187 ± 7e-6](cell:multipliers/k=2/distance) | [0.003 ± 0.002](cell:multipliers/k=4/distance) | [0.22954](cell:multipliers/k=5/distance) |
| the book's | [0.000214](cell:sec33_floquet/spectra/centre=site/omega=1.1/s=0/fourth) | 0 | [0.229543](cell:sec33_floquet/spectra/centre=site/omega=1.1/s=0/fifth) |
| largest modulus | [1.0002](cell:multipliers/k=2/modulus) | [1.003 ± 0.002](cell:multipliers/k=4/modulus) | [1.00000](cell:multipliers/k=5/modulus) |

From the fifth on the moduli are one to 9 digits. The first four are real. Which of them tell of the breather, and which
of our method? The next section decides it: the first pair keeps its distance as the step is refined, and is the pinning
pair, while the second tends to $+1$. So the breather is unstable against a shift along the chain, and hardly so. */
std::vector<std::complex<double>> multipliers(const Breather& b, const VectorXd& y, int steps) {
  const Index n = b.chain.sites;
  const double small = difference * y.cwiseAbs().maxCoeff();
  MatrixXd monodromy(2 * n, 2 * n);
  for (Index k = 0; k < 2 * n; ++k) {
    const VectorXd change = small * VectorXd::Unit(2 * n, k);
    const State more = after(b.chain, {y + change.head(n), change.tail(n)}, b.period(), steps),
                less = after(b.chain, {y - change.head(n), -change.tail(n)}, b.period(), steps);
    monodromy.col(k) << (more.y - less.y) / (2 * small), (more.v - less.v) / (2 * small);
  }
  const Eigen::VectorXcd lambda = Eigen::EigenSolver<MatrixXd>(monodromy, false).eigenvalues();
  std::vector<std::complex<double>> sorted(lambda.begin(), lambda.end());
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& p, const auto& q) {
    return std::abs(p - 1.0) < std::abs(q - 1.0);
  });
  return sorted;
}

double energy(const Breather& b, const VectorXd& y) {
  return energy_density(b.chain, at_rest(y)).sum();
}

void report_breather(Report& report) {
  const int steps = report.quick ? steps_per_period / 2 : steps_per_period;
  const VectorXd coarse = find_breather(standing, steps), fine = find_breather(standing, 2 * steps);
  report.table("standing")
      .add({{"amplitude", "largest displacement of the breather",
             compare(coarse.cwiseAbs().maxCoeff(), fine.cwiseAbs().maxCoeff())},
            {"energy", "its energy", compare(energy(standing, coarse), energy(standing, fine))}});

  // The multipliers, by their distance from +1
  const auto rough = multipliers(standing, coarse, steps),
             good = multipliers(standing, fine, 2 * steps);
  Table& circle = report.table("multipliers");
  for (std::size_t k = 0; k < good.size(); ++k)
    circle.add(
        {{"k", "order by the distance from +1", k + 1},
         {"real", "real part of the multiplier", good[k].real()},
         {"imag", "imaginary part of the multiplier", good[k].imag()},
         {"modulus", "modulus of the multiplier", compare(std::abs(rough[k]), std::abs(good[k]))},
         {"distance", "distance from +1",
          compare(std::abs(rough[k] - 1.0), std::abs(good[k] - 1.0)), "",
          "difference of two resolutions, against the largest"}});

  // The beads during one period
  Table& motion = report.table(
      "breather", {number("t", "time"), count("n", "site, counted from the centre", "site"),
                   number("y", "displacement")});
  const int frames = report.quick ? 20 : 80, stride = 2 * steps / frames;  // whole
  State now = at_rest(fine);
  for (int k = 0; k <= frames; ++k) {
    for (Index n = 0; n < fine.size(); ++n)
      motion.add({standing.period() * k / frames, n - fine.size() / 2, now.y[n]});
    now = after(standing.chain, now, standing.period() / frames, stride);
  }
}

/**
## The tail of the packet

The article says that travelling breathers decay faster than any exponential. An exponential falls by the same factor
from each bead to the next. So we take the mean energy of each bead over about a period, and the logarithm of this
factor from the bead with the most energy outwards (sec1/tail.hpp).

| beads ahead of the strongest | 0 | 4 | 8 | 10 | 11 | 12 | 13 |
|---|---|---|---|---|---|---|---|
| logarithm of the factor to the next | [0.10](cell:decay/side=ahead/beads=0/energy) | [5.314](cell:beads=4/energy) | [24.1](cell:beads=8/energy) | [60](cell:beads=10/energy) | [93](cell:beads=11/energy) | [141](cell:beads=12/energy) | [214](cell:beads=13/energy) |

Ahead of the packet the logarithm grows at every bead, until the energy underflows (`chain.travelling_decay`). Far out
each is about $3/2$ of the one before: such a bead is driven by the force $y_{n-1}^{3/2}$ of the bead behind it, and by
nothing else. At a single instant, and for the largest displacements, the logarithm grows likewise, except at one bead.
Behind the packet it grows only once: then come the waves that the impact leaves behind. */
std::vector<Sample> tail_of_packet(double h) {
  Impact impact = travelling;
  impact.time = tail_until;
  std::vector<Sample> samples;
  strike(impact, h, [&](double time, const State& now) {
    if (time >= tail_from) samples.push_back({energy_density(impact.chain, now), now.y});
    return true;
  });
  return samples;
}

void report_impacts(Report& report) {
  const double h = report.quick ? 5 * step_length : step_length;
  report
      .table("travelling", {estimate("speed", "speed of the packet after v_0 = 1 at s = 0",
                                     "site per unit of time")})
      .add({compare(packet_speed(travelling, h), packet_speed(travelling, h / 2))});
  const Turn coarse = turning_point(turning, h), fine = turning_point(turning, h / 2);
  report.table("turning").add(
      {{"site", "turning point after v_0 = 1.9 at s = 1", compare(coarse.site, fine.site), "site"},
       {"time", "its time", compare(coarse.time, fine.time)}});
  report_tail(report.table("decay"), tail_of_packet(h), tail_of_packet(h / 2));

  // The maps of the figure: densities averaged over a few units of time
  const int samples = report.quick ? 50 : 25;
  const Index shown = 60;
  Table& map = report.table(
      "impacts", {number("s", "anharmonicity of the wells"),
                  number("t", "time, middle of the samples averaged"), count("n", "site", "site"),
                  number("e", "energy density, averaged over the samples")});
  for (const Impact& impact : {travelling, turning}) {
    VectorXd mean = VectorXd::Zero(impact.chain.sites);
    strike(impact, h, [&](double time, const State& now) {
      mean += energy_density(impact.chain, now) / samples;
      if (std::lround(time / every) % samples != 0) return true;
      for (Index n = 0; n < shown; ++n)
        map.add({impact.chain.s, time - every * (samples - 1) / 2, n + 1, mean[n]});
      mean.setZero();
      return true;
    });
  }
}

/**
## Accuracy

Every number is computed with a step and with half of it, and the difference is given as its error. The figure shows
what happens as the step is halved again and again.

![Changes of speed and energy, and distances of multipliers from +1, against the step.](fig:x40)

Energy and speed change like $h^2$, as they should, and the fifth multiplier follows them down to about $10^{-5}$. Next
to $+1$ it is otherwise. The exact pair is a double eigenvalue, and an error $\eta$ of the matrix moves it by about
$\sqrt\eta$; so its distance from $+1$ falls only from 0.012 to 0.0007. The pinning pair settles near $2\cdot10^{-4}$,
though only at small steps: there the difference of two steps understates the error. The size of the differences,
`difference`, does not matter.

| number | here | the book's |
|---|---|---|
| speed of the packet, $v_0 = 1$, $s = 0$ | [0.1878](cell:travelling/speed) | 0.18780 (exercise 1) |
| turning point, $v_0 = 1.9$, $s = 1$, site | [20.055 ± 0.008](cell:turning/site) | [20.065 ± 0.006](cell:sec34_boomeron/turns/velocity=1.9/apex_site) |
| its time | [465.2 ± 0.4](cell:turning/time) | [467 ± 1](cell:sec34_boomeron/turns/velocity=1.9/apex_time) |
| amplitude of the breather, $\omega_b = 1.1$ | [0.01075](cell:standing/amplitude) | 0.01075 (exercise 2) |
| its energy | [1.536e-4](cell:standing/energy) | [1.536e-4](cell:sec32_barrier/key_pairs/s=0/omega=1.1/energy_site) |

So speed, amplitude and energy are correct to at least four digits. The time of the turning point is less certain than
its place: the path is flat there, and the mean that we take of it decides. */
struct Level {
  double h_impact, speed;
  double h_breather, energy, second, fourth, fifth;  // the last three: multipliers' distances
};

Level level(double h, int steps) {
  const VectorXd y = find_breather(standing, steps);
  const auto lambda = multipliers(standing, y, steps);
  const auto distance = [&](std::size_t k) { return std::abs(lambda[k - 1] - 1.0); };
  return {.h_impact = h,
          .speed = packet_speed(travelling, h),
          .h_breather = standing.period() / steps,
          .energy = energy(standing, y),
          .second = distance(2),
          .fourth = distance(4),
          .fifth = distance(5)};
}

void report_convergence(Report& report) {
  Table& table = report.table("convergence");
  double h = every / 2;
  int steps = steps_per_period / 8;
  Level here = level(h, steps);
  for (int halvings = 0; halvings < (report.quick ? 2 : 7); ++halvings) {
    h /= 2;
    steps *= 2;
    const Level next = level(h, steps);
    table.add({{"h_impact", "step of the impact", here.h_impact},
               {"speed", "relative change of the packet's speed in half the step",
                std::abs(next.speed / here.speed - 1)},
               {"h_breather", "step of the breather", here.h_breather},
               {"energy", "relative change of the breather's energy",
                std::abs(next.energy / here.energy - 1)},
               {"fifth", "relative change of the fifth multiplier's distance from +1",
                std::abs(next.fifth / here.fifth - 1)},
               {"fourth", "distance of the fourth multiplier from +1", here.fourth},
               {"second", "distance of the second multiplier from +1", here.second}});
    here = next;
  }
}

/**
## Questions that need better methods

Four questions of the article cannot be answered in this way. Each has its own chapters.

| question | why not here | what we do | where |
|---|---|---|---|
| the Peierls–Nabarro barrier (for discrete solitons Kivshar and Campbell 1993): by how much do the energies of the two kinds of breather differ? | by [1.62e-11](cell:sec32_barrier/key_pairs/s=0/omega=1.1/equal_frequency), and of the energies themselves this chapter knows four digits | contact events are located, orbits computed in extended precision | `sec32_barrier`, event_driven.hpp |
| how unstable is the breather, and in which wells? | of the pinning pair this chapter knows one digit | symmetries remove the exact pair; $\kappa = (\lambda+\lambda^{-1}-2)/4$ instead of $\lambda$ | `sec33_floquet` |
| the smallest kick that sets a breather in motion | it adds $c^2/2 \approx 10^{-11}$ to the energy; within each period Verlet's method changes it by more | impulses of contacts are exact, drift is compared with kick | `sec33_mobility`, `secA_integrators` |
| where is a packet long after it has turned? | the motion is chaotic: in the end it depends on the last digit of the start | two runs that agree, or a count over many runs | `sec34_boomeron`, `sec34_boomeron_map` |

The common cause is that the force has no second derivative where a contact opens or closes, so that integrators of high
order lose their order, and the linearised flow suffers even more (event_corrected.hpp, tangent.hpp). */
void reproduce(Report& report) {
  report_impacts(report);
  report_breather(report);
  report_convergence(report);
}

/**
## Statement by statement

<!-- statements -->
| statement | printed | here | verdict |
|---|---|---|---|
| `chain.travelling_decay`: travelling breathers that an impact excites are strongly localized: their decay is super-exponential | super-exponential | decay.energy (side = ahead, beads = 4), (side = ahead, beads = 5): 5.314 < 5.742 (the closest of 13) | holds, assuming |
<!-- /statements -->

## Try it

**To change it.** The constants under *The experiments* are the knobs. With `.v0 = 0.5` the packet of `travelling` is
slower and needs `.time = 450`; the program stops if a run is too short for what it reads from it. For `standing` try
`{.chain = {.sites = 11, .s = 0.5}, .omega_b = 1.05}`, or `.omega_b = 1.2`.

1. *Easy.* The packet by the methods of the book:
   `build/bin/sec34_impact run --velocity 1 --s 0 --sites 80 --time 330` gives `speed` = 0.18780. Hint: `--sites 80`
   restricts the fit of the speed to sites 20 to 60.
2. *Easy.* The breather to all digits: `build/bin/sec32_newton_breathers breather --omega 1.1` gives
   `amplitude` = 0.010747953 and `energy` = 1.53598520e-4. Hint: how many of these digits has this chapter?
3. *Harder.* Without wells: `build/bin/sec34_impact run --well none --velocity 1.87` gives `speed` = 0.952600. Find it
   with this chapter. Hint: in `report_impacts`, replace `travelling` in both calls of `packet_speed` by
   `Impact{.chain = {.sites = 100, .stiffness = 0}, .v0 = 1.87, .time = 100}`. Why must `travelling` itself stay? */
int main(int argc, char** argv) {
  return run({"sec1_the_chain", "1", "The chain, and what this book asks of it", reproduce}, argc,
             argv);
}
