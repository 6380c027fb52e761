/**
# 3.3 Breathers between a site and a bond

Where do the two breathers exchange their stability, and what happens there? Section 3.3 of James, Kevrekidis and Cuevas
(Physica D 251, 2013) finds exchanges as the anharmonicity $s$ is changed at $\omega_b = 1.1$, and leaves the
bifurcations to future work. It also states that "for different values" of $\omega_b \in (1,2]$ and $s\in[-1,1]$ four
Floquet multipliers are close to $+1$ and the others lie on the unit circle, where they accumulate at $e^{\pm2\pi
i/\omega_b}$; section 5 adds that the instabilities which it found are weak, with multipliers that exceed one by less
than $10^{-3}$.

This program tests where in the plane both statements hold (`sec33_floquet` tests them where the article shows
multipliers), maps the exchanges over the whole plane, and finds the asymmetric breathers that bifurcate there, centred
neither on a site nor on a bond. Why should they exist? The centre moves in the Peierls-Nabarro potential, drawn here so
that a stable breather sits at a minimum. Between two minima there is a maximum, between two maxima a minimum:

      both stable                both unstable
       site  between  bond        site  between  bond
               __                  __            __
            __/  \__                \__      __/
           /        \                  \____/      */
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"
#include "sec33/chart.hpp"
#include "sec33/intermediate.hpp"

using namespace lattice;

/**
## Model and method

The chain is that of Eqs. (6) and (10),
$$\ddot y_n + y_n + s\,y_n^3 = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2}.$$
The multipliers of a breather are the factors by which small changes of it grow in one period; they come in pairs
$\lambda, 1/\lambda$. One pair is exactly $+1$, that of a shift in time. The *translational pair* (*pinning pair* in
tables) belongs to a shift along the chain and lies close to $+1$, because a shift by a fraction of a site costs hardly
any energy. It is one number, $\kappa = \frac14(\lambda+1/\lambda-2)$, positive where the breather is unstable
($\lambda$ real), zero at an exchange of stability, negative where the pair is on the unit circle. There the breather is
stable if all other pairs are on the circle too, so we also give the largest modulus. Unlike $\lambda$, $\kappa$ keeps
all its digits near zero (floquet.hpp). The centre of a breather is $Q$, `centre`, in sites from the middle of the
chain.

## A chart of both breathers (figure x13)

Where do the breathers exist, and how unstable are they there? We compute all multipliers of both on a grid of 80
frequencies from 1.01 to 2 and 25 wells, $-1\le s\le1$, following each breather in $\omega_b$ through the linear well
and from there in $s$ until the family ends (chart.hpp).

![Which breather has its translational pair on the circle, where the two exchange stability, and how unstable they
are.](fig:x13) */
/// A node of the chart, and of which breather.
struct OnChart {
  Centre centre;
  const Node* node;
};

std::vector<OnChart> report_multipliers(Report& report, const Chart& site, const Chart& bond) {
  const auto columns = [](const std::string& of) {
    return Columns{
        number("fourth_" + of, "distance of the fourth multiplier from +1; nan: no breather"),
        number("excess_" + of, "largest modulus of all multipliers minus one"),
        number("others_" + of,
               "largest modulus of the multipliers other than the four, minus one")};
  };
  Table& table = report.table(
      "multiplier_chart", {number("omega", "frequency"), number("s", "anharmonicity"),
                           estimate("kappa_bond", "kappa of the pinning pair around a bond", "",
                                    "symplectic defect, against the neighbouring rows; may be nan"),
                           columns("site"), columns("bond")});
  std::vector<OnChart> seen;
  int alike = 0;
  for (std::size_t i = 0; i < site.size(); ++i)
    for (std::size_t k = 0; k < site[i].size(); ++k) {
      const Node &here = site[i][k], &there = bond[i][k];
      alike += here.kappa() * there.kappa() > 0;
      Cells row{here.spot.omega_b, here.spot.s, there.kappa(), there.defect()};
      for (const OnChart& at : {OnChart{Centre::site, &here}, OnChart{Centre::bond, &there}}) {
        const auto& pairs = at.node->pairs;
        const bool exists = at.node->exists();
        if (exists) seen.push_back(at);
        row.push_back(exists ? from_one(pairs[0]).value : std::nan(""));
        row.push_back(exists ? excess(pairs).value : std::nan(""));
        row.push_back(exists ? excess(pairs, 1).value : std::nan(""));
      }
      table.add(row);
    }
  report.facts.add("chart_same_sign", exact(alike), "nodes where kappa has one sign for both");
  return seen;
}

