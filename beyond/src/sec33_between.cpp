/**
# 3.3 Breathers between a site and a bond

Where do the two breathers exchange their stability, and what happens there? Section 3.3 of James, Kevrekidis and Cuevas
(Physica D 251, 2013) finds exchanges as the anharmonicity $s$ is changed at $\omega_b = 1.1$, and leaves the
bifurcations to future work. At $\omega_b = 1.1$ we find the exchanges of the two breathers at values of $s$ that differ
by [3.2e-7](cell:between_in_s/centre=0.5/offset). Between the two values both breathers are stable, and a third,
asymmetric one, centred neither on a site nor on a bond, exists and is unstable. In the linear well, $s = 0$, there are
six exchanges up to $\omega_b = 2$. At two of them both breathers are unstable in between; at one of these we find the
third breather, which is stable.

Why should a third breather exist? Let the centre $X$ of a breather, in sites from a site, move in a potential with two
harmonics, $V = a\cos2\pi X+b\cos4\pi X$ (the Peierls-Nabarro potential of `sec32_barrier`, with the sign for which a
stable breather sits at a minimum):

      both stable, b < 0         both unstable, b > 0
       site  third  bond          site  third  bond
               __                  __            __
            __/  \__                \__      __/
           /        \                  \____/

Then $V' = -2\pi\sin2\pi X\,(a+4b\cos2\pi X)$. Besides site and bond there is a third extremum, where $\cos2\pi X =
-a/4b$, if $|a|<4|b|$. The curvature is proportional to $-(a+4b)$ at the site and to $a-4b$ at the bond: in this
interval both are stable if $b<0$ and both unstable if $b>0$, and the third one is the opposite. The interval is narrow
because $b$ is tiny compared with the $a$ of other wells. */
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"
#include "sec3/resolutions.hpp"
#include "sec33/chart.hpp"
#include "sec33/held.hpp"

using namespace lattice;
using namespace report;

/**
## Model and method

The chain is that of Eqs. (6) and (10),
$$\ddot y_n + y_n + s\,y_n^3 = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2}.$$
Floquet multipliers come in pairs $\lambda, 1/\lambda$. That of a shift in time is exactly $+1$; the *translational
pair* (*pinning pair* in tables) belongs to a shift along the chain and is close to it. It is one number,
$\kappa = \frac14(\lambda+1/\lambda-2)$: positive if the breather is unstable, zero at an exchange of stability.

Newton's equations for the third breather are nearly singular, because shifting it costs almost no energy. So we
prescribe its centre,
$$Q = \frac{\sum_n n\,\bigl(y_n(0)^2 + y_n(T_b/2)^2\bigr)}{\sum_n \bigl(y_n(0)^2+y_n(T_b/2)^2\bigr)},$$
counted from a site, and solve
$$\dot y_n(T_b/2) = 0 \quad\text{from}\quad \dot y_n(0) = 0$$
for its positions *and* for the parameter, $s$ or $\omega_b$, at which it exists there (held.hpp). In double precision
the error of the parameter would exceed the whole interval. So each breather is solved twice in extended precision (a
64-bit mantissa), with tolerances that differ by a factor of sixteen; the error is their difference plus that from the
symplectic error of the linearised flow. */
/// A breather of the family: Q, s or omega_b with and without its error, and energy and stability.
struct ThirdBreather {
  double centre = 0;
  Wide parameter = 0, energy = 0;
  Estimate place{}, kappa{}, largest_modulus{};
};

/// Its equations on a cut, s at fixed omega_b or omega_b at fixed s, near the parameter of an exchange.
template <class T>
Held<T> third_problem(const Cut& cut, const Exchange& from, double centre) {
  Shooting<T> problem = in_precision<T>(problem_at(Centre::site, cut.at(from.place.value)));
  problem.symmetry = even_in_time(problem.chain.sites);  // no mirror
  return {problem, cut.along_s ? along_s<T>() : along_omega<T>(), T(centre)};
}

