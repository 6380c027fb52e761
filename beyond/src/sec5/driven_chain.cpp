#include "sec5/driven_chain.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>

#include "lattice/integrators/event_corrected.hpp"
#include "lattice/numerics/progress.hpp"

namespace lattice {
namespace {

/// Half a step of friction: the factor of a velocity, and the part of mv^2 that it takes. `expm1` knows a small loss
/// without cancellation, so that the budget balances over millions of steps.
struct Friction {
  double factor, loss;
  Friction(double rate, double h)
      : factor(std::exp(-rate * h / 2)), loss(-std::expm1(-rate * h) / 2) {}
};

/// One run: the steps, and what they book.
class DrivenRun {
 public:
  DrivenRun(const DrivenChain& driven, double h)
      : driven_(driven), h_(h), stepper_{h}, memory_(stepper_.memory(driven.chain)) {
    stepper_.finer = std::max(0, std::ilogb(largest_step / h));
    for (double rate : driven.losses.of_site) friction_.emplace_back(rate, h);
    if (friction_.empty()) friction_.assign(driven.chain.sites, {driven.losses.rate, h});
  }

  void advance(State<double>& state, Window& window, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
      const double start = state.t;
      push(state, window, start);
      rub_beams(state, window);
      rub_contacts(state, window, false);
      stepper_.advance(driven_.chain, state, window, h_, 1, memory_);
      rub_contacts(state, window, true);
      rub_beams(state, window);
      state.t = start + h_;
      push(state, window, state.t);
    }
  }

  EnergyBudget budget{};

 private:
  double mass(std::size_t n) const { return driven_.chain.mass_of(n); }

  /// Half a step of the drive.
  void push(State<double>& state, Window& window, double t) {
    if (driven_.drive.by == Drive::By::nothing) return;
    const double kick = driven_.drive.force(t, state.y[0]) * h_ / 2;
    if (kick == 0) return;
    const double before = state.v[0];
    state.v[0] += kick / mass(0);
    budget.work += mass(0) / 2 * (state.v[0] - before) * (state.v[0] + before);
    window.first = 0, window.last = std::max<std::size_t>(window.last, 1);
  }

  /// Half a step of the beams' friction.
  void rub_beams(State<double>& state, Window window) {
    if (driven_.losses.rate == 0 && driven_.losses.of_site.empty()) return;
    double sum = 0;
    for (std::size_t n = window.first; n < window.last; ++n) {
      sum += mass(n) * state.v[n] * state.v[n] * friction_[n].loss;
      state.v[n] *= friction_[n].factor;
    }
    budget.beams += sum;
  }

  /// Half a step of the contacts' friction, pair by pair, in one order or in the other.
  void rub_contacts(State<double>& state, Window window, bool backwards) {
    if (driven_.losses.contact == 0) return;
    const std::size_t first = window.first + 1, last = window.last;
    for (std::size_t k = first; k < last; ++k)
      rub_pair(state, backwards ? first + last - 1 - k : k);
  }

  /// The relative velocity of a pair decays at a rate that its overlap decides; the momentum stays.
  void rub_pair(State<double>& state, std::size_t i) {
    const double overlap = state.y[i - 1] - state.y[i];
    if (!(overlap > 0)) return;
    const double m = mass(i - 1), k = mass(i), reduced = m * k / (m + k);
    const double rate =
        1.5 * driven_.losses.contact * driven_.chain.eta_of(i) * std::sqrt(overlap) / reduced;
    const double w = state.v[i] - state.v[i - 1], lost = -std::expm1(-rate * h_ / 2);
    budget.contacts += reduced / 2 * w * w * lost * (2 - lost);
    state.v[i - 1] += lost * w * reduced / m;
    state.v[i] -= lost * w * reduced / k;
  }

  const DrivenChain& driven_;
  double h_;
  EventCorrected stepper_;
  NystromMemory memory_;
  std::vector<Friction> friction_{};
};

}  // namespace

double Drive::force(double t, double y) const {
  if (by == By::base) return displacement(t);
  const double overlap = displacement(t) - y;
  return overlap > 0 ? overlap * std::sqrt(overlap) : 0;
}