/**
## Over the whole plane

`sec33_floquet` tests the article's statement on two lines, where it is true: four multipliers near $+1$, all others on
the circle, twenty more at the point of accumulation for ten more sites. Here we count the nodes of the whole chart that
violate a bound. The worst are computed again, with two tolerances. */
/// How many of the twenty are elsewhere, where most of them are.
int most_missing(const std::vector<OnChart>& nodes) {
  std::vector<int> missing(nodes.size());
  parallel_for(nodes.size(), [&](std::size_t i) {
    const auto& [centre, node] = nodes[i];
    missing[i] =
        std::abs(20 - added_at_edge(centre, node->spot, node->orbit, node->pairs, chart_rule()));
  });
  return *std::max_element(missing.begin(), missing.end());
}

/**
In hard wells the translational pair leaves the neighbourhood of $+1$, along the real axis around a bond and along the
circle around a site. Of the [1719](num:sec33_between.chart_nodes_bond) nodes with a breather around a bond, and
[1730](num:sec33_between.chart_nodes_site) around a site, these numbers violate a bound:

| | around a bond | from $\omega_b =$ | around a site | from $\omega_b =$ |
|---|---|---|---|---|
| fourth multiplier farther than 0.01 from $+1$ | [398](num:sec33_between.far_bond) | [1.44 ± 0.01](num:sec33_between.far_from_bond) | [397](num:sec33_between.far_site) | [1.44 ± 0.01](num:sec33_between.far_from_site) |
| farther than 0.1 | [202](num:sec33_between.farther_bond) | [1.65 ± 0.01](num:sec33_between.farther_from_bond) | [201](num:sec33_between.farther_site) | [1.65 ± 0.01](num:sec33_between.farther_from_site) |
| a modulus exceeds one by more than $10^{-3}$ | [823](num:sec33_between.large_bond) | [1.15 ± 0.01](num:sec33_between.large_from_bond) | [94](num:sec33_between.large_site) | [1.16 ± 0.01](num:sec33_between.large_from_site) |

The largest excess is [1.06](num:sec33_between.range_largest), around a bond at $\omega_b = 2$ and $s = 1$. Near the
ends of soft families multipliers beside the four leave the circle too, by up to
[0.0494](num:sec33_between.range_others). Wherever longer chains were tried the added multipliers accumulate at the same
point. At all but [2](num:sec33_between.chart_same_sign) nodes exactly one of the two breathers has its translational
pair on the circle. */
void report_range(Report& report, const std::vector<OnChart>& seen, double spacing) {
  // How many nodes are beyond a limit, and from which frequency on
  using Pairs = std::vector<Pair>;
  const auto fourth = [](const Pairs& pairs) { return from_one(pairs[0]); };
  const auto largest = [](const Pairs& pairs) { return excess(pairs); };
  const auto beyond = [&](const std::string& name, double limit, auto of) {
    for (Centre centre : both_centres) {
      int all = 0, at_least = 0, at_most = 0;
      double first = HUGE_VAL;
      for (const auto& [around, node] : seen) {
        if (around != centre) continue;
        const Estimate e = of(node->pairs);
        ++all, at_least += e.value - e.error > limit, at_most += e.value + e.error > limit;
        if (e.value > limit) first = std::min(first, node->spot.omega_b);
      }
      const std::string suffix = centre == Centre::bond ? "_bond" : "_site";
      report.facts.add(name + suffix, compare(at_most, at_least), "nodes of the chart");
      if (std::isfinite(first)) report.facts.add(name + "_from" + suffix, {first, spacing});
      if (name == "far") report.facts.add("chart_nodes" + suffix, exact(all));
    }
  };
  beyond("far", 0.01, fourth);
  beyond("farther", 0.1, fourth);
  beyond("large", 1e-3, largest);
  beyond("very_large", 0.01, largest);

  // The worst of all nodes, and what longer chains add in the outermost wells
  const auto worst = [&](auto of) {
    const auto less = [&](const OnChart& a, const OnChart& b) {
      return of(a.node->pairs).value < of(b.node->pairs).value;
    };
    const auto& [centre, node] = *std::max_element(seen.begin(), seen.end(), less);
    return of(spectrum<double>(problem_at(centre, node->spot), node->orbit).pairs);
  };
  report.facts.add("range_others", worst([](const Pairs& p) { return excess(p, 1); }));
  report.facts.add("range_largest", worst(largest));
  std::vector<OnChart> ends;
  Estimate linear{};
  for (const OnChart& at : seen) {
    const double omega_b = at.node->spot.omega_b, s = at.node->spot.s;
    if (std::abs(s) == 1 && std::lround((omega_b - 1.01) / spacing) % 13 == 0) ends.push_back(at);
    if (s == 0) linear = larger(linear, excess(at.node->pairs));
  }
  report.facts.add("range_not_at_edge", exact(most_missing(ends)));
  report.facts.add("largest_in_linear_wells", linear);
}

