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
      centre_per_shift(0) {
  // The derivative of the centre along V, which also gives V its sign
  double sum = 0, moment = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    const double x = state.u[i], cube = x * x * x;
    const double n = double(site_number(i, u.size())) - (centre == Centre::bond ? 0.5 : 0);
    sum += cube * x;
    moment += 4 * n * cube * pair.V(Eigen::Index(i));
  }
  centre_per_shift = std::abs(moment / sum);
  if (moment < 0) pair.V = -pair.V;
}

// What carries a pendulum from the bottom of its potential just to the top
double PinnedBreather::pendulum_push() const {
  return pair.rate / (std::numbers::pi * centre_per_shift * (mu - pair.m));
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
  return *std::max_element(participation.begin(), participation.end()) / participation.front();
}

double DpsRun::farthest() const {
  double most = 0;
  for (const double x : X) most = std::max(most, std::abs(x));
  return most;
}

// How many of all runs at one tolerance, and at the other
Estimate passing(const NoiseTrials& trials, double distance, double by) {
  long coarse = 0, fine = 0;
  for (const NoiseTrial& trial : trials) {
    coarse += trial.coarse.passes(distance, by);
    fine += trial.fine.passes(distance, by);
  }
  return compare(coarse, fine);
}

Estimate largest_spread(const NoiseTrials& trials) {
  double coarse = 0, fine = 0;
  for (const NoiseTrial& trial : trials) {
    coarse = std::max(coarse, trial.coarse.spread());
    fine = std::max(fine, trial.fine.spread());
  }
  return compare(coarse, fine);
}

static double median(std::vector<double> all) {
  std::sort(all.begin(), all.end());
  return all[all.size() / 2];
}

Estimate median_passage(const NoiseTrials& trials) {
  std::vector<double> coarse, fine;
  for (const NoiseTrial& trial : trials) {
    coarse.push_back(trial.coarse.passage());
    fine.push_back(trial.fine.passage());
  }
  return compare(median(coarse), median(fine));
}

}  // namespace lattice
