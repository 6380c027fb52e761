#include "lattice/integrators/event_corrected.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "lattice/model/kernel.hpp"
#include "lattice/numerics/progress.hpp"

namespace lattice {
namespace {

/// The sum $y + d\,v + \sum_j w_j a_j$ of a stage, its small terms first; `stage` says whose accelerations, of all in
/// `row`, the terms are. They come in threes, so that each number of `triples` has a loop of its own.
template <std::size_t triples>
LATTICE_WIDE void sweep_terms(const double* __restrict__ y, const double* __restrict__ v,
                              double drift, const double* const* row, const std::size_t* stage,
                              const double* weight, double* __restrict__ out, std::size_t first,
                              std::size_t n) {
  const double* a[3 * triples + 1];
  for (std::size_t j = 0; j < 3 * triples; ++j) a[j] = row[stage[j]] + first;
  for (std::size_t i = 0; i < n; ++i) {
    double sum = drift * v[i];
    for (std::size_t j = 0; j < 3 * triples; j += 3)
      sum += weight[j] * a[j][i] + (weight[j + 1] * a[j + 1][i] + weight[j + 2] * a[j + 2][i]);
    out[i] = y[i] + sum;
  }
}

/// How often a step is divided at most.
constexpr std::size_t most_divisions = 12;

/// A stage, one sweep along the moving sites. The splitting with fourteen evaluations has at most fifteen terms.
void sweep_stage(const std::vector<double>& y, const std::vector<double>& v, double drift,
                 const StageSum& sum, const NystromMemory& at, Window window,
                 std::vector<double>& out) {
  const auto sweep = [&](auto terms) {
    const std::size_t first = window.first;
    terms(y.data() + first, v.data() + first, drift, at.row.data(), sum.stage.data(),
          sum.weight.data(), out.data() + first, first, window.last - first);
  };
  switch (sum.stage.size() / 3) {
    case 0:
      return sweep(sweep_terms<0>);
    case 1:
      return sweep(sweep_terms<1>);
    case 2:
      return sweep(sweep_terms<2>);
    case 3:
      return sweep(sweep_terms<3>);
    case 4:
      return sweep(sweep_terms<4>);
    case 5:
      return sweep(sweep_terms<5>);
    default:
      throw std::invalid_argument("a splitting scheme with more than fifteen terms");
  }
}

/**
A contact needs a correction in the step in which it switches and in the neighbouring steps. There the
force is smooth but close to its singular point: $k$ steps from $t^*$ a sixth-order sum errs by about
$h^{\alpha+1} k^{\alpha-6}$. At $k = 1$ this still hides the order of the scheme, at $k = 2$ it is twenty
times less, and beyond that it shows only near $10^{-11}$. So `reach` is two.

The overlaps $x_0, x_1$ and their rates $w_0, w_1$ (per step) at the two ends of the step tell where the contact was
`reach` steps before and will be `reach` steps after. It is singular if any of these four overlaps is not positive, or
if it dips to zero between positive ends. It matters only if it pushes at an end, or bulges above `small` between open
ends. The tangents at the ends bound a dip and a bulge. */
inline __attribute__((always_inline)) bool is_singular(double x0, double w0, double x1, double w1,
                                                       double small, double reach) {
  const double ahead = x0 + w0, behind = x1 - w1;
  const double outer = std::min(x0 - reach * w0, x1 + reach * w1),
               least = std::min(outer, std::min(x0, x1));
  const bool bulge = (w0 > 0) & (w1 < 0) & (std::min(ahead, behind) > small);
  const bool dip = (w0 < 0) & (w1 > 0) & (std::max(ahead, behind) < 0);
  return ((std::max(x0, x1) > small) | bulge) & ((least <= 0) | dip);
}

/// Flags contacts between neighbours, singular ones by 1 and those with an overlap above `tight` by 2: flag[i] is
/// that of sites i and i + 1. A flag is as wide as a number, so that the loop vectorises without packing.
LATTICE_WIDE void sweep_singular(const double* __restrict__ y0, const double* __restrict__ v0,
                                 const double* __restrict__ y1, const double* __restrict__ v1,
                                 double opening, double h, double small, double reach, double tight,
                                 std::uint64_t* __restrict__ flag, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) {
    const double x0 = opening - (y0[i + 1] - y0[i]), x1 = opening - (y1[i + 1] - y1[i]);
    flag[i] = std::uint64_t(is_singular(x0, -h * (v0[i + 1] - v0[i]), x1, -h * (v1[i + 1] - v1[i]),
                                        small, reach)) |
              std::uint64_t(std::max(x0, x1) > tight) << 1;
  }
}

}  // namespace

