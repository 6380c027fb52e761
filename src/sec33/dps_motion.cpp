#include "sec33/dps_motion.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

#include "lattice/model/sites.hpp"

namespace lattice {

PinnedBreather::PinnedBreather(const Stationary<double>& state)
    : centre(state.centre),
      mu(state.mu),
      u(state.u.begin(), state.u.end()),
      pair(contact_spectrum(state)),
      shift(0) {
  // The derivative of the centre along V, which also gives V its sign
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

// What carries a pendulum from the bottom of its potential just to the top
double PinnedBreather::freeing_push() const {
  return pair.rate / (std::numbers::pi * shift * (mu - pair.m));
}

// The arithmetic-geometric mean gives the elliptic integral; every round squares the distance of the two means
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

double DpsRun::largest() const {
  double top = 0;
  for (const double x : X) top = std::max(top, std::abs(x));
  return top;
}

double DpsRun::reaches(double distance) const {
  for (std::size_t k = 1; k < X.size(); ++k)
    if (const double now = std::abs(X[k]), before = std::abs(X[k - 1]); now > distance)
      return t[k - 1] + (t[k] - t[k - 1]) * (distance - before) / (now - before);
  return std::nan("");
}

DpsRun DpsRun::until(double time) const {
  DpsRun out = *this;
  const auto end = std::size_t(std::upper_bound(t.begin(), t.end(), time) - t.begin());
  out.t.resize(end), out.X.resize(end);
  return out;
}

double DpsRun::spread() const {
  return *std::max_element(sites.begin(), sites.end()) / sites.front();
}

namespace {

bool moved(const DpsRun& run) {
  return run.reaches(1) < HUGE_VAL;
}

// A number from all runs at one tolerance, with its distance from that at the other one
template <class Of>
auto at_both(Of of) {
  return compare(of(&NoiseTrial::coarse), of(&NoiseTrial::fine));
}

}  // namespace

// Counts
Estimate passing(const NoiseTrials& trials, double distance, double by) {
  return at_both([&](auto run) {
    return std::count_if(trials.begin(), trials.end(), [&](const NoiseTrial& trial) {
      return (trial.*run).reaches(distance) <= by;
    });
  });
}

Estimate median_departure(const NoiseTrials& trials, double by) {
  return at_both([&](auto run) {
    std::vector<double> departures;
    for (const NoiseTrial& trial : trials) {
      const double leaves = (trial.*run).reaches(0.5);
      departures.push_back(leaves <= by ? leaves : HUGE_VAL);
    }
    std::sort(departures.begin(), departures.end());
    return departures[departures.size() / 2];
  });
}

std::size_t torn(const NoiseTrials& trials) {
  return std::size_t(std::count_if(trials.begin(), trials.end(), [](const NoiseTrial& trial) {
    return moved(trial.fine) != moved(trial.coarse);
  }));
}

Estimate largest_spread(const NoiseTrials& trials) {
  return at_both([&](auto run) {
    double most = 0;
    for (const NoiseTrial& trial : trials) most = std::max(most, (trial.*run).spread());
    return most;
  });
}

// When each passes the next site, seed by seed and in the median
Delay delay_of(const NoiseTrials& controls, const NoiseTrials& trials) {
  std::array<std::size_t, 2> later{};
  std::array<double, 2> ratio{};
  for (const std::size_t fine : {0U, 1U}) {
    const auto passes = [&](const NoiseTrials& list) {
      std::vector<double> out;
      for (const NoiseTrial& trial : list) {
        const DpsRun& run = fine ? trial.fine : trial.coarse;
        out.push_back(moved(run) ? run.reaches(1) : run.t.back());
      }
      return out;
    };
    auto free = passes(trials), held = passes(controls);
    for (std::size_t k = 0; k < free.size(); ++k) later[fine] += held[k] > free[k];
    for (auto* list : {&free, &held}) std::sort(list->begin(), list->end());
    ratio[fine] = held[held.size() / 2] / free[free.size() / 2];
  }
  return {quotient(compare(later[0], later[1]), exact(double(trials.size()))),
          compare(ratio[0], ratio[1])};
}

}  // namespace lattice
