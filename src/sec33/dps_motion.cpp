#include "sec33/dps_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "lattice/gsl/random.hpp"
#include "lattice/model/sites.hpp"
#include "lattice/numerics/line_fit.hpp"

namespace lattice {

double quartic_centre(Centre centre, const Field& v) {
  double sum = 0, moment = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const double weight = std::norm(v[i]) * std::norm(v[i]);
    sum += weight;
    moment += weight * double(site_number(i, v.size()));
  }
  return moment / sum - (centre == Centre::bond ? 0.5 : 0);
}

// On how many sites a field lives
double sites_filled(const Field& v) {
  double squares = 0, fourth = 0;
  for (const auto& v_n : v) squares += std::norm(v_n), fourth += std::norm(v_n) * std::norm(v_n);
  return squares * squares / fourth;
}

PinnedBreather::PinnedBreather(Centre c, double frequency, std::size_t sites)
    : PinnedBreather(stationary<double>(c, frequency, sites)) {}

PinnedBreather::PinnedBreather(const Stationary<double>& state)
    : centre(state.centre),
      mu(state.mu),
      exponent(state.exponent),
      u(state.u.begin(), state.u.end()),
      pair(contact_spectrum(state, true)),
      shift(0) {
  double sum = 0, moment = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    const double x = state.u[i], cube = x * x * x;
    const double n = double(site_number(i, u.size())) - (centre == Centre::bond ? 0.5 : 0);
    sum += cube * x;
    moment += 4 * n * cube * pair.V(Eigen::Index(i));
  }
  shift = std::abs(moment / sum);
  if (moment < 0) pair.V = -pair.V;
}

// What carries a pendulum from the bottom of its trough just to the top of the hill
double PinnedBreather::freeing_push() const {
  return pair.rate / (std::numbers::pi * shift * (mu - pair.m));
}

