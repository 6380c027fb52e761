/**
# 3.3 The breather in between

Where do the two breathers exchange their stability, and what happens there? Section 3.3 of
James, Kevrekidis and Cuevas (Physica D 251, 2013) finds that they do so in $s$ at $\omega_b = 1.1$
and leaves the bifurcations to future work. This program maps the exchanges over the plane of
$\omega_b$ and $s$ and finds the breathers that are born there: they are centred neither on a site nor on a
bond. The landscapes below are drawn so that a stable breather sits in a valley.

      landscape of          both stable:              both unstable:
      the centre             site  between  bond       site  between  bond
                                    __                 __            __
                                 __/  \__               \__      __/
                                /        \                 \____/

What is claimed, with the identifiers under which the answers are recorded:

- "for different values" of $\omega_b \in (1,2]$ and $s\in[-1,1]$ four multipliers are close to $+1$ and the others on
  the unit circle, where they accumulate at $e^{\pm2\pi i/\omega_b}$ (`floquet.spectrum`);
- the unstable multipliers identified in section 3.3 exceed one by less than $10^{-3}$ (`floquet.instability_size`).

Here they are judged. What the multipliers do in the whole plane, the exchanges and the breathers in between are our
own measurements. */
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"
#include "sec33/exchange.hpp"
#include "sec33/held.hpp"

using namespace lattice;

/**
## Model and method

The chain is that of Eqs. (6) and (10). The pinning pair $\lambda, 1/\lambda$ of a breather, the multipliers
that belong to a shift along the chain, is one number
$$\kappa = \tfrac14\Bigl(\lambda+\frac1\lambda-2\Bigr),$$
positive where the breather is unstable (floquet.hpp). In the program it is `kappa`, $\omega_b$ and $s$ are
`omega_b` and `s`, and $Q$, `centre`, is the centre of a breather in sites from the middle of the chain.

## A chart of both breathers (figure x13)

Where do the breathers exist, and how unstable are they there? We compute all pairs of both on a grid, following
each breather in $s$ from the linear well until the family ends. On the grid a tolerance of $10^{-12}$ is enough,
since $\kappa$ is of the order of $10^{-9}$ or more nearly everywhere.

![Which breather is stable, where they change places, and how unstable they are.](fig:x13) */
struct Node {
  Spot spot{};
  Orbit<double> orbit{};
  std::vector<Pair>
      pairs{};  ///< the pinning pair first, each with the symplectic defect as its error
  bool exists() const { return !pairs.empty(); }
  double kappa() const { return exists() ? pairs[0].kappa.real() : std::nan(""); }
  double defect() const { return exists() ? pairs[0].error : std::nan(""); }
};

/**
A node is computed from the orbit of its neighbour, and left empty where the family ends. Beyond the end
Newton's method goes off to large and costly motions, so it gets only eight iterations. An amplitude
that changes by more than 15 per cent from one well to the next betrays another family. In hard wells up
to $s = 1$ no family ends, but a large breather changes quickly; there a step that is too long is
halved. */
NewtonRule<double> chart_rule() {
  NewtonRule<double> how;
  how.events.tolerance = 1e-12;
  how.most = 8;
  how.keep = 1e-6;
  return how;
}

bool same_family(const Orbit<double>& orbit, const Orbit<double>& from) {
  return std::abs(orbit.amplitude / from.amplitude - 1) <= 0.15 || orbit.omega != from.omega;
}

void visit(Centre centre, Node& node, const Node& from) {
  try {
    const auto problem = problem_at(centre, node.spot);
    node.orbit = follow(problem, from.orbit, chart_rule());
    if (!same_family(node.orbit, from.orbit)) {
      if (node.spot.s < 0) return;
      const Spot half{node.spot.omega_b, (node.spot.s + from.spot.s) / 2};
      const auto between = follow(problem_at(centre, half), from.orbit, chart_rule());
      node.orbit = follow(problem, between, chart_rule());
      if (!same_family(between, from.orbit) || !same_family(node.orbit, between)) return;
    }
    const auto found =
        floquet_pairs(problem.chain, node.orbit.start, node.orbit.period(), chart_rule().events);
    for (const auto& kappa : found.kappa) node.pairs.push_back({kappa, found.defect});
  } catch (const NewtonFailed&) {
  }
}

