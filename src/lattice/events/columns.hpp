#pragma once
/**
# The loops over columns

What the orbit and the columns of a tangent (tangent.hpp) have in common: the rows of the variational
equation and the two loops that apply them, in which nearly all the time is spent. */

#include <cstddef>

#include "lattice/events/tangent.hpp"
#include "lattice/model/kernel.hpp"

namespace lattice {

/// The end rows of an open chain have a zero coefficient for the neighbour that they lack, so the index may wrap
/// around.
template <class T>
LATTICE_WIDE void kick_block(const TangentRow<T>* row, const T* y, T* v, std::size_t rows,
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

/// A row of the matrix times the duration of the kick. The contacts across the edges of the core are negligible or lead
/// to a wall, and count in the diagonal alone.
template <class T>
TangentRow<T> row_at(const Chain& chain, const Curvature<T>& node, Window core, std::size_t n) {
  const bool ring = chain.ends == Ends::periodic;
  const T push = node.kick * inverse_mass<T>(chain, n);
  const T left = node.link[n], right = node.link[n + 1];
  return {-push * (node.well[n] + left + right), n > core.first || ring ? push * left : T(0),
          n + 1 < core.last || ring ? push * right : T(0)};
}

}  // namespace lattice
