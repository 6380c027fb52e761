#pragma once
/**
# What a proof may be asked for

How fine an enclosure is made is the caller's choice, but spacings and cuts have to agree: steps are powers of two
because the proofs take halves of them as exact, nodes lie on the ends of cells, and a window lies on the guess.
Other numbers would not make a proof coarse but wrong, so they are refused. */

#include <bit>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace lattice {

/// Throws std::invalid_argument, with one line that says what is allowed, unless `fits`.
inline void demand(bool fits, const std::string& name, const std::string& value,
                   const std::string& allowed) {
  if (!fits) throw std::invalid_argument(name + " = " + value + ": allowed is " + allowed);
}

/// Demands a whole number in [least, most].
inline void demand_within(const std::string& name, std::size_t value, std::size_t least,
                          std::size_t most) {
  demand(least <= value && value <= most, name, std::to_string(value),
         std::to_string(least) + " to " + std::to_string(most));
}

/// Demands a power of two in [least, most].
inline void demand_power(const std::string& name, std::size_t value, std::size_t least,
                         std::size_t most) {
  demand(std::has_single_bit(value) && least <= value && value <= most, name, std::to_string(value),
         "a power of two from " + std::to_string(least) + " to " + std::to_string(most));
}

}  // namespace lattice
