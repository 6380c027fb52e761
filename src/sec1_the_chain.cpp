/**
# 1 The chain: an impact, a breather and its stability

How does energy move in a Newton's cradle whose balls are held so stiffly, by short strings or by elastic beams, that
each oscillates while a pulse passes? James, Kevrekidis and Cuevas (Physica D 251, 2013) find packets of oscillations
that travel, packets that turn round, and packets that stay in place, the *breathers*. This chapter computes one of each
from the equation of motion, and the stability of the breather, in a hundred and fifty lines of code.

![A packet that travels, one that turns round, a breather, and its Floquet multipliers.](fig:x36)

The code needs the C++ standard library and Eigen. Of our own library it uses only what writes its tables: `Report`,
`Estimate` and `compare(coarse, fine)`, which is the finer value with its difference from the coarser one as error, and
`Failure`, an exception. The chapter ends with the accuracy of its numbers, with the questions that this simple method
cannot answer, and with the chapters that answer them. */

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
of a contact are one; a bead alone oscillates at frequency one. The number $s$ makes the well harmonic ($s = 0$), hard
($s > 0$) or soft ($s < 0$). These units are used throughout, except for experiments (cantilever.hpp converts). */
struct Chain {
  Index sites;
  double s = 0;  // anharmonicity of the wells

  double well(double y) const { return y * y / 2 + s * y * y * y * y / 4; }  // W
  double pull(double y) const { return -y - s * y * y * y; }                 // -W'
};

// Hertz's law: the force between two beads that overlap by x
double push(double x) {
  return x > 0 ? x * std::sqrt(x) : 0;
}

VectorXd acceleration(const Chain& chain, const VectorXd& y) {
  VectorXd a(chain.sites);
  for (Index n = 0; n < chain.sites; ++n) a[n] = chain.pull(y[n]);
  for (Index n = 1; n < chain.sites; ++n) {
    const double force = push(y[n - 1] - y[n]);
    a[n - 1] -= force;
    a[n] += force;
  }
  return a;
}

/**
## A step in time

Verlet's method gives the beads half a kick, moves them, and gives them the other half. Like the equation, it is
symplectic and reversible. Its error falls like $h^2$. */
struct State {
  VectorXd y, v;
};

void step(const Chain& chain, State& now, double h) {
  now.v += h / 2 * acceleration(chain, now.y);
  now.y += h * now.v;
  now.v += h / 2 * acceleration(chain, now.y);
}

State after(const Chain& chain, State now, double time, int steps) {
  for (int k = 0; k < steps; ++k) step(chain, now, time / steps);
  return now;
}

/**
The energy of a bead is its kinetic energy, that of its well and that of the contact to its right, Eq. (23). The
densities $e_n$ add up to the energy $\mathcal H$ of the chain, Eq. (6), which the motion conserves. */
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

/**
## An impact, and its packet

We strike the first bead of a chain at rest with the velocity $v_0$, Eq. (26), and sample the energy every 0.2 units of
time, about thirty times in an oscillation. Ahead of the packet the displacements fall off so fast that after a few
beads they underflow to zero. So the length of the chain does not matter as long as its last bead has not moved. */
constexpr double every = 0.2;

template <class Look>
void strike(const Chain& chain, double v0, double h, Look look) {
  State now{VectorXd::Zero(chain.sites), VectorXd::Zero(chain.sites)};
  now.v[0] = v0;
  for (int k = 1;; ++k) {
    now = after(chain, now, every, int(std::lround(every / h)));
    if (now.v[chain.sites - 1] != 0) throw Failure("the motion has reached the far end");
    if (!look(k * every, energy_density(chain, now), now.y)) return;
  }
}

/**
We locate the packet by its energy. Several packets may leave the struck end. The foremost one is at the first site,
counted from the far end, whose energy is the largest of the eleven around it, provided that these hold at least a
hundredth of the total. Its centre is $X = \sum n\,e_n/\sum e_n$ over these sites, Eq. (24). Here bead `n` has the
number $n+1$, so that the first is number one; while the largest energy is within the first five, the sum runs over
the first six. */
Index foremost(const VectorXd& e) {
  for (Index n = e.size() - 6; n >= 5; --n) {
    const VectorXd window = e.segment(n - 5, 11);
    if (e[n] == window.maxCoeff() && window.sum() > e.sum() / 100) return n;
  }
  return 0;
}

double centre(const VectorXd& e, Index peak) {
  double moment = 0, weight = 0;
  for (Index n = std::max<Index>(0, peak - 5); n <= std::min(e.size() - 1, peak + 5); ++n) {
    moment += double(n + 1) * e[n];
    weight += e[n];
  }
  return moment / weight;
}