/**
## Where they exchange stability

Is the exchange at $\omega_b = 1.1$ the only one? Wherever neighbours on the chart of the site-centred breather, along
either axis, have opposite signs of $\kappa$, an exchange lies between them. For a curve in a figure three digits
suffice: the search ends with a step shorter than a thousandth, and the next step is the error. Of
[333](num:sec33_between.chart_exchanges) edges of the grid with such a change of sign the search failed on
[0](num:sec33_between.chart_lost). */
/// An edge of the grid across which kappa changes its sign, and the exchange there.
struct CrossedEdge {
  Cut cut;
  TrialKappa low, high;
  const Node* near;
  Exchange found{};
  bool good = false;
};

std::vector<CrossedEdge> exchanges_of(const Chart& grid) {
  // Neighbours of opposite sign
  std::vector<CrossedEdge> edges;
  const auto look = [&](const Node& a, const Node& b, bool along_s) {
    if (!(a.kappa() * b.kappa() < 0)) return;
    const auto at = [&](const Node& n) {
      return TrialKappa{along_s ? n.spot.s : n.spot.omega_b, n.kappa()};
    };
    edges.push_back({{along_s, along_s ? a.spot.omega_b : a.spot.s}, at(a), at(b), &a});
  };
  for (std::size_t i = 0; i < grid.size(); ++i)
    for (std::size_t k = 0; k < grid[i].size(); ++k) {
      if (k > 0) look(grid[i][k - 1], grid[i][k], true);
      if (i > 0) look(grid[i - 1][k], grid[i][k], false);
    }

  // The exchange between them
  parallel_for("exchanges", edges.size(), [&](std::size_t i) {
    CrossedEdge& c = edges[i];
    try {
      c.found =
          exchange_between(Centre::site, c.cut, c.low, c.high, c.near->orbit, 1e-3, chart_rule());
      c.good = true;
    } catch (const NewtonFailed&) {
    }
  });
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
      map.add({n.spot.omega_b, n.spot.s, n.kappa(), n.defect(),
               n.exists() ? (n.kappa() > 0 ? 1.0 : -1.0) : n.kappa()});

  // The curves of exchange, point by point
  Table& curve = report.table(
      "exchange_curves",
      {number("omega", "frequency"), number("s", "anharmonicity at the exchange of stability"),
       number("error", "error of the coordinate along which it was found")});
  const std::vector<CrossedEdge> edges = exchanges_of(grid);
  int lost = 0;
  for (const CrossedEdge& c : edges) {
    lost += !c.good;
    const Spot spot = c.cut.at(c.found.place.value);
    if (c.good) curve.add({spot.omega_b, spot.s, c.found.place.error});
  }
  report.facts.add("chart_exchanges", exact(double(edges.size())),
                   "edges of this grid that an exchange crosses");
  report.facts.add("chart_lost", exact(lost), "of these edges");
}

