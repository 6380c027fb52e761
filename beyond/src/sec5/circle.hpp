#pragma once
/**
# Even functions on a circle, enclosed

A breather that starts from rest is even in time, and each of its contacts has an even compression $c(\theta)$,
$\theta = \omega_bt$. This file encloses what a proof needs of such functions: cosines, values of cosine sums
on a grid, and their Fourier coefficients after a contact law has acted on them. */

#include <vector>

#include "sec5/interval.hpp"

namespace lattice {

/// The number pi.
inline Interval<double> enclosed_pi() {
  return {0x1.921fb54442d18p+1, 0x1.921fb54442d19p+1};
}

/// cos x for x within [-4, 4], from Taylor's series and its remainder; [-1, 1] elsewhere.
Interval<double> enclosed_cosine(const Interval<double>& x);

/**
A table of $\cos(2\pi j/M)$ serves all sums. Its entries are numbers of the format, and `error` bounds the
distance of every one from the true cosine. */
struct CosineTable {
  std::vector<double> cosine;  ///< entry j belongs to the angle 2 pi j / M
  double error;

  /// `count` is a multiple of four.
  explicit CosineTable(std::size_t count);
  std::size_t count() const { return cosine.size(); }
};

/**
A sum of $n$ products, evaluated in any order, is wrong by at most $\gamma_n\sum|a_ib_i|$ with
$\gamma_n = nu/(1-nu)$, where $u$ is half a unit in the last place (Higham). Sums as long as these are evaluated
in the plain way and their error is added once. Products so small that they lose digits add less than $2^{-1074}$
each, in all sums less than `underflow`. */
inline constexpr double underflow = std::numeric_limits<double>::min();

/// An upper bound of gamma_n.
double rounding_of_sum(std::size_t n);

/// A function's values at the angles 2 pi j / M, 0 <= j <= M / 2, each wrong by at most `error`.
struct Sampled {
  std::vector<double> value;
  double error;
};

/// sum_k c_k cos(k theta) at the angles of the table.
Sampled sample(const std::vector<double>& c, const CosineTable& table);

/// The coefficients of cos(k theta), k < count, in the discrete sense: of the sum of M samples.
std::vector<Interval<double>> discrete_coefficients(const std::vector<Interval<double>>& half,
                                                    std::size_t count, const CosineTable& table);

}  // namespace lattice
