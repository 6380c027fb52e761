/**
# 1 The chain: an impact, a breather and its stability

How does energy move in a Newton's cradle whose balls are held so stiffly, by short strings or by elastic beams, that
each oscillates while a pulse passes? James, Kevrekidis and Cuevas (Physica D 251, 2013) find packets of oscillations
that travel, packets that turn round, and packets that stay in place, the *breathers*. This chapter computes one of each
from the equation of motion, by the plainest methods: Verlet's for the motion, Newton's for the breather, differences
for its stability. In linear wells, after an impact with velocity 1, a packet travels at
[0.1878](cell:travelling/speed) sites per unit of time; in hard wells, after one with velocity 1.9, it turns round at
site [20.1](cell:turning/site). The breather is unstable, but barely: its multipliers lie on the unit circle, except a
pair next to $+1$ that makes a disturbance grow by 0.02 per cent in a period.

![A packet that travels (a) and one that turns round (b), each map divided by its largest energy; a site-centred
breather, its middle bead and those on one side (c), and its Floquet multipliers (d).](fig:x36)

The code needs the C++ standard library and Eigen. Of our own library it uses what writes tables, and `compare(coarse,
fine)`, which returns the finer value with its difference from the coarser one as error.

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
#include <string>
#include <vector>

#include "report/program.hpp"

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
of a contact are one; a bead alone oscillates at frequency one. The number $s$ makes the well linear ($s = 0$), hard ($s
> 0$) or soft ($s < 0$). These units are used throughout, except for experiments (cantilever.hpp converts). Beads are
counted from 1 at the impact (from 0 in the code), those of a breather from 0 in its middle. */
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
moved. Every result is computed with the given number of steps and with twice as many. */
struct Impact {
  Chain chain;
  double v0, time;  // impact velocity; for how long we follow it
};
const Impact travelling{.chain = {.sites = 100, .s = 0}, .v0 = 1, .time = 350};
const Impact turning{.chain = {.sites = 100, .s = 1}, .v0 = 1.9, .time = 900};
constexpr double every = 0.2;                        // time between observations
constexpr int steps_between = 10;                    // of Verlet's method, so h = 0.02
constexpr Index half_width = 5;                      // of the sites that belong to a packet
constexpr double fit_from = 20, fit_to = 60;         // sites between which the speed is fitted
constexpr double smoothing = 15;                     // time over which a turning path is averaged
constexpr double tail_from = 200, tail_until = 206;  // when the tail of a packet is observed

struct Breather {
  Chain chain;  // with an odd number of sites
  double omega_b;
  double period() const { return 2 * std::numbers::pi / omega_b; }
};
const Breather standing{.chain = {.sites = 11, .s = 0}, .omega_b = 1.1};
constexpr int coarsest = 100,
              halvings = 6;          // steps in a period, a multiple of 4; how often h is halved
constexpr double difference = 1e-6;  // for derivatives, relative to the largest displacement

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
void strike(const Impact& impact, int steps, Observe observe) {
  const Index sites = impact.chain.sites;
  State now{VectorXd::Zero(sites), VectorXd::Zero(sites)};
  now.v[0] = impact.v0;
  const int observations = int(std::lround(impact.time / every));
  for (int k = 1; k <= observations; ++k) {
    now = after(impact.chain, now, every, steps);
    if (now.v[sites - 1] != 0) throw Failure("the motion has reached the far end");
    if (!observe(k * every, now)) return;
  }
}

/**
## Where the packet is

The energy of a bead is its kinetic energy, that of its well and that of the contact to its right, Eq. (23). These
densities $e_n$ add up to the energy $\mathcal H$ of the chain, Eq. (6), which the motion conserves. The centre of a
packet is $X = \sum n\,e_n/\sum e_n$ over the eleven sites around its largest energy, Eq. (24), as far as the chain has
them. Its speed is the slope of the line of least squares through $X(t)$ between two sites. */
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
  const Index first = std::max<Index>(0, peak - half_width);
  const Index last = std::min(e.size() - 1, peak + half_width);
  double moment = 0, weight = 0;
  for (Index n = first; n <= last; ++n) {
    moment += double(n + 1) * e[n];
    weight += e[n];
  }
  return moment / weight;
}

