#include "lattice/orbits/symmetry.hpp"

namespace lattice {

// From rest to rest in half a period
Symmetry even_in_time(std::size_t sites) {
  Symmetry s{.name = "time-even", .parts = 2};
  for (std::size_t n = 0; n < sites; ++n) {
    s.unknowns.push_back({{n, 1}});
    s.equations.push_back({{{sites + n, 1}}});
  }
  return s;
}

// Antisymmetric about a bond: the right half of the chain tells all
static Symmetry bond_centred(std::size_t sites) {
  Symmetry s{.name = "bond-centred", .parts = 2};
  for (std::size_t n = sites / 2; n < sites; ++n) {
    s.unknowns.push_back({{n, 1}, {sites - 1 - n, -1}});
    s.equations.push_back({{{sites + n, 1}}});
  }
  return s;
}

// After a quarter of a period positions are odd about the site and velocities even
static Symmetry site_centred(std::size_t sites) {
  Symmetry s{.name = "site-centred", .parts = 4};
  for (std::size_t n = 0; n < sites; ++n) {
    const std::size_t mirror = sites - 1 - n;
    s.unknowns.push_back({{n, 1}});
    if (n >= sites / 2)
      s.equations.push_back({{{n, 1}, {mirror, 1}}});
    else
      s.equations.push_back({{{sites + n, 1}, {sites + mirror, -1}}});
  }
  return s;
}

// No symmetry but the period itself: the whole state must return
Symmetry returning(std::size_t sites) {
  Symmetry s{.name = "returning"};
  for (std::size_t n = 0; n < sites; ++n) s.unknowns.push_back({{n, 1}});
  for (std::size_t i = 0; i < 2 * sites; ++i) s.equations.push_back({{{i, 1}}, {{i, -1}}});
  return s;
}

Symmetry centred(Centre centre, std::size_t sites) {
  return centre == Centre::bond ? bond_centred(sites) : site_centred(sites);
}

}  // namespace lattice