// The speed is the slope of a least-squares line through X(t) between sites 20 and 60
double packet_speed(double v0, double h) {
  const Chain chain{100};
  std::vector<double> t, x;
  strike(chain, v0, h, [&](double time, const VectorXd& e, const VectorXd&) {
    const double at = centre(e, foremost(e));
    if (at >= 20 && at <= 60) t.push_back(time), x.push_back(at);
    return at <= 60;
  });
  const VectorXd T = Eigen::Map<VectorXd>(t.data(), Index(t.size())),
                 X = Eigen::Map<VectorXd>(x.data(), Index(x.size()));
  const VectorXd from_mean = T.array() - T.mean();
  return from_mean.dot(X) / from_mean.squaredNorm();
}

/**
The article says that these packets decay faster than any exponential. An exponential falls by the same factor from each
bead to the next. We take the mean energy of each bead over 6.2 units of time, about a period, from $t = 200$ on, and
the logarithm of this factor from the bead with the most energy outwards. Ahead of it, it grows at every bead, from
[0.10](cell:decay/side=ahead/beads=0/energy) to [214](cell:decay/side=ahead/beads=13/energy) thirteen beads on, after
which the energy underflows (`chain.travelling_decay`). At a single instant, and for the largest displacements, it grows
likewise, with one step back. Behind the packet it grows over two beads only: then come the waves that the impact
leaves behind. */
struct Sizes {
  VectorXd energy, instant, displacement;  // mean, at the end of the interval, largest modulus
};

Sizes packet_sizes(double h) {
  const Index sites = 100;
  Sizes now{VectorXd::Zero(sites), VectorXd::Zero(sites), VectorXd::Zero(sites)};
  strike({sites}, 1, h, [&](double time, const VectorXd& e, const VectorXd& y) {
    if (time < 200) return true;
    now.energy += e, now.instant = e;
    now.displacement = now.displacement.cwiseMax(y.cwiseAbs());
    return time < 206;
  });
  return now;
}

void report_decay(Report& report, double h) {
  const std::array<Sizes, 2> runs{packet_sizes(h), packet_sizes(h / 2)};
  Index peak = 0;
  runs[1].energy.maxCoeff(&peak);
  Table& table = report.table("decay");
  for (Index way : {1, -1})
    for (Index n = peak, beads = 0; beads < (way > 0 ? 20 : 10); n += way, ++beads) {
      const auto fall = [&](VectorXd Sizes::*size) {
        const auto of = [&](const Sizes& run) {
          return std::log((run.*size)[n] / (run.*size)[n + way]);
        };
        return compare(of(runs[0]), of(runs[1]));
      };
      // The displacement is the last to underflow
      if (runs[0].instant[n + way] < 1e-300) break;
      const char* scale = "of two steps, against the largest";
      table.add({{"side", "of the packet: ahead or behind", way > 0 ? "ahead" : "behind"},
                 {"beads", "from the bead with the most energy", beads},
                 {"energy", "logarithm of the mean energy over that of the next bead outwards",
                  fall(&Sizes::energy), "", scale},
                 {"instant", "the same of the energies at the last instant", fall(&Sizes::instant),
                  "", scale},
                 {"displacement", "the same of the largest displacements",
                  fall(&Sizes::displacement), "", scale}});
    }
}

/**
## A packet that turns round

In hard wells a packet slows down, turns and comes back. We now follow the strongest packet, which on its way back need
not be the foremost one. Its centre swings, because its beads oscillate; averaging over 15 units of time, about four of
their periods, removes that. The turning point is the furthest of these means. */
struct Turn {
  double site = 0, time = 0;
};

Turn turning_point(double v0, double s, double h) {
  const Chain chain{100, s};
  const int looks = 75;
  std::vector<double> x;
  Turn turn;
  strike(chain, v0, h, [&](double time, const VectorXd& e, const VectorXd&) {
    Index peak = 0;
    e.maxCoeff(&peak);
    x.push_back(centre(e, peak));
    if (x.size() < looks) return true;
    double mean = 0;
    for (int k = 0; k < looks; ++k) mean += x[x.size() - 1 - std::size_t(k)] / looks;
    if (mean > turn.site) turn = {mean, time - every * (looks - 1) / 2};
    return mean > turn.site - 5 && time < 1000;
  });
  return turn;
}