double packet_speed(const Impact& impact, int steps) {
  double points = 0, sum_t = 0, sum_X = 0, sum_tX = 0, sum_tt = 0, X = 0;
  strike(impact, steps, [&](double t, const State& now) {
    X = packet_centre(impact.chain, now);
    if (X >= fit_from && X <= fit_to) {
      points += 1;
      sum_t += t;
      sum_X += X;
      sum_tX += t * X;
      sum_tt += t * t;
    }
    return X <= fit_to;
  });
  if (X <= fit_to) throw Failure("the packet does not get through the sites of the fit");
  return (points * sum_tX - sum_t * sum_X) / (points * sum_tt - sum_t * sum_t);
}

/**
## A packet that turns round

In hard wells a packet slows down, turns and comes back, though all beads and wells are alike; sec34_boomeron.cpp
follows it. Its centre oscillates with its beads; a mean over 15 units of time, about four periods of the beads, removes
this oscillation. The turning point is the furthest of these means, and the run ends when the packet is five sites
behind it. */
double turning_point(const Impact& impact, int steps) {
  const std::size_t samples = std::size_t(std::lround(smoothing / every));
  std::vector<double> X;
  double mean = 0, furthest = 0;
  strike(impact, steps, [&](double, const State& now) {
    X.push_back(packet_centre(impact.chain, now));
    if (X.size() < samples) return true;
    mean = 0;
    for (std::size_t k = 1; k <= samples; ++k) mean += X[X.size() - k] / double(samples);
    furthest = std::max(furthest, mean);
    return mean > furthest - half_width;
  });
  if (mean > furthest - half_width) throw Failure("the packet has not come back");
  return furthest;
}

/**
## The tail of a packet

The article says that travelling breathers decay faster than any exponential. An exponential falls by the same factor
from each bead to the next. So we take the mean energy of each bead over about a period, and the logarithm of this
factor from the bead with the most energy outwards.

| beads ahead of the strongest | 4 | 8 | 12 | 13 |
|---|---|---|---|---|
| logarithm of the factor to the next | [5.314](cell:decay/side=ahead/beads=4/energy) | [24.1](cell:beads=8/energy) | [141](cell:beads=12/energy) | [214](cell:beads=13/energy) |

Ahead of the packet the logarithm grows at every bead, until the energy underflows. Far out each is about $3/2$ of the
one before: such a bead is driven by the force $y_{n-1}^{3/2}$ of the bead behind it, and by nothing else. The verdict
on the article's sentence (`chain.travelling_decay`, below) assumes that *decay* means this, the mean energy ahead. At a
single instant, and for the largest displacements, the logarithm grows likewise except at one bead; behind the packet
it does not, since the waves that the impact leaves follow there after three beads. */
struct Tail {
  VectorXd energy, instant, displacement;  // sum over the samples, last of them, and largest
};

Tail tail_of_packet(int steps) {
  Impact impact = travelling;
  impact.time = tail_until;
  const VectorXd none = VectorXd::Zero(impact.chain.sites);
  Tail tail{none, none, none};
  strike(impact, steps, [&](double time, const State& now) {
    if (time < tail_from) return true;
    tail.instant = energy_density(impact.chain, now);
    tail.energy += tail.instant;
    tail.displacement = tail.displacement.cwiseMax(now.y.cwiseAbs());
    return true;
  });
  return tail;
}

// The factors, ahead of the packet and behind it
void report_tail(Table& table, const Tail& coarse, const Tail& fine) {
  const char* scale = "of two steps, against the largest";
  const Index behind = 10;  // so many beads
  Index peak = 0;
  fine.energy.maxCoeff(&peak);
  for (const bool ahead : {true, false})
    for (Index k = 0; ahead || k < behind; ++k) {
      const Index n = ahead ? peak + k : peak - k, next = ahead ? n + 1 : n - 1;
      if (coarse.instant[next] < 1e-300) break;
      const auto fall = [&](const VectorXd& rough, const VectorXd& good) {
        return compare(std::log(rough[n] / rough[next]), std::log(good[n] / good[next]));
      };
      table.add({{"side", "of the packet: ahead or behind", ahead ? "ahead" : "behind"},
                 {"beads", "from the bead with the most energy", k},
                 {"energy", "logarithm of the mean energy over that of the next bead outwards",
                  fall(coarse.energy, fine.energy), "", scale},
                 {"instant", "the same of the energies at the last instant",
                  fall(coarse.instant, fine.instant), "", scale},
                 {"displacement", "the same of the largest displacements",
                  fall(coarse.displacement, fine.displacement), "", scale}});
    }
}