StageSum::StageSum(const std::vector<double>& row, double scale) {
  for (std::size_t j = 0; j < row.size(); ++j)
    if (row[j] != 0) weight.push_back(row[j] * scale), stage.push_back(j);
  while (weight.size() % 3 != 0) weight.push_back(0), stage.push_back(0);
}

NystromMemory::NystromMemory(const Nystrom& base, std::size_t sites, double negligible)
    : small(negligible) {
  v.resize(sites), shift.resize(sites);
  y.assign(base.c.size(), v), a = y;
  shift_weight.resize(y.size());
  flag.resize(sites), correction.resize(sites + 1), prepared.resize(most_divisions + 1);
  for (std::size_t i = 0; i < y.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) shift_weight[j] += base.b[i] * base.a[i][j];
}

NystromMemory EventCorrected::memory(const Chain& chain) const {
  return {base, chain.sites, std::pow(negligible, 1 / chain.contact.exponent())};
}

namespace detail {

/**
## A step

The corrections know the type of the contact; the sweeps that give the accelerations know the well as well
(`accelerator` in kernel.hpp). */
template <class C>
struct NystromStep {
  const Nystrom& base;
  const Chain& chain;
  const C& contact;
  const int finer;
  const double reach;
  const Accelerate<double> accelerate = accelerator<double>(chain);

  /// The overlap of contact `i` in the step that has just been tried.
  Quintic overlap_during(const State<double>& state, std::size_t i, double h,
                         const NystromMemory& at) const {
    const double d = contact.opening(), half = h * h / 2;
    const std::vector<double>&y = at.y[base.last()], &a = at.a[base.last()];
    const auto across = [&](const std::vector<double>& q) { return stretch(chain, q.data(), i); };
    return {d - across(state.y), -h * across(state.v), -half * across(at.a[0]),
            d - across(y),       -h * across(at.v),    -half * across(a)};
  }

  /// The square of the frequency of contact `i` at the overlap `x`.
  double square_frequency(std::size_t i, double x) const {
    const double inverse = (i > 0 ? inverse_mass<double>(chain, i - 1) : 0) +
                           (i < chain.sites ? inverse_mass<double>(chain, i) : 0);
    return inverse * chain.eta_of(i) * contact.stiffness(contact.opening() - x);
  }

  /// Makes the sums for steps of length `h`, unless they are those of the last call; `tight` is a power of two.
  void prepare(StepSums& step, double h, double frequency) const {
    if (h == step.length) return;
    step = {h};
    for (const auto& row : base.a) step.sums.emplace_back(row, h * h);
    step.sums.emplace_back(base.b, h);
    step.fast = frequency * frequency, step.tight = 1;
    const auto fits = [&](double x) {
      double most = 0;
      for (std::size_t i = 0; i <= chain.sites; ++i) most = std::max(most, square_frequency(i, x));
      return most <= step.fast;
    };
    while (step.tight < escape_displacement && fits(2 * step.tight)) step.tight *= 2;
    while (step.tight > 1e-30 && !fits(step.tight)) step.tight /= 2;
  }

  /// Whether a step like `now` is too long for contact `i` at the overlap `x`, unless the motion was lost before.
  bool too_fast(std::size_t i, double x, const State<double>& state, const StepSums& now) const {
    return x > now.tight && square_frequency(i, x) > now.fast &&
           -stretch(chain, state.y.data(), i) < escape_displacement;
  }