/**
## A breather

A breather is a time-periodic motion, with frequency $\omega_b$ and period $T_b = 2\pi/\omega_b$, that is confined to a
few beads. A bead alone oscillates at frequency one. Like the well, a contact pushes a bead back, and so raises the
frequency: breathers have $\omega_b > 1$, and those near one are small. (At small amplitudes this holds in hard and soft
wells too: the push grows with the power $3/2$, the anharmonic force with the power 3.) They do not radiate, since
contacts without a linear part carry no linear waves. In the tail each amplitude is about the power $3/2$ of the one
before, so the decay is faster than any exponential. There are two kinds, symmetric about a bead (*site-centred*) or
about a contact (*bond-centred*).

How does one find a site-centred one? Let it start from rest, so that it is even in time. Half a period later it is its
own mirror image with the sign changed, $y_n(t+T_b/2) = -y_{-n}(t)$. Both symmetries together give conditions after a
*quarter* of the period,
$$y_n + y_{-n} = 0,\qquad \dot y_n - \dot y_{-n} = 0 \qquad\text{at } t = T_b/4,$$
one equation per bead for the unknown positions $y_n(0)$. */
constexpr double omega_b = 1.1, period = 2 * std::numbers::pi / omega_b;
const Chain chain_of_breather{11};

VectorXd residual(const Chain& chain, const VectorXd& y, int steps) {
  const State end = after(chain, {y, VectorXd::Zero(chain.sites)}, period / 4, steps / 4);
  VectorXd r(chain.sites);
  for (Index n = 0, m = chain.sites - 1; n < chain.sites; ++n, --m)
    r[n] = n <= m ? end.y[n] + end.y[m] : end.v[n] - end.v[m];
  return r;
}

/**
Small breathers obey the discrete $p$-Schrödinger (DpS) equation of section 3.1. From it the article derives a profile
of known size, Eqs. (18) to (20): $y_n(0) = 2\epsilon\,(-1)^n\,[g(n+\frac12)+g(n-\frac12)]$ with
$g(x) = (\frac3{10})^3\cos^6(x/3)$ and $\epsilon = (2\tau_0(\omega_b-1))^2$. It differs from the breather by twelve per
cent, close enough for Newton's method to converge. */
VectorXd guess(const Chain& chain) {
  const double tau_0 = 5 * std::pow(std::tgamma(0.25), 2) / (24 * std::sqrt(std::numbers::pi));
  const double eps = std::pow(2 * tau_0 * (omega_b - 1), 2);
  const auto g = [](double x) {
    const double edge = 1.5 * std::numbers::pi;
    return std::abs(x) < edge ? 0.027 * std::pow(std::cos(x / 3), 6) : 0.0;
  };
  VectorXd y(chain.sites);
  for (Index i = 0; i < chain.sites; ++i) {
    const Index n = i - chain.sites / 2;
    y[i] = 2 * eps * (n % 2 == 0 ? 1 : -1) * (g(double(n) + 0.5) + g(double(n) - 0.5));
  }
  return y;
}

// Newton's method; each column of the derivative is a difference of two residuals
VectorXd breather(const Chain& chain, int steps) {
  VectorXd y = guess(chain);
  const double size = y.cwiseAbs().maxCoeff();
  std::string history;
  for (int k = 0; k < 10; ++k) {
    const VectorXd r = residual(chain, y, steps);
    history += " " + short_text(r.cwiseAbs().maxCoeff() / size);
    if (r.cwiseAbs().maxCoeff() < 1e-12 * size) return y;
    MatrixXd derivative(chain.sites, chain.sites);
    for (Index n = 0; n < chain.sites; ++n) {
      VectorXd near = y;
      near[n] += 1e-6 * size;
      derivative.col(n) = (residual(chain, near, steps) - r) / (1e-6 * size);
    }
    y -= derivative.partialPivLu().solve(r);
  }
  throw Failure("Newton's method does not converge, relative residuals" + history);
}

