#include "lattice/events/location.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

#include "lattice/events/columns.hpp"
#include "lattice/model/kernel.hpp"

namespace lattice {
namespace {

/**
A few loops take most of the time and are left to the compiler to vectorise: one entry of the extrapolation
table from its two predecessors, the forces and curvatures (tangent.hpp) along the chain, the kicks of beads of
unit mass, and the largest difference of two rows of numbers. */
template <class T>
LATTICE_WIDE void extrapolate_entry(T* __restrict__ a, const T* __restrict__ b, T gain,
                                    std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) a[k] = b[k] + gain * (b[k] - a[k]);
}

template <class T, class C>
LATTICE_WIDE void sweep_curvature(const C contact, const T* __restrict__ y, std::size_t n,
                                  T* __restrict__ push, T* __restrict__ link) {
  for (std::size_t i = 1; i < n; ++i) {
    push[i] = contact.force(y[i] - y[i - 1]);
    link[i] = contact.stiffness(y[i] - y[i - 1]);
  }
}

template <class T>
LATTICE_WIDE void sweep_kick(T* __restrict__ v, T kick, const T* __restrict__ pull,
                             const T* __restrict__ push, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) v[i] += kick * (pull[i] + (push[i] - push[i + 1]));
}

/**
Numbers without a sign are ordered as their bits are, infinity above all of them and what is not a number above
that, so that a comparison of integers finds the largest and misses no runaway. */
[[maybe_unused]] LATTICE_WIDE std::int64_t largest_bits(const double* __restrict__ a,
                                                        const double* __restrict__ b,
                                                        std::size_t count) {
  constexpr std::int64_t no_sign = std::numeric_limits<std::int64_t>::max();
  std::int64_t most = 0;
  for (std::size_t k = 0; k < count; ++k)
    most = std::max(most, std::bit_cast<std::int64_t>(a[k] - b[k]) & no_sign);
  return most;
}

/// The largest |a[k] - b[k]|; infinite if anything is not a finite number.
template <class T>
T largest_difference(const T* a, const T* b, std::size_t count) {
  const T infinity = std::numeric_limits<T>::infinity();
  T most(0);
  if constexpr (std::is_same_v<T, double>)
    most = std::bit_cast<double>(largest_bits(a, b, count));
  else
    for (std::size_t k = 0; k < count && most < infinity; ++k) {
      const T d = a[k] - b[k], size = d < T(0) ? -d : d;
      if (!(size <= most)) most = size;
    }
  return most < infinity ? most : infinity;
}

/**
The tangent vector is one column, and its rows are used once: the coefficients (row_at in columns.hpp)
need not be kept. */
/// Adds to velocities `v` what a kick does to a column, for the rows 1 to n - 2 of beads of unit mass.
template <class T>
LATTICE_WIDE void sweep_tangent_vector(const T* __restrict__ y, T* __restrict__ v, T kick,
                                       const T* __restrict__ well, const T* __restrict__ link,
                                       std::size_t n) {
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const T left = link[i], right = link[i + 1], self = -kick * (well[i] + left + right);
    v[i] += ((kick * left) * y[i - 1] + (kick * right) * y[i + 1]) + self * y[i];
  }
}

/// A potential of the caller's own has no loop of ours, and wider numbers do not fit into vectors.
template <class T, class C>
void curvatures_of(const C& contact, const T* y, std::size_t n, T* push, T* link) {
  if constexpr (std::is_same_v<C, OwnContact>) {
    std::vector<T> r(n);
    for (std::size_t i = 1; i < n; ++i) r[i] = y[i] - y[i - 1];
    if (n < 2) return;
    forces_of(contact, r.data() + 1, push + 1, n - 1);
    stiffnesses_of(contact, r.data() + 1, link + 1, n - 1);
  } else if constexpr (std::is_same_v<T, double>) {
    sweep_curvature(contact, y, n, push, link);
  } else {
    for (std::size_t i = 1; i < n; ++i) {
      push[i] = contact.force(y[i] - y[i - 1]);
      link[i] = contact.stiffness(y[i] - y[i - 1]);
    }
  }
}

}  // namespace

template <class T>
void Leapfrog<T>::step(std::vector<T>& z, T dt) {
  StepRecord<T> unused;
  run(z, dt, T(0), T(1), 1, unused);
}

