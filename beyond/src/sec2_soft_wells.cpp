/**
# 2 A breather in ever softer wells

Section 2 of James, Kevrekidis and Cuevas (Physica D 251, 2013) ends with the remark that wells spoil the proof of its
theorem, and section 3 finds breathers in them. What happens in between, to a breather whose wells are made softer and
softer at a fixed period? It may be lost at some stiffness, if its branch turns back or its size diverges, or it may
persist and cease to be localized only where there are no wells. The article does not ask. We follow the breather, and
see it spread until many contacts share the mean force. A rule of equal areas tells what becomes of it where the wells
vanish.

![A breather spreads as its wells are made softer (a); width, amplitude and central mean force (b), which
tends to the value that an equal-area rule demands.](fig:x17) */
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "lattice/diagnostics/observe.hpp"
#include "lattice/gsl/gsl_ode.hpp"
#include "lattice/numerics/parallel.hpp"
#include "lattice/orbits/breather.hpp"
#include "report/program.hpp"
#include "sec2/mean_force.hpp"

using namespace lattice;

/**
## Model and method

The chain is that of Eq. (9) in wells $W = \frac12ky^2$, $k = W''(0)$ (`kappa` in the tables),
$$\ddot y_n + k\,y_n = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2},\qquad y_n(t+2\pi) = y_n(t),$$
where everything is dimensionless. A breather is found as in sec2_nonexistence.cpp, by Newton's method for motions that
return after a period; of its two kinds we take the one around a bond, in which two neighbours swing against each other.
The substitution $y(t) = k^2\,Y(\sqrt k\,t)$ restores unit wells, so a soft well at period $2\pi$ is the same problem as
a unit well at the high frequency $\omega_b = 1/\sqrt k$. We follow the branch in $\ln k$ itself, with a well of our
own, and keep the substitution as a check. */
struct Spring {
  double k = 1;
  static constexpr const char* name = "spring";
  template <class T>
  T energy(T y) const {
    return T(k) / T(2) * (y * y);
  }
  template <class T>
  T force(T y) const {
    return -T(k) * y;
  }
  template <class T>
  T stiffness(T) const {
    return T(k);
  }
};

/**
## The branch

The branch begins at $k = 1/2$, where the substitution turns a breather in unit wells into its first point. From there
it is continued in its arclength, a parameter that goes on growing where $k$ itself turns back, so that a fold would be
noticed. */
/// The bond-centred breather of period 2 pi in springs with k = 1 / omega_b^2, by substitution.
Shooting<double> spring_problem(double k, std::size_t sites) {
  return {{sites, Spring{k}, Hertz{0}}, bond_centred(sites), 1};
}

Orbit<double> substituted(double k, std::size_t sites) {
  const auto unit = find_breather(breather_problem(Centre::bond, 1 / std::sqrt(k), 0, sites));
  return newton(spring_problem(k, sites), (k * k * unit.x).eval());
}

/**
We stop at stiffnesses that fall by factors of $\sqrt2$. With $\bar F_n$, the time average of the push of bead $n$ on
bead $n+1$, the width of a breather is the number of contacts that share this force, $(\sum\bar F_n)^2/\sum\bar F_n^2$.
Chains of two lengths tell whether the ends matter. */
constexpr std::array<std::size_t, 2> lengths{92, 104};

struct Breather {
  double k, amplitude, energy, width, central;
  std::vector<double> contact;

  Breather(const Shooting<double>& problem, const Orbit<double>& orbit)
      : k(problem.chain.well.as<Spring>().k),
        amplitude(orbit.amplitude),
        energy(orbit.energy),
        contact(mean_forces(problem.chain, orbit.start, orbit.period(), 1e-11).contact) {
    width = participation(contact);
    central = contact[contact.size() / 2];
  }
};