/**
The nodes of one frequency form a column, and the columns can run side by side once each has a start. So we
first follow the linear well in $\omega_b$; from each of its breathers we go up and down in $s$. The
quick run ends at $\omega_b = 1.2$, after three pairs of exchanges. */
using Nodes = std::vector<Node>;
using Chart = std::vector<Nodes>;

/// The nodes of one frequency, from the orbit in the linear well.
void visit_wells(Centre centre, Nodes& column) {
  const std::size_t middle = column.size() / 2;
  visit(centre, column[middle], column[middle]);
  for (std::size_t k = middle + 1; k < column.size() && column[k - 1].exists(); ++k)
    visit(centre, column[k], column[k - 1]);
  for (std::size_t k = middle; k-- > 0 && column[k + 1].exists();)
    visit(centre, column[k], column[k + 1]);
}

/// The same before they are visited.
Nodes wells_at(double omega_b, int wells) {
  Nodes column(2 * std::size_t(wells) + 1);
  for (int k = -wells; k <= wells; ++k)
    column[std::size_t(k + wells)].spot = {omega_b, double(k) / wells};
  return column;
}

Chart chart(Centre centre, bool quick) {
  const int frequencies = quick ? 12 : 80, wells = quick ? 2 : 12;
  const double top = quick ? 1.2 : 2;
  const auto middle = std::size_t(wells);
  Chart grid;
  Orbit<double> seed = find_breather(problem_at(centre, {1.01, 0}));
  for (int i = 0; i < frequencies; ++i) {
    const double omega_b = 1.01 + (top - 1.01) * double(i) / (frequencies - 1);
    Nodes column = wells_at(omega_b, wells);
    seed = column[middle].orbit = follow(problem_at(centre, {omega_b, 0}), seed, chart_rule());
    grid.push_back(std::move(column));
  }
  parallel_for("chart", grid.size(), [&](std::size_t i) { visit_wells(centre, grid[i]); });
  return grid;
}

/**
Node by node we keep the multipliers next to $+1$, the largest of all, and the largest beside the quadruplet. */
struct Seen {
  Centre centre;
  const Node* node;
};

