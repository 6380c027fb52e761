#pragma once
/**
# Groups of breathers under noise

One trial is an accident. For each kind of noise (`noise_readings`) and each case a *group* of trials is run, which
differ in the seed alone. Beside the site-centred and the bond-centred breather there is a *control*: the site-centred
one under the same noise without its part in the pinning pair, which to first order cannot move. */

#include <string>
#include <utility>
#include <vector>

#include "sec33/dps_motion.hpp"

namespace lattice {

/// Their frequency, and how long they are followed.
inline constexpr double noise_mu = 10, trial_time = 500;
/// With which tolerances, and how many samples.
inline constexpr Accuracy coarse_trial{1e-8, 1}, fine_trial{1e-10, 2};

/// The readings of "uniformly distributed" and "of amplitude 0.01", the main one first.
inline constexpr Noise noise_readings[] = {{"complex", true, false, false, 0.01},
                                           {"narrow", true, false, false, 0.005},
                                           {"real", false, false, false, 0.01},
                                           {"positive", false, true, false, 0.01},
                                           {"relative", true, false, true, 0.01}};

/// Which breather, or the control.
enum class NoiseCase { site, control, bond };
inline constexpr std::pair<NoiseCase, const char*> noise_cases[] = {
    {NoiseCase::site, "site"}, {NoiseCase::control, "control"}, {NoiseCase::bond, "bond"}};

/// Both breathers of frequency `noise_mu`.
struct Breathers {
  PinnedBreather site, bond;

  Breathers()
      : site(Centre::site, noise_mu, sites_of(Centre::site)),
        bond(Centre::bond, noise_mu, sites_of(Centre::bond)) {}
  const PinnedBreather& of(NoiseCase which) const { return which == NoiseCase::bond ? bond : site; }
  Field start(const Noise& reading, NoiseCase which, NoiseTrial& trial) const {
    return perturbed(of(which), reading, which != NoiseCase::control, trial);
  }
};

/**
The main and the narrow reading get sixteen seeds. In some of the others a breather waits longer, so they run half as
long again, with six seeds. A control belongs to the main reading alone and, to see when it moves after all, runs twice
as long. */
struct Group {
  const Noise* reading;
  NoiseCase which;
  std::string name;
  std::vector<NoiseTrial> trials{};

  bool main() const { return reading == noise_readings; }
  bool many() const { return reading <= noise_readings + 1; }
  double time() const { return trial_time * (!many() ? 1.5 : which == NoiseCase::control ? 2 : 1); }
};

/// All groups, before they are run.
std::vector<Group> groups_of_trials(bool quick);

/// Runs all trials side by side, each at both tolerances.
void run_trials(std::vector<Group>& groups, const Breathers& breathers);

/// The trials of a group. Throws std::invalid_argument if there is none.
const std::vector<NoiseTrial>& trials_of(const std::vector<Group>& groups, NoiseCase which,
                                         const Noise& reading = noise_readings[0]);

}  // namespace lattice