// All energy is accounted for at every sample
double evolve(const DrivenChain& driven, State<double>& state, const TimeGrid& grid,
              const DrivenLook& look) {
  const Losses& losses = driven.losses;
  const auto good = [](double rate) { return rate >= 0 && std::isfinite(rate); };
  if (!(good(losses.rate) && good(losses.contact) &&
        std::all_of(losses.of_site.begin(), losses.of_site.end(), good)))
    throw std::invalid_argument("loss rates must be finite and >= 0");
  if (!losses.of_site.empty() && losses.of_site.size() != driven.chain.sites)
    throw std::invalid_argument("site-dependent losses need one rate per site");
  if (driven.chain.ends != Ends::free &&
      (losses.contact > 0 || driven.drive.by != Drive::By::nothing))
    throw std::invalid_argument("a drive and losses in contacts need a chain with free ends");
  const double start = energy(driven.chain, state), t0 = state.t;
  DrivenRun run(driven, grid.step());
  Window window = waking(driven.chain, state);
  double scale = start, open = 0;
  if (!look(state, run.budget)) return 0;
  Progress progress(number_label("step", grid.step()), 1);
  for (std::size_t k = 1; k <= grid.samples; ++k) {
    run.advance(state, window, grid.steps);
    state.t = t0 + double(k) * grid.interval();
    const EnergyBudget& l = run.budget;
    const double now = energy(driven.chain, state);
    scale = std::max({scale, now, l.work});
    open = std::max(open, std::abs(now + l.beams + l.contacts - l.work - start));
    if (!look(state, l)) break;
    progress.reach(double(k) / double(grid.samples));
  }
  return scale > 0 ? open / scale : 0;
}

// The step is found in runs that nobody observes
Refined<DrivenEnd> evolve(const Converged& stated, const DrivenChain& driven, State<double>& state,
                          double duration, Every every, const DrivenLook& look) {
  assert_usable(state, stated.tolerance);
  const State<double> start = state;
  const auto run = [&](EventCorrected method, const DrivenLook& watch) {
    // A drive that turns round within a step would be seen at a few phases only
    if (driven.drive.by != Drive::By::nothing)
      method.step = std::min(method.step, 1 / std::abs(driven.drive.omega));
    DrivenEnd out{start, {}, 0, 0};
    out.imbalance = evolve(driven, out.end, time_grid(method, duration, every),
                           [&](const State<double>& now, const EnergyBudget& so_far) {
                             out.budget = so_far;
                             return watch(now, so_far);
                           });
    out.energy = energy(driven.chain, out.end);
    return out;
  };
  auto runs =
      refined(stated.tolerance, [&](const EventCorrected& method) { return run(method, {}); });
  state = run(runs.method, look).end;
  return runs;
}

// In units of the collision, and of the root q of the overlap: with a time that passes at the rate dt = 2q ds the motion
// q' = v, v' = -4 q^2 (q^2 + 1.5 A v) is smooth even where the contact closes and opens
double restitution(double contact, double velocity) {
  const double loss = 1.5 * contact * std::pow(velocity, 0.2), h = 1. / 512;
  using Point = std::array<double, 2>;
  const auto rate = [&](const Point& p) {
    return Point{p[1], -4 * p[0] * p[0] * (p[0] * p[0] + loss * p[1])};
  };
  const auto step = [&](Point p, double ds) {
    const auto moved = [&](const Point& by, double w) {
      return Point{p[0] + w * by[0], p[1] + w * by[1]};
    };
    const Point a = rate(p), b = rate(moved(a, ds / 2)), c = rate(moved(b, ds / 2)),
                d = rate(moved(c, ds));
    for (std::size_t i : {0U, 1U}) p[i] += ds / 6 * (a[i] + 2 * (b[i] + c[i]) + d[i]);
    return p;
  };
  Point p{0, 1}, next = step(p, h);
  for (; next[0] > 0; next = step(p, h)) p = next;
  // The last step ends where q is zero
  double last = h;
  for (int k = 0; k < 8; ++k) next = step(p, last), last -= next[0] / next[1];
  return -step(p, last)[1];
}

double contact_loss(double e, double velocity) {
  if (!(e > 0 && e <= 1))
    throw std::invalid_argument("a coefficient of restitution must lie between 0 and 1");
  if (e == 1) return 0;
  double low = 0, high = 1;
  while (restitution(high, velocity) > e) high *= 2;
  for (int k = 0; k < 50; ++k) {
    const double middle = (low + high) / 2;
    (restitution(middle, velocity) > e ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace lattice