/// The breather near given positions and parameter, and its multipliers.
ThirdBreather third_breather(const Cut& cut, const Exchange& from, double centre,
                             const Vector<double>& near) {
  const auto held = third_problem<Wide>(cut, from, centre);
  std::array<Vector<Wide>, 2> x;
  std::array<MultiplierPairs<Wide>, 2> pairs;
  for (const Resolution resolution : {Resolution::fine, Resolution::coarse}) {
    const auto k = std::size_t(resolution);
    const NewtonRule<Wide> how = rule<Wide>(resolution);
    x[k] = newton(held.equations(), Vector<Wide>(near.cast<Wide>()), how).x;
    const auto there = held.at(x[k]);
    pairs[k] = floquet_pairs(there.chain, held.start(x[k]), there.period(), how.events);
  }
  const Eigen::Index last = x[0].size() - 1;
  const double apart = double(magnitude<Wide>(x[1][last] - x[0][last]));
  ThirdBreather out{centre, x[0][last], energy(held.at(x[0]).chain, held.start(x[0]))};
  out.place = {double(out.parameter),
               apart + double(pairs[0].symplectic_error) / std::abs(from.slope)};
  const Spectrum all{pairs_with_errors(pairs[1], pairs[0]), {}};
  out.kappa = all.kappa();
  out.largest_modulus = all.largest_modulus();
  return out;
}

/**
The family begins and ends at two exchanges that lie close together, one of the site- and one of the bond-centred
breather. Their order tells whether both are stable between them or neither is. From centre to centre the orbit is moved
at a fixed parameter (`moved_to_centre`); the guess of the parameter goes from one exchange to the other like the square
of a sine. */
struct ExchangePair {
  std::array<Exchange, 2> found;  ///< site, bond
  Estimate width() const {
    const Estimate &site = found[0].place, &bond = found[1].place;
    return {bond.value - site.value, site.error + bond.error};
  }
  bool resolved() const { return std::abs(width().value) > width().error; }
  /// What both breathers are between the two.
  std::string between() const {
    if (!resolved()) return "unresolved";
    return (width().value > 0) == (found[0].slope < 0) ? "stable" : "unstable";
  }
};

/// The family at `count` - 1 centres between site and bond. Throws NewtonFailed.
std::vector<ThirdBreather> third_breathers(const Cut& cut, const ExchangePair& ends, int count) {
  const Exchange& from = ends.found[0];
  const auto n = Eigen::Index(from.orbit.start.y.size());
  Vector<double> x(n + 1);
  for (Eigen::Index i = 0; i < n; ++i) x[i] = from.orbit.start.y[std::size_t(i)];
  const auto centre = [&](std::size_t k) { return double(k + 1) / (2 * count); };
  std::vector<Vector<double>> near;
  for (std::size_t k = 0; k + 1 < std::size_t(count); ++k) {
    const double wave = std::sin(pi<double>() * centre(k));
    x[n] = from.place.value + wave * wave * ends.width().value;
    near.push_back(moved_to_centre(third_problem<double>(cut, from, centre(k)), x));
    x = near.back();
  }
  std::vector<ThirdBreather> out(near.size());
  parallel_for("third breathers", out.size(),
               [&](std::size_t k) { out[k] = third_breather(cut, from, centre(k), near[k]); });
  return out;
}

/// Its energy between those of the site-centred (0) and of the bond-centred breather (1) at the same frequency.
double energy_share(const Cut& cut, const ExchangePair& ends, const ThirdBreather& one) {
  std::array<Wide, 2> e{};
  for (std::size_t k : {0U, 1U}) {
    const auto problem = problem_at(both_centres[k], cut.at(double(one.parameter)));
    auto wide = in_precision<Wide>(problem);
    if (!cut.along_s) wide.omega = one.parameter;
    e[k] = newton(wide, newton_from(problem, ends.found[k].orbit)).energy;
  }
  return double((one.energy - e[0]) / (e[1] - e[0]));
}

