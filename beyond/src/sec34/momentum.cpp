#include "sec34/momentum.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

namespace lattice {

namespace {

constexpr double turn = 2 * std::numbers::pi;

// Derivative of the band-limited envelope at site n, times the sign of the envelope
double slope(const std::vector<double>& y, std::size_t n, std::size_t first, std::size_t last) {
  double out = 0;
  for (std::size_t m = 1; m <= last - first; ++m)
    out += ((n + m <= last ? y[n + m] : 0) - (n >= first + m ? y[n - m] : 0)) / double(m);
  return out;
}

}  // namespace

Gauge::Gauge(const Chain& of, double time, std::size_t half)
    : sites_(of.sites), half_(half), stretch_(time), square_(of.sites), turned_(of.sites) {}

// The packet is around the strongest site, wherever that is
void Gauge::operator()(const State<double>& now, const std::vector<double>& density,
                       double centre) {
  const std::size_t peak = strongest(density), first = std::max(peak, half_ + 1) - half_,
                    last = std::min(peak + half_, sites_ - 2);
  sum_.t += now.t, sum_.centre += centre, ++looks_;
  sum_.momentum += momentum(now, first, last);
  for (std::size_t n = first; n <= last; ++n) {
    sum_.energy += density[n];
    sum_.beads += now.v[n];
    if (n < last) sum_.current -= (now.v[n] * now.y[n + 1] - now.v[n + 1] * now.y[n]) / 2;
    sum_.envelope += now.v[n] * slope(now.y, n, first, last);
    add_angle(now, n);
  }
  before_.push_back(now);
  if (before_.size() > lag()) before_.pop_front();
  if (now.t >= stretch_ * double(all.size() + 1)) close();
}

std::size_t Gauge::lag() const {
  return before_.size() < 2 ? 2 : std::size_t(std::lround(cycle / (before_[1].t - before_[0].t)));
}

// The angle by which a bead has turned since one cycle ago, beyond a whole turn, and its velocity squared
void Gauge::add_angle(const State<double>& now, std::size_t n) {
  square_[n] += now.v[n] * now.v[n];
  if (before_.size() < lag()) return;
  const State<double>& past = before_.front();
  turned_[n] += std::complex(now.y[n], -now.v[n] * cycle / turn) *
                std::complex(past.y[n], past.v[n] * cycle / turn);
}

// The action of each bead is that of the stretch in which it belonged to the packet
void Gauge::close() {
  for (std::size_t n = 0; n < sites_; ++n) {
    if (square_[n] > 0) sum_.action += square_[n] * cycle / (turn + std::arg(turned_[n]));
    sum_.frequency += square_[n];
  }
  sum_.frequency *= looks_ / sum_.action;
  for (double Means::*x :
       {&Means::t, &Means::centre, &Means::energy, &Means::action, &Means::frequency,
        &Means::momentum, &Means::current, &Means::envelope, &Means::beads})
    sum_.*x /= looks_;
  all.push_back(sum_);
  sum_ = {}, looks_ = 0;
  std::fill(square_.begin(), square_.end(), 0.0);
  std::fill(turned_.begin(), turned_.end(), 0.0);
}

std::size_t strongest(const std::vector<double>& density) {
  return std::size_t(std::max_element(density.begin(), density.end()) - density.begin());
}

// A speed is that between the neighbours of a stretch, so the last one has none
std::vector<Means> means_along(const WavesAbsorbed& impact, double step, double until,
                               std::size_t sites, double stretch, std::size_t half) {
  Gauge gauge({sites, Quartic{impact.s}}, stretch, half);
  follow_without(impact, step, until, sites,
                 [&](const State<double>& now, const std::vector<double>& density, double centre) {
                   gauge(now, density, centre);
                 });
  std::vector<Means> all = std::move(gauge.all);
  for (std::size_t k = 1; k + 1 < all.size(); ++k)
    all[k].speed = (all[k + 1].centre - all[k - 1].centre) / (all[k + 1].t - all[k - 1].t);
  if (!all.empty()) all.pop_back();
  return all;
}

double momentum(const State<double>& now, std::size_t first, std::size_t last) {
  double p = 0;
  for (std::size_t n = first; n <= last; ++n) p -= now.v[n] * (now.y[n + 1] - now.y[n - 1]) / 2;
  return p;
}

// What telescopes is the flux, the rest are the terms of wells and contacts
Terms rates(const Chain& chain, const State<double>& now, std::size_t first, std::size_t last) {
  const auto& [y, v, t] = now;
  const auto push = [&](std::size_t contact) { return contact_push(chain, now.y.data(), contact); };
  const auto flux = [&](std::size_t n) {
    return (now.v[n - 1] * now.v[n] - now.y[n - 1] * now.y[n] -
            push(n) * (now.y[n] - now.y[n - 1])) /
           2;
  };
  Terms rate{flux(first) - flux(last + 1)};
  for (std::size_t n = first; n <= last; ++n) {
    const double left = y[n] - y[n - 1], right = y[n + 1] - y[n];
    rate.wells -= (chain.well.force(y[n]) + y[n]) * (left + right) / 2;
    rate.contacts += (push(n + 1) * left - push(n) * right) / 2;
  }
  return rate;
}

// The window stays until the centre is more than a site from its middle
std::vector<Balance> balance_along(const WavesAbsorbed& impact, double step, double from,
                                   double until, std::size_t sites) {
  const Chain chain{sites, Quartic{impact.s}};
  std::vector<Balance> all;
  Balance at;
  Terms rate;
  std::size_t site = 0;
  double start = 0;
  const auto watch = [&](const State<double>& now, const std::vector<double>& density, double) {
    if (now.t < from) return;
    const double x = energy_centre(density, strongest(density)) - 1;
    const auto held = [&] { return momentum(now, site - within, site + within); };
    if (site == 0) {
      site = std::size_t(std::lround(x));
      start = held();
    } else {
      const Terms here = rates(chain, now, site - within, site + within);
      for (double Terms::*r : {&Terms::edges, &Terms::wells, &Terms::contacts})
        at.sum.*r += (now.t - at.t) / 2 * (rate.*r + here.*r);
    }
    if (std::abs(x - double(site)) > 1) {
      const double old = held();
      site = std::size_t(std::lround(x));
      at.window += held() - old;
    }
    rate = rates(chain, now, site - within, site + within);
    at.t = now.t;
    at.change = held() - start;
    if (now.t >= from + 8 * double(all.size()) - 1e-9) all.push_back(at);
  };
  follow_without(impact, step, until, sites, watch);
  return all;
}

}  // namespace lattice
