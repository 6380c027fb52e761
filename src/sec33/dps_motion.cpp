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

namespace {

// A number from all runs at one tolerance, with its distance from that at the other one
template <class Of>
auto at_both(Of of) {
  return compare(of(&NoiseTrial::coarse), of(&NoiseTrial::fine));
}

double median(std::vector<double> x) {
  std::sort(x.begin(), x.end());
  return x[x.size() / 2];
}

// When each passes the next site; what has not moved by the end of its run moves no earlier
std::vector<double> passages(const NoiseTrials& trials, DpsRun NoiseTrial::*run) {
  std::vector<double> out;
  for (const NoiseTrial& trial : trials) {
    const double t = (trial.*run).reaches(1);
    out.push_back(std::isnan(t) ? (trial.*run).t.back() : t);
  }
  return out;
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

std::size_t torn(const NoiseTrials& trials) {
  return std::size_t(std::count_if(trials.begin(), trials.end(), [](const NoiseTrial& trial) {
    return std::isnan(trial.fine.reaches(1)) != std::isnan(trial.coarse.reaches(1));
  }));
}

// Sizes and delays
Estimate largest_spread(const NoiseTrials& trials) {
  return at_both([&](auto run) {
    double most = 0;
    for (const NoiseTrial& trial : trials) {
      const std::vector<double>& sites = (trial.*run).sites;
      most = std::max(most, *std::max_element(sites.begin(), sites.end()) / sites.front());
    }
    return most;
  });
}

Delay delay_of(const NoiseTrials& controls, const NoiseTrials& trials) {
  const Estimate later = at_both([&](auto run) {
    const auto held = passages(controls, run), free = passages(trials, run);
    int count = 0;
    for (std::size_t k = 0; k < free.size(); ++k) count += held[k] > free[k];
    return count;
  });
  const auto ratio = [&](auto run) {
    return median(passages(controls, run)) / median(passages(trials, run));
  };
  return {quotient(later, exact(double(trials.size()))), at_both(ratio)};
}

}  // namespace lattice