/**
The arithmetic-geometric mean converges within a few rounds, because every round squares the relative
distance of the two means. */
double PinnedBreather::departure(double growing) const {
  const double speed = 2 * shift * pair.rate * std::abs(growing);
  double a = std::hypot(speed, pair.rate / std::numbers::pi), b = speed;
  if (!(speed > 0)) return std::numeric_limits<double>::infinity();
  while (a - b > 1e-15 * a) {
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  return 1 / (2 * a);
}

// How far it went, and when it first passed a given distance
double DpsBreatherRun::largest() const {
  double top = 0;
  for (const double x : X) top = std::max(top, std::abs(x));
  return top;
}

double DpsBreatherRun::reaches(double distance) const {
  for (std::size_t k = 1; k < X.size(); ++k)
    if (const double now = std::abs(X[k]), before = std::abs(X[k - 1]); now > distance)
      return t[k - 1] + (t[k] - t[k - 1]) * (distance - before) / (now - before);
  return std::nan("");
}

DpsBreatherRun DpsBreatherRun::until(double time) const {
  DpsBreatherRun out = *this;
  const auto end = std::upper_bound(out.t.begin(), out.t.end(), time) - out.t.begin();
  out.t.resize(std::size_t(end)), out.X.resize(std::size_t(end));
  return out;
}

// A run of the whole equation; the drifts of norm and energy say how far it can be trusted
DpsBreatherRun follow_breather(const PinnedBreather& breather, Field v, double time,
                               const Accuracy& accuracy, const DpsLook& watch) {
  DpsBreatherRun out;
  const auto energy_of = [&](const Field& w) { return energy(w, false, breather.exponent); };
  const double start = energy_of(v);
  const TurningDps equation{{v.size(), Ends::free, breather.exponent, 1}, breather.mu};
  out.norm_drift = evolve_dps(equation, v, time, std::size_t(std::ceil(accuracy.samples * time)),
                              accuracy.tolerance, [&](double t, const Field& now) {
                                out.t.push_back(t);
                                out.X.push_back(quartic_centre(breather.centre, now));
                                const double sites = sites_filled(now);
                                if (out.t.size() == 1) out.sites = sites;
                                out.most_sites = std::max(out.most_sites, sites);
                                out.energy_drift = std::max(out.energy_drift,
                                                            std::abs(energy_of(now) / start - 1));
                                watch(t, now);
                              });
  return out;
}

// Start along the growing direction and fit the growth of its share over four growth times
double measured_rate(const PinnedBreather& site, double size, const Accuracy& accuracy) {
  Field v = site.u;
  site.pair.add({size, size / site.pair.push}, v);
  std::vector<double> t, share;
  follow_breather(site, v, 4 / site.pair.rate, accuracy, [&](double now, Field w) {
    for (std::size_t i = 0; i < w.size(); ++i) w[i] -= site.u[i];
    t.push_back(now);
    share.push_back(std::log(site.pair.growing(w)));
  });
  return fit_line(t, share).slope;
}

bool moved(const DpsBreatherRun& run, double by) {
  return run.reaches(1) <= by;
}

double bisect_push(const PinnedBreather& bond, const Accuracy& accuracy, int steps) {
  const auto freed = [&](double push) {
    Field v = bond.u;
    bond.pair.add({0, push}, v);
    return moved(follow_breather(bond, v, 12 / bond.pair.rate, accuracy));
  };
  double low = 0.8 * bond.freeing_push(), high = 1.2 * bond.freeing_push();
  if (freed(low) || !freed(high))
    throw std::runtime_error("the push that frees the bond-centred breather is not between " +
                             std::to_string(low) + " and " + std::to_string(high));
  // Every run decides one binary digit
  for (int k = 0; k < steps; ++k) {
    const double middle = (low + high) / 2;
    (freed(middle) ? high : low) = middle;
  }
  return (low + high) / 2;
}

// Real or complex noise, of one sign or both, absolute or in proportion to the breather
Field Noise::operator()(const Field& u, std::size_t seed) const {
  Random random(seed);
  const auto draw = [&] { return amplitude * random.uniform(positive ? 0 : -1, 1); };
  Field w;
  for (const auto& u_n : u) {
    const double re = draw(), im = imaginary ? draw() : 0;
    w.push_back(std::complex<double>(re, im) * (relative ? u_n : 1.0));
  }
  return w;
}

Field perturbed(const PinnedBreather& breather, const Noise& noise, bool pinned,
                NoiseTrial& trial) {
  Field w = noise(breather.u, trial.seed);
  if (!pinned) breather.pair.add(-breather.pair.of(w), w);
  trial.kick = breather.pair.of(w);
  trial.growing = std::abs(breather.pair.growing(w));
  for (std::size_t i = 0; i < w.size(); ++i) w[i] += breather.u[i];
  return w;
}

// A breather has left after half a site; its speed is that over the first site it then crosses
Census tally(const std::vector<NoiseTrial>& trials, DpsBreatherRun NoiseTrial::*which, double by) {
  Census out;
  for (const NoiseTrial& trial : trials) {
    const DpsBreatherRun& run = trial.*which;
    const double leaves = run.reaches(0.5), there = run.reaches(1.5);
    out.left += leaves <= by;
    out.moved += moved(run, by);
    out.departures.push_back(leaves <= by ? leaves : HUGE_VAL);
    if (there <= by) out.speeds.push_back(1 / (there - leaves));
  }
  std::sort(out.departures.begin(), out.departures.end());
  std::sort(out.speeds.begin(), out.speeds.end());
  return out;
}

// Does the pendulum predict each departure, and which pushes free a breather?
double departure_difference(const std::vector<NoiseTrial>& trials,
                            DpsBreatherRun NoiseTrial::*which, const PinnedBreather& site) {
  double apart = 0;
  for (const NoiseTrial& trial : trials) {
    const double pendulum = site.departure(trial.growing);
    apart = std::max(apart, std::abs((trial.*which).reaches(0.5) / pendulum - 1));
  }
  return apart;
}

PushCount count_pushes(const std::vector<NoiseTrial>& trials, DpsBreatherRun NoiseTrial::*which,
                       double freeing) {
  PushCount out;
  for (const NoiseTrial& trial : trials) {
    const bool pushed = std::abs(trial.kick.imag()) > freeing;
    out.over += pushed;
    out.told += pushed == moved(trial.*which);
  }
  return out;
}

std::size_t torn(const std::vector<NoiseTrial>& trials) {
  return std::size_t(std::count_if(trials.begin(), trials.end(), [](const NoiseTrial& trial) {
    return moved(trial.good) != moved(trial.rough);
  }));
}

Estimate largest_spread(const std::vector<NoiseTrial>& trials) {
  double rough = 0, good = 0;
  for (const NoiseTrial& trial : trials) {
    rough = std::max(rough, trial.rough.spread());
    good = std::max(good, trial.good.spread());
  }
  return compare(rough, good);
}

// When each passes the next site, seed by seed and in the median
Delay delay_of(const std::vector<NoiseTrial>& controls, const std::vector<NoiseTrial>& trials) {
  const auto passes = [](const std::vector<NoiseTrial>& list, DpsBreatherRun NoiseTrial::*which) {
    std::vector<double> out;
    for (const NoiseTrial& trial : list) {
      const DpsBreatherRun& run = trial.*which;
      out.push_back(moved(run) ? run.reaches(1) : run.t.back());
    }
    return out;
  };
  std::array<std::size_t, 2> later{};
  std::array<double, 2> ratio{};
  for (const std::size_t fine : {0U, 1U}) {
    const auto run = fine ? &NoiseTrial::good : &NoiseTrial::rough;
    auto free = passes(trials, run), held = passes(controls, run);
    for (std::size_t k = 0; k < free.size(); ++k) later[fine] += held[k] > free[k];
    for (auto* list : {&free, &held}) std::sort(list->begin(), list->end());
    ratio[fine] = held[held.size() / 2] / free[free.size() / 2];
  }
  return {quotient(compare(later[0], later[1]), exact(double(trials.size()))),
          compare(ratio[0], ratio[1])};
}

}  // namespace lattice
