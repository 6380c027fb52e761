#pragma once
#include "lattice/events/location.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

#include "lattice/events/columns.hpp"
#include "lattice/model/kernel.hpp"

namespace lattice {
namespace {

// Loops that take most of the time and are left to the compiler to vectorise
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

/// A potential of the caller's own has no loop of ours.
template <class T, class C>
void curvatures_of(const C& contact, const T* y, std::size_t n, T* push, T* link) {
  if constexpr (std::is_same_v<C, OwnContact>) {
    std::vector<T> r(n);
    for (std::size_t i = 1; i < n; ++i) r[i] = y[i] - y[i - 1];
    if (n < 2) return;
    forces_of(contact, r.data() + 1, push + 1, n - 1);
    stiffnesses_of(contact, r.data() + 1, link + 1, n - 1);
  } else {
    sweep_curvature(contact, y, n, push, link);
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
  if (!chain_.variation)
    for (std::size_t i = 0; i < n; ++i) rate += v[i] * v[i];
  else
    for (std::size_t i = 0; i < n; ++i) rate += T(chain_.mass_of(i)) * v[i] * v[i];
  z[2 * n] += rate * dt;
  if (has_vector_) add_scaled(z.data() + 2 * n + 1, z.data() + 3 * n + 1, dt, n);
}

template <class T>
void Leapfrog<T>::kick(std::vector<T>& z, const Curvature<T>& node) {
  const std::size_t n = chain_.sites;
  std::visit([&](const auto& well) { forces_of(well, z.data(), pull_.data(), n); },
             chain_.well.kind);
  if (!chain_.variation)
    sweep_kick(z.data() + n, node.kick, pull_.data(), push_.data(), n);
  else
    for (std::size_t i = 0; i < n; ++i)
      z[n + i] += node.kick * inverse_mass<T>(chain_, i) * (pull_[i] + (push_[i] - push_[i + 1]));
  if (has_vector_) kick_tangent_vector(node, z.data() + 2 * n + 1, z.data() + 3 * n + 1);
}

// The sweep over the tangent vector leaves out its end rows, and does not know of masses
template <class T>
void Leapfrog<T>::kick_tangent_vector(const Curvature<T>& node, const T* y, T* v) const {
  const std::size_t n = chain_.sites;
  const Window all{0, n};
  const auto row = [&](std::size_t i) {
    const TangentRow<T> r = row_at(chain_, node, all, i);
    v[i] +=
        (r.left * y[i > 0 ? i - 1 : n - 1] + r.right * y[i + 1 < n ? i + 1 : 0]) + r.self * y[i];
  };
  if (!chain_.variation)
    sweep_tangent_vector(y, v, node.kick, node.well, node.link, n);
  else
    for (std::size_t i = 1; i + 1 < n; ++i) row(i);
  row(0);
  if (n > 1) row(n - 1);
}

/// Forces and curvatures, from the same square roots.
template <class T>
void Leapfrog<T>::evaluate(const T* y, T* well, T* link) {
  const std::size_t n = chain_.sites;
  ++evaluations;
  std::visit([&](const auto& contact) { curvatures_of(contact, y, n, push_.data(), link); },
             chain_.contact.kind);
  std::visit([&](const auto& kind) { stiffnesses_of(kind, y, well, n); }, chain_.well.kind);
  // The vectorised sweep leaves out the two end contacts and the stiffnesses eta_n
  for (std::size_t i : {std::size_t(0), n}) {
    push_[i] = contact_push(chain_, y, i);
    link[i] = chain_.has_contact(i)
                  ? T(chain_.eta_of(i)) * chain_.contact.stiffness(stretch(chain_, y, i))
                  : T(0);
  }
  for (std::size_t i = 1; i < n && chain_.variation; ++i) {
    push_[i] *= T(chain_.eta_of(i));
    link[i] *= T(chain_.eta_of(i));
  }
}

}  // namespace lattice

/// The functions of this file in a number type.
#define LATTICE_LEAPFROG(T) template class Leapfrog<T>;