std::vector<Breather> softer_and_softer(std::size_t sites, std::size_t count) {
  Shooting<double> problem = spring_problem(0.5, sites);
  const Along<double> along{
      "ln k", [](const Shooting<double>& p) { return std::log(p.chain.well.as<Spring>().k); },
      [](Shooting<double>& p, const double& l) { p.chain.well = Spring{std::exp(l)}; }, 1e-4};
  Orbit<double> orbit = substituted(0.5, sites);
  std::vector<Breather> out{{problem, orbit}};
  Stride stride;
  stride.most = 1;
  for (std::size_t i = 1; i < count; ++i) {
    Branch branch(problem, along, orbit, -1, {}, stride);
    const double goal = std::log(0.5) - 0.5 * std::numbers::ln2 * double(i);
    orbit = branch.reach(goal);
    problem.chain.well = Spring{std::exp(goal)};
    out.emplace_back(problem, orbit);
  }
  return out;
}

/**
## What becomes of it (figure x17)

Down to $k = 1/128$ the branch does not turn back; the breather spreads, and from $1/2$ on its amplitude grows by the
factor [12.0909](num:sec2_soft_wells.amplitude_growth). In a wide breather neighbours swing against each other,
$y_n = \bar y_n + (-1)^n a(t)$, at a mean distance $g$ that changes little from place to place:
$$\ddot a = (-2a-g)_+^{3/2} - (2a-g)_+^{3/2}.$$
At a fixed period such motions of the free chain have one parameter, so that $g$ is a function of the mean force
$\bar F$. Small swings of the period $2\pi$ need $6|g|^{1/2} = 1$, that is, $g = -\frac1{36}$ and
$\bar F = \frac1{216}$. Below this force, in the outer parts of the breather, the swing has died out and the beads only
lean on one another, with $g = -\bar F^{2/3}$. The means obey $k\,\bar y_n = \bar F_{n-1}-\bar F_n$ and
$g = \bar y_{n+1} - \bar y_n$, hence
$$\bar F'' = -k\,g(\bar F),\qquad \int_0^{\bar F_c} g\,d\bar F = 0.$$
In the first equation $k$ sets only the scale of length, so that to leading order in $k$ the width grows like
$k^{-1/2}$. Multiplied by $\bar F'$ and integrated from far away, where $\bar F = 0$, to the centre, where
$\bar F' = 0$, it gives the second, a rule of equal areas for the central force $\bar F_c$ at $k \to 0$. This number
comes from the free chain alone, and the breathers must reach it. */
struct Neighbours {
  double left_over, force, lagrangian;  ///< a at a quarter of the period; means over it
};

Neighbours neighbours(double swing, double g, const Tolerance& tolerance) {
  Reference reference(
      [g](double, const double* x, double* dx) {
        const double r = std::max(2 * x[0] - g, 0.0), l = std::max(-2 * x[0] - g, 0.0);
        const double right = r * std::sqrt(r), left = l * std::sqrt(l);
        dx[0] = x[1];
        dx[1] = left - right;
        dx[2] = (right + left) / 2;
        dx[3] = x[1] * x[1] / 2 - (r * right + l * left) / 5;
      },
      4, tolerance);
  const double quarter = std::numbers::pi / 2;
  double t = 0;
  std::vector<double> x{swing, 0, 0, 0};
  reference.advance(t, quarter, x);
  return {x[0], x[2] / quarter, x[3] / quarter};
}

/**
The integral need not be computed. Let $L$ be the mean Lagrangian of a bead, kinetic minus potential energy. Because the
action is stationary, $\bar F = dL/dg$ at a fixed period, so that $g\,d\bar F = d(g\bar F - L)$. Where the beads only
lean on one another, $L = -\frac25|g|^{5/2}$ and $g\bar F - L = -\frac35\bar F^{5/3}$, which vanishes with the force; so
the integral from zero is $g\bar F - L$. Two nested bisections do the rest. For a given swing we look for the $g$ at
which the period is $2\pi$: the larger $g$, the weaker the push and the slower the swing. Among the swings we look for
the one at which the integral vanishes. */
template <class Good>
double last_good(double good, double bad, Good is_good) {
  for (int k = 0; k < 60; ++k) {
    const double middle = (good + bad) / 2;
    (is_good(middle) ? good : bad) = middle;
  }
  return good;
}

