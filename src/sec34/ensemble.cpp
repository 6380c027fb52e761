#include "sec34/ensemble.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "lattice/numerics/line_fit.hpp"

namespace lattice {

std::vector<Spread> spread_of(const std::vector<Path>& smoothed, std::size_t every) {
  const std::size_t members = smoothed.size(), tenth = members / 10;
  std::vector<Spread> out;
  for (std::size_t k = 0; k < smoothed.at(0).t.size(); k += every) {
    std::vector<double> x;
    double mean = 0, square = 0;
    for (const Path& p : smoothed) {
      x.push_back(p.centre.at(k));
      mean += x.back() / double(members);
    }
    for (double c : x) square += (c - mean) * (c - mean) / double(members - 1);
    std::sort(x.begin(), x.end());
    out.push_back({smoothed[0].t[k], mean, std::sqrt(square), x[tenth], x[members - 1 - tenth]});
  }
  return out;
}

double time_to_spread(const std::vector<Spread>& all, double sites) {
  for (const Spread& at : all)
    if (at.deviation > sites) return at.t;
  throw std::runtime_error("the packets stay together");
}

// The slope of the logarithm of the spread
Estimate growth(const std::vector<Spread>& all, double from, double to) {
  std::vector<double> t, logarithm;
  for (const Spread& at : all)
    if (at.t >= from && at.t <= to) {
      t.push_back(at.t);
      logarithm.push_back(std::log(at.deviation));
    }
  return fit_line(t, logarithm).estimate();
}

double mean_deviation(const std::vector<Spread>& all, double from, double to) {
  double sum = 0, n = 0;
  for (const Spread& at : all)
    if (at.t >= from && at.t <= to) {
      sum += at.deviation;
      ++n;
    }
  return sum / n;
}

}  // namespace lattice