/**
## The linear well: six exchanges

At $s = 0$ we follow the site-centred breather from $\omega_b = 1.01$ to 2 in 79 steps and locate, for both breathers,
the exchanges where its $\kappa$ changes sign. A grid twenty-five times as dense, run once from 1.003, shows no others.

<!-- exchange.six -->
In the linear well the site- and bond-centred breathers exchange stability six times between $\omega_b = 1.003$ and 2,
first at 1.01794 and last at 1.49164. (computed)
<!-- /exchange.six -->

Up to the first exchange the bond-centred breather is the stable one, as in the DpS equation;
then they alternate. At 1.1 it is the bond-centred one again.

Each of the six is a pair, one exchange of either breather; those of the first pair are too close to be told apart.

| exchange | $\omega_b$, site-centred | bond- minus site-centred | in between both are |
|---|---|---|---|
| 1 | [1.01794](cell:windows/exchange=1/omega_site) | unresolved | |
| 2 | [1.07504](cell:windows/exchange=2/omega_site) | [-6.5e-9 ± 2e-10](cell:width) | stable |
| 3 | [1.16086](cell:windows/exchange=3/omega_site) | [4.57e-7](cell:width) | stable |
| 4 | [1.26186](cell:windows/exchange=4/omega_site) | [5.23e-5](cell:width) | unstable |
| 5 | [1.32615](cell:windows/exchange=5/omega_site) | [-2.05e-4](cell:width) | unstable |
| 6 | [1.49164](cell:windows/exchange=6/omega_site) | [-5.11e-4](cell:width) | stable |

The six are sought where $\kappa$ of the site-centred breather changes sign along the row $s = 0$ of the chart below.
Around a bond the search interval is a little wider, because the two do not coincide. */
std::vector<ExchangePair> exchange_pairs(const Chart& grid, bool quick) {
  // Where kappa changes its sign in the middle row
  std::vector<std::pair<const Node*, const Node*>> pairs;
  const std::size_t middle = grid.front().size() / 2;
  for (std::size_t i = 1; i < grid.size(); ++i)
    if (grid[i - 1][middle].kappa * grid[i][middle].kappa < 0)
      pairs.emplace_back(&grid[i - 1][middle], &grid[i][middle]);

  // Both exchanges of each pair
  std::vector<ExchangePair> edges(pairs.size());
  parallel_for("windows", 2 * pairs.size(), [&](std::size_t i) {
    const auto& [left, right] = pairs[i / 2];
    const Centre centre = both_centres[i % 2];
    Orbit<double> near = left->orbit;
    double low = left->spot.omega_b, high = right->spot.omega_b;
    if (centre == Centre::bond) {
      near = find_breather(problem_at(centre, {low, 0}));
      low -= 0.002, high += 0.002;
    }
    edges[i / 2].found[i % 2] = quick ? exchange<double>(centre, {false, 0}, low, high, near)
                                      : exchange<Wide>(centre, {false, 0}, low, high, near);
  });
  return edges;
}

std::vector<ExchangePair> report_windows(Report& report, const Chart& grid) {
  const std::vector<ExchangePair> edges = exchange_pairs(grid, report.quick);
  // A width below its error is not reported
  Table& table = report.table(
      "windows",
      {count("exchange", "counted from the lowest frequency on"),
       estimate("omega_site",
                "frequency at the exchange of stability of the site-centred breather, s = 0"),
       estimate("omega_bond",
                "frequency at the exchange of stability of the bond-centred breather, s = 0"),
       estimate("width", "omega_bond - omega_site; nan where it is below its error", "",
                "combined error of the two, against the largest; may be nan"),
       number("s", "anharmonicity, zero"),
       label("between", "state of the two pinning pairs between the two frequencies")});
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const auto& [site, bond] = edges[k].found;
    const Estimate none{std::nan(""), std::nan("")};
    table.add({k + 1, site.place, bond.place, edges[k].resolved() ? edges[k].width() : none, 0.0,
               edges[k].between()});
  }
  return edges;
}

/**
## The third breather (figure x14)

We follow two families from a site, $Q=0$, to the next bond, $Q=1/2$: one in $s$ at $\omega_b = 1.1$, where both
symmetric breathers are stable, and one in $\omega_b$ at $s = 0$, at the fifth exchange, where both are unstable. At the
other exchanges no third breather was looked for.

<!-- exchange.between -->
In two exchanges that we followed, the site- and bond-centred breathers do not exchange stability at the same parameter:
in between, a third, asymmetric breather exists. At $\omega_b = 1.1$ it exists over an interval of 3.2e-7 in $s$ and is
unstable, between two stable breathers, with $\kappa =$ 1.26e-14. In the linear well near $\omega_b =$ 1.32615 it is
stable, between two unstable ones, with $\kappa =$ -1.733e-11. (computed)
<!-- /exchange.between -->

The argument from two harmonics can be tested. Half way, at $a = 0$, all three curvatures are $16\pi^2|b|$ in size. So
$\kappa$, proportional to minus the curvature, is as large there for the third breather as for the site-centred one,
whose $\kappa$ has grown from zero over half the interval. Half of the interval times the slope
[7.55e-8](cell:sec33_floquet/exchange/slope) is within four per cent of the $\kappa$ that we find half way. In the other
family two harmonics are not enough: they would make $\kappa$ symmetric about the middle, $Q = \frac14$, and there it is
larger towards the bond. We do not know what determines the sign of $b$.

| $\kappa$ of the third breather | $Q = 0.15$ | $0.25$ | $0.35$ |
|---|---|---|---|
| $\omega_b = 1.1$ | [7.91e-15 ± 7e-17](cell:between_in_s/centre=0.15/kappa) | [1.26e-14](cell:centre=0.25/kappa) | [7.99e-15 ± 8e-17](cell:centre=0.35/kappa) |
| $s = 0$ | [-9.99e-12](cell:between_in_omega/centre=0.15/kappa) | [-1.733e-11](cell:centre=0.25/kappa) | [-1.302e-11](cell:centre=0.35/kappa) |

![Centre, energy and stability of the intermediate breathers.](fig:x14) */
/// Two exchanges close together on a cut: the ends of a family of intermediate breathers.
struct FamilyEnds {
  const char* name;
  Cut cut;
  ExchangePair edge;
};