double central_force(const Tolerance& tolerance) {
  const auto gap = [&](double swing) {
    return last_good(-0.2, 2 * swing,
                     [&](double g) { return neighbours(swing, g, tolerance).left_over < 0; });
  };
  const double swing = last_good(0.1, 0.4, [&](double a) {
    const double g = gap(a);
    const Neighbours c = neighbours(a, g, tolerance);
    return g * c.force < c.lagrangian;
  });
  return neighbours(swing, gap(swing), tolerance).force;
}

/**
## The limit of soft wells

The width of the computed breathers grows with the power [-0.4999](num:sec2_soft_wells.width_exponent) of the stiffness,
where $-\frac12$ is expected, and the mean force at their centre tends to
[0.0759926](num:sec2_soft_wells.central_limit), where the rule of equal areas demands
[0.0759928](num:sec2_soft_wells.central_theory). By $k\,\bar y_n = \bar F_{n-1}-\bar F_n$ the mean displacements grow
like $k^{-1/2}$ to leading order, while the swing of neighbours against each other tends to a limit. In this limit the
breather tends, near its centre, to a motion of the free chain with the same mean force at every contact, as the theorem
demands, and this motion is no longer localized.

Width and central force have been extrapolated to $k = 0$. The equations suggest a series in $k$, so we lay a polynomial
through the last points and read it at zero. How good is that? Two successive parabolas may agree by chance, since the
extrapolated force does not converge smoothly but scatters about its limit, less and less along our sequence. The error
is therefore the largest distance of the last parabola from three other extrapolations: the parabola before it and the
last two cubics. */
/// The polynomial through the points from `first` up to `last`, at zero (Neville's scheme).
double at_zero(const std::vector<double>& x, std::vector<double> y, std::size_t first,
               std::size_t last) {
  for (std::size_t order = 1; order <= last - first; ++order)
    for (std::size_t i = first; i + order <= last; ++i)
      y[i] = (x[i] * y[i + 1] - x[i + order] * y[i]) / (x[i] - x[i + order]);
  return y[first];
}

Estimate limit_of(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t n = x.size() - 1;
  Estimate limit{at_zero(x, y, n - 2, n), 0};
  for (const auto& [first, last] : {std::pair{n - 3, n - 1}, {n - 3, n}, {n - 4, n - 1}})
    limit.error = std::max(limit.error, std::abs(at_zero(x, y, first, last) - limit.value));
  return limit;
}

/**
The power of the width is taken from one stiffness to the next, the force as it is. */
Estimate width_power(const std::vector<Breather>& softer) {
  std::vector<double> x, y;
  for (std::size_t i = 1; i < softer.size(); ++i) {
    const Breather &a = softer[i - 1], &b = softer[i];
    x.push_back(std::sqrt(a.k * b.k));
    y.push_back(std::log(b.width / a.width) / std::log(b.k / a.k));
  }
  return limit_of(x, y);
}

Estimate central_limit(const std::vector<Breather>& softer) {
  std::vector<double> x, y;
  for (const Breather& breather : softer) {
    x.push_back(breather.k);
    y.push_back(breather.central);
  }
  return limit_of(x, y);
}

using Both = std::array<std::vector<Breather>, 2>;  // on chains of two lengths

