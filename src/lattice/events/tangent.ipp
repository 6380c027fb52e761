#pragma once
#include "lattice/events/tangent.hpp"

#include <cmath>

#include "lattice/events/columns.hpp"

namespace lattice {

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

/// A copy of rows and columns of the tangent, positions `y` and velocities `v` row by row.
template <class T>
struct ColumnBlock {
  std::size_t rows, columns;
  std::vector<T> y = std::vector<T>(rows * columns, T(0)), v = y;
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

/// A whole step costs each of these sites one such rotation of its columns.
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

/// The weight $w_j = \prod_{i \ne j} j^2/(j^2 - i^2)$ of the run of $j$ kicks (Richardson extrapolation): the runs
/// differ from the exact solution by a series in even powers of their step, and the sum is free of its first terms.
template <class T>
T extrapolation_weight(std::size_t j, std::size_t levels) {
  T weight(1);
  for (std::size_t i = 1; i <= levels; ++i)
    if (i != j) weight *= T(double(j * j)) / (T(double(j * j)) - T(double(i * i)));
  return weight;
}

/// Advances the columns by one step. Every level starts from the same block. The weighted increments are summed and not
/// the weighted values: the weights are large and alternate in sign, and their rounding would spoil entries of order
/// one.
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

template <class T>
void advance_tangent(const Chain& chain, const StepRecord<T>& record,
                     std::type_identity_t<T> negligible, Tangent<T>& tangent) {
  const Window core = core_of(chain, record, negligible);
  const std::size_t half = chain.sites;
  // A column that vanishes throughout the core remains zero there
  std::vector<std::size_t> columns;
  for (std::size_t k = 0; k < tangent.columns; ++k) {
    std::size_t n = core.first;
    while (n < core.last && tangent(n, k) == T(0) && tangent(n + half, k) == T(0)) ++n;
    if (n < core.last) columns.push_back(k);
  }
  rotate_outside(chain, core, record.duration, tangent);
  if (columns.empty()) return;
  // The others are packed into a block, their number rounded up to a multiple of eight
  const std::size_t width = (columns.size() + 7) / 8 * 8;
  ColumnBlock<T> block{core.last - core.first, width};
  const auto each = [&](auto move) {
    for (std::size_t n = core.first; n < core.last; ++n)
      for (std::size_t k = 0; k < columns.size(); ++k) {
        const std::size_t at = (n - core.first) * width + k;
        move(tangent(n, columns[k]), block.y[at]);
        move(tangent(n + half, columns[k]), block.v[at]);
      }
  };
  each([](const T& from, T& to) { to = from; });
  extrapolate_block(chain, record, core, block);
  each([](T& to, const T& from) { to = from; });
}

}  // namespace lattice

/// The functions of this file in a number type.
#define LATTICE_TANGENT(T)                                           \
  template Window core_of<T>(const Chain&, const StepRecord<T>&, T); \
  template void advance_tangent<T>(const Chain&, const StepRecord<T>&, T, Tangent<T>&);
