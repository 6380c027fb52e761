#pragma once
/**
# The tail of a breather, site by site

Far from the centre a breather falls off so fast that its displacements pass through all magnitudes that a number format
has, within a few sites. Newton's method must reach the same relative accuracy at every site (`scaled`), and every contact,
however faint, is a contact event. Double precision ends at $10^{-308}$, extended precision much farther out; where both
exist their difference is the error. */

#include <cmath>
#include <cstddef>

#include "lattice/orbits/breather.hpp"
#include "lattice/orbits/breather_pairs.hpp"
#include "report/program.hpp"

namespace lattice {

/// The site-centred breather of frequency `omega_b` in linear wells, to the last digit of every site.
template <class T>
Orbit<T> with_tail(double omega_b, std::size_t sites) {
  const auto problem = breather_problem<double>(Centre::site, omega_b, 0, sites);
  return newton(in_precision<T>(problem), find_breather(problem), scaled_rule<T>());
}

/// The tail in both precisions; sites beyond the shorter chain of extended precision count as zero.
struct Tail {
  Orbit<double> orbit;
  Orbit<Wide> wide;

  /// Of the breather of this frequency.
  explicit Tail(double omega_b)
      : orbit(with_tail<double>(omega_b, 99)), wide(with_tail<Wide>(omega_b, 63)) {}
  /// |y_n(0)| in double precision.
  double size(long n) const { return std::abs(orbit.start.y[std::size_t(n + 49)]); }
  /// The same in extended precision.
  Wide wide_size(long n) const {
    return n < -31 || n > 31 ? Wide(0) : std::abs(wide.start.y[std::size_t(n + 31)]);
  }
  /// ln|y_(n+1)| / ln|y_n|, away from the centre; nan where the outer one has vanished.
  double exponent(long n) const {
    const Wide inner = wide_size(n), outer = wide_size(n < 0 ? n - 1 : n + 1);
    return inner > 0 && outer > 0 ? double(std::log(outer) / std::log(inner)) : std::nan("");
  }
};

/// The tail site by site, and the law |y_(n+1)| ~ |y_n|^(3/2) from its end, site `last_wide`, inwards.
inline void report_tail_table(Report& report, const Tail& tail, long last_wide) {
  const double none = std::nan(""), end = double(std::log(tail.wide_size(last_wide)));
  Table& table = report.table(
      "tail", {count("n", "site", "site"),
               estimate("size", "|y_n(0)| in double precision; nan where it has underflown", "",
                        "difference from extended precision; nan where size is"),
               number("exponent", "ln |y_(n+1)| / ln |y_n| away from the centre"),
               number("double_log", "ln(-ln |y_n(0)|) in extended precision"),
               number("law", "the same by the law 3/2 from the outermost site inwards")});
  for (long n = -49; n <= 49; ++n) {
    const double here = tail.size(n);
    const Wide wide = tail.wide_size(n);
    const Estimate size = here > 1e-300 && wide > 0 ? Estimate{here, std::abs(double(here - wide))}
                                                    : Estimate{none, none};
    table.add({n, size, tail.exponent(n), wide > 0 ? double(std::log(-std::log(wide))) : none,
               std::log(-end) + double(std::abs(n) - last_wide) * std::log(1.5)});
  }
}

}  // namespace lattice