/**
## The linear well: six exchanges

At $s = 0$ we locate for both breathers, in extended precision (a 64-bit mantissa), the exchanges that the grid shows;
on one twenty-five times as dense, run once from $\omega_b = 1.003$, there are no others up to 2.
[](finding:exchange.six) In the *window* between two of them one breather is stable. Up to the first exchange it is the
bond-centred one, as in the DpS equation; then they alternate: at 1.1, between the second and the third, it is the
bond-centred one again, between the last two the site-centred one. Each exchange is a close pair, one of the
site-centred and one of the bond-centred breather. Their order tells whether both are stable between them or neither is;
those of the first pair are too close to be told apart.

| exchange | $\omega_b$ |
|---|---|
| 1 | [1.01794 ± 2e-10](num:sec33_between.window_1) |
| 2 | [1.07504 ± 1e-10](num:sec33_between.window_2) |
| 3 | [1.16086 ± 1e-10](num:sec33_between.window_3) |
| 4 | [1.26186 ± 4e-10](num:sec33_between.window_4) |
| 5 | [1.32615 ± 5e-10](num:sec33_between.window_5) |
| 6 | [1.49164 ± 5e-10](num:sec33_between.window_6) |

The middle row of the chart shows where to look: even the shortest window is more than four of its steps wide.
Around a bond the search interval is a little wider, because the two exchanges of a pair do not coincide. */
std::vector<ExchangePair> exchange_pairs(const Chart& grid, bool quick) {
  // Where kappa changes its sign in the middle row
  std::vector<std::pair<const Node*, const Node*>> pairs;
  const std::size_t middle = grid.front().size() / 2;
  for (std::size_t i = 1; i < grid.size(); ++i)
    if (grid[i - 1][middle].kappa() * grid[i][middle].kappa() < 0)
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
      {estimate("omega_site",
                "frequency at the exchange of stability of the site-centred breather, s = 0"),
       estimate("omega_bond",
                "frequency at the exchange of stability of the bond-centred breather, s = 0"),
       estimate("width", "omega_bond - omega_site; nan where it is below its error", "",
                "combined error of the two, against the largest; may be nan"),
       number("s", "anharmonicity, zero"),
       label("between", "state of the two pinning pairs between the two frequencies")});
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const auto& [site, bond] = edges[k].found;
    const bool known = edges[k].resolved();
    const Estimate width = known ? edges[k].width() : Estimate{std::nan(""), std::nan("")};
    table.add({site.place, bond.place, width, 0.0, edges[k].between()});
    report.facts.add("window_" + std::to_string(k + 1), site.place);
    if (known) report.facts.add("window_width_" + std::to_string(k + 1), width);
  }
  return edges;
}

/**
## Intermediate breathers (figure x14)

How wide is the interval in which both are stable, or both unstable? Let the potential of the centre $X$, in sites from
a site, have two harmonics, $V = a\cos2\pi X+b\cos4\pi X$. Then $V' = -2\pi\sin2\pi X\,(a+4b\cos2\pi X)$, and besides
site and bond there is a third extremum where $\cos2\pi X = -a/4b$, if $|a|<4|b|$. The curvature is proportional to
$-(a+4b)$ at the site and to $a-4b$ at the bond: both are stable in this interval if $b<0$, and both unstable if $b>0$.
It is narrow because $b$ is tiny compared with the $a$ of other wells. Half way, at $a = 0$, all three curvatures are
$16\pi^2|b|$ in size. So $\kappa$, proportional to minus the curvature, is as large there for the third breather as for
the site-centred one, for which it has grown over half the interval, from the exchange on. At $\omega_b = 1.1$ half of
[3.22e-7](num:sec33_between.exchange_gap) times the slope [7.55e-8](num:sec33_floquet.exchange_slope) is within four per
cent of what we find, [1.26e-14](num:sec33_between.kappa_between_in_s). We do not know what determines the sign of $b$.

Newton's equations for the third breather are nearly singular, because shifting it costs almost no energy. We prescribe
its centre,
$$Q = \frac{\sum_n n\,\bigl(y_n(0)^2 + y_n(T_b/2)^2\bigr)}{\sum_n \bigl(y_n(0)^2+y_n(T_b/2)^2\bigr)},$$
and solve for its positions and for the parameter, $s$ or $\omega_b$, at which it exists there (held.hpp), from a site,
$Q=0$, to the next bond, $Q=1/2$, at two tolerances of extended precision; each orbit is the next one's guess
(intermediate.hpp).

![Centre, energy and stability of the intermediate breathers.](fig:x14) */
/// Two exchanges close together on a cut: the ends of a family of intermediate breathers.
struct FamilyEnds {
  const char* name;
  Cut cut;
  ExchangePair edge;
};

