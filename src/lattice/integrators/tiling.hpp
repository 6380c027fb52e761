#pragma once
/**
# Long chains: tiles in time and threads

In a plain run of a long chain that moves everywhere, each stage (a kick and a drift, integrate.hpp) reads
and writes every site once, and the memory delivers the sites more slowly than the processor takes the
square roots. But nothing forces us to finish one stage everywhere before the next begins: a site needs
its two neighbours as the previous stage left them, no more. So we take a block of sites that fits in the
first-level cache and do many stages there, each shifted to the left by at least one site, because the
right edge of the block does not yet have its neighbour's new position.

        stage 2   ....]......]        ] right edge of a block; it moves left
        stage 1       ....]......]      from stage to stage

The contact across such an edge is evaluated once, at the right moment, and kept for the next block. The
operations are those of the plain run in another order, and the bits are the same. */

#include <cstddef>

#include "lattice/numerics/parallel.hpp"
#include "lattice/integrators/integrate.hpp"

namespace lattice {

/**
Programs use all this through one stepper. It takes plain stages until the whole chain moves, and also if
the chain is too short for tiles to pay; `least` keeps the chain from being shared too finely among
threads. The copies take as much memory as the state. Threads, block, depth and `least` change the speed
and nothing else. */
struct Tiled {
  Scheme scheme;
  double step;                               ///< the largest that it may take
  std::size_t threads = lattice::threads();  ///< at most
  std::size_t block = 1024;     ///< sites; with their shift they fit in the first-level cache
  std::size_t depth = 32;       ///< stages per pass
  std::size_t least = 1 << 13;  ///< sites per thread; fewer are in the cache anyway

  /// Advances `state` by `count` steps of length `h`; returns the number of site-force evaluations.
  template <class T>
  double advance(const Chain& chain, State<T>& state, Window& window, double h,
                 std::size_t count) const;
};

}  // namespace lattice
