#pragma once
/**
# How far equal packets spread

Impacts that differ in late digits only make packets whose smoothed paths differ more and more. */

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "lattice/diagnostics/path.hpp"

namespace lattice {

/// The centres at one time: mean, standard deviation, lower and upper decile.
struct Spread {
  double t, mean, deviation, low, high;
};

/// The spread of smoothed paths with equal times, at every sample whose number is a multiple of `every`.
inline std::vector<Spread> spread_of(const std::vector<Path>& smoothed, std::size_t every) {
  const std::size_t members = smoothed.size(), tenth = members / 10;
  std::vector<Spread> out;
  for (std::size_t k = 0; k < smoothed.at(0).size(); k += every) {
    std::vector<double> x;
    double mean = 0, square = 0;
    for (const Path& p : smoothed) {
      x.push_back(p.samples.at(k).centre);
      mean += x.back() / double(members);
    }
    for (double c : x) square += (c - mean) * (c - mean) / double(members - 1);
    std::sort(x.begin(), x.end());
    out.push_back({smoothed[0][k].t, mean, std::sqrt(square), x[tenth], x[members - 1 - tenth]});
  }
  return out;
}

/// The part of it from one time to another.
inline std::vector<Spread> between(std::vector<Spread> all, double from, double to) {
  std::erase_if(all, [&](const Spread& at) { return at.t < from || at.t > to; });
  return all;
}

/// The first time at which the deviation exceeds `sites`. Throws std::runtime_error if it never does.
inline double time_to_spread(const std::vector<Spread>& all, double sites) {
  for (const Spread& at : all)
    if (at.deviation > sites) return at.t;
  throw std::runtime_error("the packets stay together");
}

}  // namespace lattice
