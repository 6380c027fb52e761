/**
# 3.3 The breather in between

Where does the stability of the two breathers change hands, and what happens there? Section 3.3 of
James, Kevrekidis and Cuevas (Physica D 251, 2013) finds that it does so in $s$ at $\omega_b = 1.1$
and leaves the bifurcations to future work. This program maps the exchanges over the plane of
$\omega_b$ and $s$ and finds the breathers that are born there: they are centred neither on a site nor on a
bond. The landscapes below are drawn so that a stable breather sits in a valley.

      landscape of          both stable:              both unstable:
      the centre             site  between  bond       site  between  bond
                                    __                 __            __
                                 __/  \__               \__      __/
                                /        \                 \____/

The article claims nothing here; what we find is measured. */
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "lattice/numbers/parallel.hpp"
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
`omega` and `s`, and $Q$, `centre`, is the centre of a breather in sites from the middle of the chain.

## The exchange in the plane of $\omega_b$ and $s$ (figure x13)

Is the exchange at $\omega_b = 1.1$ the only one? We compute $\kappa$ of the site-centred breather on a
grid, following it in $s$ from the linear well until the family ends. Around a bond the sign is
the opposite one, except in strips too narrow to be seen. On the grid a tolerance of $10^{-12}$ is enough,
since $\kappa$ is of the order of $10^{-9}$ or more nearly everywhere.

![Which breather is stable, and where they change places.](fig:x13) */
struct Node {
  Spot spot{};
  double kappa = std::numeric_limits<double>::quiet_NaN(), defect = kappa;
  Orbit<double> orbit{};
  bool exists() const { return !std::isnan(kappa); }
};
using Column_of_nodes = std::vector<Node>;

/**
A node is computed from the orbit of its neighbour, and left empty where the family ends. Beyond the end
Newton's method wanders off to large and costly motions, so it gets only eight iterations. An amplitude that
changes by more than 15 per cent from one well to the next betrays another family. */
NewtonRule<double> chart_rule() {
  NewtonRule<double> how;
  how.events.tolerance = 1e-12;
  how.most = 8;
  return how;
}

void visit(Node& node, const Orbit<double>& from) {
  try {
    const auto problem = problem_at(Centre::site, node.spot);
    node.orbit = follow(problem, from, chart_rule());
    const double growth = node.orbit.amplitude / from.amplitude;
    if (std::abs(growth - 1) > 0.15 && node.orbit.omega == from.omega) return;  // another family
    const auto pairs =
        floquet_pairs(problem.chain, node.orbit.start, node.orbit.period(), chart_rule().events);
    node.kappa = pairs.pinning();
    node.defect = pairs.defect;
  } catch (const NewtonFailed&) {
  }
}

/**
The nodes of one frequency form a column, and the columns can run side by side once each has a start. So we
first follow the linear well in $\omega_b$; from each of its breathers we go up and down in $s$. The
quick run ends at $\omega_b = 1.2$, after three pairs of exchanges. */
std::vector<Column_of_nodes> chart(int frequencies, int wells, double top) {
  std::vector<Column_of_nodes> grid;
  Orbit<double> seed = find_breather(problem_at(Centre::site, {1.01, 0}));
  for (int i = 0; i < frequencies; ++i) {
    const double omega = 1.01 + (top - 1.01) * double(i) / (frequencies - 1);
    Column_of_nodes column(std::size_t(2 * wells + 1));
    for (int k = -wells; k <= wells; ++k)
      column[std::size_t(k + wells)].spot = {omega, double(k) / wells};
    seed = column[std::size_t(wells)].orbit =
        follow(problem_at(Centre::site, {omega, 0}), seed, chart_rule());
    grid.push_back(std::move(column));
  }
  parallel_for("chart", grid.size(), [&](std::size_t i) {
    const auto middle = std::size_t(wells);
    Column_of_nodes& column = grid[i];
    visit(column[middle], column[middle].orbit);
    for (std::size_t k = middle + 1; k < column.size() && column[k - 1].exists(); ++k)
      visit(column[k], column[k - 1].orbit);
    for (std::size_t k = middle; k-- > 0 && column[k + 1].exists();)
      visit(column[k], column[k + 1].orbit);
  });
  return grid;
}

