#pragma once
/**
# Crossing an interval between switchings

Periodic orbits and their Floquet multipliers are wanted to the last digits, and switchings stand in the
way. A contact of overlap $x$ pushes with $x_+^{3/2}$. Where it opens or closes, at $t^*$, its overlap
crosses zero at a finite speed, so along an orbit the force behaves like $(t-t^*)_+^{3/2}$ and the
stiffness, its derivative, like $(t-t^*)_+^{1/2}$. A formula of any order that takes a step $h$ across
$t^*$ integrates these as if they were polynomials, and errs by $h\cdot h^{3/2}$ in the state and by
$h\cdot h^{1/2}$ in the tangent map (tangent.hpp). Ending a step at $t^*$ is not enough: the derivatives of
the square root still blow up at the end of the step.

A change of the independent variable repairs this. With $t = t^* + u^2$ the root $(t-t^*)^{1/2} = u$
becomes a straight line, and the whole solution, which is a power series in $(t-t^*)^{1/2}$, becomes one
in $u$. The formula then has its full accuracy again. This file crosses an interval whose ends are
switchings; landing.hpp finds the ends. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "lattice/landing/tangent.hpp"
#include "lattice/model/chain.hpp"

namespace lattice {

/**
An interval $[a, a+L]$ between two switchings needs the square at both ends, and the simplest map with
that property is the cubic
$$t = a + L\,\varphi(s), \qquad \varphi(s) = 3s^2 - 2s^3, \qquad 0 \le s \le 1,$$
for which $t - a \simeq 3Ls^2$ and $a + L - t \simeq 3L(1-s)^2$. We use it on every interval; at an end
without a switching it does no harm. Unlike a cosine it needs no library function, so that its bits are
the same everywhere.

The tangent map passes a switching without a jump. In general the derivative of a flow across a surface
in phase space gains a term proportional to the jump of the vector field there. Here the contact force
is continuous and the jump is zero; that the instant of switching depends on the initial state does not
matter to first order.

Only differences $\varphi(e)-\varphi(s)$ are needed, and they factorise, so that short ones lose no
digits to cancellation. */
template <class T>
T span(T s, T e) {
  return (e - s) * (T(3) * (s + e) - T(2) * (s * s + s * e + e * e));
}

/**
A single number governs the accuracy: `tolerance` bounds the error of a step, relative to the amplitude
for the orbit and absolute for a tangent of order one. By default it is 128 units in the last place. The
other members rarely need to be set. `floor` is explained at `Care` in landing.hpp; `sight` is short
against the period $2\pi$ of a well; and a number type with more digits needs more `levels` of the
extrapolation below. */
template <class T>
struct Landing {
  T tolerance = T(128) * std::numeric_limits<T>::epsilon();
  T floor = T(-1);    ///< slower switchings are not landed on; < 0: from the tolerance
  T sight = T(0.05);  ///< time step of the look-out for switchings
  int levels = 2 + std::numeric_limits<T>::digits10 / 2;  ///< of the extrapolation, at most
};

/// What a flow did. `error` is the sum of the estimates of all steps, measured like the tolerance; if
/// the solution runs away it exceeds one or is infinite, and the state is the last one computed.
template <class T>
struct Flow {
  std::size_t switchings = 0;   ///< contacts that opened or closed at the end of an interval
  std::size_t unlanded = 0;     ///< contacts that did so in the middle of a step all the same
  std::size_t steps = 0;        ///< of the final passage; their column work is `column_sweeps`
  std::size_t evaluations = 0;  ///< of the force on the whole chain
  std::size_t column_sweeps = 0;
  T error = T(0);
  T energy_drift = T(0);  ///< relative
  T area = T(0);          ///< time integral of sum mu_n v_n^2
};

/**
Two loops take most of the time and are left to the compiler to vectorise: one entry of the extrapolation
table from its two predecessors, and the forces and curvatures (tangent.hpp) along the chain. */
template <class T>
LATTICE_WIDE void refine(T* __restrict__ a, const T* __restrict__ b, T gain, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) a[k] = b[k] + gain * (b[k] - a[k]);
}