/**
Equal steps in $s$ are unequal ones in $t$. A kick lasts for the time between two whole steps, a drift for
the time between two half steps. The sequence is the same when run backwards, and so its error is a series
in even powers of the step, as extrapolation wants it. */
template <class T>
void Leapfrog<T>::run(std::vector<T>& z, T length, T s, T h, std::size_t kicks,
                      StepRecord<T>& record) {
  const T half = h / T(double(2 * kicks));
  const auto at = [&](std::size_t i) { return i == 2 * kicks ? s + h : s + half * T(double(i)); };
  record.lead.push_back(length * span(at(0), at(1)));
  drift(z, record.lead.back());
  for (std::size_t i = 1; i < 2 * kicks; i += 2) {
    // A run that keeps no record has room for one node
    if (!has_vector_) own_.clear();
    Curvatures<T>& nodes = has_vector_ ? record.nodes : own_;
    T* room = nodes.add(chain_.sites, length * span(at(i - 1), at(i + 1)),
                        length * span(at(i), at(std::min(i + 2, 2 * kicks))));
    evaluate(z.data(), room, room + chain_.sites);
    const Curvature<T> node = nodes[nodes.size() - 1];
    kick(z, node);
    drift(z, node.drift);
  }
}

template <class T>
void Leapfrog<T>::drift(std::vector<T>& z, T dt) const {
  const std::size_t n = chain_.sites;
  add_scaled(z.data(), z.data() + n, dt, n);
  const T* v = z.data() + n;
  T rate(0);
  if (chain_.mass.empty())
    for (std::size_t i = 0; i < n; ++i) rate += v[i] * v[i];
  else
    for (std::size_t i = 0; i < n; ++i) rate += T(chain_.mass[i]) * v[i] * v[i];
  z[2 * n] += rate * dt;
  if (has_vector_) add_scaled(z.data() + 2 * n + 1, z.data() + 3 * n + 1, dt, n);
}

template <class T>
void Leapfrog<T>::kick(std::vector<T>& z, const Curvature<T>& node) {
  const std::size_t n = chain_.sites;
  detail::with_kind(chain_.well,
                    [&](const auto& well) { forces_of(well, z.data(), pull_.data(), n); });
  if (chain_.mass.empty())
    sweep_kick(z.data() + n, node.kick, pull_.data(), push_.data(), n);
  else
    for (std::size_t i = 0; i < n; ++i)
      z[n + i] += node.kick * inverse_mass<T>(chain_, i) * (pull_[i] + (push_[i] - push_[i + 1]));
  if (has_vector_) kick_tangent_vector(node, z.data() + 2 * n + 1, z.data() + 3 * n + 1);
}

/**
The sweep over the tangent vector leaves out its end rows, and does not know of masses; for these the rows
are those of the columns. */
template <class T>
void Leapfrog<T>::kick_tangent_vector(const Curvature<T>& node, const T* y, T* v) const {
  const std::size_t n = chain_.sites;
  const Window all{0, n};
  const auto row = [&](std::size_t i) {
    kick_row(row_at(chain_, node, all, i), y[i > 0 ? i - 1 : n - 1], y[i], y[i + 1 < n ? i + 1 : 0],
             v[i]);
  };
  if (chain_.mass.empty())
    sweep_tangent_vector(y, v, node.kick, node.well, node.link, n);
  else
    for (std::size_t i = 1; i + 1 < n; ++i) row(i);
  row(0);
  if (n > 1) row(n - 1);
}

/**
A kick needs the forces, and its record the curvatures; both come from the same square roots. The vectorised sweep
leaves out the two end contacts, which depend on the boundary condition
(chain.hpp), and the stiffnesses $\eta_n$; both follow here. */
template <class T>
void Leapfrog<T>::evaluate(const T* y, T* well, T* link) {
  const std::size_t n = chain_.sites;
  ++evaluations;
  detail::with_kind(chain_.contact,
                    [&](const auto& contact) { curvatures_of(contact, y, n, push_.data(), link); });
  detail::with_kind(chain_.well, [&](const auto& kind) { stiffnesses_of(kind, y, well, n); });
  for (std::size_t i : {std::size_t(0), n}) {
    push_[i] = contact_push(chain_, y, i);
    link[i] = chain_.pushes(i)
                  ? T(chain_.eta_of(i)) * chain_.contact.stiffness(stretch(chain_, y, i))
                  : T(0);
  }
  for (std::size_t i = 1; i < n && !chain_.eta.empty(); ++i) {
    push_[i] *= T(chain_.eta[i]);
    link[i] *= T(chain_.eta[i]);
  }
}

template <class T>
SegmentIntegrator<T>::SegmentIntegrator(const Chain& chain, const EventTolerance<T>& rule,
                                        T amplitude)
    : chain_(chain), rule_(rule), amplitude_(amplitude) {
  rule_.tolerance = std::max(rule.tolerance, T(16) * std::numeric_limits<T>::epsilon());
}

