#pragma once
/**
# Counting sites

A localized state sits around a site or around a bond. Sites carry the article's numbers:
$1-N/2 \le n \le N/2$ on an even number of sites, where a bond-centred state has its centre in the
contact of $n = 0$ and $n = 1$, and $|n| \le (N-1)/2$ on an odd number, where a site-centred state
has its centre at $n = 0$. */

#include <cstddef>

namespace lattice {

/// Site-centred: u_{-n} = u_n. Bond-centred: u_{1-n} = -u_n.
enum class Centre { site, bond };
inline constexpr Centre both_centres[] = {Centre::site, Centre::bond};

/// Lengths of the article's chains; one site more around a bond.
constexpr std::size_t sites_of(Centre centre) {
  return centre == Centre::site ? 31 : 32;
}

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