void report_breathers(Report& report, const Both& softer) {
  const auto& [shorter, longer] = softer;

  // Breather by breather
  const char* const from = "difference of two chain lengths";
  Table& table = report.table("softer_wells");
  for (std::size_t i = 0; i < longer.size(); ++i) {
    const Breather &a = shorter[i], &b = longer[i];
    table.add(
        {{"kappa", "stiffness of the wells", b.k},
         {"amplitude", "largest displacement at t = 0", compare(a.amplitude, b.amplitude), "",
          from},
         {"energy", "energy of the breather", compare(a.energy, b.energy), "", from},
         {"width", "contacts that share the mean force", compare(a.width, b.width), "site", from},
         {"central", "mean force of the central contact", compare(a.central, b.central), "",
          from}});
  }

  // How the mean force spreads, at every fourth stiffness
  Table& profiles = report.table("softer_profiles");
  for (std::size_t i = 0; i < longer.size(); i += 4)
    for (int n = -40; n <= 40; ++n) {
      const auto force = [&](std::size_t j) {
        return softer[j][i].contact[std::size_t(long(lengths[j] / 2) + n)];
      };
      profiles.add(
          {{"kappa", "stiffness of the wells", longer[i].k},
           {"n", "contact, from the centre of the breather", n, "site"},
           {"force", "mean force of the contact", Estimate{force(1), std::abs(force(1) - force(0))},
            "", "difference of two chain lengths, against the largest"}});
    }
}

void report_limits(Report& report, const Both& softer) {
  const auto& [shorter, longer] = softer;

  // Where width and central force go, and where the free chain says that the force must go
  const Breather &short_last = shorter.back(), &last = longer.back();
  report.facts.add("width_exponent", compare(width_power(shorter), width_power(longer)));
  report.facts.add("central_limit", compare(central_limit(shorter), central_limit(longer)));
  report.facts.add("central_theory", compare(central_force(1e-9), central_force(1e-12)));
  report.facts.add("softest", exact(last.k));
  report.facts.add("amplitude_growth", compare(short_last.amplitude / shorter.front().amplitude,
                                               last.amplitude / longer.front().amplitude));
  report.facts.add("softest_width", compare(short_last.width, last.width), "site");
  report.facts.add("softest_central", compare(short_last.central, last.central));

  // The second breather, by the branch and by substitution
  const auto missed = [&](std::size_t j) {
    const Breather& second = softer[j][1];
    return std::abs(substituted(second.k, lengths[j]).amplitude / second.amplitude - 1);
  };
  report.facts.add("substitution_difference", compare(missed(0), missed(1)),
                   "relative to the amplitude");
}

/**
## Differences and limits

The article does not treat this question, so no claim of it is judged here. The results are seen on thirteen
bond-centred breathers in linear wells and on the limit to which they tend; on chains twice as long, run once, four more
were followed down to $1/512$. Nothing is proved for the stiffnesses in between and below. A breather in very soft wells
needs a chain longer than its width, and there our sequence ends. The equation for $\bar F$ holds to leading order in
$k$; we did not bound its error, and we do not know the origin of the scatter of the extrapolated force. */
void reproduce(Report& report) {
  Both softer;
  parallel_for(
      2, [&](std::size_t j) { softer[j] = softer_and_softer(lengths[j], report.quick ? 6 : 13); });
  report_breathers(report, softer);
  report_limits(report, softer);
}

/**
## Try it

1. *Easy.* A breather in unit wells, seen in soft ones:
   `build/bin/sec32_newton_breathers breather --centre bond --omega 2` gives `amplitude` = 2.29298. Hint: which $k$ is
   this, and what is $k^2$ times the amplitude? The table `softer_wells` has it as its third row.
2. *Harder.* Do soft wells know the other kind of breather?
   `build/bin/sec32_newton_breathers breather --centre site --omega 2` gives `energy` = 35.3456913, the energy around a
   bond to seven digits. Hint: the equation for $\bar F$ does not know where the sites are.
3. *Harder.* What is the substitution for contacts of the exponent $\alpha$?
   `build/bin/sec32_newton_breathers breather --centre bond --omega 2 --contact power --alpha 3`
   gives `amplitude` = 1.10053. Hint: $k\,y$ and $y^\alpha$ must grow alike; at $k = \frac14$ and period $2\pi$ the
   amplitude is half of that.
4. *Open.* Does the solution of $\bar F'' = -k\,g(\bar F)$ lie on the profiles of the figure, and is the standing wave
   at the centre stable in the free chain, and the breather with it? */
int main(int argc, char** argv) {
  return run({"sec2_soft_wells", "2", "A breather in ever softer wells (section 2)", reproduce},
             argc, argv);
}
