#include "lattice/integrators/event_corrected.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "lattice/model/kernel.hpp"
#include "lattice/numerics/interrupt.hpp"

namespace lattice {
namespace {

/// Three terms $w_j a_j$ of the sum of a stage at site `i`. The terms come in threes, because a stage is
/// one pass over the sites and the compiler makes the best of it when their number is known.
template <class T>
inline __attribute__((always_inline)) T triple(const T* const* a, const T* weight, std::size_t i) {
  return weight[0] * a[0][i] + (weight[1] * a[1][i] + weight[2] * a[2][i]);
}

/// The sum $y + d\,v + \sum_j w_j a_j$ of a stage with as many triples, its small terms first; `stage` says
/// whose accelerations, of all in `row`, the terms are.
template <std::size_t triples, class T>
LATTICE_WIDE void sweep_terms(const T* __restrict__ y, const T* __restrict__ v, T drift,
                              const T* const* row, const std::size_t* stage, const T* weight,
                              T* __restrict__ out, std::size_t first, std::size_t n) {
  const T* a[3 * triples + 1];
  for (std::size_t j = 0; j < 3 * triples; ++j) a[j] = row[stage[j]] + first;
  for (std::size_t i = 0; i < n; ++i) {
    T sum = drift * v[i];
    for (std::size_t j = 0; j < 3 * triples; j += 3) sum += triple(a + j, weight + j, i);
    out[i] = y[i] + sum;
  }
}

/// How often a step is divided at most.
constexpr std::size_t most_divisions = 12;

/**
The scheme of six stages has at most six terms in a sum, the splitting with fourteen evaluations at most
fifteen. Each number of triples has its own loop, which passes over the sites once. */
template <class T>
void sweep_stage(const T* y, const T* v, T drift, const T* const* row, const StageSum<T>& sum,
                 T* out, Window window) {
  const auto sweep = [&](auto terms) {
    terms(y + window.first, v + window.first, drift, row, sum.stage.data(), sum.weight.data(),
          out + window.first, window.first, window.last - window.first);
  };
  switch (sum.stage.size() / 3) {
    case 0:
      return sweep(sweep_terms<0, T>);
    case 1:
      return sweep(sweep_terms<1, T>);
    case 2:
      return sweep(sweep_terms<2, T>);
    case 3:
      return sweep(sweep_terms<3, T>);
    case 4:
      return sweep(sweep_terms<4, T>);
    case 5:
      return sweep(sweep_terms<5, T>);
    default:
      throw std::invalid_argument("a scheme of more than fifteen terms");
  }
}

/**
A contact needs a correction in the step in which it switches and in the neighbouring steps. There the
force is smooth but close to its singular point: $k$ steps from $t^*$ a sixth-order sum errs by about
$h^{\alpha+1} k^{\alpha-6}$. At $k = 1$ this still hides the order of the scheme, at $k = 2$ it is twenty
times less, and beyond that it shows only near $10^{-11}$.

The test needs no memory of earlier steps: the overlaps $x_0, x_1$ and their rates $w_0, w_1$ (per step)
at the two ends of the step tell where the contact was two steps before and will be two steps after. We
call it singular if any of these four overlaps is not positive, or if it dips to zero between positive
ends. It matters only if it pushes at an end, or bulges above `small` between open ends. The tangents at
the ends bound a dip and a bulge. */
template <class T>
inline __attribute__((always_inline)) bool is_singular(T x0, T w0, T x1, T w1, T small) {
  const T reach = T(2), ahead = x0 + w0, behind = x1 - w1;
  const T outer = std::min(x0 - reach * w0, x1 + reach * w1),
          least = std::min(outer, std::min(x0, x1));
  const bool bulge = (w0 > T(0)) & (w1 < T(0)) & (std::min(ahead, behind) > small);
  const bool dip = (w0 < T(0)) & (w1 > T(0)) & (std::max(ahead, behind) < T(0));
  return ((std::max(x0, x1) > small) | bulge) & ((least <= T(0)) | dip);
}

/// Flags contacts between neighbours, singular ones by 1 and those with an overlap above `tight` by 2: flag[i] is
/// that of sites i and i + 1. A flag is as wide as a number, so that the loop vectorises without packing.
template <class T>
LATTICE_WIDE void sweep_singular(const T* __restrict__ y0, const T* __restrict__ v0,
                                 const T* __restrict__ y1, const T* __restrict__ v1, T opening, T h,
                                 T small, T tight, std::uint64_t* __restrict__ flag,
                                 std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) {
    const T x0 = opening - (y0[i + 1] - y0[i]), x1 = opening - (y1[i + 1] - y1[i]);
    flag[i] = std::uint64_t(is_singular<T>(x0, -h * (v0[i + 1] - v0[i]), x1,
                                           -h * (v1[i + 1] - v1[i]), small)) |
              std::uint64_t(std::max(x0, x1) > tight) << 1;
  }
}

}  // namespace