  /// Lists the singular contacts; whether none that is closed at an end of the step is too fast. Those between two
  /// beads are tested in one vectorised pass, those at the ends of the chain depend on the boundary condition.
  bool find(const State<double>& state, Window window, double h, const StepSums& now,
            NystromMemory& at) const {
    const std::size_t n = chain.sites, left = std::max<std::size_t>(window.first, 1) - 1;
    const std::size_t inner = std::min(window.last, n - 1) - left;
    bool slow = true;
    const auto enter = [&](std::size_t i, std::uint64_t flag) {
      if (flag & 1) at.contacts.push_back(i);
      if (flag & 2) {
        const Quintic x = overlap_during(state, i, h, at);
        slow &= !too_fast(i, std::max(x.x0, x.x1), state, now);
      }
    };
    const auto try_end = [&](std::size_t i) {
      const Quintic x = overlap_during(state, i, h, at);
      enter(i, is_singular(x.x0, x.w0, x.x1, x.w1, at.small, reach) ? 3 : 2);
    };
    at.contacts.clear();
    if (chain.has_contact(0) && window.first == 0) try_end(0);
    sweep_singular(state.y.data() + left, state.v.data() + left, at.y[base.last()].data() + left,
                   at.v.data() + left, contact.opening(), h, at.small, reach, now.tight,
                   at.flag.data(), inner);
    for (std::size_t k = 0; k < inner; ++k)
      if (at.flag[k]) enter(left + 1 + k, at.flag[k]);
    if (chain.has_contact(n) && window.last == n) try_end(n);
    return slow;
  }

  /// The true impulse of contact `i` less the one that the stages gave it, and likewise for the moments. A force that
  /// is always there, like that of precompression, is left out of both, so that it does not spoil the last digits.
  Impulse impulse_error(const State<double>& state, std::size_t i, double h,
                        const NystromMemory& at) const {
    const std::size_t last = base.last();
    const Quintic x = overlap_during(state, i, h, at);
    const double d = contact.opening(), eta = chain.eta_of(i), open = contact.force(d);
    const double twice = 2 * contact.exponent;
    const auto push = [&](double s) { return eta * (contact.force(d - x(s)) - open); };
    Impulse sum = exact_impulse(x, push, twice != std::floor(twice));
    for (std::size_t k = 0; k <= last; ++k) {
      const std::vector<double>& y = k > 0 ? at.y[k] : state.y;
      const double f = eta * contact.force(stretch(chain, y.data(), i)) - eta * open;
      sum.velocity -= base.b[k] * f;
      sum.position -= k < last ? base.a[last][k] * f : 0;
      sum.shift -= at.shift_weight[k] * f;
    }
    // Between open ends the stages may have met more than the quintic tells
    if (!(std::max(x.x0, x.x1) > 0))
      for (std::size_t k = 1; k < last; ++k)
        sum.reach = std::max(sum.reach, d - stretch(chain, at.y[k].data(), i));
    return {h * sum.velocity, h * h * sum.position, h * h * h * sum.shift, sum.reach};
  }

  /// Runs `action(n)` once for every site that lies within `reach` of a listed contact.
  template <class Action>
  static void near_contacts(const NystromMemory& at, std::size_t reach, Action action) {
    std::size_t next = 0;
    for (std::size_t i : at.contacts) {
      next = std::max(next, std::max(i, reach) - reach);
      for (; next < std::min(i + reach, at.v.size()); ++next) action(next);
    }
  }

  /// Every bead gets what its two contacts owe it, in velocity and position; what the stages lacked is kept as `shift`.
  /// This may set a bead in motion that was at rest, so the window is adapted.
  void exchange_impulses(Window& window, NystromMemory& at) const {
    std::vector<double>& y = at.y[base.last()];
    near_contacts(at, 1, [&](std::size_t n) {
      const double inverse = inverse_mass<double>(chain, n);
      const Impulse &left = at.correction[n], &right = at.correction[n + 1];
      at.v[n] += inverse * (left.velocity - right.velocity);
      y[n] += inverse * (left.position - right.position);
      at.shift[n] = inverse * (left.shift - right.shift);
      window = {std::min(window.first, n), std::max(window.last, n + 1)};
    });
    widen(chain, contact, y.data(), window);
  }

