#pragma once
/**
# What the proof for the chain takes from analysis

The constants of chain_enclosure.hpp, each in a function of its own, so that a test can hold it against what it
bounds. */

#include <cstddef>
#include <vector>

#include "sec5/circle.hpp"

namespace lattice {

/// The mean of |g|, 2 / s - 1 with s = sin(pi / omega), 1 < omega < 2.
Interval<double> mean_of_kernel(const Interval<double>& omega);
/// pi / (omega s), which no |g| exceeds.
Interval<double> largest_of_kernel(const Interval<double>& omega);

/**
The variation $V$ of $f'$, $f = (c_+)^{3/2}$, is at most $3\int c_+^{1/2}|c''|\,d\theta$, and cosine sums are bounded
by the sums of the moduli of their coefficients. */
/// An upper bound of V / (2 pi).
Interval<double> variation_of_force(const std::vector<double>& c);

/**
A coefficient of $\cos k\theta$ is at most $2V/(2\pi k^2)$. Among `samples` points those at $k+jM$ are taken for the
one at $k$, with $\sum_{j\ne0}(jM+k)^{-2} \le \frac{\pi^2}3(M-k)^{-2}$; and those from `harmonics` on are left out,
where $|G_k| \le k^{-2}/(\omega^2-K^{-2})$ for $k > K$. */
/// The largest error of a coefficient below `harmonics`, over V / (2 pi).
Interval<double> folded_back(std::size_t samples, std::size_t harmonics);
/// Sum of |G_k| times the coefficients from `harmonics` on, over V / (2 pi).
Interval<double> left_out(const Interval<double>& omega, std::size_t harmonics);

/// Ranges of a cosine sum on equal cells of the half circle: from its ends and its second derivative.
std::vector<Interval<double>> ranges(const std::vector<double>& c, std::size_t cells);

}  // namespace lattice