/// One cut along s, at 1.1, and one along the linear well, where both are unstable, if there is one.
std::vector<FamilyEnds> family_ends(const std::vector<ExchangePair>& edges) {
  const Cut cut{true, 1.1};
  std::vector<FamilyEnds> families{{"between_in_s", cut, {}}};
  parallel_for(2, [&](std::size_t k) {
    const Orbit<double> near = find_breather(problem_at(both_centres[k], cut.at(0)));
    families[0].edge.found[k] = exchange<Wide>(both_centres[k], cut, 0.1, 0.2, near);
  });
  const auto both_unstable = [](const ExchangePair& edge) {
    return edge.between() == "unstable" && edge.found[0].place.value > 1.3;
  };
  const auto last = std::find_if(edges.begin(), edges.end(), both_unstable);
  if (last != edges.end()) families.push_back({"between_in_omega", {false, 0}, *last});
  return families;
}

void report_between(Report& report, const std::vector<ExchangePair>& edges) {
  for (const auto& [name, cut, edge] : family_ends(edges)) {
    // The family, and its energy on the way from the site's to the bond's
    const auto family = third_breathers(cut, edge, report.quick ? 2 : 10);
    std::vector<double> share(family.size());
    parallel_for(share.size(), [&, &cut = cut, &edge = edge](std::size_t i) {
      share[i] = energy_share(cut, edge, family[i]);
    });

    // It begins and ends at the two exchanges themselves, the first and the last row
    Table& table = report.table(
        name,
        {number("centre", "centre Q, in sites from the site where the branch begins", "site"),
         estimate("parameter", "parameter of the branch, s or omega_b"),
         estimate(
             "offset",
             "parameter minus its value at the exchange of stability of the site-centred breather",
             "", "combined error of the two, against the largest"),
         number("share", "(E - E_site) / (E_bond - E_site) at equal frequency"),
         estimate("kappa", "kappa of its pinning pair; positive where it is unstable", "",
                  "from two tolerances, against the largest"),
         estimate("largest_modulus", "largest modulus of all its multipliers")});
    const Estimate &site = edge.found[0].place, &bond = edge.found[1].place;
    const Estimate zero{};
    const auto largest = [&, &cut = cut, &edge = edge](std::size_t k) {
      const Exchange& end = edge.found[k];
      const auto problem = problem_at(both_centres[k], cut.at(end.place.value));
      return spectrum<Wide>(problem, end.orbit).largest_modulus();
    };
    table.add({0.0, site, Estimate{0, site.error}, 0.0, zero, largest(0)});
    for (std::size_t i = 0; i < family.size(); ++i) {
      const ThirdBreather& one = family[i];
      const Estimate offset{double(one.parameter - Wide(site.value)), one.place.error + site.error};
      table.add({one.centre, one.place, offset, share[i], one.kappa, one.largest_modulus});
    }
    table.add({0.5, bond, edge.width(), 1.0, zero, largest(1)});
  }
}