template <class T>
StageSum<T>::StageSum(const std::vector<double>& row, double scale) {
  for (std::size_t j = 0; j < row.size(); ++j)
    if (row[j] != 0) weight.push_back(T(row[j]) * T(scale)), stage.push_back(j);
  while (weight.size() % 3 != 0) weight.push_back(T(0)), stage.push_back(0);
}

/**
As a rule a run has a single step length, and its sums are made once. */
template <class T>
NystromMemory<T>::NystromMemory(const Nystrom& base, std::size_t sites, double negligible)
    : small(negligible) {
  v.resize(sites), shift.resize(sites);
  y.assign(base.c.size(), v), a = y;
  shift_weight.resize(y.size());
  flag.resize(sites), correction.resize(sites + 1), prepared.resize(most_divisions + 1);
  for (std::size_t i = 0; i < y.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) shift_weight[j] += T(base.b[i] * base.a[i][j]);
}

template <class T>
NystromMemory<T> EventCorrected::memory(const Chain& chain) const {
  return {base, chain.sites, std::pow(negligible, 1 / chain.contact.exponent())};
}

namespace detail {

/**
## A step

Only the contact has to be known to the corrections, because few of them are made. The sweeps that give the
accelerations know the well as well (`accelerator` in kernel.hpp). */
template <class T, class C>
struct NystromStep {
  const Nystrom& base;
  const Chain& chain;
  const C& contact;
  const int finer;
  const Accelerate<T> accelerate = accelerator<T>(chain);

  /**
  A stage is one sweep along the moving sites. To correct a contact we then need what its overlap did in
  this step: values, rates and accelerations at both ends, in units of the step, as the quintic wants
  them. */
  static void combine(const std::vector<T>& y, const std::vector<T>& v, double drift,
                      const StageSum<T>& sum, Window window, NystromMemory<T>& at,
                      std::vector<T>& out) {
    sweep_stage<T>(y.data(), v.data(), T(drift), at.row.data(), sum, out.data(), window);
  }

  /// The overlap of contact `i` in the step that has just been tried.
  Quintic<T> overlap_during(const State<T>& state, std::size_t i, T h,
                            const NystromMemory<T>& at) const {
    const T d = T(contact.opening()), half = h * h / T(2);
    const std::vector<T>&y = at.y[base.last()], &a = at.a[base.last()];
    const auto across = [&](const std::vector<T>& q) { return stretch(chain, q.data(), i); };
    return {d - across(state.y), -h * across(state.v), -half * across(at.a[0]),
            d - across(y),       -h * across(at.v),    -half * across(a)};
  }

  /// The square of the frequency of contact `i` at the overlap `x`.
  T square_frequency(std::size_t i, T x) const {
    const T inverse = (i > 0 ? inverse_mass<T>(chain, i - 1) : T(0)) +
                      (i < chain.sites ? inverse_mass<T>(chain, i) : T(0));
    return inverse * T(chain.eta_of(i)) * contact.stiffness(T(contact.opening()) - x);
  }

