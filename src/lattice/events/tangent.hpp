#pragma once
/**
# The tangent map

The *tangent map* is the derivative of the flow: by how much does the state at the end of a run change if that at its
start is changed a little? A small change $\delta y$ of an orbit $y$ of the chain obeys the variational equation
$$\mu_n\,\delta\ddot y_n = -\bigl(W''(y_n)+k_{n-1}+k_n\bigr)\,\delta y_n
  + k_{n-1}\,\delta y_{n-1} + k_n\,\delta y_{n+1},\qquad k_n = \eta_n V''(y_{n+1}-y_n),$$
where $k_n$ is the stiffness of the contact between the beads $n$ and $n+1$. We carry many changes at once, each a
column of a matrix, and keep the entries of a row next to each other: the three coefficients of the row are then
scalars, and the processor works on as many columns at a time as its vectors are wide. */

#include <algorithm>
#include <cstddef>
#include <vector>

#include "lattice/model/chain.hpp"

namespace lattice {

/// Columns as an array of `2 * sites` rows: first those of the positions, then those of the velocities. Carried along a
/// periodic orbit for one period, the identity becomes the monodromy matrix (floquet.hpp).
template <class T>
struct Tangent {
  std::size_t sites = 0, columns = 0;
  std::vector<T> entries;  ///< row by row

  /// The first columns of the identity.
  Tangent(std::size_t site_count, std::size_t column_count)
      : sites(site_count), columns(column_count), entries(2 * sites * columns, T(0)) {
    for (std::size_t i = 0; i < std::min(2 * sites, columns); ++i) (*this)(i, i) = T(1);
  }
  /// Entry of row 0 <= row < 2 * sites.
  T& operator()(std::size_t row, std::size_t column) { return entries[row * columns + column]; }
  const T& operator()(std::size_t row, std::size_t column) const {
    return entries[row * columns + column];
  }
  /// The entries of row `i`: displacements first, then velocities.
  T* row(std::size_t i) { return entries.data() + i * columns; }
};

/// The second derivatives of all wells and contacts at one instant, which make the matrix of the variational equation,
/// with the duration of the kick and of the drift (schemes.hpp) that they serve.
template <class T>
struct Curvature {
  T kick, drift;         ///< durations
  const T *well, *link;  ///< link[i] belongs to the contact of i - 1 with i
};

/// Hundreds of them in one block of memory: allocating each would cost as much as a loop over the sites.
template <class T>
class Curvatures {
 public:
  /// One more along a chain of so many sites; returns where its wells are to be written, and then its links.
  T* add(std::size_t sites, T kick, T drift) {
    sites_ = sites;
    durations_.push_back(kick), durations_.push_back(drift);
    numbers_.resize(size() * (2 * sites + 1), T(0));
    return numbers_.data() + (size() - 1) * (2 * sites + 1);
  }
  /// Number `k`, from zero; valid until the next one is added.
  Curvature<T> operator[](std::size_t k) const {
    const T* well = numbers_.data() + k * (2 * sites_ + 1);
    return {durations_[2 * k], durations_[2 * k + 1], well, well + sites_};
  }
  std::size_t size() const { return durations_.size() / 2; }  ///< how many there are
  void clear() { durations_.clear(), numbers_.clear(); }

 private:
  std::size_t sites_ = 0;
  std::vector<T> durations_{}, numbers_{};
};

/// The curvatures that the orbit met in a step of location.hpp, which combines several leapfrog runs over the same
/// interval: that of level $j$ drifts by `lead[j - 1]` and then alternates $j$ kicks and drifts. The columns follow
/// later.
template <class T>
struct StepRecord {
  T duration = 0;         ///< of the step
  std::vector<T> lead{};  ///< first drift of each level
  Curvatures<T> nodes{};  ///< one for level 1, two for level 2, and so on

  /// How many leapfrog runs were combined.
  std::size_t levels() const { return lead.size(); }
};

/// Coefficients of a row: of the own displacement, and of those of the left and right neighbour.
template <class T>
struct TangentRow {
  T self, left, right;
};

/**
Far from the centre of a breather the contacts hardly push, and a change oscillates by itself in the well as it is at
rest, a motion that we know exactly. The sites in between are the core: from the first to the last one with a contact
whose stiffness over the mass exceeds `negligible`, or a well whose curvature differs from its value at rest by more
than that. With precompression the core is the whole chain. */
template <class T>
Window core_of(const Chain& chain, const StepRecord<T>& record, std::type_identity_t<T> negligible);

/// Replaces the columns of `tangent` by their images after the step that `record` holds. Accelerations below
/// `negligible` (per unit of displacement) count as none.
template <class T>
void advance_tangent(const Chain& chain, const StepRecord<T>& record,
                     std::type_identity_t<T> negligible, Tangent<T>& tangent);

}  // namespace lattice
