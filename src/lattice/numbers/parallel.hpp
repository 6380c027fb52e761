#pragma once
/**
# Independent runs on all cores

A parameter sweep is many runs that know nothing of each other, so they can share the cores. Each worker
takes the next index that nobody has taken, and each run writes only to its own slot, so that the results
depend neither on the number of cores nor on which worker was faster. The number of workers is set once for
a program; by default it is the number of cores that the process may use, which a scheduler or `taskset`
can make smaller than that of the machine. */

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>

namespace lattice {

/// Cores that this process may use.
std::size_t granted_cores();

/// Sets the number of workers of `parallel_for` and of tiled runs from now on; zero stands for all
/// granted cores. No result depends on it.
void set_threads(std::size_t count);

/// How many workers there are.
std::size_t threads();

/**
`body(i)` is called for every `i` below `count`, in any order and on all workers. If one call throws, no
further ones are begun, and the first exception is thrown again here. */
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

/// The same for long sweeps, with a counter under the name `label`.
void parallel_for(const std::string& label, std::size_t count,
                  const std::function<void(std::size_t)>& body);

/**
Whoever waits wants to see that something moves. On a terminal, and never in a log, standard error shows one
line that is overwritten: `Progress` counts the parts of a sweep or the hundredths of a run, and where
nobody counts `Heartbeat` shows the seconds. */
class Progress {
 public:
  /// A counter up to `total` under the name `label`.
  Progress(std::string label, std::size_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// One more part is done. Safe to call from several threads.
  void tick() { reach(done_ + 1); }
  /// `k` parts are done; what was reached before is not shown again.
  void reach(std::size_t k);

 private:
  std::string label_;
  std::size_t total_;
  std::atomic<std::size_t> done_{0};
  bool shown_;
};

/// A function that takes the time of a run and shows under `label` how many hundredths of `until` it is.
std::function<void(double)> shown(const std::string& label, double until);

/// Shows `label` and the seconds since it was made, once a second, while nobody shows a `Progress`.
class Heartbeat {
 public:
  /// Begins at once if somebody watches a terminal.
  explicit Heartbeat(std::string label);
  ~Heartbeat();
  Heartbeat(const Heartbeat&) = delete;
  Heartbeat& operator=(const Heartbeat&) = delete;

 private:
  struct Beat;
  std::unique_ptr<Beat> beat_;
};

}  // namespace lattice
