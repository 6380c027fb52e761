#include "sec33/dps_motion.hpp"

#include <algorithm>
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

double DpsRun::reaches(double distance) const {
  for (std::size_t k = 1; k < X.size(); ++k)
    if (const double now = std::abs(X[k]), before = std::abs(X[k - 1]); now > distance)
      return t[k - 1] + (t[k] - t[k - 1]) * (distance - before) / (now - before);
  return std::nan("");
}

// What has not moved by the end of its run moves no earlier
double DpsRun::passage() const {
  const double time = reaches(1);
  return std::isnan(time) ? t.back() : time;
}

double DpsRun::spread() const {
  return *std::max_element(sites.begin(), sites.end()) / sites.front();
}

namespace {

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

// Sizes and delays
Estimate largest_spread(const NoiseTrials& trials) {
  return at_both([&](auto run) {
    double most = 0;
    for (const NoiseTrial& trial : trials) most = std::max(most, (trial.*run).spread());
    return most;
  });
}

Estimate median_passage(const NoiseTrials& trials) {
  return at_both([&](auto run) {
    std::vector<double> t;
    for (const NoiseTrial& trial : trials) t.push_back((trial.*run).passage());
    std::sort(t.begin(), t.end());
    return t[t.size() / 2];
  });
}

}  // namespace lattice