  /// Makes the sums for steps of length `h`, unless they are those of the last call. The smallest overlap that may be
  /// too fast is found among the powers of two.
  void prepare(StepSums<T>& step, double h, double frequency) const {
    if (h == step.length) return;
    step = {h};
    for (const auto& row : base.a) step.sums.emplace_back(row, h * h);
    step.sums.emplace_back(base.b, h);
    step.fast = T(frequency * frequency), step.tight = T(1);
    const auto fits = [&](T x) {
      T most(0);
      for (std::size_t i = 0; i <= chain.sites; ++i) most = std::max(most, square_frequency(i, x));
      return most <= step.fast;
    };
    while (step.tight < T(escape_displacement) && fits(T(2) * step.tight)) step.tight *= T(2);
    while (step.tight > T(1e-30) && !fits(step.tight)) step.tight /= T(2);
  }

  /// Whether a step like `now` is too long for contact `i` at the overlap `x`, unless the motion was lost before.
  bool too_fast(std::size_t i, T x, const State<T>& state, const StepSums<T>& now) const {
    return x > now.tight && square_frequency(i, x) > now.fast &&
           -stretch(chain, state.y.data(), i) < T(escape_displacement);
  }

  /**
  Few contacts switch in a step, but all have to be looked at. Those between two beads are tested in one
  vectorised pass without branches, after which the flagged ones are gathered. The contacts at the ends of
  the chain depend on the boundary condition and are tested one by one. */
  /// Lists the singular contacts; whether none that is closed at an end of the step is too fast.
  bool find(const State<T>& state, Window window, T h, const StepSums<T>& now,
            NystromMemory<T>& at) const {
    const std::size_t n = chain.sites, left = std::max<std::size_t>(window.first, 1) - 1;
    const std::size_t inner = std::min(window.last, n - 1) - left;
    bool slow = true;
    const auto enter = [&](std::size_t i, std::uint64_t flag) {
      if (flag & 1) at.contacts.push_back(i);
      if (flag & 2) {
        const Quintic<T> x = overlap_during(state, i, h, at);
        slow &= !too_fast(i, std::max(x.x0, x.x1), state, now);
      }
    };
    const auto try_end = [&](std::size_t i) {
      const Quintic<T> x = overlap_during(state, i, h, at);
      enter(i, is_singular(x.x0, x.w0, x.x1, x.w1, at.small) ? 3 : 2);
    };
    at.contacts.clear();
    if (chain.pushes(0) && window.first == 0) try_end(0);
    sweep_singular<T>(state.y.data() + left, state.v.data() + left, at.y[base.last()].data() + left,
                      at.v.data() + left, T(contact.opening()), h, at.small, now.tight,
                      at.flag.data(), inner);
    for (std::size_t k = 0; k < inner; ++k)
      if (at.flag[k]) enter(left + 1 + k, at.flag[k]);
    if (chain.pushes(n) && window.last == n) try_end(n);
    return slow;
  }

