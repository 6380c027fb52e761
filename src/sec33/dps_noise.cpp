#include "sec33/dps_noise.hpp"

#include "lattice/gsl/random.hpp"

namespace lattice {

// Real and imaginary parts, site by site
Field Noise::operator()(const Field& u, std::size_t seed) const {
  Random random(seed);
  Field noise;
  for (const auto& u_n : u) {
    const double re = random.uniform(-1, 1), im = is_complex ? random.uniform(-1, 1) : 0;
    noise.push_back(std::complex(amplitude * re, amplitude * im) * (is_relative ? u_n : 1.0));
  }
  return noise;
}

// Seeds that no run has
double fraction_beyond(double threshold, const Noise& noise, const PinnedBreather& breather) {
  constexpr std::size_t draws = 1000;
  std::size_t larger = 0;
  for (std::size_t seed = 1001; seed <= 1000 + draws; ++seed)
    if (std::abs(breather.pair.of(noise(breather.u, seed)).imag()) > threshold) ++larger;
  return double(larger) / double(draws);
}

// A control loses what the noise has along V
Field NoiseGroup::perturbed(NoiseTrial& trial) const {
  Field v = of(breather.u, trial.seed);
  if (without_mode) breather.pair.add(-breather.pair.of(v), v);
  trial.kick = breather.pair.of(v);
  for (std::size_t i = 0; i < v.size(); ++i) v[i] += breather.u[i];
  return v;
}

// Push and threshold with its error, and both outcomes
int predicted_by(const Estimate& threshold, const NoiseGroup& group) {
  int predicted = 0;
  for (const NoiseTrial& trial : group.trials) {
    const double push = std::abs(trial.kick.imag());
    const int passages = trial.coarse.passes(1) + trial.fine.passes(1);
    if (push > threshold.value + threshold.error && passages == 2) ++predicted;
    if (push < threshold.value - threshold.error && passages == 0) ++predicted;
  }
  return predicted;
}

// Run by run
static const char* exact_if = "exact where both tolerances agree";
static const char* which_noise = "main, narrow, real or relative";
static const char* which_start = "site, bond, or control: a site without the translational mode";

void add_runs(Table& table, const NoiseGroup& group) {
  for (const NoiseTrial& trial : group.trials) {
    const auto passes = [&](double distance) {
      return trial.of(
          [&](const DpsRun& run) { return int(run.passes(distance, group.counted_by)); });
    };
    table.add({{"noise", which_noise, group.noise},
               {"start", which_start, group.start},
               {"seed", "of the noise", trial.seed},
               {"left", "1 if |X| exceeds 1/2 by t = 500, or by 750 under real noise", passes(0.5),
                "", exact_if},
               {"moved", "1 if |X| exceeds 1 by then", passes(1), "", exact_if},
               {"spread", "by which factor the participation number grows at most",
                trial.of([](const DpsRun& run) { return run.spread(); })}});
  }
}

// All of the group
void add_departures(Table& table, const NoiseGroup& group) {
  const NoiseTrials& trials = group.trials;
  table.add({{"noise", which_noise, group.noise},
             {"start", which_start, group.start},
             {"seeds", "number of runs", trials.size()},
             {"by", "time by which a departure counts", group.counted_by, "unit of time"},
             {"left", "breathers whose |X| exceeds 1/2 by then",
              passing(trials, 0.5, group.counted_by), "", exact_if},
             {"moved", "breathers whose |X| exceeds 1 by then",
              passing(trials, 1, group.counted_by), "", exact_if},
             {"passage",
              "median time at which |X| exceeds 1; a run without a passage enters with its length",
              median_passage(trials)},
             {"spread", "by which factor the participation number grows at most",
              largest_spread(trials)}});
}

// Each control beside the breather under all of the noise
void add_controls(Table& table, const NoiseGroup& all_of_it, const NoiseGroup& controls) {
  const auto is_later = [](const DpsRun& control, const DpsRun& run) {
    return int(control.passage() > run.passage());
  };
  for (std::size_t k = 0; k < controls.trials.size(); ++k) {
    const NoiseTrial &control = controls.trials[k], &trial = all_of_it.trials[k];
    table.add({{"seed", "of the noise", trial.seed},
               {"later", "1 if the control moves later than the breather under the whole noise",
                compare(is_later(control.coarse, trial.coarse), is_later(control.fine, trial.fine)),
                "", exact_if}});
  }
}

}  // namespace lattice
