#pragma once
/**
# The tangent map

Newton's method and Floquet theory need the derivative of the flow, the *tangent map*: by how much does
the state at the end of a run change if that at its start is changed a little? A small change
$\delta y$ of an orbit $y$ of the chain (chain.hpp) obeys the variational equation
$$\mu_n\,\delta\ddot y_n = -\bigl(W''(y_n)+k_{n-1}+k_n\bigr)\,\delta y_n
  + k_{n-1}\,\delta y_{n-1} + k_n\,\delta y_{n+1},\qquad k_n = \eta_n V''(y_{n+1}-y_n),$$
where $k_n$ is the stiffness of the contact between the beads $n$ and $n+1$. The system is linear and
its matrix tridiagonal and the same for all changes. We carry many of them at once, each a column of a
matrix, and keep the entries of a row next to each other in memory: the three coefficients of the row are
then scalars, and the processor works on as many columns at a time as its vectors are wide. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lattice/model/chain.hpp"

namespace lattice {

/**
A tangent holds its columns as an array of `2 * sites` rows: first those of the positions, then those of
the velocities. It begins as the identity, or as its first `columns` columns. Carried along a periodic
orbit for one period, the identity becomes the monodromy matrix, whose eigenvalues are the Floquet
multipliers (floquet.hpp). Its first `sites` columns belong to changes of the initial positions. */
template <class T>
struct Tangent {
  std::size_t sites = 0, columns = 0;
  std::vector<T> entries;

  Tangent(std::size_t site_count, std::size_t column_count)
      : sites(site_count), columns(column_count), entries(2 * sites * columns, T(0)) {
    for (std::size_t i = 0; i < std::min(2 * sites, columns); ++i) (*this)(i, i) = T(1);
  }
  T& operator()(std::size_t row, std::size_t column) { return entries[row * columns + column]; }
  const T& operator()(std::size_t row, std::size_t column) const {
    return entries[row * columns + column];
  }
  T* row(std::size_t i) { return entries.data() + i * columns; }
};

/**
At one instant the matrix of the variational equation is known from the second derivatives of all wells and
contacts, which we call curvatures. They are kept together with the duration of the kick and of the drift
that they serve (schemes.hpp explains the two words). */
template <class T>
struct Curvature {
  T kick, drift;
  std::vector<T> well, link;  ///< link[i] belongs to the contact of i - 1 with i
};

/**
Orbit and columns need not be computed together. A step of the integrator of crossing.hpp combines several
leapfrog runs over the same interval: that of level $j$ drifts by `lead[j - 1]` and then alternates $j$
kicks and drifts. The orbit is computed first and leaves a record of the curvatures that it met; the
columns follow it afterwards. */
template <class T>
struct Record {
  T duration = 0;
  std::vector<T> lead;
  std::vector<Curvature<T>> nodes;  ///< one for level 1, two for level 2, and so on

  std::size_t levels() const { return lead.size(); }
};

/**
How are the runs combined? Those of $1, 2, \dots, k$ kicks differ from the exact solution by a series in
even powers of their step. The polynomial in $1/j^2$ through their results, taken at zero, is free of its
first $k-1$ terms, and Lagrange's formula gives the weights (Richardson extrapolation):
$$w_j = \prod_{i \ne j} \frac{j^2}{j^2 - i^2}, \qquad \sum_j w_j = 1.$$ */
template <class T>
T extrapolation_weight(std::size_t j, std::size_t levels) {
  T weight(1);
  for (std::size_t i = 1; i <= levels; ++i)
    if (i != j) weight *= T(double(j * j)) / (T(double(j * j)) - T(double(i * i)));
  return weight;
}

/**
The work is done on a panel, a block of rows and columns of the tangent that is copied to a place of its
own, positions `y` and velocities `v` row by row. */
template <class T>
struct Panel {
  std::size_t rows = 0, columns = 0;
  std::vector<T> y, v;
  void resize(std::size_t row_count, std::size_t column_count) {
    rows = row_count;
    columns = column_count;
    y.assign(rows * columns, T(0));
    v.assign(rows * columns, T(0));
  }
};

/// Coefficients of a row: of the own displacement, and of those of the left and right neighbour.
template <class T>
struct Row {
  T self, left, right;
};