  /**
  What contact `i` is owed is its true impulse less the one that the stages gave it, and likewise for the
  moments. A force that is always there, like that of precompression, cancels in the difference; we leave
  it out of both terms, so that it does not spoil the last digits. */
  Impulse<T> defect(const State<T>& state, std::size_t i, T h, const NystromMemory<T>& at) const {
    const std::size_t last = base.last();
    const Quintic<T> x = overlap_during(state, i, h, at);
    const T d = T(contact.opening()), eta = T(chain.eta_of(i)), open = contact.force(d);
    const double twice = 2 * contact.exponent;
    const auto push = [&](T s) { return eta * (contact.force(d - x(s)) - open); };
    Impulse<T> sum = exact_impulse(x, push, twice != std::floor(twice));
    for (std::size_t k = 0; k <= last; ++k) {
      const std::vector<T>& y = k > 0 ? at.y[k] : state.y;
      const T f = eta * contact.force(stretch(chain, y.data(), i)) - eta * open;
      sum.velocity -= T(base.b[k]) * f;
      sum.position -= k < last ? T(base.a[last][k]) * f : T(0);
      sum.shift -= at.shift_weight[k] * f;
    }
    // Between open ends the stages may have met more than the quintic tells
    if (!(std::max(x.x0, x.x1) > T(0)))
      for (std::size_t k = 1; k < last; ++k)
        sum.reach = std::max(sum.reach, d - stretch(chain, at.y[k].data(), i));
    return {h * sum.velocity, h * h * sum.position, h * h * h * sum.shift, sum.reach};
  }

  /**
  A corrected contact pushes its two beads, and these push the beads next to them. So all that follows
  happens at the few sites near a listed contact, each visited once however many contacts are near. First
  every bead gets what its two contacts owe it, in velocity and position; what the stages lacked is kept
  as `shift`. This may set a bead in motion that was at rest, so the window is adapted. */

  /// Runs `action(n)` once for every site that lies within `reach` of a listed contact.
  template <class Action>
  static void near_contacts(const NystromMemory<T>& at, std::size_t reach, Action action) {
    std::size_t next = 0;
    for (std::size_t i : at.contacts) {
      next = std::max(next, std::max(i, reach) - reach);
      for (; next < std::min(i + reach, at.v.size()); ++next) action(next);
    }
  }

  void exchange_impulses(Window& window, NystromMemory<T>& at) const {
    std::vector<T>& y = at.y[base.last()];
    near_contacts(at, 1, [&](std::size_t n) {
      const T inverse = inverse_mass<T>(chain, n);
      const Impulse<T>&left = at.correction[n], &right = at.correction[n + 1];
      at.v[n] += inverse * (left.velocity - right.velocity);
      y[n] += inverse * (left.position - right.position);
      at.shift[n] = inverse * (left.shift - right.shift);
      window = {std::min(window.first, n), std::max(window.last, n + 1)};
    });
    widen(chain, contact, y.data(), window);
  }

  /**
  Then the forces must follow. The accelerations at the end of the step are computed anew at the corrected
  positions, and the velocities get the second-moment term of the formula, $K$ times `shift`. Here $K$ is
  the stiffness of everything else that acts on the bead: its well, and those contacts which need no
  correction themselves. */
  void repair_forces(Window window, NystromMemory<T>& at) const {
    std::vector<T>&y = at.y[base.last()], &a = at.a[base.last()];
    struct Side {
      std::size_t contact = std::size_t(-1);
      T push{}, pull{};
    };
    const auto side = [&](std::size_t i) -> Side {
      const T push = push_at(chain, contact, y.data(), i);
      if (at.correction[i].velocity != T(0) || push == T(0)) return {i, push, T(0)};
      return {i, push,
              -T(chain.eta_of(i)) * contact.stiffness(stretch(chain, y.data(), i)) *
                  stretch(chain, at.shift.data(), i)};
    };
    // The right side of a bead is the left one of the next
    Side left, right;
    near_contacts(at, 2, [&](std::size_t n) {
      if (n < window.first || n >= window.last) return;
      left = right.contact == n ? right : side(n);
      right = side(n + 1);
      a[n] = chain.well.force(y[n]) + (left.push - right.push);
      T more = -chain.well.stiffness(y[n]) * at.shift[n] + (left.pull - right.pull);
      if (!chain.mass.empty()) a[n] *= inverse_mass<T>(chain, n), more *= inverse_mass<T>(chain, n);
      at.v[n] += more;
    });
  }