/**
## Curves of exchange over the plane (figure x13)

We compute $\kappa$ of the site-centred breather on a grid of 80 frequencies from 1.01 to 2 and 25 wells,
$-1\le s\le1$, following each breather in $\omega_b$ through the linear well and from there in $s$ until the family ends
(chart.hpp). An exchange lies between any two neighbours with opposite signs of $\kappa$. For a curve in a figure three
digits suffice: the search ends with a step shorter than a thousandth, and the next step is the error.

![Where the site-centred breather is stable against a shift, and where not.](fig:x13) */
/// An edge of the grid across which kappa changes its sign.
struct CrossedEdge {
  Cut cut;
  TrialKappa low, high;
  const Node* near;
};

std::vector<CrossedEdge> crossed_edges(const Chart& grid) {
  // Neighbours of opposite sign
  std::vector<CrossedEdge> edges;
  const auto look = [&](const Node& a, const Node& b, bool along_s) {
    if (!(a.kappa * b.kappa < 0)) return;
    const auto at = [&](const Node& n) {
      return TrialKappa{along_s ? n.spot.s : n.spot.omega_b, n.kappa};
    };
    edges.push_back({{along_s, along_s ? a.spot.omega_b : a.spot.s}, at(a), at(b), &a});
  };
  for (std::size_t i = 0; i < grid.size(); ++i)
    for (std::size_t k = 0; k < grid[i].size(); ++k) {
      if (k > 0) look(grid[i][k - 1], grid[i][k], true);
      if (i > 0) look(grid[i - 1][k], grid[i][k], false);
    }
  return edges;
}

void report_exchanges(Report& report, const Chart& grid) {
  // The figure colours the plane by the sign of kappa, which gets a column of its own
  Table& map = report.table(
      "chart",
      {number("omega", "frequency"), number("s", "anharmonicity"),
       estimate("kappa", "kappa of the pinning pair around a site; nan where the family has ended",
                "", "symplectic defect, against the neighbouring rows; may be nan"),
       number("sign",
              "sign of kappa: +1 where the pinning pair is off the unit circle; may be nan")});
  for (const auto& column : grid)
    for (const Node& n : column)
      map.add({n.spot.omega_b, n.spot.s, n.kappa, n.kappa_error,
               n.exists() ? (n.kappa > 0 ? 1.0 : -1.0) : n.kappa});

  // The curves of exchange, point by point
  const std::vector<CrossedEdge> edges = crossed_edges(grid);
  const auto row = [](const CrossedEdge& c) {
    const Exchange found =
        exchange_between(Centre::site, c.cut, c.low, c.high, c.near->orbit, 1e-3, chart_rule());
    const PlanePoint spot = c.cut.at(found.place.value);
    return Cells{spot.omega_b, spot.s, found.place.error};
  };
  report
      .table(
          "exchange_curves",
          {number("omega", "frequency"), number("s", "anharmonicity at the exchange of stability"),
           number("error", "error of the coordinate along which it was found")})
      .fill(edges, row, "exchanges");
}

/**
## Differences and limits

The chart follows each family in $s$ only until Newton's method fails, which for soft wells is near the fold of the
family; two exchanges between neighbouring nodes would escape. We did not test whether a third breather stops a moving
one. */
void reproduce(Report& report) {
  report.output.note("tolerance", "flow to 128 and 2048 roundings of the type");
  const Chart grid = chart(report.quick);
  report_between(report, report_windows(report, grid));
  report_exchanges(report, grid);
}

/**
## Try it

**To change it.** Another family is one more entry in `family_ends`; another well or contact is set where `problem_at`
makes the chain (exchange.hpp).

1. *Easy.* The curve of exchange at another frequency: `build/bin/sec33_floquet exchange --centre site --omega 1.15`
   gives `s0` = 0.0187803. Is the site-centred breather stable in the linear well there?
   Hint: it is unstable at $\omega_b = 1.1$, and of the six exchanges of the linear well none lies between the two
   frequencies. Where will the next one be?
2. *Harder.* Find an exchange without any multiplier. `build/bin/sec32_barrier barrier --omega 1.1 --s 0.1525` gives
   `equal_area` = -3.04e-17, four orders less than at $s = 0$; a little further, `build/bin/sec32_barrier barrier
   --omega 1.1 --s 0.15252` gives `equal_area` = 5.3e-19. Hint: site and bond exchange their stability where the first
   harmonic of the potential at equal area vanishes, and with it the barrier. That at equal frequency is nowhere near
   zero there: `equal_frequency` is millions of times larger. */
int main(int argc, char** argv) {
  return run(
      {"sec33_between", "3.3", "Breathers between a site and a bond (section 3.3)", reproduce},
      argc, argv);
}
