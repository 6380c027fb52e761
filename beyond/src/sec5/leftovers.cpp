#include "sec5/leftovers.hpp"

#include <cmath>

namespace lattice {

double Leftover::at_a_time(double watched) const {
  double life = 0;
  for (const BreatherTrack& b : found) life += b.lived / watched;
  return life;
}

void Leftover::run(double duration, double least, double tolerance) {
  const std::size_t sites = 64;
  Field field = waves > 0 ? noisy_wave(sites, waves, 0.01, seed) : random_field(sites, seed);
  BreatherWatch watch(least);
  evolve_dps(Dps{sites, Ends::periodic}, field, duration, std::size_t(duration), tolerance,
             [&](double tau, const Field& now) {
               if (tau >= duration / 6) watch.look(tau, now);
             });
  found = watch.breathers();
}

Estimate over_seeds(const std::vector<std::vector<double>>& values) {
  std::vector<Estimate> means;
  for (const auto& v : values) {
    double mean = 0, square = 0;
    for (double x : v) mean += x / double(v.size());
    for (double x : v) square += (x - mean) * (x - mean) / double(v.size() - 1);
    means.push_back({mean, std::sqrt(square / double(v.size()))});
  }
  return compare(means[0], means[1]);
}

// Breather by breather, and run by run
LeftoverStatistics statistics_of(const std::vector<Leftover> (&runs)[2], int waves,
                                 double watched) {
  std::vector<std::vector<double>> number(2), rest(2), share(2), speed(2), size(2);
  for (std::size_t k : {0u, 1u})
    for (const Leftover& r : runs[k]) {
      if (r.waves != waves) continue;
      for (const BreatherTrack& b : r.found) {
        rest[k].push_back(b.strayed < 2);
        speed[k].push_back(b.speed);
        size[k].push_back(std::abs(b.speed));
        share[k].push_back(b.energy / static_energy(b.norm));
      }
      number[k].push_back(r.at_a_time(watched));
    }
  return {number, rest, share, speed, size};
}

RandomEnergies random_energies(unsigned long seeds, double surplus) {
  double mean = 0, square = 0;
  int above = 0;
  for (unsigned long seed = 1; seed <= seeds; ++seed) {
    const double here = energy(random_field(64, seed), true) / 64;
    mean += here / double(seeds), square += here * here / double(seeds);
    above += here > surplus;
  }
  const double free = double(seeds - 1);
  const double scatter = std::sqrt((square - mean * mean) * double(seeds) / free);
  return {above, {scatter, scatter / std::sqrt(2 * free)}};
}

}  // namespace lattice