/**
The curves of exchange pass between the nodes: wherever neighbours on the grid, along either axis, have
opposite signs of $\kappa$, an exchange lies between them. */
struct Crossing_place {
  Cut cut;
  Trial_kappa low, high;
  const Node* near;
  Exchange found{};
  bool good = false;
};

std::vector<Crossing_place> crossings(const std::vector<Column_of_nodes>& grid) {
  std::vector<Crossing_place> out;
  const auto look = [&](const Node& a, const Node& b, bool along_s) {
    if (!(a.kappa * b.kappa < 0)) return;
    const auto at = [&](const Node& n) {
      return Trial_kappa{along_s ? n.spot.s : n.spot.omega, n.kappa};
    };
    out.push_back({{along_s, along_s ? a.spot.omega : a.spot.s}, at(a), at(b), &a});
  };
  for (std::size_t i = 0; i < grid.size(); ++i)
    for (std::size_t k = 0; k < grid[i].size(); ++k) {
      if (k > 0) look(grid[i][k - 1], grid[i][k], true);
      if (i > 0) look(grid[i - 1][k], grid[i][k], false);
    }
  return out;
}

/**
The figure colours the plane by the sign of $\kappa$, which gets a column of its own. */
Table chart_table(const std::vector<Column_of_nodes>& grid) {
  Table map{
      {number("omega", "frequency"), number("s", "anharmonicity"),
       number("kappa", "of the pinning pair around a site; nan where the family has ended"),
       number("kappa_error", "symplectic defect, against the neighbouring rows; may be nan"),
       number("sign", "of kappa: +1 where the site-centred breather is unstable; may be nan")}};
  for (const auto& column : grid)
    for (const Node& n : column)
      map.add({n.spot.omega, n.spot.s, n.kappa, n.defect,
               n.exists() ? (n.kappa > 0 ? 1.0 : -1.0) : n.kappa});
  return map;
}

/**
A curve for the eye needs no more than three digits: each exchange is refined until a step is shorter than a
thousandth, and the next step is the error. */
void refine_places(std::vector<Crossing_place>& places) {
  parallel_for("exchanges", places.size(), [&](std::size_t i) {
    Crossing_place& c = places[i];
    try {
      c.found =
          exchange_between(Centre::site, c.cut, c.low, c.high, c.near->orbit, 1e-3, chart_rule());
      c.good = true;
    } catch (const NewtonFailed&) {
    }
  });
}

/**
What is counted are the edges of this grid across which the sign of $\kappa$ changes: the number tells how many
searches were made, and depends on the grid. Near the end of a family a search may fail; the facts count how
many were lost. */
std::vector<Column_of_nodes> report_chart(Report& report) {
  auto grid = report.quick ? chart(12, 2, 1.2) : chart(80, 12, 2);
  auto places = crossings(grid);
  refine_places(places);
  Table curve{{number("omega", "frequency"), number("s", "anharmonicity at the exchange"),
               number("error", "of the coordinate along which it was found")}};
  int lost = 0;
  for (const Crossing_place& c : places) {
    lost += !c.good;
    const Spot spot = c.cut.at(c.found.place.value);
    if (c.good) curve.add({spot.omega, spot.s, c.found.place.error});
  }
  report.facts.add("chart_exchanges", exact(double(places.size())),
                   "edges of this grid that an exchange crosses");
  report.facts.add("chart_lost", exact(lost), "of these edges");
  report.output.add("chart", chart_table(grid));
  report.output.add("exchange_curves", std::move(curve));
  return grid;
}