  /**
  All corrections are computed before any is made, so that left and right are treated alike. At the end the
  memory is cleared again at the sites that were touched. */
  /// Whether the step resolves all contacts; otherwise, unless it is the `last` resort, nothing is corrected.
  bool correct(const State<T>& state, Window& window, T h, bool last, const StepSums<T>& now,
               NystromMemory<T>& at) const {
    bool good = window.first == window.last || find(state, window, h, now, at) || last;
    if (at.contacts.empty() || !good) return good;
    for (std::size_t i : at.contacts) {
      at.correction[i] = defect(state, i, h, at);
      good &= last || !too_fast(i, at.correction[i].reach, state, now);
    }
    if (good) {
      exchange_impulses(window, at);
      repair_forces(window, at);
      near_contacts(at, 1, [&](std::size_t n) { at.shift[n] = T(0); });
    }
    for (std::size_t i : at.contacts) at.correction[i] = {};
    return good;
  }

  double step(State<T>& state, Window& window, double h, std::size_t divided,
              NystromMemory<T>& at) const;
  double run(State<T>& state, Window& window, double h, std::size_t count,
             NystromMemory<T>& at) const;
};

/**
A step is an ordinary one followed by the corrections. Its last stage is the new state, which is
corrected in place, and the accelerations there are those with which the next step begins: they are
swapped at no cost, and one evaluation of the force is saved. A step that is too long for a contact leaves state and
accelerations as they were, and its halves are tried. */
template <class T, class C>
double NystromStep<T, C>::step(State<T>& state, Window& window, double h, std::size_t divided,
                               NystromMemory<T>& at) const {
  const std::size_t last = base.last();
  double work = 0;
  StepSums<T>& now = at.prepared[divided];
  prepare(now, h, std::ldexp(divided > 0 ? 0.125 : 0.5, -std::min(finer, 3)) / h);
  for (std::size_t i = 1; i <= last; ++i) {
    combine(state.y, state.v, base.c[i] * h, now.sums[i], window, at, at.y[i]);
    accelerate(chain, at.y[i].data(), at.a[i].data(), window);
    work += double(window.last - window.first);
  }
  combine(state.v, state.v, 0, now.sums.back(), window, at, at.v);
  if (!correct(state, window, T(h), divided == most_divisions, now, at)) {
    heed_stop();
    const int parts = divided == 0 ? 2 + finer % 2 : 2;
    for (int k = 0; k < parts; ++k) work += step(state, window, h / parts, divided + 1, at);
    return work;
  }
  std::swap(state.y, at.y[last]), std::swap(state.v, at.v), std::swap(at.a[0], at.a[last]);
  std::swap(at.row[0], at.row[last]);
  return work;
}

// A run of equal steps, each of which may be divided
template <class T, class C>
double NystromStep<T, C>::run(State<T>& state, Window& window, double h, std::size_t count,
                              NystromMemory<T>& at) const {
  at.row.clear();
  for (const std::vector<T>& stage : at.a) at.row.push_back(stage.data());
  accelerate(chain, state.y.data(), at.a[0].data(), window);
  double work = double(window.last - window.first);
  for (std::size_t k = 0; k < count; ++k) {
    if (k % 64 == 63) heed_stop();
    work += step(state, window, h, 0, at);
  }
  return work;
}

}  // namespace detail

template <class T>
double EventCorrected::advance(const Chain& chain, State<T>& state, Window& window, double h,
                               std::size_t count, NystromMemory<T>& at) const {
  double work = 0;
  detail::with_kind(chain.contact, [&]<class C>(const C& contact) {
    work = detail::NystromStep<T, C>{base, chain, contact, finer}.run(state, window, h, count, at);
  });
  return work;
}

template struct StageSum<double>;
template struct StepSums<double>;
template struct NystromMemory<double>;
template NystromMemory<double> EventCorrected::memory<double>(const Chain&) const;
template double EventCorrected::advance<double>(const Chain&, State<double>&, Window&, double,
                                                std::size_t, NystromMemory<double>&) const;

}  // namespace lattice
