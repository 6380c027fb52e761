#pragma once
/**
# Looking at a run

A travelling breather is a packet of energy, some seven sites wide, that moves along the chain while its
beads oscillate. This file turns snapshots of the energy density $e_n$ (Eq. (23), chain.hpp) into the
quantities that the article quotes: where the packet is,
$$X = \frac{\sum_{|n-c|\le m} n\,e_n}{\sum_{|n-c|\le m} e_n} \qquad\text{(Eq. (24))},$$
with $c$ the site of its largest density and $m = 5$, how fast it moves, and how much energy it carries. */

#include <cstddef>
#include <optional>
#include <vector>

#include "lattice/numerics/ieee.hpp"

namespace lattice {

/// Half of the window of 2m + 1 sites that belongs to a packet; m = 5 is the article's choice, below Eq. (24).
inline constexpr std::size_t packet_half_width = 5;

/// Sum of `e` over the sites within `m` of `peak`.
double window_sum(const std::vector<double>& e, std::size_t peak,
                  std::size_t m = packet_half_width);

/// Energy centre X around the index `peak`, Eq. (24), in the article's counting (first site = 1).
double energy_centre(const std::vector<double>& e, std::size_t peak,
                     std::size_t m = packet_half_width);

/**
An impact may launch several packets and leave a vibration at the struck end, and any of these can carry
more energy than the breather that travels ahead. So the tracker looks from the far end. Without precompression nothing
runs ahead of the first packet but its own super-exponentially small tail, so `share` matters only where a weak packet
runs ahead of a strong one, as in hard wells. */
/// The first site, from the far end, that is the largest of its window and whose window holds at least `share` of the
/// energy; nothing if there is none.
std::optional<std::size_t> front_packet(const std::vector<double>& e, double share = 0.01,
                                        std::size_t m = packet_half_width);

/// How many sites share the energy, (sum e_n)^2 / sum e_n^2: one if a single site has all of it, N if all have the same.
double participation(const std::vector<double>& e);

}  // namespace lattice