template <class T, class Onsite, class Contact>
LATTICE_WIDE void sweep_curvature(const Onsite onsite, const Contact contact,
                                  const T* __restrict__ y, std::size_t n, T* __restrict__ push,
                                  T* __restrict__ link, T* __restrict__ well) {
  for (std::size_t i = 1; i < n; ++i) {
    push[i] = contact.force(y[i] - y[i - 1]);
    link[i] = contact.stiffness(y[i] - y[i - 1]);
  }
  for (std::size_t i = 0; i < n; ++i) well[i] = onsite.stiffness(y[i]);
}

/**
The orbit travels with one column of the tangent, a *probe*. It shows how accurate the columns will be, and
whether the step suits them, before we carry all of them: the orbit is smoother than its tangent by one
derivative and would be content with too long a step. Positions `y`, velocities `v`, the area and, if
there is a probe, its two halves lie in one array.

The area $\mathcal A = \int\sum\mu_n\dot y_n^2\,dt$ over a period, the action by which section 3.2
compares breathers, travels along as one more position: while the chain drifts its velocities are
constant, and so is the rate of the area. Its extrapolation is then as accurate as that of the orbit.

The leapfrog drifts, kicks and drifts, so that it never evaluates a contact at the very instant of a
switching, where the square root would magnify rounding errors. */
template <class T, class Onsite, class Contact>
class Leapfrog {
 public:
  Leapfrog(const Chain<Onsite, Contact>& chain, bool probe)
      : chain_(chain), probe_(probe), push_(chain.sites + 1, T(0)) {}

  /// `kicks` kicks from `s` to `s + h` on an interval of the given length; adds to `record`.
  void run(std::vector<T>& z, T length, T s, T h, std::size_t kicks, Record<T>& record);
  /// One plain step of duration `dt`: drift for half of it, kick, drift for the other half.
  void step(std::vector<T>& z, T dt) {
    Record<T> unused;
    run(z, dt, T(0), T(1), 1, unused);
  }
  std::size_t evaluations = 0;

 private:
  void drift(std::vector<T>& z, T dt) const;
  void kick(std::vector<T>& z, Curvature<T>& node);
  void evaluate(const T* y, Curvature<T>& node);

  const Chain<Onsite, Contact>& chain_;
  bool probe_;
  std::vector<T> push_;
  std::vector<Row<T>> rows_;
};

/**
Equal steps in $s$ are unequal ones in $t$. A kick lasts for the time between two whole steps, a drift for
the time between two half steps. The sequence is the same when run backwards, and so its error is a series
in even powers of the step, as extrapolation wants it. */
template <class T, class Onsite, class Contact>
void Leapfrog<T, Onsite, Contact>::run(std::vector<T>& z, T length, T s, T h, std::size_t kicks,
                                       Record<T>& record) {
  const T half = h / T(double(2 * kicks));
  const auto at = [&](std::size_t i) { return i == 2 * kicks ? s + h : s + half * T(double(i)); };
  record.lead.push_back(length * span(at(0), at(1)));
  drift(z, record.lead.back());
  for (std::size_t i = 1; i < 2 * kicks; i += 2) {
    Curvature<T> node{length * span(at(i - 1), at(i + 1)),
                      length * span(at(i), at(std::min(i + 2, 2 * kicks))),
                      std::vector<T>(chain_.sites), std::vector<T>(chain_.sites + 1, T(0))};
    kick(z, node);
    drift(z, node.drift);
    if (probe_) record.nodes.push_back(std::move(node));
  }
}

template <class T, class Onsite, class Contact>
void Leapfrog<T, Onsite, Contact>::drift(std::vector<T>& z, T dt) const {
  const std::size_t n = chain_.sites;
  add_scaled(z.data(), z.data() + n, dt, n);
  T rate(0);
  for (std::size_t i = 0; i < n; ++i) rate += T(chain_.mass_of(i)) * z[n + i] * z[n + i];
  z[2 * n] += rate * dt;
  if (probe_) add_scaled(z.data() + 2 * n + 1, z.data() + 3 * n + 1, dt, n);
}