/**
Nearly all the time is spent in the two loops below. The end rows of an open chain have a zero coefficient
for the neighbour that they lack, so the index may wrap around as on a ring. */
template <class T>
LATTICE_WIDE void kick_panel(const Row<T>* row, const T* y, T* v, std::size_t rows,
                             std::size_t columns) {
  for (std::size_t n = 0; n < rows; ++n) {
    const T self = row[n].self, left = row[n].left, right = row[n].right;
    const T* __restrict__ here = y + n * columns;
    const T* __restrict__ before = y + (n > 0 ? n - 1 : rows - 1) * columns;
    const T* __restrict__ after = y + (n + 1 < rows ? n + 1 : 0) * columns;
    T* __restrict__ speed = v + n * columns;
    for (std::size_t c = 0; c < columns; ++c)
      speed[c] += (left * before[c] + right * after[c]) + self * here[c];
  }
}

/// `y += factor * v`, for a drift and for the sum of the levels.
template <class T>
LATTICE_WIDE void add_scaled(T* __restrict__ y, const T* __restrict__ v, T factor,
                             std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) y[i] += factor * v[i];
}

/**
Far from the centre of a breather (a vibration that is localized at a few sites) the contacts hardly push,
and a tangent does not notice accelerations far below the precision asked for. There a change oscillates
by itself in the well as it is at rest, and we know this motion exactly. The sites in between are the
core: from the first to the last one with a contact whose stiffness over the mass exceeds `negligible`, or
a well whose curvature differs from its value at rest by more than that. With precompression the contacts
are stiff at rest, and the core is the whole chain. */
template <class T, class Onsite, class Contact>
Window core_of(const Chain<Onsite, Contact>& chain, const Record<T>& record, T negligible) {
  const std::size_t n = chain.sites;
  const T rest = chain.onsite.stiffness(T(0));
  std::vector<char> live(n, 0);
  const auto light = [&](std::size_t i) { return i < n ? lightness<T>(chain, i) : T(0); };
  for (const Curvature<T>& node : record.nodes)
    for (std::size_t i = 0; i <= n; ++i) {
      const bool stiff = std::max(light(i - 1), light(i)) * node.link[i] > negligible;
      if (stiff && i > 0) live[i - 1] = 1;
      if (stiff && i < n) live[i] = 1;
      if (i < n) {
        const T change = light(i) * (node.well[i] - rest);
        if (change > negligible || change < -negligible) live[i] = 1;
      }
    }
  Window core{0, n};
  while (core.first < n && !live[core.first]) ++core.first;
  while (core.last > core.first && !live[core.last - 1]) --core.last;
  const bool ring = chain.ends == Ends::periodic && core.first < core.last;
  return ring ? Window{0, n} : core;
}

/**
The core's rows of the matrix come multiplied by the duration of the kick. The contacts across the edges
of the core are negligible or lead to a wall, and so they count in the diagonal alone. */
template <class T, class Onsite, class Contact>
void rows_at(const Chain<Onsite, Contact>& chain, const Curvature<T>& node, Window core,
             std::vector<Row<T>>& rows) {
  const bool ring = chain.ends == Ends::periodic;
  rows.resize(core.last - core.first);
  for (std::size_t n = core.first; n < core.last; ++n) {
    const T push = node.kick * lightness<T>(chain, n);
    const T left = node.link[n], right = node.link[n + 1];
    rows[n - core.first] = {-push * (node.well[n] + left + right),
                            n > core.first || ring ? push * left : T(0),
                            n + 1 < core.last || ring ? push * right : T(0)};
  }
}

/**
Outside the core a change obeys $\mu\,\delta\ddot y = -K\,\delta y$ with the curvature $K = W''(0)$ at
rest. In a well, $K > 0$, position and velocity turn by the angle $\omega t$ with $\omega^2 = K/\mu$;
without a well they drift; and on top of a hill, $K < 0$, the circular functions become hyperbolic. */
template <class T>
struct AtRest {
  T y_y, y_v, v_y, v_v;

  AtRest(T stiffness, T duration) : y_y(1), y_v(duration), v_y(0), v_v(1) {
    using std::cos, std::sin, std::cosh, std::sinh, std::sqrt;
    const T omega = sqrt(stiffness < T(0) ? -stiffness : stiffness), angle = omega * duration;
    if (stiffness == T(0)) return;
    const bool well = stiffness > T(0);
    const T s = well ? sin(angle) : sinh(angle);
    y_y = v_v = well ? cos(angle) : cosh(angle);
    y_v = s / omega;
    v_y = well ? -(s * omega) : s * omega;
  }
};

