#include "sec36/watched_runs.hpp"

#include "lattice/numerics/parallel.hpp"

namespace lattice {

// The error is the difference of the two
WatchedRuns pass_twice(const StruckArray& blow, std::size_t n) {
  WatchedRuns runs;
  parallel_for(2, [&](std::size_t i) {
    runs[i] = pass(blow, n, 60, i ? RunResolution{0.05, 0.05} : RunResolution{0.1, 0.1});
  });
  return runs;
}

Estimate speed_between(const WatchedRuns& runs, const StruckArray& blow, double from, double to) {
  const auto speed = [&](const WatchedRun& run) {
    return run.path.line(from, to)->slope / blow.scales.tau_c();
  };
  return compare(speed(runs[0]), speed(runs[1]));
}

}  // namespace lattice