/**
A kick needs the forces, and its record the curvatures; both come from the same square roots. */
template <class T, class Onsite, class Contact>
void Leapfrog<T, Onsite, Contact>::kick(std::vector<T>& z, Curvature<T>& node) {
  const std::size_t n = chain_.sites;
  evaluate(z.data(), node);
  for (std::size_t i = 0; i < n; ++i)
    z[n + i] += node.kick * lightness<T>(chain_, i) *
                (chain_.onsite.force(z[i]) + (push_[i] - push_[i + 1]));
  if (!probe_) return;
  rows_at(chain_, node, {0, n}, rows_);
  kick_panel(rows_.data(), z.data() + 2 * n + 1, z.data() + 3 * n + 1, n, 1);
}

/**
The vectorised sweep leaves out the two end contacts, which depend on the boundary condition
(boundary.hpp), and the stiffnesses $\eta_n$; both follow here. */
template <class T, class Onsite, class Contact>
void Leapfrog<T, Onsite, Contact>::evaluate(const T* y, Curvature<T>& node) {
  const std::size_t n = chain_.sites;
  ++evaluations;
  sweep_curvature(chain_.onsite, chain_.contact, y, n, push_.data(), node.link.data(),
                  node.well.data());
  for (std::size_t i : {std::size_t(0), n}) {
    push_[i] = contact_push(chain_, y, i);
    node.link[i] = chain_.boundary().pushes(i)
                       ? T(chain_.eta_of(i)) * chain_.contact.stiffness(stretch(chain_, y, i))
                       : T(0);
  }
  for (std::size_t i = 1; i < n && !chain_.eta.empty(); ++i) {
    push_[i] *= T(chain_.eta[i]);
    node.link[i] *= T(chain_.eta[i]);
  }
}

/**
A passage is the way across one interval: the state in which it ends, the sum of the errors of its steps,
and the records that the columns will follow. */
template <class T>
struct Passage {
  std::vector<T> z;
  T error = T(0);
  std::vector<Record<T>> records;
};

/**
A step adds one leapfrog level after another until the last two extrapolated values agree, so that a short
interval costs two or three levels and a long one as many as the precision allows. If they do not suffice,
the step is shortened. We compare the value of $j$ levels with that of $j-1$, which estimates the error
of the latter. The usual comparison within level $j$ gives a number smaller by a factor $j^2$, and trusts
the asymptotic series too early while a recent switching is still near.

Agreement is measured on the orbit and on the probe. A runaway, a bead beyond the rim of a soft well,
never agrees: a step of 1/16384 of the interval is accepted as it is, and if the error then exceeds one
the crossing gives up. */
template <class T, class Onsite, class Contact>
class Crossing {
 public:
  Crossing(const Chain<Onsite, Contact>& chain, const Landing<T>& rule, T amplitude)
      : chain_(chain), rule_(rule), amplitude_(amplitude) {
    rule_.tolerance = std::max(rule.tolerance, T(16) * std::numeric_limits<T>::epsilon());
  }
  /// Crosses an interval of the given length (in time) from the positions, velocities and area in `z`,
  /// 2 * sites + 1 numbers; with `probe` it leaves records for the columns.
  Passage<T> cross(const std::vector<T>& z, T length, bool probe);
  std::size_t evaluations = 0;

 private:
  std::vector<T> with_probe(std::vector<T> z) const;
  T step(Leapfrog<T, Onsite, Contact>& leapfrog, std::vector<T>& z, T length, T s, T h,
         Record<T>& record);
  T difference(const std::vector<T>& a, const std::vector<T>& b) const;

  const Chain<Onsite, Contact>& chain_;
  Landing<T> rule_;
  T amplitude_;
  std::vector<std::vector<T>> table_;
};

