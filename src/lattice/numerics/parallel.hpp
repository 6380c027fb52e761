#pragma once
/**
# Independent runs on all cores

Each worker takes the next index that nobody has taken, and each run writes only to its own slot, so that the results depend
neither on the number of cores nor on which worker was faster. */

#include <cstddef>
#include <functional>
#include <string>

#include "lattice/numerics/ieee.hpp"

namespace lattice {

/// Cores that this process may use, of which a scheduler or `taskset` can leave less than the machine has.
std::size_t granted_cores();

/// Sets the number of workers of `parallel_for` from now on; zero stands for all
/// granted cores. No result depends on it.
void set_threads(std::size_t count);

/// How many workers there are.
std::size_t threads();

/// Calls `body(i)` for every `i` below `count`, in any order and on all workers. If one call throws, no further ones are
/// begun, and the first exception is thrown again here.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

/// The same for long sweeps, which show how many parts are done (progress.hpp).
void parallel_for(const std::string& label, std::size_t count,
                  const std::function<void(std::size_t)>& body);

}  // namespace lattice
