#pragma once
/**
# What an instability leaves

When the modulation of a wave (dps_waves.hpp) has grown, peaks stand on a sea of irregular waves, and many of them
last for a few oscillations only. We call a peak a breather if the five sites around it hold more than three times
the mean norm, and if it goes on doing so for a given time, while its centre never moves by more than a site and a
half between two samples.

The energy of a breather is compared with that of a static one of the same norm $N$ (stationary.hpp): with the
frequency $\mu$ and $N = \mu^4N_1$ this is $\frac25\mu N = \frac25N(N/N_1)^{1/4}$, where $N_1$ is the norm at $\mu =
1$. A peak that moves has less. */

#include <cstddef>
#include <vector>

#include "lattice/dps/evolve.hpp"

namespace lattice {

/// One breather: when it was first seen and for how long; means of norm and energy on its sites; the slope of
/// its path, and how far its centre strayed in all.
struct BreatherTrack {
  double born = 0, lived = 0, norm = 0, energy = 0, speed = 0, strayed = 0;
};

/// Watches a ring and collects the breathers that live for at least `least`.
class BreatherWatch {
 public:
  explicit BreatherWatch(double least) : least_(least) {}
  /// To be called at every sample; `field` is that of a ring.
  void look(double tau, const Field& field);
  /// All of them, those that still live included, in the order of their birth.
  std::vector<BreatherTrack> breathers() const;

 private:
  struct FollowedPeak {
    std::vector<double> tau{}, centre{};
    double norm = 0, energy = 0;
    bool alive = true, seen = false;
  };
  struct Peak {
    double tau, centre, norm, energy;
    bool high;
  };
  void meet(const Peak& peak, double sites);

  double least_;
  std::vector<FollowedPeak> followed_peaks_{};
};

/**
A run without a breather does not show that none is ever born. Births that know nothing of each other, $r$ per unit of
time, leave $n$ or fewer in the watched time $W$ with the probability $e^{-rW}\sum_{k\le n}(rW)^k/k!$. The rate at which
this is five per cent is the upper limit at 95 per cent; for $n = 0$ it is $-\ln0.05/W$, the rule of three. */
/// The upper limit at 95 per cent of a rate, from so many births in the time `watched`.
double rate_below(std::size_t births, double watched);

/// Energy of a static DpS breather of this norm.
double static_energy(double norm);

/// The wave with `waves` periods on a ring, A = 1, with each entry changed by random shares of at most `share`.
Field noisy_wave(std::size_t sites, int waves, double share, unsigned long seed);

/// The share of the norm of a ring that the plane wave of wavenumber q has: one for the wave by itself.
double wave_share(const Field& field, double q);

/// A ring of mean norm one with independent normal amplitudes: the energy per site is that of infinite temperature up
/// to a scatter with the seed.
Field random_field(std::size_t sites, unsigned long seed);

}  // namespace lattice