/**
The first step tries the whole interval. What remains is always divided evenly, so that no sliver is left
at its end. */
template <class T, class Onsite, class Contact>
Passage<T> Crossing<T, Onsite, Contact>::cross(const std::vector<T>& z, T length, bool probe) {
  Passage<T> way{probe ? with_probe(z) : z, T(0), {}};
  Leapfrog<T, Onsite, Contact> leapfrog(chain_, probe);
  const T shortest = T(1) / T(16384);
  T s(0), h(1);
  while (s < T(1) && way.error <= T(1)) {
    const T pieces = T(int((T(1) - s) / h * T(0.999)) + 1);
    h = (T(1) - s) / pieces;
    Record<T> record;
    record.duration = length * span(s, s + h);
    std::vector<T> end = way.z;
    const T error = step(leapfrog, end, length, s, h, record);
    if (error > rule_.tolerance && h > shortest) {
      h *= error > T(100) * rule_.tolerance ? T(0.5) : T(0.75);
      continue;
    }

    /**
    The step is accepted. If half of the levels were enough for it, the next one may be twice as long. */
    way.z = std::move(end);
    way.error += error;
    s = pieces == T(1) ? T(1) : s + h;
    if (record.levels() <= std::size_t(rule_.levels + 1) / 2) h *= T(2);
    way.records.push_back(std::move(record));
  }
  evaluations += leapfrog.evaluations;
  way.z.resize(2 * chain_.sites + 1);
  return way;
}

/**
A probe must not miss what another column would see, as it might if it shared a symmetry of the orbit. It
begins each interval with the same numbers between $-1$ and 1, which have no symmetry. */
template <class T, class Onsite, class Contact>
std::vector<T> Crossing<T, Onsite, Contact>::with_probe(std::vector<T> z) const {
  for (std::size_t i = 0, n = 2 * chain_.sites; i < n; ++i)
    z.push_back(T(int(7 * i % 11) - 5) / T(5));
  return z;
}

/**
The table of the extrapolation holds increments, whose rounding errors are smaller than those of the
values. After level $j$ its first entry is the polynomial in the square of the step through all $j$
results, taken at zero and computed by Neville's recursion. Returns the estimated error. */
template <class T, class Onsite, class Contact>
T Crossing<T, Onsite, Contact>::step(Leapfrog<T, Onsite, Contact>& leapfrog, std::vector<T>& z,
                                     T length, T s, T h, Record<T>& record) {
  table_.clear();
  T error = std::numeric_limits<T>::infinity();
  for (std::size_t j = 1; j <= std::size_t(rule_.levels) && !(error <= rule_.tolerance); ++j) {
    const std::vector<T> previous = j > 1 ? table_.front() : z;
    table_.push_back(z);
    leapfrog.run(table_.back(), length, s, h, j, record);
    add_scaled(table_.back().data(), z.data(), T(-1), z.size());
    for (std::size_t i = j - 1; i > 0; --i) {
      const T ratio = T(double(j)) / T(double(i)), gain = T(1) / (ratio * ratio - T(1));
      refine(table_[i - 1].data(), table_[i].data(), gain, z.size());
    }
    if (j > 1) error = difference(table_.front(), previous);
  }
  add_scaled(z.data(), table_.front().data(), T(1), z.size());
  return error;
}

/**
The difference of two extrapolated values is relative to the amplitude for the orbit, to its square for the
area, and absolute for the probe. It is infinite if anything is not a finite number. */
template <class T, class Onsite, class Contact>
T Crossing<T, Onsite, Contact>::difference(const std::vector<T>& a, const std::vector<T>& b) const {
  const std::size_t orbit = 2 * chain_.sites;
  T worst[3] = {T(0), T(0), T(0)}, sum(0);
  for (std::size_t k = 0; k < a.size(); ++k) {
    const T d = a[k] - b[k], size = d < T(0) ? -d : d;
    T& most = worst[k < orbit ? 0 : k == orbit ? 1 : 2];
    most = size > most ? size : most;
    sum += size;
  }
  if (!(sum < std::numeric_limits<T>::infinity())) return std::numeric_limits<T>::infinity();
  return std::max({worst[0] / amplitude_, worst[1] / (amplitude_ * amplitude_), worst[2]});
}

}  // namespace lattice