/**
## Is it stable?

In one period a small disturbance of the breather is multiplied by the *monodromy* matrix, whose eigenvalues are the
Floquet multipliers $\lambda$. If one lies outside the unit circle, some disturbance grows. The columns of the matrix
are again differences. The equation is Hamiltonian, so multipliers come in pairs $\lambda$, $1/\lambda$. One pair is
exactly $+1$, because the breather may be shifted in time. Another, the *pinning pair*, is very close to it, because the
breather may almost be shifted along the chain. */
std::vector<std::complex<double>> multipliers(const Chain& chain, const VectorXd& y, int steps) {
  const Index n = chain.sites;
  const double small = 1e-6 * y.cwiseAbs().maxCoeff();
  MatrixXd monodromy(2 * n, 2 * n);
  for (Index k = 0; k < 2 * n; ++k) {
    const VectorXd change = small * VectorXd::Unit(2 * n, k);
    const State more = after(chain, {y + change.head(n), change.tail(n)}, period, steps),
                less = after(chain, {y - change.head(n), -change.tail(n)}, period, steps);
    monodromy.col(k) << (more.y - less.y) / (2 * small), (more.v - less.v) / (2 * small);
  }
  const Eigen::VectorXcd lambda = Eigen::EigenSolver<MatrixXd>(monodromy, false).eigenvalues();
  std::vector<std::complex<double>> sorted(lambda.begin(), lambda.end());
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
    const double to_a = std::abs(a - 1.0), to_b = std::abs(b - 1.0);
    return to_a != to_b ? to_a < to_b : a.imag() > b.imag();
  });
  return sorted;
}

/**
## Accuracy

Every number is computed with a step and with half of it; the difference is its error. The turning point also depends on
how the path is smoothed. The last column has the same number by the methods of the later chapters.

| number | here | the book's |
|---|---|---|
| speed of the packet, $v_0 = 1$, $s = 0$ | [0.1878](cell:travelling/speed) | 0.18780 (exercise 1) |
| turning point, $v_0 = 1.9$, $s = 1$, site | [20.055 ± 0.008](cell:turning/site) | [20.065 ± 0.006](cell:sec34_boomeron/turns/velocity=1.9/apex_site) |
| its time | [465.2 ± 0.4](cell:turning/time) | [467 ± 1](cell:sec34_boomeron/turns/velocity=1.9/apex_time) |
| amplitude of the breather, $\omega_b = 1.1$ | [0.01075](cell:standing/amplitude) | 0.01075 (exercise 2) |
| its energy | [1.536e-4](cell:standing/energy) | [1.536e-4](cell:sec32_barrier/key_pairs/s=0/omega=1.1/energy_site) |
| distance of the fifth multiplier from $+1$ | [0.229543 ± 3e-6](cell:multipliers/k=5/distance) | [0.229543](cell:sec33_floquet/spectra/centre=site/omega=1.1/s=0/fifth) |
| of the fourth (here of the split exact pair, there of the pinning pair) | [0.003 ± 0.002](cell:multipliers/k=4/distance) | [0.000214](cell:sec33_floquet/spectra/centre=site/omega=1.1/s=0/fourth) |

So speed, amplitude and energy are correct to at least four digits, the fifth multiplier to five, and the turning point
to three in space and two in time. No digit of the distances of the four multipliers next to $+1$ is known, and there
the difference of two steps understates the error. */
void report_impacts(Report& report) {
  const double h = report.quick ? 0.1 : 0.02;
  report
      .table("travelling", {estimate("speed", "speed of the packet after v_0 = 1 at s = 0",
                                     "site per unit of time")})
      .add({compare(packet_speed(1, h), packet_speed(1, h / 2))});
  report_decay(report, h);
  const Turn coarse = turning_point(1.9, 1, h), fine = turning_point(1.9, 1, h / 2);
  report.table("turning").add(
      {{"site", "turning point after v_0 = 1.9 at s = 1", compare(coarse.site, fine.site), "site"},
       {"time", "its time", compare(coarse.time, fine.time)}});

  // The maps of the figure: densities averaged over a few units of time
  const int looks = report.quick ? 50 : 25;
  Table& map = report.table(
      "impacts", {number("s", "anharmonicity of the wells"),
                  number("t", "time, middle of the averaging interval"), count("n", "site", "site"),
                  number("e", "energy density, averaged over the interval")});
  for (const auto& [s, v0, time] : {std::array{0.0, 1.0, 300.0}, {1.0, 1.9, 900.0}}) {
    VectorXd sum = VectorXd::Zero(100);
    strike({100, s}, v0, h, [&](double now, const VectorXd& e, const VectorXd&) {
      sum += e / looks;
      if (std::lround(now / every) % looks != 0) return true;
      for (Index n = 0; n < 60; ++n) map.add({s, now - every * looks / 2, n + 1, sum[n]});
      sum.setZero();
      return now < time - every;
    });
  }
}