/**
The first step tries the whole interval. What remains is always divided evenly, so that no sliver is left
at its end. */
template <class T>
SmoothSegment<T> SegmentIntegrator<T>::integrate(const std::vector<T>& z, T length,
                                                 bool tangent_vector) {
  SmoothSegment<T> segment{tangent_vector ? append_tangent_vector(z) : z, T(0), {}};
  Leapfrog<T> leapfrog(chain_, tangent_vector);
  const T shortest = T(1) / T(16384);
  T s(0), h(1);
  while (s < T(1) && segment.error <= T(1)) {
    const T pieces = T(int((T(1) - s) / h * T(0.999)) + 1);
    h = (T(1) - s) / pieces;
    StepRecord<T> record;
    record.duration = length * span(s, s + h);
    std::vector<T> end = segment.z;
    const T error = step(leapfrog, end, length, s, h, record);
    if (error > rule_.tolerance && h > shortest) {
      h *= error > T(100) * rule_.tolerance ? T(0.5) : T(0.75);
      continue;
    }

    /**
    The step is accepted. If half of the levels were enough for it, the next one may be twice as long. */
    segment.z = std::move(end);
    segment.error += error;
    s = pieces == T(1) ? T(1) : s + h;
    if (record.levels() <= std::size_t(rule_.levels + 1) / 2) h *= T(2);
    segment.records.push_back(std::move(record));
  }
  evaluations += leapfrog.evaluations;
  segment.z.resize(2 * chain_.sites + 1);
  return segment;
}

/**
The tangent vector must not miss what another one would see, as it might if it shared a symmetry of the orbit. It
begins each segment with the same numbers between $-1$ and 1, which have no symmetry. */
template <class T>
std::vector<T> SegmentIntegrator<T>::append_tangent_vector(std::vector<T> z) const {
  for (std::size_t i = 0, n = 2 * chain_.sites; i < n; ++i)
    z.push_back(T(int(7 * i % 11) - 5) / T(5));
  return z;
}

/**
The table of the extrapolation holds increments, whose rounding errors are smaller than those of the
values. After level $j$ its first entry is the polynomial in the square of the step through all $j$
results, taken at zero and computed by Neville's recursion. Returns the estimated error. */
template <class T>
T SegmentIntegrator<T>::step(Leapfrog<T>& leapfrog, std::vector<T>& z, T length, T s, T h,
                             StepRecord<T>& record) {
  T error = std::numeric_limits<T>::infinity();
  for (std::size_t j = 1; j <= std::size_t(rule_.levels) && !(error <= rule_.tolerance); ++j) {
    if (j > 1) previous_ = table_.front();
    if (j > table_.size()) table_.emplace_back();
    std::vector<T>& latest = table_[j - 1];
    latest = z;
    leapfrog.run(latest, length, s, h, j, record);
    add_scaled(latest.data(), z.data(), T(-1), z.size());
    for (std::size_t i = j - 1; i > 0; --i) {
      const T ratio = T(double(j)) / T(double(i)), gain = T(1) / (ratio * ratio - T(1));
      extrapolate_entry(table_[i - 1].data(), table_[i].data(), gain, z.size());
    }
    if (j > 1) error = difference(table_.front(), previous_);
  }
  add_scaled(z.data(), table_.front().data(), T(1), z.size());
  return error;
}

/**
The difference of two extrapolated values is relative to the amplitude for the orbit, to its square for the
area, and absolute for the tangent vector. It is infinite if anything is not a finite number. */
template <class T>
T SegmentIntegrator<T>::difference(const std::vector<T>& a, const std::vector<T>& b) const {
  const std::size_t orbit = 2 * chain_.sites;
  const auto worst = [&](std::size_t from, std::size_t to) {
    return largest_difference(a.data() + from, b.data() + from, to - from);
  };
  const T of_orbit = worst(0, orbit), of_area = worst(orbit, orbit + 1),
          of_vector = worst(orbit + 1, a.size());
  const T most = std::max({of_orbit, of_area, of_vector});
  if (!(most < std::numeric_limits<T>::infinity())) return most;
  return std::max({of_orbit / amplitude_, of_area / (amplitude_ * amplitude_), of_vector});
}

#define LATTICE_INSTANCES(T)  \
  template class Leapfrog<T>; \
  template class SegmentIntegrator<T>;
#include "lattice/model/instances.hpp"

}  // namespace lattice