  /// Accelerations anew at the corrected positions, and for the velocities the second-moment term of the formula, $K$
  /// times `shift`. Here $K$ is the stiffness of everything else that acts on the bead: its well, and those contacts
  /// which need no correction themselves.
  void repair_forces(Window window, NystromMemory& at) const {
    std::vector<double>&y = at.y[base.last()], &a = at.a[base.last()];
    struct Side {
      std::size_t contact = std::size_t(-1);
      double push{}, pull{};
    };
    const auto side = [&](std::size_t i) -> Side {
      const double push = push_at(chain, contact, y.data(), i);
      if (at.correction[i].velocity != 0 || push == 0) return {i, push, 0};
      return {i, push,
              -chain.eta_of(i) * contact.stiffness(stretch(chain, y.data(), i)) *
                  stretch(chain, at.shift.data(), i)};
    };
    // The right side of a bead is the left one of the next
    Side left, right;
    near_contacts(at, 2, [&](std::size_t n) {
      if (n < window.first || n >= window.last) return;
      left = right.contact == n ? right : side(n);
      right = side(n + 1);
      a[n] = chain.well.force(y[n]) + (left.push - right.push);
      double more = -chain.well.stiffness(y[n]) * at.shift[n] + (left.pull - right.pull);
      if (chain.variation)
        a[n] *= inverse_mass<double>(chain, n), more *= inverse_mass<double>(chain, n);
      at.v[n] += more;
    });
  }

  /// All corrections are computed before any is made, so that left and right are treated alike. Whether the step
  /// resolves all contacts; otherwise, unless it is the `last` resort, nothing is corrected.
  bool correct(const State<double>& state, Window& window, double h, bool last, const StepSums& now,
               NystromMemory& at) const {
    bool good = window.first == window.last || find(state, window, h, now, at) || last;
    if (at.contacts.empty() || !good) return good;
    for (std::size_t i : at.contacts) {
      at.correction[i] = impulse_error(state, i, h, at);
      good &= last || !too_fast(i, at.correction[i].reach, state, now);
    }
    if (good) {
      exchange_impulses(window, at);
      repair_forces(window, at);
      near_contacts(at, 1, [&](std::size_t n) { at.shift[n] = 0; });
    }
    for (std::size_t i : at.contacts) at.correction[i] = {};
    return good;
  }

  /// An ordinary step and the corrections. Its last stage is the new state, and the accelerations there are those with
  /// which the next step begins: they are swapped. A step that is too long for a contact leaves state and accelerations
  /// as they were, and its halves are tried.
  double step(State<double>& state, Window& window, double h, std::size_t divided,
              NystromMemory& at) const {
    const std::size_t last = base.last();
    double work = 0;
    StepSums& now = at.prepared[divided];
    prepare(now, h, std::ldexp(divided > 0 ? 0.125 : 0.5, -std::min(finer, 3)) / h);
    for (std::size_t i = 1; i <= last; ++i) {
      sweep_stage(state.y, state.v, base.c[i] * h, now.sums[i], at, window, at.y[i]);
      accelerate(chain, at.y[i].data(), at.a[i].data(), window);
      work += double(window.last - window.first);
    }
    sweep_stage(state.v, state.v, 0, now.sums.back(), at, window, at.v);
    if (!correct(state, window, h, divided == most_divisions, now, at)) {
      heed_stop();
      const int parts = divided == 0 ? 2 + finer % 2 : 2;
      for (int k = 0; k < parts; ++k) work += step(state, window, h / parts, divided + 1, at);
      return work;
    }
    std::swap(state.y, at.y[last]), std::swap(state.v, at.v), std::swap(at.a[0], at.a[last]);
    std::swap(at.row[0], at.row[last]);
    return work;
  }

  /// A run of equal steps, each of which may be divided.
  double run(State<double>& state, Window& window, double h, std::size_t count,
             NystromMemory& at) const {
    at.row.clear();
    for (const std::vector<double>& stage : at.a) at.row.push_back(stage.data());
    accelerate(chain, state.y.data(), at.a[0].data(), window);
    double work = double(window.last - window.first);
    for (std::size_t k = 0; k < count; ++k) {
      if (k % 64 == 63) heed_stop();
      work += step(state, window, h, 0, at);
    }
    return work;
  }
};

}  // namespace detail

double EventCorrected::advance(const Chain& chain, State<double>& state, Window& window, double h,
                               std::size_t count, NystromMemory& at) const {
  const auto run = [&]<class C>(const C& contact) {
    const detail::NystromStep<C> stepper{base, chain, contact, finer, reach};
    return stepper.run(state, window, h, count, at);
  };
  return std::visit(run, chain.contact.kind);
}

template Method::Method(const EventCorrected&);

}  // namespace lattice
