#include "sec33/dps_noise.hpp"

#include <cstddef>
#include <stdexcept>

#include "lattice/numerics/parallel.hpp"

namespace lattice {

std::vector<Group> groups_of_trials(bool quick) {
  std::vector<Group> out;
  for (const Noise& reading : noise_readings)
    for (const auto& [which, name] : noise_cases) {
      Group group{&reading, which, std::string("_") + reading.name + "_" + name};
      if (!group.main() && which == NoiseCase::control) continue;
      const std::size_t seeds = quick ? (group.many() ? 4 : 1) : (group.many() ? 16 : 6);
      for (std::size_t seed = 1; seed <= seeds; ++seed) group.trials.push_back({seed});
      out.push_back(std::move(group));
    }
  return out;
}

void run_trials(std::vector<Group>& groups, const Breathers& breathers) {
  std::vector<std::pair<const Group*, NoiseTrial*>> all;
  for (Group& group : groups)
    for (NoiseTrial& trial : group.trials) all.emplace_back(&group, &trial);
  parallel_for("perturbed breathers", all.size(), [&](std::size_t i) {
    const auto& [group, trial] = all[i];
    const Field v = breathers.start(*group->reading, group->which, *trial);
    const PinnedBreather& breather = breathers.of(group->which);
    trial->rough = follow_breather(breather, v, group->time(), coarse_trial);
    trial->good = follow_breather(breather, v, group->time(), fine_trial);
  });
}

const std::vector<NoiseTrial>& trials_of(const std::vector<Group>& groups, NoiseCase which,
                                         const Noise& reading) {
  for (const Group& group : groups)
    if (group.reading == &reading && group.which == which) return group.trials;
  throw std::invalid_argument(std::string("no trials of the reading ") + reading.name);
}

}  // namespace lattice
