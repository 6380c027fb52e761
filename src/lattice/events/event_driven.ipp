#pragma once
#include "lattice/events/event_driven.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "lattice/events/columns.hpp"
#include "lattice/numerics/progress.hpp"

namespace lattice {
namespace {

/// One entry of the extrapolation table from its two predecessors.
template <class T>
LATTICE_WIDE void extrapolate_entry(T* __restrict__ a, const T* __restrict__ b, T gain,
                                    std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) a[k] = b[k] + gain * (b[k] - a[k]);
}

/// Numbers without a sign are ordered as their bits are, infinity above all of them and what is not a number above
/// that.
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

/// What integrating across a segment gives.
template <class T>
struct SmoothSegment {
  std::vector<T> z;  ///< positions, velocities, action integral: 2 * sites + 1 numbers
  T error = T(0);    ///< the sum of those of its steps
  std::vector<StepRecord<T>> records;  ///< for the columns; without nodes if no tangent vector
};

/**
A step adds one leapfrog level after another until the last two extrapolated values agree; a step that does not suffice
is shortened. The value of $j$ levels is compared with that of $j-1$, which estimates the error of the latter. The usual
comparison within level $j$ gives a number smaller by a factor $j^2$, and trusts the asymptotic series too early while a
recent event is still near. A runaway never agrees: a step of 1/16384 of the interval is accepted as it is, and if the
error then exceeds one the integration gives up. */
template <class T>
class SegmentIntegrator {
 public:
  SegmentIntegrator(const Chain& chain, const EventTolerance<T>& rule, T amplitude)
      : chain_(chain), rule_(rule), amplitude_(amplitude) {
    rule_.tolerance = std::max(rule.tolerance, T(16) * std::numeric_limits<T>::epsilon());
  }

