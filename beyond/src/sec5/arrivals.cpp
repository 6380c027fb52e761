#include "sec5/arrivals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "lattice/diagnostics/observe.hpp"
#include "lattice/impact/impact.hpp"

namespace lattice {
namespace {

/// Collects the maxima of a signal while it is sampled.
class Maxima {
 public:
  void add(double t, double x, double step) {
    if (seen_ >= 2 && middle_ > left_ && middle_ >= x) {
      const double rise = (x - left_) / 2, bend = x - 2 * middle_ + left_;
      all.push_back({t - step - rise / bend * step, middle_ - rise * rise / (2 * bend)});
      if (all.back().height > all[highest].height) highest = all.size() - 1;
    }
    left_ = middle_, middle_ = x, ++seen_;
  }
  std::vector<Maximum> all{};
  std::size_t highest = 0;

 private:
  double left_ = 0, middle_ = 0;
  std::size_t seen_ = 0;
};

/// Half the time between the maxima on either side; zero if one is missing.
double period_at(const std::vector<Maximum>& all, std::size_t i) {
  return i > 0 && i + 1 < all.size() ? (all[i + 1].t - all[i - 1].t) / 2 : 0;
}

/// The maximum that is the strongest one with the weight (1 - nu s/4)^power; none, `all.size()`, where all come too late.
std::size_t strongest_maximum(const std::vector<Maximum>& all, double nu, int power) {
  double most = 0;
  std::size_t out = all.size();
  for (std::size_t i = 0; i < all.size() && nu * all[i].t < 4; ++i) {
    const double rate = 1 - nu * all[i].t / 4;
    const double weighted = all[i].height * rate * rate * (power == 3 ? rate : 1);
    if (weighted > most) most = weighted, out = i;
  }
  return out;
}

/// The top of a parabola through the weighted logarithms of a maximum and its neighbours.
double top_between(const std::vector<Maximum>& all, std::size_t i, double nu, int power) {
  const auto log = [&](std::size_t k) {
    return std::log(all[k].height) + power * std::log1p(-nu * all[k].t / 4);
  };
  if (!(nu * all[i + 1].t < 4 && all[i - 1].height > 0 && all[i + 1].height > 0)) return all[i].t;
  const double a = all[i - 1].t - all[i].t, b = all[i + 1].t - all[i].t, middle = log(i);
  const double u = (log(i - 1) - middle) / a, v = (log(i + 1) - middle) / b;
  return all[i].t + std::clamp((u * b - v * a) / (2 * (u - v)), a, b);
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

// Each contact and each bead keeps its own maxima; the impact is the first of the first bead
Arrivals packet_arrivals(const DrivenChain& driven, double velocity, double duration,
                         std::size_t last, double step) {
  const Chain& chain = driven.chain;
  const std::size_t contacts = std::min(last, chain.sites - 1);
  std::vector<Maxima> push(contacts), speed(contacts);
  const TimeGrid steps = time_grid(duration, step, step);
  State<double> state = struck(chain.sites, velocity);
  speed[0].all.push_back({0, velocity});
  Arrivals out;
  out.budget = evolve(driven, state, steps, [&](const State<double>& now, const EnergyBudget&) {
    // Beyond the first bead at rest nothing has moved yet
    for (std::size_t n = 0; n < contacts && (now.y[n] != 0 || now.v[n] != 0); ++n) {
      const double overlap = now.y[n] - now.y[n + 1];
      push[n].add(now.t, overlap > 0 ? overlap * std::sqrt(overlap) : 0, steps.step());
      speed[n].add(now.t, std::abs(now.v[n]), steps.step());
    }
    // The centre swings with the beads; so it is taken at every step
    out.centres.push_back({now.t, energy_centre(energy_density(chain, now), 0, chain.sites)});
    // The packet has passed when the last push is well below its maximum
    const Maxima& end = push.back();
    if (period_at(end.all, end.highest) == 0 || now.y[contacts - 1] >= now.y[contacts]) return true;
    const Maximum& top = end.all[end.highest];
    return !(top.height > 1e-12 && now.t > top.t + 60);
  });
  double latest = 0;
  for (std::size_t n = 0; n < contacts; ++n) {
    Arrival p;
    p.pushes = std::move(push[n].all), p.speeds = std::move(speed[n].all);
    const std::size_t top = push[n].highest;
    if (!p.pushes.empty()) p.t = p.pushes[top].t, p.force = p.pushes[top].height;
    if (!p.speeds.empty()) p.velocity = p.speeds[speed[n].highest].height;
    p.period = period_at(p.pushes, top);
    p.reached = p.period > 0 && p.t > latest;
    latest = std::max(latest, p.t);
    out.contacts.push_back(std::move(p));
  }
  return out;
}

Travelled travelled_after(const Arrivals& arrivals, double t) {
  Travelled out;
  double last = 0, site = 0;
  std::vector<std::array<double, 2>> passed{{0, 0}};
  for (std::size_t n = 1; n < arrivals.contacts.size() && last < t; ++n) {
    const Arrival& p = arrivals.contacts[n];
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

double centre_after(const Arrivals& arrivals, double t) {
  const auto& all = arrivals.centres;
  const auto next =
      std::find_if(all.begin(), all.end(), [&](const Maximum& p) { return p.t >= t; });
  if (next == all.begin() || next == all.end()) throw std::out_of_range("the run is too short");
  const double part = (t - next[-1].t) / (next->t - next[-1].t);
  return next[-1].height + part * (next->height - next[-1].height);
}

// The internal clock runs on: what slows down are the turns beyond those of a linear oscillation
Arrivals slowed(const Arrivals& undamped, double nu) {
  if (!(nu > 0)) return undamped;
  const double turn = 2 * std::numbers::pi;
  Arrivals out;
  double latest = 0;
  for (const Arrival& from : undamped.contacts) {
    const std::size_t i = strongest_maximum(from.pushes, nu, 3),
                      k = strongest_maximum(from.speeds, nu, 2);
    Arrival p;
    if (const double period = period_at(from.pushes, i); period > 0) {
      const double s = top_between(from.pushes, i, nu, 3), rate = 1 - nu * s / 4;
      p.t = true_time(nu, s);
      p.force = from.pushes[i].height * rate * rate * rate;
      p.period = turn / (1 + (turn / period - 1) * rate);
    }
    if (k < from.speeds.size())
      p.velocity = from.speeds[k].height * std::pow(1 - nu * from.speeds[k].t / 4, 2);
    p.reached = p.period > 0 && p.t > latest;
    latest = std::max(latest, p.t);
    out.contacts.push_back(std::move(p));
  }
  for (const Maximum& c : undamped.centres)
    if (nu * c.t < 4) out.centres.push_back({true_time(nu, c.t), c.height});
  return out;
}

double seen_until(const Arrivals& arrivals, double resolution) {
  std::vector<double> v;
  for (const Arrival& p : arrivals.contacts) v.push_back(p.velocity);
  return falls_below(v, resolution);
}

}  // namespace lattice