std::vector<Seen> report_multipliers(Report& report, const Chart& site, const Chart& bond) {
  const auto columns = [](const std::string& of) {
    return Columns{
        number("fourth_" + of, "distance of the fourth multiplier from +1; nan: no breather"),
        number("excess_" + of, "largest modulus of all minus one"),
        number("others_" + of, "largest modulus beside the four minus one")};
  };
  Table& table = report.table(
      "multiplier_chart", {number("omega", "frequency"), number("s", "anharmonicity"),
                           estimate("kappa_bond", "of the pinning pair around a bond", "",
                                    "symplectic defect, against the neighbouring rows; may be nan"),
                           columns("site"), columns("bond")});
  std::vector<Seen> seen;
  int alike = 0;
  for (std::size_t i = 0; i < site.size(); ++i)
    for (std::size_t k = 0; k < site[i].size(); ++k) {
      const Node &here = site[i][k], &there = bond[i][k];
      alike += here.kappa() * there.kappa() > 0;
      Cells row{here.spot.omega_b, here.spot.s, there.kappa(), there.defect()};
      for (const Seen& at : {Seen{Centre::site, &here}, Seen{Centre::bond, &there}}) {
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
## Two lines through the plane

The article has "computed the Floquet spectrum for different values" of $\omega_b\in(1,2]$ and $s\in[-1,1]$, without
saying which. It cannot mean every pair of values, since the families of soft wells end before $\omega_b=2$. It
shows multipliers at $\omega_b=1.1$ only, for all $s$, and follows breathers in $\omega_b$ through the linear well; we
judge the statement on these two lines. In hard wells, which its figure 7 follows too, it fails (next section). Near $+1$ means
within 0.01 and at least ten times as near as the fifth multiplier; its own distance cannot be prescribed, because for
$\omega_b \to 1$ the point of accumulation itself comes near. All others may leave the circle by $10^{-3}$ at most,
the size that the article neglects. And ten more sites must add twenty multipliers at the point of accumulation,
within $10^{-4}$ in $\kappa$, because the first of the new beads still touch the old ends; this is asked at every
thirteenth frequency of the linear well and in three wells at $1.1$. These bounds are ours, and the nodes that decide
are computed once more, with two tolerances. */
int added_at_edge(const Seen& at) {
  // The same breather on a longer chain, with beads at rest beyond the old ends
  const auto& [centre, node] = at;
  const auto longer = problem_at(centre, node->spot, 10);
  State<double> start(longer.chain.sites);
  std::copy(node->orbit.start.y.begin(), node->orbit.start.y.end(), start.y.begin() + 5);
  const Orbit<double> orbit = newton(longer, longer.reduce(start), chart_rule());
  const auto found = floquet_pairs(longer.chain, orbit.start, orbit.period(), chart_rule().events);
  std::vector<Pair> pairs;
  for (const auto& kappa : found.kappa) pairs.push_back({kappa, found.defect});
  const double omega_b = node->spot.omega_b, close = 1e-4;
  return at_edge(pairs, omega_b, close) - at_edge(node->pairs, omega_b, close);
}

/// How many of the twenty are elsewhere, where most of them are.
int most_missing(const std::vector<Seen>& nodes) {
  std::vector<int> missing(nodes.size());
  parallel_for(nodes.size(),
               [&](std::size_t i) { missing[i] = std::abs(20 - added_at_edge(nodes[i])); });
  return *std::max_element(missing.begin(), missing.end());
}

/**
What is far from $+1$, and what is large? Of many nodes the worst is taken. */
struct Worst {
  Estimate fourth, share, others, largest;

  explicit Worst(const std::vector<Seen>& nodes) {
    using Pairs = std::vector<Pair>;
    const auto worst = [&](auto of) {
      const auto less = [&](const Seen& a, const Seen& b) {
        return of(a.node->pairs).value < of(b.node->pairs).value;
      };
      const auto& [centre, node] = *std::max_element(nodes.begin(), nodes.end(), less);
      return of(spectrum<double>(problem_at(centre, node->spot), node->orbit).pairs);
    };
    fourth = worst([](const Pairs& p) { return from_one(p[0]); });
    share = worst([](const Pairs& p) { return quotient(from_one(p[0]), from_one(p[1])); });
    others = worst([](const Pairs& p) { return excess(p, 1); });
    if (others.value == 0) others = exact(0);  // none leaves the circle
    largest = worst([](const Pairs& p) { return excess(p); });
  }
};

/**
On the two lines the statement is true: the fourth multiplier is no farther from $+1$ than
[0.000815379](num:sec33_between.spectrum_fourth). The second statement is one of section 5, about the instabilities that section
3.3 identified. Those are the ones at $\omega_b=1.1$, and there no modulus exceeds one by more than
[0.000583922](num:sec33_between.instability_size_largest). An earlier criterion judged both statements in the whole plane, which
held against the article what lies outside of its figures. Through the linear well the largest excess is
[0.000525970](num:sec33_between.largest_in_linear_wells). */
int judge_lines(Report& report, const std::vector<Seen>& seen, const std::vector<Seen>& at_110,
                double spacing) {
  // The nodes of both lines, and those that are computed with longer chains
  std::vector<Seen> lines = at_110, ends;
  for (const Seen& at : at_110)
    if (const double s = at.node->spot.s; s == -1 || s == 0 || s == 1) ends.push_back(at);
  Estimate linear{};
  for (const Seen& at : seen) {
    if (at.node->spot.s != 0) continue;
    lines.push_back(at);
    linear = larger(linear, excess(at.node->pairs));
    if (std::lround((at.node->spot.omega_b - 1.01) / spacing) % 13 == 0) ends.push_back(at);
  }
  report.facts.add("largest_in_linear_wells", linear);

  const Worst worst(lines);
  const int missing = most_missing(ends);
  judge(report, "floquet.spectrum",
        four_near_one_everywhere(worst.fourth, worst.share, worst.others, missing));
  judge(report, "floquet.instability_size", small_instability(Worst(at_110).largest));
  return missing;
}

/**
## Over the whole plane

What happens elsewhere is a finding of ours. In hard wells the pinning pair leaves the neighbourhood of $+1$, along
the axis around a bond and along the circle around a site: from $\omega_b =$ [1.44](num:sec33_between.far_from_bond)
on there are wells in which the fourth multiplier is farther away than 0.01, at [398](num:sec33_between.far_bond) of
[1719](num:sec33_between.chart_nodes_bond) nodes around a bond and at [397](num:sec33_between.far_site) of
[1730](num:sec33_between.chart_nodes_site) around a site, and from [1.65](num:sec33_between.farther_from_bond) on farther
than 0.1, at [202](num:sec33_between.farther_bond) and [201](num:sec33_between.farther_site) nodes. Moduli exceed one by
more than $10^{-3}$ at [823](num:sec33_between.large_bond) nodes around a bond, from $\omega_b =$
[1.15](num:sec33_between.large_from_bond) on, and at [94](num:sec33_between.large_site) around a site, from
[1.16](num:sec33_between.large_from_site) on, and by [1.06121](num:sec33_between.range_largest) at most, at $\omega_b = 2$
and $s = 1$. Next to the end of the families in soft wells multipliers beside the four leave the circle too, by up to
[0.0493672](num:sec33_between.range_others). Wherever longer chains were tried
they accumulate at the same point. At all but
[2](num:sec33_between.chart_same_sign) nodes the pinning pair makes one of the two breathers stable and the other one
unstable. */
void report_range(Report& report, const std::vector<Seen>& seen, int missing, double spacing) {
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
  const Worst worst(seen);
  report.facts.add("range_fourth", worst.fourth);
  report.facts.add("range_others", worst.others);
  report.facts.add("range_largest", worst.largest);
  std::vector<Seen> ends;
  for (const Seen& at : seen)
    if (std::abs(at.node->spot.s) == 1 &&
        std::lround((at.node->spot.omega_b - 1.01) / spacing) % 13 == 0)
      ends.push_back(at);
  report.facts.add("range_not_at_edge", exact(std::max(missing, most_missing(ends))));
}

/**
## Where they change places

Is the exchange at $\omega_b = 1.1$ the only one? Wherever neighbours on the chart of the site-centred breather,
along either axis, have opposite signs of $\kappa$, an exchange lies between them. A curve for the eye needs no more
than three digits: each exchange is refined until a step is shorter than a thousandth, and the next step is the
error. What is counted are the edges of this grid across which the sign changes: the number tells how many searches
were made, and depends on the grid. Near the end of a family a search may fail; the facts count how many were lost. */
void report_exchanges(Report& report, const Chart& grid) {
  // The figure colours the plane by the sign of kappa, which gets a column of its own
  Table& map = report.table(
      "chart",
      {number("omega", "frequency"), number("s", "anharmonicity"),
       estimate("kappa", "of the pinning pair around a site; nan where the family has ended", "",
                "symplectic defect, against the neighbouring rows; may be nan"),
       number("sign", "of kappa: +1 where the site-centred breather is unstable; may be nan")});
  for (const auto& column : grid)
    for (const Node& n : column)
      map.add({n.spot.omega_b, n.spot.s, n.kappa(), n.defect(),
               n.exists() ? (n.kappa() > 0 ? 1.0 : -1.0) : n.kappa()});

  // Neighbours of opposite sign
  struct Crossing_place {
    Cut cut;
    TrialKappa low, high;
    const Node* near;
    Exchange found{};
    bool good = false;
  };
  std::vector<Crossing_place> places;
  const auto look = [&](const Node& a, const Node& b, bool along_s) {
    if (!(a.kappa() * b.kappa() < 0)) return;
    const auto at = [&](const Node& n) {
      return TrialKappa{along_s ? n.spot.s : n.spot.omega_b, n.kappa()};
    };
    places.push_back({{along_s, along_s ? a.spot.omega_b : a.spot.s}, at(a), at(b), &a});
  };
  for (std::size_t i = 0; i < grid.size(); ++i)
    for (std::size_t k = 0; k < grid[i].size(); ++k) {
      if (k > 0) look(grid[i][k - 1], grid[i][k], true);
      if (i > 0) look(grid[i - 1][k], grid[i][k], false);
    }

  // The exchange between them
  parallel_for("exchanges", places.size(), [&](std::size_t i) {
    Crossing_place& c = places[i];
    try {
      c.found =
          exchange_between(Centre::site, c.cut, c.low, c.high, c.near->orbit, 1e-3, chart_rule());
      c.good = true;
    } catch (const NewtonFailed&) {
    }
  });
  Table& curve =
      report.table("exchange_curves",
                   {number("omega", "frequency"), number("s", "anharmonicity at the exchange"),
                    number("error", "of the coordinate along which it was found")});
  int lost = 0;
  for (const Crossing_place& c : places) {
    lost += !c.good;
    const Spot spot = c.cut.at(c.found.place.value);
    if (c.good) curve.add({spot.omega_b, spot.s, c.found.place.error});
  }
  report.facts.add("chart_exchanges", exact(double(places.size())),
                   "edges of this grid that an exchange crosses");
  report.facts.add("chart_lost", exact(lost), "of these edges");
}

/**
## The linear well: six exchanges

At $s = 0$ we locate for both breathers, in extended precision (a 64-bit mantissa), the exchanges that the grid shows; on
one that is twenty-five times as dense, run once from $\omega_b = 1.003$, there are no others up to 2.
[](finding:exchange.six) Between two exchanges lies a *window* in which one of the two is stable. From $\omega_b = 1$
on it is the bond, as in the DpS equation, but only up to the first; between the last two,
[1.32615](num:sec33_between.window_5) and [1.49164](num:sec33_between.window_6), it is the site. Each exchange is a
close pair, one of the site-centred and one of the bond-centred breather. The order of the two tells whether both
breathers are stable between them or neither is; those of the first pair are too close to be told apart. */
struct Window_edge {
  std::array<Exchange, 2> found;  ///< site, bond
  Estimate width() const {
    const Estimate &site = found[0].place, &bond = found[1].place;
    return {bond.value - site.value, site.error + bond.error};
  }
  bool resolved() const { return std::abs(width().value) > width().error; }
  /// What both are between the two; nothing is said of a width below its error.
  std::string between() const {
    if (!resolved()) return "unresolved";
    return (width().value > 0) == (found[0].slope < 0) ? "stable" : "unstable";
  }
};

/**
The middle row of the chart shows where to look: even the shortest window is more than four of its steps wide.
Around a bond the search interval is a little wider, because the two exchanges of a pair do not coincide. The figure
marks the edges of the windows, so the table has one row for each pair of exchanges. */
std::vector<Window_edge> report_windows(Report& report, const Chart& grid) {
  // Where kappa changes its sign in the middle row
  std::vector<std::pair<const Node*, const Node*>> pairs;
  const std::size_t middle = grid.front().size() / 2;
  for (std::size_t i = 1; i < grid.size(); ++i)
    if (grid[i - 1][middle].kappa() * grid[i][middle].kappa() < 0)
      pairs.emplace_back(&grid[i - 1][middle], &grid[i][middle]);

  // Both exchanges of each pair
  std::vector<Window_edge> edges(pairs.size());
  parallel_for("windows", 2 * pairs.size(), [&](std::size_t i) {
    const auto& [left, right] = pairs[i / 2];
    const Centre centre = both_centres[i % 2];
    Orbit<double> near = left->orbit;
    double low = left->spot.omega_b, high = right->spot.omega_b;
    if (centre == Centre::bond) {
      near = find_breather(problem_at(centre, {low, 0}));
      low -= 0.002, high += 0.002;
    }
    edges[i / 2].found[i % 2] = report.quick ? exchange<double>(centre, {false, 0}, low, high, near)
                                             : exchange<Wide>(centre, {false, 0}, low, high, near);
  });

  // A width below its error is not reported
  Table& table = report.table(
      "windows", {estimate("omega_site", "exchange of the site-centred breather, s = 0"),
                  estimate("omega_bond", "exchange of the bond-centred breather"),
                  estimate("width", "omega_bond - omega_site; nan where it is below its error", "",
                           "of both together, against the largest; may be nan"),
                  number("s", "anharmonicity: zero"),
                  label("between", "what both breathers are between the two")});
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
## The breather in between (figure x14)

Where both breathers are stable, or both unstable, the landscape asks for a third one between them. It can be shifted
along the chain almost freely, so we prescribe its centre $Q$ and solve for its positions and for the parameter, $s$
or $\omega_b$, at which it exists there (held.hpp). We go from a site, $Q=0$, to the next bond, $Q=1/2$; the orbit at
one centre is the guess for the next.

![Centre, energy and stability of the breathers in between.](fig:x14) */
struct Between {
  double centre = 0;
  Wide parameter = 0, energy = 0;
  Estimate place{}, kappa{};
};

template <class T>
Held<T> held_problem(const Cut& cut, const Exchange& from, double centre) {
  Shooting<T> problem = in_precision<T>(problem_at(Centre::site, cut.at(from.place.value)));
  problem.symmetry = even_in_time(problem.chain.sites);
  return {problem, cut.along_s ? along_s<T>() : along_omega<T>(), T(centre)};
}

/**
Only the tiny energy barrier between site and bond fixes the parameter, and in double precision the error of
the parameter exceeds the whole interval on which the family exists. So double precision only moves the
breather to its centre. From there extended precision solves for it twice and independently, with tolerances
that differ by a factor of sixteen. The error is their difference plus what the violation of symplecticity
of the linearised flow (`defect`) makes of the parameter. */
Between describe_between(const Cut& cut, const Exchange& from, double centre,
                         const Vector<double>& near) {
  const auto held = held_problem<Wide>(cut, from, centre);
  std::array<Vector<Wide>, 2> x;
  std::array<Pairs<Wide>, 2> pairs;
  for (std::size_t coarser : {0U, 1U}) {
    const NewtonRule<Wide> how = rule<Wide>(int(coarser));
    x[coarser] = solve(held, Vector<Wide>(near.cast<Wide>()), how).x;
    const auto there = held.at(x[coarser]);
    pairs[coarser] = floquet_pairs(there.chain, held.start(x[coarser]), there.period(), how.events);
  }
  const Eigen::Index last = x[0].size() - 1;
  const double apart = double(magnitude<Wide>(x[1][last] - x[0][last]));
  Between out{centre, x[0][last], energy(held.at(x[0]).chain, held.start(x[0]))};
  out.place = {double(out.parameter), apart + double(pairs[0].defect) / std::abs(from.slope)};
  const Pair pair = compare_pairs(pairs[1], pairs[0]).front();
  out.kappa = {pair.kappa.real(), pair.error};
  return out;
}

/**
Newton's method needs a guess at each centre. The orbit at one centre is moved to the next, and the guess of
the parameter goes from one exchange to the other like the square of a sine. */
std::vector<Between> between(const Cut& cut, const Window_edge& edge, int count) {
  const Exchange& from = edge.found[0];
  const auto n = Eigen::Index(from.orbit.start.y.size());
  Vector<double> x(n + 1);
  for (Eigen::Index i = 0; i < n; ++i) x[i] = from.orbit.start.y[std::size_t(i)];
  const auto centre = [&](std::size_t k) { return double(k + 1) / (2 * count); };
  std::vector<Vector<double>> near;
  for (std::size_t k = 0; k + 1 < std::size_t(count); ++k) {
    const double wave = std::sin(pi<double>() * centre(k));
    x[n] = from.place.value + wave * wave * edge.width().value;
    near.push_back(moved_to_centre(held_problem<double>(cut, from, centre(k)), x));
    x = near.back();
  }
  std::vector<Between> out(near.size());
  parallel_for("breathers in between", out.size(),
               [&](std::size_t k) { out[k] = describe_between(cut, from, centre(k), near[k]); });
  return out;
}

/**
How does its energy change from a site to a bond? We compare it with those of the symmetric breathers at the
same parameters, hence at the same frequency: the share is zero at the site's energy and one at the bond's. */
double energy_share(const Cut& cut, const std::array<Exchange, 2>& ends, const Between& one) {
  std::array<Wide, 2> e{};
  for (std::size_t k : {0U, 1U}) {
    const auto problem = problem_at(both_centres[k], cut.at(double(one.parameter)));
    auto wide = in_precision<Wide>(problem);
    if (!cut.along_s) wide.omega = one.parameter;
    e[k] = polish(wide, follow(problem, ends[k].orbit)).energy;
  }
  return double((one.energy - e[0]) / (e[1] - e[0]));
}

/**
[](finding:exchange.between) Half way the first of these families is at $s =$
[0.152520](num:sec33_between.middle_between_in_s), the second at $\omega_b =$
[1.32606](num:sec33_between.middle_between_in_omega). Other exchanges were not searched. The quick run has
only the first of the two. */
void report_between(Report& report, const std::vector<Window_edge>& edges) {
  // One cut along s, between the exchanges at 1.1, and one along the linear well, where both are unstable
  struct Family {
    const char* name;
    Cut cut;
    Window_edge edge;
  };
  std::vector<Family> families{{"between_in_s", Cut{}, {}}};
  parallel_for(2, [&](std::size_t k) {
    const Orbit<double> near = find_breather(problem_at(both_centres[k], {}));
    families[0].edge.found[k] = exchange<Wide>(both_centres[k], Cut{}, 0.1, 0.2, near);
  });
  report.facts.add("exchange_gap", families[0].edge.width());
  const auto both_unstable = [](const Window_edge& edge) {
    return edge.between() == "unstable" && edge.found[0].place.value > 1.3;
  };
  const auto last = std::find_if(edges.begin(), edges.end(), both_unstable);
  if (last != edges.end()) families.push_back({"between_in_omega", {false, 0}, *last});

  for (const auto& [name, cut, edge] : families) {
    // The family, and its energy on the way from the site's to the bond's
    const auto family = between(cut, edge, report.quick ? 2 : 10);
    std::vector<double> share(family.size());
    parallel_for(share.size(), [&, &cut = cut, &edge = edge](std::size_t i) {
      share[i] = energy_share(cut, edge.found, family[i]);
    });

    // It begins and ends at the two exchanges themselves, the first and the last row
    Table& table =
        report.table(name, {number("centre", "Q, sites from the site at which it begins", "site"),
                            estimate("parameter", "s, or omega_b"),
                            estimate("offset", "parameter minus that of the exchange at the site",
                                     "", "of both, against the largest"),
                            number("share", "(E - E_site) / (E_bond - E_site) at equal frequency"),
                            estimate("kappa", "of its pinning pair: positive where it is unstable",
                                     "", "from two tolerances, against the largest")});
    const Estimate &site = edge.found[0].place, &bond = edge.found[1].place;
    const Estimate zero{};
    table.add({0.0, site, Estimate{0, site.error}, 0.0, zero});
    for (std::size_t i = 0; i < family.size(); ++i) {
      const Between& one = family[i];
      const Estimate offset{double(one.parameter - Wide(site.value)), one.place.error + site.error};
      table.add({one.centre, one.place, offset, share[i], one.kappa});
    }
    table.add({0.5, bond, edge.width(), 1.0, zero});

    // Half way
    const Between& middle = family[family.size() / 2];
    report.facts.add(std::string("kappa_") + name, middle.kappa);
    report.facts.add(std::string("middle_") + name, middle.place);
  }
}

/**
## Differences and limits

The chart follows each family in $s$ only until Newton's method fails, which for soft wells is near the
fold of the family.

## Extensions

- Follow the breather in between through the whole plane: where is it stable?
- Does a kicked breather stop at the stable breather in between?
- At a zero of the second harmonic of the barrier three curves of exchange would meet: is there one in the
  plane? */
void reproduce(Report& report) {
  report.output.note("tolerance", "flow to 128 and 2048 roundings of the type");
  const Chart site = chart(Centre::site, report.quick), bond = chart(Centre::bond, report.quick);

  // The frequency of the article's figures is none of the chart's
  std::array<Nodes, 2> columns;
  parallel_for(2, [&](std::size_t k) {
    columns[k] = wells_at(1.1, int(site[0].size() / 2));
    Node& middle = columns[k][columns[k].size() / 2];
    middle.orbit = find_breather(problem_at(both_centres[k], middle.spot));
    visit_wells(both_centres[k], columns[k]);
  });
  std::vector<Seen> at_110;
  for (std::size_t k : {0U, 1U})
    for (const Node& node : columns[k])
      if (node.exists()) at_110.push_back({both_centres[k], &node});
  const double spacing = site[1][0].spot.omega_b - site[0][0].spot.omega_b;
  const auto seen = report_multipliers(report, site, bond);
  report_range(report, seen, judge_lines(report, seen, at_110, spacing), spacing);
  report_exchanges(report, site);
  report_between(report, report_windows(report, site));
}

int main(int argc, char** argv) {
  return run({"sec33_between", "3.3", "Breathers centred nowhere (section 3.3)", reproduce}, argc,
             argv);
}