  /// Integrates across a segment of the given length (in time) from positions, velocities and action integral in `z`; with a
  /// tangent vector it leaves records for the columns. The first step tries the whole interval. What remains is always
  /// divided evenly, so that no sliver is left.
  SmoothSegment<T> integrate(const std::vector<T>& z, T length, bool tangent_vector) {
    SmoothSegment<T> segment{z, T(0), {}};
    // Numbers without a symmetry, so that the vector does not miss what a column would see
    for (std::size_t i = 0; i < 2 * chain_.sites && tangent_vector; ++i)
      segment.z.push_back(T(int(7 * i % 11) - 5) / T(5));
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

      // The step is accepted; if half of the levels were enough, the next one may be twice as long
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

  std::size_t evaluations = 0;  ///< of the force on the whole chain, in all segments

 private:
  /// Returns the estimated error. The table holds increments, whose rounding errors are smaller than those of the
  /// values. After level $j$ its first entry is the polynomial in the square of the step through all $j$ results, taken
  /// at zero and computed by Neville's recursion.
  T step(Leapfrog<T>& leapfrog, std::vector<T>& z, T length, T s, T h, StepRecord<T>& record) {
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

  /// Relative to the amplitude for the orbit, to its square for the action integral, and absolute for the tangent vector; infinite
  /// if anything is not a finite number.
  T difference(const std::vector<T>& a, const std::vector<T>& b) const {
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

  const Chain& chain_;
  EventTolerance<T> rule_;
  T amplitude_;
  std::vector<std::vector<T>> table_;
  std::vector<T> previous_;  ///< the first entry of the table before the latest level
};

/// An instant, `ahead` of now, at which the contact `bond` opens or closes (`crosses`) or comes so close to it that we
/// want to look there. Without a bond it is the end of the run.
template <class T>
struct ContactEvent {
  static constexpr std::size_t none = std::size_t(-1);
  T ahead;
  std::size_t bond = none;
  bool crosses = false;
};

/**
An event at speed $u$ inside a step of length $h$ makes an error of the order $0.1\,u^{1/2}h^{3/2}$ in the tangent and
$0.1\,u^{3/2}h^{5/2}$ in the state. It need not be located if $u$ is below `slowest`: the square of the tolerance for a
tangent, its power 3/4 for an orbit alone. So the tail of a breather soon drops out, and with it the risk of chasing
rounding errors. If `slowest` is set to zero, every event is located, however faint; one that is missed counts as a
fault only above `serious`, the speed that the tolerance would have set.

An event located with an error $\delta$ costs an error $\delta^{3/2}$. Events within `slack`, the power 3/4
of the tolerance, therefore count as one: a pair related by symmetry needs one segment. Where an overlap
only touches zero, $x \simeq c(t-t^*)^2$, its stiffness has a corner, and an error $\delta$ in
time leaves an error $\delta^2$: we locate such an extremum within `near`. */
template <class T>
struct EventThresholds {
  T slowest, serious, slack, near;

  EventThresholds(const EventTolerance<T>& rule, T amplitude, bool tangent) {
    using std::sqrt;
    const T fine = tangent ? rule.tolerance : rule.tolerance * amplitude;
    const T by_tolerance = tangent ? fine * fine / T(16) : power34(fine);
    slowest = rule.slowest_event.value_or(by_tolerance);
    serious = std::max(slowest, by_tolerance);
    slack = power34(rule.tolerance) / T(4);
    near = sqrt(rule.tolerance) / T(16);
  }
  static T power34(T x) {
    using std::sqrt;
    return sqrt(x * sqrt(x));
  }
};

/// The time step of the detection, short against the period $2\pi$ of a well and against the hardest collision that we
/// expect, with twice the amplitude as its speed. Only stiff contacts and light beads shorten the usual step.
template <class T>
T search_step_for(const Chain& chain, double amplitude) {
  double fastest = 0;
  for (std::size_t i = 0; i <= chain.sites; ++i) {
    if (!is_distinct_contact(chain, i)) continue;
    const double inverse = (i > 0 ? inverse_mass<double>(chain, i - 1) : 0) +
                           (i < chain.sites ? inverse_mass<double>(chain, i) : 0);
    const double d = chain.contact.opening(), eta = chain.eta_of(i);
    const auto energy = [&](double x) { return inverse * eta * chain.contact.energy(d - x); };
    double x = 1;
    while (x > 1e-30 && energy(x) > energy(0) + 2 * amplitude * amplitude) x /= 2;
    fastest = std::max(fastest, std::sqrt(inverse * eta * chain.contact.stiffness(d - x)));
  }
  return std::min(T(0.05), T(3 / fastest));
}

/// Goes from event to event and remembers on which side of zero each overlap is: $+1$ closed, $-1$ open, 0 not yet
/// known (both beads at rest). Time is counted as what is left of the duration, so that tiny intervals are known to
/// full relative precision.
template <class T>
class EventIntegrator {
 public:
  /// A contact that begins exactly at zero is on the side to which its speed carries it, or its acceleration.
  EventIntegrator(const Chain& chain, const State<T>& state, T duration,
                  const EventTolerance<T>& rule, Tangent<T>* tangent)
      : chain_(chain),
        tangent_(tangent),
        rule_(rule),
        left_(duration),
        search_step_(search_step_for<T>(chain, double(largest(state)))),
        z_(state.y),
        side_(chain.sites + 1, 0),
        at_extremum_(chain.sites + 1, 0),
        largest_(std::max(largest(state), T(chain.contact.opening()))),
        thresholds_(rule, largest(state), tangent != nullptr),
        segments_(chain, rule, largest(state)) {
    z_.insert(z_.end(), state.v.begin(), state.v.end());
    z_.push_back(T(0));
    const std::vector<T> a = accelerations(chain_, state.y);
    for (std::size_t i = 0; i <= chain_.sites; ++i) {
      const Overlap<T> o = overlap(z_, a, i);
      side_[i] = sign_of(o.x != T(0) ? o.x : o.u != T(0) ? o.u : o.w);
    }
  }

  /// Every segment either advances in time or changes the side of a contact, but rounding could make a contact
  /// that rests at zero chatter. So the number of segments is bounded, generously: 64 per contact and unit of
  /// time. Beyond that we go straight to the end, with steps as short as the tolerance demands.
  FlowReport<T> run() {
    const double duration(left_), limit = 64 * (1 + duration) * double(chain_.sites + 1);
    Progress progress("", 1);
    for (double segments = 0; left_ > T(0); ++segments) {
      heed_stop();
      locate(segments < limit ? detect() : ContactEvent<T>{left_}, segments < limit);
      progress.reach(1 - double(left_) / duration);
    }
    flow_.evaluations += segments_.evaluations;
    return flow_;
  }

  /// Positions, velocities and the action integral (location.hpp), 2 * sites + 1 numbers.
  const std::vector<T>& end() const { return z_; }

 private:
  /// Positions and velocities are in `z`, accelerations in `a`, which may be empty if they do not matter. A missing
  /// contact counts as open.
  Overlap<T> overlap(const std::vector<T>& z, const std::vector<T>& a, std::size_t i) const {
    if (!is_distinct_contact(chain_, i)) return {T(-1), T(0), T(0)};
    return {T(chain_.contact.opening()) - stretch(chain_, z.data(), i),
            -stretch(chain_, z.data() + chain_.sites, i),
            a.empty() ? T(0) : -stretch(chain_, a.data(), i)};
  }

  /// The earliest event of the first step in which a contact opens or closes, or the end of the run.
  ContactEvent<T> detect() {
    Leapfrog<T> leapfrog(chain_, false);
    std::vector<T> before, now = z_;
    ContactEvent<T> first{left_};
    for (T gone(0); gone < left_ && first.bond == ContactEvent<T>::none;) {
      const T dt = std::min(search_step_, left_ - gone);
      before = now;
      leapfrog.step(now, dt);
      first.ahead = dt;
      for (std::size_t i = 0; i <= chain_.sites; ++i)
        if (is_distinct_contact(chain_, i)) check_contact(before, now, dt, i, gone == T(0), first);
      first.ahead = gone + first.ahead;
      gone += dt;
    }
    flow_.evaluations += leapfrog.evaluations;
    if (first.bond == ContactEvent<T>::none || first.ahead > left_) first.ahead = left_;
    return first;
  }

  /// A contact whose overlap turns round within 1/500 of its amplitude from zero may or may not have switched;
  /// the leapfrog, with steps of 0.05, cannot tell. We go to the extremum and see. `at_extremum_` keeps us from
  /// going there again at the `start` of the next search.
  void check_contact(const std::vector<T>& before, const std::vector<T>& now, T dt, std::size_t i,
                     bool start, ContactEvent<T>& first) {
    const Overlap<T> o = overlap(before, {}, i), p = overlap(now, {}, i);
    const T size = std::max({magnitude(o.x), magnitude(o.u), magnitude(p.x), magnitude(p.u)});
    const T side = T(side_[i]);
    if (side_[i] == 0 || is_faint(now, i, size)) {
      if (p.x != T(0)) side_[i] = sign_of(p.x);
      return;
    }

    // On the other side at the end it has switched; else only the extremum in between shows what happened
    const Arc<T> arc{o.x, o.u, p.x, p.u, dt};
    const auto stays = [&](T s) { return side * arc.value(s) > T(0); };
    ContactEvent<T> found{dt, i, true};
    if (side * p.x < T(0)) {
      found.ahead *= Arc<T>::last(T(1), stays);
    } else if (side * o.u < T(0) && side * p.u > T(0) && !(start && at_extremum_[i])) {
      const T turn = Arc<T>::last(T(1), [&](T s) { return side * arc.slope(s) < T(0); });
      const T dip = side * arc.value(turn), amplitude = std::max(size, magnitude(p.u - o.u) / dt);
      if (dip > amplitude / T(500)) return;
      found.crosses = dip < T(0);
      found.ahead *= found.crosses ? Arc<T>::last(turn, stays) : turn;
    } else {
      return;
    }
    if (first.bond == ContactEvent<T>::none || found.ahead < first.ahead) first = found;
  }

  /// An event is located once without the tangent vector, to correct the target. The search ends when the correction is
  /// too small to matter. A contact that is found on the wrong side at the end of a segment has switched within it,
  /// and becomes the target. After a dozen attempts, in a runaway, or if events are no longer to be
  /// `corrected`, the segment stands as it is.
  void locate(ContactEvent<T> target, bool corrected) {
    for (int attempt = 0;; ++attempt) {
      const bool rehearsal = target.bond != ContactEvent<T>::none && attempt == 0;
      const SmoothSegment<T> segment =
          segments_.integrate(z_, target.ahead, tangent_ && !rehearsal);
      const std::vector<T> y(segment.z.begin(), segment.z.begin() + long(chain_.sites));
      const std::vector<T> a = accelerations(chain_, y);
      const ContactEvent<T> shift = correction(segment.z, a, target);
      const T enough = shift.crosses ? thresholds_.slack : thresholds_.near;
      const bool settled = magnitude(shift.ahead) <= enough, lost = !(segment.error <= T(1));
      if ((settled && !rehearsal) || attempt == 12 || !corrected || lost)
        return accept(segment, a, target);
      target = {target.ahead + shift.ahead, shift.bond, shift.crosses};
      if (target.ahead >= left_) target = {left_};
    }
  }

  /// Of the contacts on the wrong side and the one aimed at, the one that switched first is the next target;
  /// `ahead` is the time from the end of the segment to its event, in general negative. If the contact
  /// aimed at does not switch after all, we aim at its extremum.
  ContactEvent<T> correction(const std::vector<T>& z, const std::vector<T>& a,
                             const ContactEvent<T>& target) const {
    ContactEvent<T> first{T(0)};
    const auto reachable = [&](T t) { return magnitude(t) < T(1) && target.ahead + t > T(0); };
    for (std::size_t i = 0; i <= chain_.sites; ++i) {
      const Overlap<T> o = overlap(z, a, i);
      const bool aimed = target.crosses && i == target.bond, wrong = T(side_[i]) * o.x < T(0);
      if (!(aimed || wrong) || is_faint(z, i, std::max(magnitude(o.x), magnitude(o.u)))) continue;
      const T shift = o.leaves(side_[i]);
      if (reachable(shift) && (!first.crosses || shift < first.ahead)) first = {shift, i, true};
    }
    if (first.crosses || target.bond == ContactEvent<T>::none) return first;
    const T shift = overlap(z, a, target.bond).turns();
    return reachable(shift) ? ContactEvent<T>{shift, target.bond, false} : first;
  }

  /// The segment is final. The orbit moves on, the columns follow along the records, and the contacts take
  /// their sides: at zero the speed decides, elsewhere the overlap. To the columns a stiffness below 1/64 of
  /// the tolerance is negligible.
  void accept(const SmoothSegment<T>& segment, const std::vector<T>& a,
              const ContactEvent<T>& target) {
    z_ = segment.z;
    left_ = target.ahead < left_ && segment.error <= T(1) ? left_ - target.ahead : T(0);
    flow_.error += segment.error;
    flow_.steps += segment.records.size();
    for (const StepRecord<T>& record : segment.records)
      if (tangent_) advance_tangent(chain_, record, rule_.tolerance / T(64), *tangent_);
    if (target.ahead > search_step_ / T(100))
      std::fill(at_extremum_.begin(), at_extremum_.end(), 0);
    if (target.bond != ContactEvent<T>::none && !target.crosses) at_extremum_[target.bond] = 1;
    for (std::size_t i = 0; i <= chain_.sites; ++i) {
      const Overlap<T> o = overlap(z_, a, i);
      update_side(o, is_faint(z_, i, std::max(magnitude(o.x), magnitude(o.u))), side_[i]);
    }
  }

  /// Whether an overlap of this `size` is too small to be located: by the thresholds, or because two beads move alike and
  /// their positions are rounded.
  bool is_faint(const std::vector<T>& z, std::size_t i, const T& size) const {
    if (size <= thresholds_.slowest) return true;
    const T units = T(64) * std::numeric_limits<T>::epsilon();
    if (size > units * largest_) return false;
    T near(chain_.contact.opening());
    for (const std::size_t n : {i > 0 ? i - 1 : chain_.sites - 1, i < chain_.sites ? i : 0})
      near = std::max({near, magnitude(z[n]), magnitude(z[chain_.sites + n])});
    return size <= units * near;
  }

  /// A contact that moves away from its side and is within `slack` of zero (in time) has switched. One that is
  /// found on the wrong side elsewhere is a missed event, and is counted if that is serious.
  void update_side(const Overlap<T>& o, bool faint, int& side) {
    const T size = std::max(magnitude(o.x), magnitude(o.u));
    if (!faint && magnitude(o.x) <= T(2) * thresholds_.slack * magnitude(o.u)) {
      if (T(side) * o.u < T(0)) {
        ++flow_.contact_events;
        side = sign_of(o.u);
      }
    } else if (T(side) * o.x < T(0)) {
      flow_.missed_events += !faint && size > thresholds_.serious;
      side = sign_of(o.x);
    }
  }

  const Chain& chain_;
  Tangent<T>* tangent_;
  const EventTolerance<T>& rule_;
  T left_, search_step_;
  std::vector<T> z_;
  std::vector<int> side_, at_extremum_;
  T largest_;
  EventThresholds<T> thresholds_;
  SegmentIntegrator<T> segments_;
  FlowReport<T> flow_;
};

/// The error that a flow of so many steps may have.
template <class T>
T allowed_error(const FlowReport<T>& report, const EventTolerance<T>& rule) {
  const T tolerance = std::max(rule.tolerance, T(16) * std::numeric_limits<T>::epsilon());
  return tolerance * T(double(report.steps + 1));
}

/// What is wrong with a flow, in one line.
template <class T>
std::string fault_of(const FlowReport<T>& report, const EventTolerance<T>& rule) {
  if (!(report.error <= T(1))) return "the motion runs away: no step is short enough to follow it";
  if (report.missed_events > 0)
    return "the flow missed " + std::to_string(report.missed_events) +
           " openings or closings of contacts";
  return number_label("the flow has an error of", double(report.error)) +
         number_label(" (allowed:", double(allowed_error(report, rule))) + ")";
}

}  // namespace

template <class T>
bool is_accurate(const FlowReport<T>& report, const EventTolerance<T>& rule) {
  return report.missed_events == 0 && report.error <= allowed_error(report, rule);
}

// What only wants the end is spared the question
template <class T>
FlowReport<T> flow(const Chain& chain, State<T>& state, std::type_identity_t<T> duration,
                   const EventTolerance<T>& rule, Tangent<T>* tangent) {
  const FlowReport<T> report = try_flow(chain, state, duration, rule, tangent);
  if (!is_accurate(report, rule)) throw FlowFailed(fault_of(report, rule));
  return report;
}

// From event to event; energy, action integral and time are added at the end
template <class T>
FlowReport<T> try_flow(const Chain& chain, State<T>& state, std::type_identity_t<T> duration,
                       const EventTolerance<T>& rule, Tangent<T>* tangent) {
  const T before = energy(chain, state);
  EventIntegrator<T> integrator(chain, state, duration, rule, tangent);
  FlowReport<T> result = integrator.run();
  const auto middle = integrator.end().begin() + long(chain.sites);
  state.y.assign(integrator.end().begin(), middle);
  state.v.assign(middle, integrator.end().end() - 1);
  result.action_integral = integrator.end().back();
  state.t += duration;
  const T change = magnitude(energy(chain, state) - before);
  result.energy_drift = before != T(0) ? change / magnitude(before) : change;
  return result;
}

}  // namespace lattice

/// The functions of this file in a number type.
#define LATTICE_FLOW(T)                                                                    \
  template bool is_accurate<T>(const FlowReport<T>&, const EventTolerance<T>&);            \
  template FlowReport<T> flow<T>(const Chain&, State<T>&, T, const EventTolerance<T>&,     \
                                 Tangent<T>*);                                             \
  template FlowReport<T> try_flow<T>(const Chain&, State<T>&, T, const EventTolerance<T>&, \
                                     Tangent<T>*);