// All three results, with the given steps and with twice as many
void report_impacts(Report& report, int steps) {
  const Estimate speed =
                     compare(packet_speed(travelling, steps), packet_speed(travelling, 2 * steps)),
                 turn = compare(turning_point(turning, steps), turning_point(turning, 2 * steps));
  const std::string unit = "site per unit of time";
  report.table("travelling", {estimate("speed", "of the packet after v_0 = 1 at s = 0", unit)})
      .add({speed});
  report.table("turning", {estimate("site", "turning point after v_0 = 1.9 at s = 1", "site")})
      .add({turn});
  report_tail(report.table("decay"), tail_of_packet(steps), tail_of_packet(2 * steps));
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
one equation per bead for the unknown positions $y_n(0)$. */
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
  const double size = y.cwiseAbs().maxCoeff();
  const double small = difference * size;
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

We sort them by their distance from $+1$. The first two are real and keep their distance,
[0.000215 ± 5e-6](cell:multipliers/k=2/distance), as the step is refined: they are the pinning pair
([0.000214](cell:sec33_floquet/spectra/centre=site/omega=1.1/s=0/fourth) in `sec33_floquet`). The next two tend to $+1$
(figure x40): they are the exact pair. All others lie on the unit circle, to 8 digits. So the breather is unstable
against a shift along the chain, but only weakly: such a shift grows by 0.02 per cent in a period. */
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

/**
## Accuracy

![Changes of speed and energy in the last halving, and distances of multipliers from +1, against the step.](fig:x40)

Energy and speed converge like $h^2$, as they should. Next to $+1$ it is otherwise. The linearised motion is less smooth
than the motion, and its error falls only like $h^{3/2}$ (`secA_integrators`); and an error of a matrix moves a double
eigenvalue by about its square root. So the exact pair should approach $+1$ like $h^{3/4}$, by a factor 13 in the figure
(dotted), and it does so roughly. The pinning pair settles only at steps below 0.003. It changes by 1 per cent from 400
to 800 steps in a period and by 12 from 1600 to 3200: at long steps one halving understates the error.

The turning point, site [20.055 ± 0.008](cell:turning/site), agrees with that of `sec34_boomeron`,
[20.065 ± 0.006](cell:sec34_boomeron/turns/velocity=1.9/apex_site), and the energy of the breather,
[1.5360e-4](cell:standing/energy), with that of `sec32_barrier`,
[1.53599e-4](cell:sec32_barrier/key_pairs/s=0/omega=1.1/energy_site). */
void report_breather(Report& report, int finer) {
  struct Level {
    double speed, amplitude, energy;
    std::vector<std::complex<double>> multiplier;

    double from_one(std::size_t k) const { return std::abs(multiplier[k - 1] - 1.0); }
  };
  Table& convergence = report.table("convergence");
  Level last, now;
  VectorXd y;
  for (int k = 0; k <= finer; ++k) {
    const int steps = coarsest << k, between = 2 << k;
    y = find_breather(standing, steps);
    last = now;
    now = {packet_speed(travelling, between), y.cwiseAbs().maxCoeff(), energy(standing, y),
           multipliers(standing, y, steps)};
    if (k == 0) continue;
    convergence.add({{"h_impact", "step of the impact", every / between},
                     {"speed", "relative change of the packet's speed since twice the step",
                      std::abs(now.speed / last.speed - 1)},
                     {"h_breather", "step of the breather", standing.period() / steps},
                     {"energy", "relative change of the breather's energy",
                      std::abs(now.energy / last.energy - 1)},
                     {"fourth", "distance of the fourth multiplier from +1", now.from_one(4)},
                     {"second", "distance of the second multiplier from +1", now.from_one(2)}});
  }
  report.table("standing")
      .add({{"amplitude", "largest displacement of the breather",
             compare(last.amplitude, now.amplitude)},
            {"energy", "its energy", compare(last.energy, now.energy)}});

  // The multipliers, by their distance from +1
  Table& circle = report.table("multipliers");
  for (std::size_t k = 1; k <= now.multiplier.size(); ++k)
    circle.add({{"k", "order by the distance from +1", k},
                {"real", "real part of the multiplier", now.multiplier[k - 1].real()},
                {"imag", "imaginary part of the multiplier", now.multiplier[k - 1].imag()},
                {"distance", "distance from +1", compare(last.from_one(k), now.from_one(k)), "",
                 "difference of two resolutions, against the largest"}});

  // The beads during one period
  Table& motion = report.table(
      "breather", {number("t", "time"), count("n", "site, counted from the centre", "site"),
                   number("y", "displacement")});
  State state = at_rest(y);
  for (int k = 0; k <= coarsest; ++k) {
    for (Index n = 0; n < y.size(); ++n)
      motion.add({standing.period() * k / coarsest, n - y.size() / 2, state.y[n]});
    state = after(standing.chain, state, standing.period() / coarsest, 1 << finer);
  }
}

// The maps of the figure: energy densities averaged over a few units of time
void report_maps(Report& report, int steps) {
  const int samples = report.quick ? 50 : 25;
  const Index shown = 60;
  Table& map = report.table(
      "impacts", {number("s", "anharmonicity of the wells"),
                  number("t", "time, middle of the samples averaged"), count("n", "site", "site"),
                  number("e", "energy density, averaged over the samples")});
  for (const Impact& impact : {travelling, turning}) {
    VectorXd mean = VectorXd::Zero(impact.chain.sites);
    strike(impact, steps, [&](double time, const State& now) {
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
## Questions that need better methods

Four questions of the article cannot be answered in this way. Each has its own chapters.

| question | why not here | what we do | where |
|---|---|---|---|
| the Peierls–Nabarro barrier (for discrete solitons Kivshar and Campbell 1993): by how much do the energies of the two kinds of breather differ? | by [1.62e-11](cell:sec32_barrier/key_pairs/s=0/omega=1.1/equal_frequency); this chapter knows the energies to $10^{-9}$ | contact events are located, orbits computed in extended precision | `sec32_barrier`, event_driven.hpp |
| how unstable is the breather, and in which wells? | of the pinning pair this chapter knows two digits, at small steps | symmetries remove the exact pair; $\kappa = (\lambda+\lambda^{-1}-2)/4$ instead of $\lambda$ | `sec33_floquet` |
| the smallest kick that sets a breather in motion | it adds about $2\cdot10^{-11}$ to the energy | impulses of contacts are exact, drift is compared with kick | `sec33_mobility`, `secA_integrators` |
| where is a packet long after it has turned? | the path becomes sensitive to the step | two runs that agree, or a count over many runs | `sec34_boomeron`, `sec34_boomeron_map` |

Two things stand behind the first three rows: differences far below an error that falls like $h^2$, and a force without
a second derivative at a contact event, which takes the order from better integrators (event_corrected.hpp) and spoils
the linearised motion even more (tangent.hpp). The fourth is a property of the motion. */
void reproduce(Report& report) {
  const int steps = report.quick ? steps_between / 5 : steps_between;
  report_impacts(report, steps);
  report_breather(report, report.quick ? 3 : halvings);
  report_maps(report, steps);
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
   `amplitude` = 0.010747953 and `energy` = 1.53598520e-4. Hint: how many of these digits has this chapter, with
   [0.0107479](cell:standing/amplitude)?
3. *Harder.* Without wells: `build/bin/sec34_impact run --well none --velocity 1.87` gives `speed` = 0.952600. Find it
   with this chapter. Hint: in `report_impacts`, replace `travelling` in both calls of `packet_speed` by
   `Impact{.chain = {.sites = 100, .stiffness = 0}, .v0 = 1.87, .time = 100}`. Why must `travelling` itself stay? */
int main(int argc, char** argv) {
  return run({"sec1_the_chain", "1", "An impact, a breather and its stability", reproduce}, argc,
             argv);
}
