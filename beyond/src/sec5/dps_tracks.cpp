#include "sec5/dps_tracks.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "lattice/gsl/random.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "lattice/standing/stationary.hpp"

namespace lattice {
namespace {

constexpr long half_width = 2;  ///< sites of a breather on either side of its peak

}  // namespace

void BreatherWatch::look(double tau, const Field& field) {
  const long n = long(field.size());
  const auto at = [&](long i) { return field[std::size_t(((i % n) + n) % n)]; };
  std::vector<double> window(field.size());
  double mean = 0;
  for (long i = 0; i < n; ++i) {
    for (long k = -half_width; k <= half_width; ++k) window[std::size_t(i)] += std::norm(at(i + k));
    mean += window[std::size_t(i)] / double(n);
  }
  for (FollowedPeak& followed : followed_peaks_) followed.seen = false;
  // Peaks of the norm on five sites, with their centres and the energy of their contacts
  for (long i = 0; i < n; ++i) {
    const double here = window[std::size_t(i)];
    bool highest = here > 2 * mean;
    for (long k = 1; k <= half_width && highest; ++k)
      highest =
          here >= window[std::size_t((i + k) % n)] && here > window[std::size_t((i - k + n) % n)];
    if (!highest) continue;
    double centre = 0, contacts = 0;
    for (long k = -half_width; k <= half_width; ++k)
      centre += double(k) * std::norm(at(i + k)) / here;
    for (long k = -half_width - 1; k <= half_width; ++k) {
      const double d = std::abs(at(i + k + 1) - at(i + k));
      contacts += 0.4 * (d * d * std::sqrt(d));
    }
    meet({tau, double(i) + centre, here, contacts, here > 3 * mean}, double(n));
  }
  for (FollowedPeak& followed : followed_peaks_) followed.alive = followed.alive && followed.seen;
}

// The nearest followed peak goes on; on a ring its centre may have gone round
void BreatherWatch::meet(const Peak& peak, double sites) {
  FollowedPeak* nearest = nullptr;
  double least = 1.5;
  for (FollowedPeak& followed : followed_peaks_) {
    if (!followed.alive || followed.seen) continue;
    const double apart = std::abs(std::remainder(peak.centre - followed.centre.back(), sites));
    if (apart < least) nearest = &followed, least = apart;
  }
  if (!nearest && !peak.high) return;
  if (!nearest) nearest = &followed_peaks_.emplace_back();
  FollowedPeak& followed = *nearest;
  const double before = followed.tau.empty() ? peak.centre : followed.centre.back();
  followed.tau.push_back(peak.tau);
  followed.centre.push_back(before + std::remainder(peak.centre - before, sites));
  followed.norm += peak.norm, followed.energy += peak.energy;
  followed.seen = true;
}

// Only who lives long enough is a breather
std::vector<BreatherTrack> BreatherWatch::breathers() const {
  std::vector<BreatherTrack> out;
  for (const FollowedPeak& followed : followed_peaks_) {
    const double lived = followed.tau.back() - followed.tau.front(),
                 seen = double(followed.tau.size());
    if (lived < least_) continue;
    const auto [low, high] = std::minmax_element(followed.centre.begin(), followed.centre.end());
    out.push_back({followed.tau.front(), lived, followed.norm / seen, followed.energy / seen,
                   fit_line(followed.tau, followed.centre).slope, *high - *low});
  }
  return out;
}

// The sum of the Poisson distribution is a tail of the chi-squared one
double rate_below(std::size_t births, double watched) {
  return gsl_cdf_chisq_Pinv(0.95, 2 * (double(births) + 1)) / 2 / watched;
}

// The energy goes with the power 5/4 of the norm
double static_energy(double norm) {
  static const double unit = stationary<double>(Centre::site, 1.0, 31).norm();
  return 0.4 * norm * std::sqrt(std::sqrt(norm / unit));
}

Field noisy_wave(std::size_t sites, int waves, double share, unsigned long seed) {
  Random random(seed);
  Field field(sites);
  for (std::size_t n = 0; n < sites; ++n) {
    const double real = random.uniform(-share, share), imaginary = random.uniform(-share, share);
    const double phase = 2 * std::numbers::pi * waves * double(n) / double(sites);
    field[n] = std::polar(1.0, phase) * std::complex<double>(1 + real, imaginary);
  }
  return field;
}

double wave_share(const Field& field, double q) {
  std::complex<double> sum = 0;
  for (std::size_t n = 0; n < field.size(); ++n) sum += field[n] * std::polar(1.0, -q * double(n));
  return std::norm(sum) / (double(field.size()) * norm(field));
}

// Box and Muller's pairs of normal numbers
Field random_field(std::size_t sites, unsigned long seed) {
  Random random(seed);
  Field field(sites);
  for (auto& a : field) {
    const double modulus = std::sqrt(-std::log(1 - random.uniform(0, 1)));
    a = std::polar(modulus, 2 * std::numbers::pi * random.uniform(0, 1));
  }
  const double scale = std::sqrt(double(sites) / norm(field));
  for (auto& a : field) a *= scale;
  return field;
}

}  // namespace lattice