void report_breather(Report& report) {
  const int steps = report.quick ? 400 : 800;
  const VectorXd coarse = breather(chain_of_breather, steps),
                 fine = breather(chain_of_breather, 2 * steps);
  const auto both = [&](auto number) { return compare(number(coarse), number(fine)); };
  const auto energy = [](const VectorXd& y) {
    return energy_density(chain_of_breather, {y, 0 * y}).sum();
  };
  report.table("standing")
      .add({{"amplitude", "largest displacement of the breather",
             both([](const VectorXd& y) { return y.cwiseAbs().maxCoeff(); })},
            {"energy", "its energy", both(energy)}});

  // The beads during one period
  Table& motion = report.table(
      "breather", {number("t", "time"), count("n", "site, counted from the centre", "site"),
                   number("y", "displacement")});
  const int frames = report.quick ? 20 : 80;
  State now{fine, VectorXd::Zero(fine.size())};
  for (int k = 0; k <= frames; ++k) {
    for (Index n = 0; n < fine.size(); ++n)
      motion.add({period * k / frames, n - fine.size() / 2, now.y[n]});
    now = after(chain_of_breather, now, period / frames, 2 * steps / frames);
  }

  // The multipliers, by their distance from +1
  const auto rough = multipliers(chain_of_breather, coarse, steps),
             good = multipliers(chain_of_breather, fine, 2 * steps);
  Table& circle = report.table("multipliers");
  for (std::size_t k = 0; k < good.size(); ++k)
    circle.add({{"k", "order by the distance from +1", k + 1},
                {"real", "real part of the multiplier", good[k].real()},
                {"imag", "imaginary part of the multiplier", good[k].imag()},
                {"error", "difference of two resolutions", std::abs(good[k] - rough[k])},
                {"distance", "distance from +1",
                 compare(std::abs(rough[k] - 1.0), std::abs(good[k] - 1.0)), "",
                 "difference of two resolutions, against the largest"}});
}

/**
## Questions that need better methods

Four questions of the article cannot be answered in this way. Each has its own chapters.

| question | why not here | what we do | where |
|---|---|---|---|
| the barrier: by how much do the energies of the two kinds of breather differ? | [1.62e-11](cell:sec32_barrier/key_pairs/s=0/omega=1.1/equal_frequency), while the energies themselves are [1.536e-4](cell:sec32_barrier/key_pairs/s=0/omega=1.1/energy_bond), of which this chapter knows four digits | contact events are located, orbits computed in extended precision | `sec32_barrier`, event_driven.hpp |
| are the multipliers next to $+1$ on the circle? | an error $\eta$ of the monodromy moves them by $\sqrt\eta$: two that are exactly $+1$ appear at a distance of [0.003 ± 0.002](cell:multipliers/k=4/distance) | symmetries remove the exact pair; $\kappa = (\lambda+\lambda^{-1}-2)/4$ instead of $\lambda$ | `sec33_floquet` |
| the smallest kick that sets a breather in motion | it adds $c^2/2 \approx 10^{-11}$ to the energy; within each period Verlet's method changes it by more | impulses of contacts are exact, drift is compared with kick | `sec33_mobility`, `secA_integrators` |
| where is a packet long after it has turned? | the motion is chaotic: late fates depend on the last digit of the start | two runs that agree, or a count over many runs | `sec34_boomeron`, `sec34_boomeron_map` |

The common cause is that the force has no second derivative where a contact opens or closes, so that integrators of high
order lose their order, and the linearised flow suffers even more (event_corrected.hpp, tangent.hpp).

## Statement by statement

<!-- statements -->
| statement | printed | here | verdict |
|---|---|---|---|
| `chain.travelling_decay`: travelling breathers that an impact excites are strongly localized: their decay is super-exponential | super-exponential | decay.energy (side = ahead, beads = 4), (side = ahead, beads = 5): 5.314 < 5.742 (the closest of 13) | holds, assuming |
<!-- /statements -->

## Symbols

Each has one meaning unless a chapter says otherwise.

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
| $T$ | inverse speed of a travelling breather: the time after which the next site does the same |

## Try it

1. *Easy.* The packet by the methods of the book:
   `build/bin/sec34_impact run --velocity 1 --s 0 --sites 80 --time 330` gives `speed` = 0.18780. Hint: `--sites 80`
   restricts the fit of the speed to sites 20 to 60.
2. *Harder.* Without wells: `build/bin/sec34_impact run --well none --velocity 1.87` gives `speed` = 0.952600. Which
   lines of this chapter must change for that? Hint: two, and the argument of `packet_speed`. */
void reproduce(Report& report) {
  report_impacts(report);
  report_breather(report);
}

int main(int argc, char** argv) {
  return run({"sec1_the_chain", "1", "The chain, and what this book asks of it", reproduce}, argc,
             argv);
}