/**
A whole step costs each of these sites one such rotation of its columns, however many levels it took in
the core. */
template <class T, class Onsite, class Contact>
void rotate_outside(const Chain<Onsite, Contact>& chain, Window core, T duration,
                    Tangent<T>& tangent) {
  for (std::size_t n = 0; n < chain.sites; ++n) {
    if (n >= core.first && n < core.last) continue;
    const AtRest<T> turn(chain.onsite.stiffness(T(0)) * lightness<T>(chain, n), duration);
    T *y = tangent.row(n), *v = tangent.row(n + chain.sites);
    for (std::size_t k = 0; k < tangent.columns; ++k) {
      const T old = y[k];
      y[k] = turn.y_y * old + turn.y_v * v[k];
      v[k] = turn.v_v * v[k] + turn.v_y * old;
    }
  }
}

/**
A column that vanishes throughout the core, such as one that begins far out in the tail, remains zero
there. Only the others are packed into the panel. */
template <class T>
struct Packing {
  Window core;
  std::vector<std::size_t> columns;

  Packing(const Tangent<T>& tangent, Window window) : core(window) {
    for (std::size_t k = 0; k < tangent.columns; ++k)
      for (std::size_t n = core.first; n < core.last; ++n)
        if (tangent(n, k) != T(0) || tangent(n + tangent.sites, k) != T(0)) {
          columns.push_back(k);
          break;
        }
  }
  template <class Move>
  void each(std::size_t stride, Move move) const {
    for (std::size_t n = core.first; n < core.last; ++n)
      for (std::size_t k = 0; k < columns.size(); ++k)
        move(n, columns[k], (n - core.first) * stride + k);
  }
};

/**
Now we carry the columns over one step. Every level starts from the same panel. We sum the weighted
increments rather than the weighted values, because the weights are large and alternate in sign, and
their rounding would otherwise spoil the entries of order one. */
template <class T, class Onsite, class Contact>
void extrapolate_panel(const Chain<Onsite, Contact>& chain, const Record<T>& record, Window core,
                       Panel<T>& panel) {
  const std::size_t count = panel.y.size();
  std::vector<Row<T>> rows;
  std::vector<T> y, v, dy(count, T(0)), dv(count, T(0));
  std::size_t at = 0;
  for (std::size_t j = 1; j <= record.levels(); ++j) {
    y = panel.y;
    v = panel.v;
    add_scaled(y.data(), v.data(), record.lead[j - 1], count);
    for (std::size_t i = 0; i < j; ++i, ++at) {
      rows_at(chain, record.nodes[at], core, rows);
      kick_panel(rows.data(), y.data(), v.data(), panel.rows, panel.columns);
      add_scaled(y.data(), v.data(), record.nodes[at].drift, count);
    }
    add_scaled(y.data(), panel.y.data(), T(-1), count);
    add_scaled(v.data(), panel.v.data(), T(-1), count);
    const T weight = extrapolation_weight<T>(j, record.levels());
    add_scaled(dy.data(), y.data(), weight, count);
    add_scaled(dv.data(), v.data(), weight, count);
  }
  add_scaled(panel.y.data(), dy.data(), T(1), count);
  add_scaled(panel.v.data(), dv.data(), T(1), count);
}

/**
All together: `carry` replaces the columns of `tangent` by their images after the step that `record` holds.
Accelerations below `negligible` (per unit of displacement) count as none. The panel is padded to whole
vectors of eight columns. */
template <class T, class Onsite, class Contact>
void carry(const Chain<Onsite, Contact>& chain, const Record<T>& record, T negligible,
           Tangent<T>& tangent) {
  const Window core = core_of(chain, record, negligible);
  const Packing<T> packing(tangent, core);
  rotate_outside(chain, core, record.duration, tangent);
  if (packing.columns.empty()) return;
  const std::size_t width = (packing.columns.size() + 7) / 8 * 8, half = chain.sites;
  Panel<T> panel;
  panel.resize(core.last - core.first, width);
  packing.each(width, [&](std::size_t n, std::size_t k, std::size_t at) {
    panel.y[at] = tangent(n, k);
    panel.v[at] = tangent(n + half, k);
  });
  extrapolate_panel(chain, record, core, panel);
  packing.each(width, [&](std::size_t n, std::size_t k, std::size_t at) {
    tangent(n, k) = panel.y[at];
    tangent(n + half, k) = panel.v[at];
  });
}

}  // namespace lattice