/// One cut along s, at 1.1, and one along the linear well, where both are unstable, if there is one.
std::vector<FamilyEnds> family_ends(const std::vector<ExchangePair>& edges) {
  std::vector<FamilyEnds> families{{"between_in_s", Cut{}, {}}};
  parallel_for(2, [&](std::size_t k) {
    const Orbit<double> near = find_breather(problem_at(both_centres[k], {}));
    families[0].edge.found[k] = exchange<Wide>(both_centres[k], Cut{}, 0.1, 0.2, near);
  });
  const auto both_unstable = [](const ExchangePair& edge) {
    return edge.between() == "unstable" && edge.found[0].place.value > 1.3;
  };
  const auto last = std::find_if(edges.begin(), edges.end(), both_unstable);
  if (last != edges.end()) families.push_back({"between_in_omega", {false, 0}, *last});
  return families;
}

/**
[](finding:exchange.between) The first of these families has its midpoint at $s =$
[0.153](num:sec33_between.middle_between_in_s), the second at $\omega_b =$
[1.33](num:sec33_between.middle_between_in_omega). At the other exchanges no third breather was looked for. */
void report_between(Report& report, const std::vector<ExchangePair>& edges) {
  const std::vector<FamilyEnds> families = family_ends(edges);
  report.facts.add("exchange_gap", families[0].edge.width());
  for (const auto& [name, cut, edge] : families) {
    // The family, and its energy on the way from the site's to the bond's
    const auto family = intermediate_breathers(cut, edge, report.quick ? 2 : 10);
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
      const Intermediate& one = family[i];
      const Estimate offset{double(one.parameter - Wide(site.value)), one.place.error + site.error};
      table.add({one.centre, one.place, offset, share[i], one.kappa, one.largest_modulus});
    }
    table.add({0.5, bond, edge.width(), 1.0, zero, largest(1)});

    // Half way
    const Intermediate& middle = family[family.size() / 2];
    report.facts.add(std::string("kappa_") + name, middle.kappa);
    report.facts.add(std::string("largest_modulus_") + name, middle.largest_modulus);
    report.facts.add(std::string("middle_") + name, middle.place);
  }
}

/**
## Differences and limits

The chart follows each family in $s$ only until Newton's method fails, which for soft wells is near the fold of the
family. Third breathers were followed at two exchanges only; two exchanges between neighbouring nodes of the chart would
escape; and we did not test whether a third breather stops a moving one. */
void reproduce(Report& report) {
  report.output.note("tolerance", "flow to 128 and 2048 roundings of the type");
  const Chart site = chart(Centre::site, report.quick), bond = chart(Centre::bond, report.quick);

  const double spacing = site[1][0].spot.omega_b - site[0][0].spot.omega_b;
  const auto seen = report_multipliers(report, site, bond);
  report_range(report, seen, spacing);
  report_exchanges(report, site);
  report_between(report, report_windows(report, site));
}

/**
## Try it

1. *Easy.* The curve of exchange at another frequency: `build/bin/sec33_floquet exchange --centre site --omega 1.15`
   gives `s0` = 0.0187803. Is the site-centred breather stable in the linear well there?
   Hint: it is unstable at $\omega_b = 1.1$, and of the six exchanges of the linear well none lies between the two
   frequencies. Where will the next one be?
2. *Harder.* Find an exchange without any multiplier. `build/bin/sec32_barrier barrier --omega 1.1 --s 0.1525` gives
   `equal_area` = -3.04e-17, four orders less than at $s = 0$; a little further, `build/bin/sec32_barrier barrier
   --omega 1.1 --s 0.15252` gives `equal_area` = 5.3e-19. Hint: site and bond exchange their stability where the first
   harmonic of the potential at equal area vanishes, and with it the barrier. That at equal frequency is nowhere near
   zero there: `equal_frequency` is millions of times larger.
3. *Open.* Follow the intermediate breather through the whole plane: where is it stable, and does a kicked breather stop
   at it?
4. *Open.* The second harmonic $b$ changes its sign from one exchange to another. At a zero of both harmonics curves of
   exchange would meet: is there one in the plane? */
int main(int argc, char** argv) {
  return run(
      {"sec33_between", "3.3", "Breathers between a site and a bond (section 3.3)", reproduce},
      argc, argv);
}
