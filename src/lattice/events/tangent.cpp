#include "lattice/events/tangent.hpp"

#include <cmath>

#include "lattice/events/columns.hpp"

namespace lattice {

template <class T>
T extrapolation_weight(std::size_t j, std::size_t levels) {
  T weight(1);
  for (std::size_t i = 1; i <= levels; ++i)
    if (i != j) weight *= T(double(j * j)) / (T(double(j * j)) - T(double(i * i)));
  return weight;
}

template <class T>
Window core_of(const Chain& chain, const StepRecord<T>& record,
               std::type_identity_t<T> negligible) {
  const std::size_t n = chain.sites;
  const T rest = chain.well.stiffness(T(0));
  const auto light = [&](std::size_t i) { return i < n ? inverse_mass<T>(chain, i) : T(0); };
  const auto stiff = [&](const Curvature<T>& node, std::size_t i) {
    return std::max(light(i - 1), light(i)) * node.link[i] > negligible;
  };
  const auto live = [&](const Curvature<T>& node, std::size_t i) {
    const T change = light(i) * (node.well[i] - rest);
    return change > negligible || change < -negligible || stiff(node, i) || stiff(node, i + 1);
  };
  // From either end inwards, in each node up to where the last one stopped
  std::size_t first = n, last = 0;
  for (std::size_t k = 0; k < record.nodes.size(); ++k) {
    const Curvature<T> node = record.nodes[k];
    for (std::size_t i = 0; i < first; ++i)
      if (live(node, i)) first = i;
    for (std::size_t i = n; i > last; --i)
      if (live(node, i - 1)) last = i;
  }
  if (first == n) return {n, n};
  return chain.ends == Ends::periodic ? Window{0, n} : Window{first, last};
}

namespace detail {

/**
The work is done on a block of rows and columns of the tangent that is copied to a place of its
own, positions `y` and velocities `v` row by row. */
template <class T>
struct ColumnBlock {
  std::size_t rows = 0, columns = 0;
  std::vector<T> y, v;
  void resize(std::size_t row_count, std::size_t column_count) {
    rows = row_count;
    columns = column_count;
    y.assign(rows * columns, T(0));
    v.assign(rows * columns, T(0));
  }
};

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
template <class T>
void rotate_outside(const Chain& chain, Window core, T duration, Tangent<T>& tangent) {
  for (std::size_t n = 0; n < chain.sites; ++n) {
    if (n >= core.first && n < core.last) continue;
    const AtRest<T> turn(chain.well.stiffness(T(0)) * inverse_mass<T>(chain, n), duration);
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
there. Only the others are packed into the block. */
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
Now we advance the columns by one step. Every level starts from the same block. We sum the weighted
increments rather than the weighted values, because the weights are large and alternate in sign, and
their rounding would otherwise spoil the entries of order one. */
template <class T>
void extrapolate_block(const Chain& chain, const StepRecord<T>& record, Window core,
                       ColumnBlock<T>& block) {
  const std::size_t count = block.y.size();
  std::vector<TangentRow<T>> rows(block.rows);
  std::vector<T> y, v, dy(count, T(0)), dv(count, T(0));
  std::size_t at = 0;
  // Level j crosses the step in j substeps, along the positions that the trajectory had there
  for (std::size_t j = 1; j <= record.levels(); ++j) {
    y = block.y;
    v = block.v;
    add_scaled(y.data(), v.data(), record.lead[j - 1], count);
    for (std::size_t i = 0; i < j; ++i, ++at) {
      const Curvature<T> node = record.nodes[at];
      for (std::size_t n = 0; n < block.rows; ++n)
        rows[n] = row_at(chain, node, core, core.first + n);
      kick_block(rows.data(), y.data(), v.data(), block.rows, block.columns);
      add_scaled(y.data(), v.data(), node.drift, count);
    }
    // What this level adds to the start enters with its extrapolation weight
    add_scaled(y.data(), block.y.data(), T(-1), count);
    add_scaled(v.data(), block.v.data(), T(-1), count);
    const T weight = extrapolation_weight<T>(j, record.levels());
    add_scaled(dy.data(), y.data(), weight, count);
    add_scaled(dv.data(), v.data(), weight, count);
  }
  add_scaled(block.y.data(), dy.data(), T(1), count);
  add_scaled(block.v.data(), dv.data(), T(1), count);
}

}  // namespace detail

using namespace detail;

// Sites in the tail feel nothing but their wells; those of the core feel their contacts too
template <class T>
void advance_tangent(const Chain& chain, const StepRecord<T>& record,
                     std::type_identity_t<T> negligible, Tangent<T>& tangent) {
  const Window core = core_of(chain, record, negligible);
  const Packing<T> packing(tangent, core);
  rotate_outside(chain, core, record.duration, tangent);
  if (packing.columns.empty()) return;
  // Columns that reach the core, their number rounded up to a multiple of eight
  const std::size_t width = (packing.columns.size() + 7) / 8 * 8, half = chain.sites;
  ColumnBlock<T> block;
  block.resize(core.last - core.first, width);
  packing.each(width, [&](std::size_t n, std::size_t k, std::size_t at) {
    block.y[at] = tangent(n, k);
    block.v[at] = tangent(n + half, k);
  });
  extrapolate_block(chain, record, core, block);
  packing.each(width, [&](std::size_t n, std::size_t k, std::size_t at) {
    tangent(n, k) = block.y[at];
    tangent(n + half, k) = block.v[at];
  });
}

#define LATTICE_INSTANCES(T)                                         \
  template T extrapolation_weight<T>(std::size_t, std::size_t);      \
  template Window core_of<T>(const Chain&, const StepRecord<T>&, T); \
  template void advance_tangent<T>(const Chain&, const StepRecord<T>&, T, Tangent<T>&);
#include "lattice/model/instances.hpp"

}  // namespace lattice
