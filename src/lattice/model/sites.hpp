#pragma once
/**
# Counting sites

A localized state is centred on a site or on the bond between two sites. In the middle of a finite chain
the first needs an odd number $N$ of sites, the second an even one. Sites carry the article's numbers:
for odd $N$ they are $|n| \le (N-1)/2$, and a site-centred state has its centre at $n = 0$; for even $N$
they are $1-N/2 \le n \le N/2$, and a bond-centred state has its centre in the contact of $n = 0$ with
$n = 1$. */

#include <cstddef>

#include "lattice/numerics/ieee.hpp"

namespace lattice {

/// Where the centre is. The profile u_n of the small-amplitude limit (stationary.hpp) has the symmetry
/// u_{-n} = u_n if it is site-centred, u_{1-n} = -u_n if bond-centred.
enum class Centre { site, bond };
/// Both, in the order in which pairs of breathers keep them.
inline constexpr Centre both_centres[] = {Centre::site, Centre::bond};

/// The article's number of the site with the given index, 0 <= index < sites.
inline long site_number(std::size_t index, std::size_t sites) {
  return long(index) - (long(sites) - 1) / 2;
}

/// Index of the article's site `n`.
inline std::size_t site_index(long n, std::size_t sites) {
  return std::size_t(n + (long(sites) - 1) / 2);
}

/// Whether a state with this centre fits on `sites` sites.
inline bool fits(Centre centre, std::size_t sites) {
  return sites >= 2 && (sites % 2 == 0) == (centre == Centre::bond);
}

}  // namespace lattice
