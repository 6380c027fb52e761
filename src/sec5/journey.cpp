#include "sec5/journey.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "lattice/packets/impact.hpp"

namespace lattice {
namespace {

/// Finds the maxima of a signal while it is sampled, and keeps the highest with its neighbours.
class HighestTop {
 public:
  void add(double t, double x, double step) {
    if (seen_ >= 2 && middle_ > left_ && middle_ >= x) {
      const double rise = (x - left_) / 2, bend = x - 2 * middle_ + left_;
      keep(t - step - rise / bend * step, middle_ - rise * rise / (2 * bend));
    }
    left_ = middle_, middle_ = x, ++seen_;
  }
  double t() const { return t_; }
  double height() const { return height_; }
  /// Half the time between the maxima on either side; zero if one is missing.
  double period() const { return before_ >= 0 && after_ >= 0 ? (after_ - before_) / 2 : 0; }

 private:
  void keep(double t, double height) {
    if (height > height_)
      before_ = last_, t_ = t, height_ = height, after_ = -1;
    else if (after_ < 0)
      after_ = t;
    last_ = t;
  }
  double left_ = 0, middle_ = 0, t_ = 0, height_ = 0, before_ = -1, after_ = -1, last_ = -1;
  std::size_t seen_ = 0;
};

/// The velocity at bead `n` (counted from zero) that the slow clock predicts.
double slowed_velocity(const Passing& p, double nu) {
  return p.velocity * std::exp(-nu / 2 * true_time(nu, p.t));
}

/// Where a falling sequence of velocities passes `resolution`.
double falls_below(const std::vector<double>& v, double resolution) {
  const auto low = std::find_if(v.begin(), v.end(), [&](double x) { return x < resolution; });
  const double n = double(low - v.begin());
  if (low == v.end() || low == v.begin()) return n;
  const double before = std::log(low[-1]), after = std::log(std::max(*low, 1e-300));
  return n + (before - std::log(resolution)) / (before - after);
}

}  // namespace

double slow_clock(double nu, double t) {
  return nu > 0 ? -4 / nu * std::expm1(-nu * t / 4) : t;
}

double true_time(double nu, double s) {
  if (!(nu > 0)) return s;
  return nu * s < 4 ? -4 / nu * std::log1p(-nu * s / 4) : std::numeric_limits<double>::infinity();
}

// Each contact and each bead keeps its own maxima
Journey follow_packet(const Bench& bench, double velocity, double duration, std::size_t last,
                      double step) {
  const Chain& chain = bench.chain;
  const std::size_t contacts = std::min(last, chain.sites - 1);
  std::vector<HighestTop> push(contacts), speed(contacts);
  const TimeGrid steps = time_grid(duration, step, step);
  State<double> state = struck(chain.sites, velocity);
  Journey out;
  out.ledger = run_bench(bench, state, steps, [&](const State<double>& now, const Ledger&) {
    for (std::size_t n = 0; n < contacts; ++n) {
      const double overlap = now.y[n] - now.y[n + 1];
      push[n].add(now.t, overlap > 0 ? overlap * std::sqrt(overlap) : 0, steps.step());
      speed[n].add(now.t, std::abs(now.v[n]), steps.step());
    }
    out.duration = now.t;
    // The packet has passed when the last push is well below its maximum
    const double end = now.y[contacts - 1] - now.y[contacts];
    return !(push.back().period() > 0 && push.back().height() > 1e-12 && end < 0 &&
             now.t > push.back().t() + 60);
  });
  double latest = 0;
  for (std::size_t n = 0; n < contacts; ++n) {
    Passing p{push[n].t(), push[n].height(), push[n].period(), speed[n].height()};
    if (n == 0) p.velocity = std::max(p.velocity, velocity);
    p.reached = p.period > 0 && p.t > latest;
    latest = std::max(latest, p.t);
    out.contacts.push_back(p);
  }
  return out;
}

Progressed way_after(const Journey& journey, double t) {
  Progressed out;
  double last = 0, site = 0;
  std::vector<std::array<double, 2>> passed{{0, 0}};
  for (std::size_t n = 1; n < journey.contacts.size() && last < t; ++n) {
    const Passing& p = journey.contacts[n];
    if (!p.reached) continue;
    // Of the last stretch only what lies before the end counts
    const double until = std::min(p.t, t), dwell = (p.t - last) / (double(n) - site);
    out.oscillations += (until - last) / p.period;
    out.sites += (until - last) / dwell;
    out.period = p.period;
    last = until, site = double(n);
    passed.push_back({p.t, double(n)});
    const auto& from = passed[passed.size() - std::min<std::size_t>(passed.size(), 6)];
    out.speed = (double(n) - from[1]) / (p.t - from[0]);
  }
  if (last < t && out.period > 0) out.oscillations += (t - last) / out.period, out.speed = 0;
  return out;
}

// The internal clock runs on: what slows down are the turns beyond those of a linear oscillation
Progressed predicted_way(const Journey& undamped, double nu, double t) {
  const double s = slow_clock(nu, t), turn = 2 * std::numbers::pi;
  Progressed out = way_after(undamped, s);
  const double rate = nu > 0 ? 1 - nu * s / 4 : 1;
  out.oscillations += (t - s) / turn;
  out.speed *= rate;
  out.period = turn / (1 + (turn / out.period - 1) * rate);
  return out;
}

double seen_until(const Journey& journey, double resolution) {
  std::vector<double> v;
  for (const Passing& p : journey.contacts) v.push_back(p.velocity);
  return falls_below(v, resolution);
}

double predicted_sight(const Journey& undamped, double nu, double resolution) {
  std::vector<double> v;
  for (const Passing& p : undamped.contacts) v.push_back(slowed_velocity(p, nu));
  return falls_below(v, resolution);
}

}  // namespace lattice