/**
## The linear well: six exchanges

At $s = 0$ we locate all exchanges for both breathers in a wider type (a 64-bit mantissa). Between two
exchanges lies a *window* in which one of the two is stable. From $\omega_b = 1$ on it is the bond, as in the
DpS equation, but only up to [1.01794](num:sec33_between.window_1); between the last two exchanges,
[1.32615](num:sec33_between.window_5) and [1.49164](num:sec33_between.window_6), it is the site. Each exchange
is a close pair, one of the site-centred and one of the bond-centred breather. The order of the two tells
whether both breathers are stable between them or neither is; those of the first pair are too close to be
told apart. */
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
Around a bond the search interval is a little wider, because the two exchanges of a pair do not coincide. */
std::vector<Window_edge> window_edges(const std::vector<Column_of_nodes>& grid, bool quick) {
  std::vector<std::pair<const Node*, const Node*>> pairs;
  const std::size_t middle = grid.front().size() / 2;
  for (std::size_t i = 1; i < grid.size(); ++i)
    if (grid[i - 1][middle].kappa * grid[i][middle].kappa < 0)
      pairs.emplace_back(&grid[i - 1][middle], &grid[i][middle]);
  std::vector<Window_edge> edges(pairs.size());
  parallel_for("windows", 2 * pairs.size(), [&](std::size_t i) {
    const auto& [left, right] = pairs[i / 2];
    const Centre centre = both_centres[i % 2];
    Orbit<double> near = left->orbit;
    double low = left->spot.omega, high = right->spot.omega;
    if (centre == Centre::bond) {
      near = find_breather(problem_at(centre, {low, 0}));
      low -= 0.002, high += 0.002;
    }
    edges[i / 2].found[i % 2] = quick ? exchange<double>(centre, {false, 0}, low, high, near)
                                      : exchange<Wide>(centre, {false, 0}, low, high, near);
  });
  return edges;
}

/**
The figure marks the edges of the windows, so the table has one row for each pair of exchanges. */
std::vector<Window_edge> report_windows(Report& report, const std::vector<Column_of_nodes>& grid) {
  const auto edges = window_edges(grid, report.quick);
  Table table{{number("omega_site", "exchange of the site-centred breather, s = 0"),
               number("omega_site_error", "its error"),
               number("omega_bond", "exchange of the bond-centred breather"),
               number("omega_bond_error", "its error"),
               number("width", "omega_bond - omega_site; nan where it is below its error"),
               number("width_error", "of both together, against the largest; may be nan"),
               number("s", "anharmonicity: zero"),
               label("between", "what both breathers are between the two")}};
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const Window_edge& edge = edges[k];
    const Estimate &site = edge.found[0].place, &bond = edge.found[1].place;
    const Estimate none{std::nan(""), std::nan("")}, width = edge.resolved() ? edge.width() : none;
    table.add({site.value, site.error, bond.value, bond.error, width.value, width.error, 0.0,
               edge.between()});
    report.facts.add("window_" + std::to_string(k + 1), site);
    if (edge.resolved()) report.facts.add("window_width_" + std::to_string(k + 1), width);
  }
  report.output.add("windows", std::move(table));
  return edges;
}

