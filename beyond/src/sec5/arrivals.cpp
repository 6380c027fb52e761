#include "sec5/arrivals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace lattice {
namespace {

/// Half the time between the maxima on either side; zero if one is missing.
double period_at(const std::vector<Maximum>& all, std::size_t i) {
  return i > 0 && i + 1 < all.size() ? (all[i + 1].t - all[i - 1].t) / 2 : 0;
}

/// The push that is the strongest one with the weight of the slow clock; none, `all.size()`, where all come too late.
std::size_t strongest(const std::vector<Maximum>& all, double nu) {
  double most = 0;
  std::size_t out = all.size();
  for (std::size_t i = 0; i < all.size() && nu * all[i].t < 4; ++i) {
    const double rate = 1 - nu * all[i].t / 4, weighted = all[i].height * rate * rate * rate;
    if (weighted > most) most = weighted, out = i;
  }
  return out;
}

/// Pushes are a period apart: the top of a parabola through the weighted logarithms of one and its neighbours.
double top_between(const std::vector<Maximum>& all, std::size_t i, double nu) {
  const auto log = [&](std::size_t k) {
    return std::log(all[k].height) + 3 * std::log1p(-nu * all[k].t / 4);
  };
  if (!(nu * all[i + 1].t < 4 && all[i - 1].height > 0 && all[i + 1].height > 0)) return all[i].t;
  const double a = all[i - 1].t - all[i].t, b = all[i + 1].t - all[i].t, middle = log(i);
  const double u = (log(i - 1) - middle) / a, v = (log(i + 1) - middle) / b;
  return all[i].t + std::clamp((u * b - v * a) / (2 * (u - v)), a, b);
}

}  // namespace

double slow_clock(double nu, double t) {
  return nu > 0 ? -4 / nu * std::expm1(-nu * t / 4) : t;
}

double true_time(double nu, double theta) {
  if (!(nu > 0)) return theta;
  return nu * theta < 4 ? -4 / nu * std::log1p(-nu * theta / 4)
                        : std::numeric_limits<double>::infinity();
}

void Maxima::add(double t, double x, double step) {
  if (seen_ >= 2 && middle_ > left_ && middle_ >= x) {
    const double rise = (x - left_) / 2, bend = x - 2 * middle_ + left_;
    all.push_back({t - step - rise / bend * step, middle_ - rise * rise / (2 * bend)});
  }
  left_ = middle_, middle_ = x, ++seen_;
}

// Without losses all weights are one
Arrival arrival(std::vector<Maximum> pushes) {
  const std::size_t i = strongest(pushes, 0);
  Arrival out;
  if (i < pushes.size()) out.t = pushes[i].t;
  out.period = period_at(pushes, i);
  out.pushes = std::move(pushes);
  return out;
}

void Arrivals::add(Arrival next) {
  next.reached = next.period > 0 && std::all_of(contacts.begin(), contacts.end(),
                                                [&](const Arrival& p) { return p.t < next.t; });
  contacts.push_back(std::move(next));
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

// Straight lines between the steps
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
  for (const Arrival& from : undamped.contacts) {
    const std::size_t i = strongest(from.pushes, nu);
    Arrival p;
    if (const double period = period_at(from.pushes, i); period > 0) {
      const double theta = top_between(from.pushes, i, nu);
      p.t = true_time(nu, theta);
      p.period = turn / (1 + (turn / period - 1) * (1 - nu * theta / 4));
    }
    out.add(std::move(p));
  }
  for (const Maximum& c : undamped.centres)
    if (nu * c.t < 4) out.centres.push_back({true_time(nu, c.t), c.height});
  return out;
}

}  // namespace lattice
