#pragma once
/**
# Independent runs on all cores

To sweep a parameter is to make many runs that know nothing of each other, so they can share the cores.
Each worker takes the next index that nobody has taken, and each run writes only to its own slot, so that
the results depend neither on the number of cores nor on who was faster. The number of workers is set once
for a program; by default it is the number of cores that the process may use, which a scheduler or
`taskset` can make smaller than that of the machine. */

#ifdef __linux__
#include <sched.h>
#endif
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace lattice {

/**
Whoever waits wants to see that something moves. On a terminal, and never in a log, standard error shows one
line that is overwritten: `Progress` counts the parts of a sweep or the hundredths of a run, and where
nobody counts `Heartbeat` shows the seconds. */
namespace detail {
inline std::atomic<int> counting{0};  ///< how many show their progress now

/// Whether somebody is there to see it; a test may say so.
inline bool watched() {
  return isatty(STDERR_FILENO) != 0;
}
}  // namespace detail

class Progress {
 public:
  Progress(std::string label, std::size_t total)
      : label_(std::move(label)), total_(total), shown_(detail::watched()) {
    ++detail::counting;
  }
  ~Progress() {
    --detail::counting;
    if (shown_) std::fprintf(stderr, "\r\033[K");
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /**
  Parts may be done in several threads, and in any order. */
  /// One more part is done.
  void tick() { reach(done_ + 1); }
  /// `k` parts are done; what was reached before is not shown again.
  void reach(std::size_t k) {
    std::size_t before = done_;
    while (k > before && !done_.compare_exchange_weak(before, k)) {
    }
    if (shown_ && k > before) std::fprintf(stderr, "\r%s %zu/%zu", label_.c_str(), k, total_);
  }

 private:
  std::string label_;
  std::size_t total_;
  std::atomic<std::size_t> done_{0};
  bool shown_;
};

/**
A heart beats once a second, in a thread of its own. */
/// Shows `label` and the seconds since it was made, once a second, while nobody shows a `Progress`.
class Heartbeat {
 public:
  explicit Heartbeat(std::string label) {
    if (detail::watched())
      beating_ = std::thread([this, label = std::move(label)] {
        std::unique_lock lock(guard_);
        for (int seconds = 1; !over_.wait_for(lock, std::chrono::seconds(1), [&] { return done_; });
             ++seconds)
          if (detail::counting == 0)
            std::fprintf(stderr, "\r%s %d s\033[K", label.c_str(), seconds);
      });
  }
  /**
  It ends at once, and takes its line with it. */
  ~Heartbeat() {
    if (!beating_.joinable()) return;
    {
      const std::lock_guard lock(guard_);
      done_ = true;
    }
    over_.notify_one();
    beating_.join();
    std::fprintf(stderr, "\r\033[K");
  }
  Heartbeat(const Heartbeat&) = delete;
  Heartbeat& operator=(const Heartbeat&) = delete;

 private:
  std::mutex guard_;
  std::condition_variable over_;
  bool done_ = false;
  std::thread beating_;
};

/**
The default number of workers is that of the cores that this process may use. */
inline std::size_t granted_cores() {
#ifdef __linux__
  cpu_set_t set;
  CPU_ZERO(&set);
  if (sched_getaffinity(0, sizeof set, &set) == 0 && CPU_COUNT(&set) > 0)
    return std::size_t(CPU_COUNT(&set));
#endif
  return std::max(1U, std::thread::hardware_concurrency());
}

namespace detail {
inline std::atomic<std::size_t> chosen_threads{0};
}

/// Workers of `parallel_for` and of tiled runs from now on; zero stands for all granted cores. No
/// result depends on it.
inline void set_threads(std::size_t count) {
  detail::chosen_threads = count;
}

/// How many workers there are.
inline std::size_t threads() {
  const std::size_t chosen = detail::chosen_threads;
  return chosen > 0 ? chosen : granted_cores();
}

/**
Now the loop: `body(i)` is called for every `i` below `count`, in any order and on all workers. If one call
throws, no further ones are begun, and the first exception is thrown again here. */
template <class Body>
void parallel_for(std::size_t count, Body body) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr error;
  std::mutex guard;
  const auto work = [&] {
    for (std::size_t i; (i = next++) < count;) try {
        body(i);
      } catch (...) {
        const std::lock_guard lock(guard);
        if (!error) error = std::current_exception();
        next = count;
      }
  };
  std::vector<std::thread> workers;
  for (std::size_t k = 1, all = std::min(threads(), count); k < all; ++k)
    workers.emplace_back(work);
  work();
  for (auto& worker : workers) worker.join();
  if (error) std::rethrow_exception(error);
}

/**
The same for long sweeps, with a counter under the name `label`. */
template <class Body>
void parallel_for(const std::string& label, std::size_t count, Body body) {
  Progress progress(label, count);
  parallel_for(count, [&](std::size_t i) {
    body(i);
    progress.tick();
  });
}

}  // namespace lattice