/**
## The breather in between (figure x14)

Where both breathers are stable, or both unstable, a third one must lie between them. It can be shifted along
the chain almost freely, so we prescribe its centre $Q$ and solve for its positions and for the parameter, $s$
or $\omega_b$, at which it exists there (held.hpp). We go from a site, $Q=0$, to the next bond, $Q=1/2$; the
orbit at one centre is the guess for the next.

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
breather to its centre. From there the wider type solves for it twice and independently, with tolerances
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
The family begins and ends at the two exchanges themselves, so they are the first and the last row. */
Table between_table(const Cut& cut, const std::array<Exchange, 2>& ends,
                    const std::vector<Between>& family) {
  Table table{{number("centre", "Q, sites from the site at which it begins", "site"),
               number("parameter", "s, or omega_b"), number("parameter_error", "its error"),
               number("offset", "parameter minus that of the exchange at the site"),
               number("offset_error", "of both, against the largest"),
               number("share", "(E - E_site) / (E_bond - E_site) at equal frequency"),
               number("kappa", "of its pinning pair: positive where it is unstable"),
               number("kappa_error", "from two tolerances, against the largest")}};
  const Estimate &site = ends[0].place, &bond = ends[1].place;
  table.add({0.0, site.value, site.error, 0.0, site.error, 0.0, 0.0, 0.0});
  std::vector<double> share(family.size());
  parallel_for(share.size(), [&](std::size_t i) { share[i] = energy_share(cut, ends, family[i]); });
  for (std::size_t i = 0; i < family.size(); ++i)
    table.add({family[i].centre, family[i].place.value, family[i].place.error,
               double(family[i].parameter - Wide(site.value)), family[i].place.error + site.error,
               share[i], family[i].kappa.value, family[i].kappa.error});
  table.add({0.5, bond.value, bond.error, bond.value - site.value, bond.error + site.error, 1.0,
             0.0, 0.0});
  return table;
}

/**
At $\omega_b = 1.1$ the family exists on an interval of $s$ of length
[3.22e-7](num:sec33_between.exchange_gap), and it is unstable, with $\kappa =$
[1.262e-14](num:sec33_between.kappa_between_in_s) half way, at $s =$
[0.152520](num:sec33_between.middle_between_in_s): where both symmetric breathers are stable, the one between
them sits on the hill. At $s = 0$ near the exchange [1.32615](num:sec33_between.window_5) it is the other way
round: both symmetric breathers are unstable, and the stable breather is the one without symmetry, with
$\kappa =$ [-1.73285e-11](num:sec33_between.kappa_between_in_omega) at $\omega_b =$
[1.32606](num:sec33_between.middle_between_in_omega). The quick run has only the first of the two. */
void report_between(Report& report, const std::vector<Window_edge>& edges) {
  const int count = report.quick ? 2 : 10;
  std::array<Exchange, 2> ends;
  parallel_for(2, [&](std::size_t k) {
    const Orbit<double> near = find_breather(problem_at(both_centres[k], {}));
    ends[k] = exchange<Wide>(both_centres[k], Cut{}, 0.1, 0.2, near);
  });
  const Window_edge in_s{ends};
  report.facts.add("exchange_gap", in_s.width());
  const auto add = [&](const std::string& name, const Cut& cut, const Window_edge& edge) {
    const auto family = between(cut, edge, count);
    const Between& middle = family[family.size() / 2];
    report.facts.add("kappa_" + name, middle.kappa);
    report.facts.add("middle_" + name, middle.place);
    report.output.add(name, between_table(cut, edge.found, family));
  };
  add("between_in_s", Cut{}, in_s);
  for (const Window_edge& edge : edges)
    if (edge.between() == "unstable" && edge.found[0].place.value > 1.3) {
      add("between_in_omega", {false, 0}, edge);
      break;
    }
}

/**
## Differences and limits

The chart follows each family in $s$ only until Newton's method fails, which for soft wells is near the
fold of the family. It shows the exchange of the pinning pair and no other instability.

## Extensions

- Follow the breather in between through the whole plane: where is it stable?
- Does a kicked breather stop at the stable breather in between?
- At a zero of the second harmonic of the barrier three curves of exchange would meet: is there one in the
  plane? */
void reproduce(Report& report) {
  report.output.note("tolerance", "flow to 128 and 2048 roundings of the type");
  const auto grid = report_chart(report);
  report_between(report, report_windows(report, grid));
}

int main(int argc, char** argv) {
  return run({"sec33_between", "3.3", "Breathers centred nowhere (section 3.3)", reproduce}, argc,
             argv);
}
