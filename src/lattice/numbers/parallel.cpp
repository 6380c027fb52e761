#include "lattice/numbers/parallel.hpp"

#ifdef __linux__
#include <sched.h>
#endif
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "lattice/numbers/interrupt.hpp"

namespace lattice {

namespace {
std::atomic<std::size_t> chosen_threads{0};
}

std::size_t granted_cores() {
#ifdef __linux__
  cpu_set_t set;
  CPU_ZERO(&set);
  if (sched_getaffinity(0, sizeof set, &set) == 0 && CPU_COUNT(&set) > 0)
    return std::size_t(CPU_COUNT(&set));
#endif
  return std::max(1U, std::thread::hardware_concurrency());
}

void set_threads(std::size_t count) {
  chosen_threads = count;
}

std::size_t threads() {
  const std::size_t chosen = chosen_threads;
  return chosen > 0 ? chosen : granted_cores();
}

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr error;
  std::mutex guard;
  const auto work = [&, flag = stop_flag] {
    const Interruptible with_flag(flag);
    for (std::size_t i; (i = next++) < count;) try {
        heed_stop();
        body(i);
      } catch (...) {
        const std::lock_guard lock(guard);
        if (!error) error = std::current_exception();
        next = count;
      }
  };
  // This thread works too
  std::vector<std::thread> workers;
  for (std::size_t k = 1, all = std::min(threads(), count); k < all; ++k)
    workers.emplace_back(work);
  work();
  for (auto& worker : workers) worker.join();
  if (error) std::rethrow_exception(error);
}

// The same for long jobs, which report how many parts are done
void parallel_for(const std::string& label, std::size_t count,
                  const std::function<void(std::size_t)>& body) {
  Progress progress(label, count);
  parallel_for(count, [&](std::size_t i) {
    body(i);
    progress.tick();
  });
}

// Progress is shown only to somebody who watches a terminal
namespace {
std::atomic<int> counting{0};  // how many show their progress now

bool watched() {
  return isatty(STDERR_FILENO) != 0;
}
}  // namespace

Progress::Progress(std::string label, std::size_t total)
    : label_(std::move(label)), total_(total), shown_(watched()) {
  ++counting;
}

Progress::~Progress() {
  --counting;
  if (shown_) std::fprintf(stderr, "\r\033[K");
}

// Parts end in any order, but the count shown never goes back
void Progress::reach(std::size_t k) {
  std::size_t before = done_;
  while (k > before && !done_.compare_exchange_weak(before, k)) {
  }
  if (shown_ && k > before) std::fprintf(stderr, "\r%s %zu/%zu", label_.c_str(), k, total_);
}

// The hundredths of a run that knows its time
std::function<void(double)> shown(const std::string& label, double until) {
  return [until, progress = std::make_shared<Progress>(label, 100)](double t) {
    progress->reach(std::size_t(100 * t / until));
  };
}

// A sign of life once a second, for work that has no parts to count
struct Heartbeat::Beat {
  explicit Beat(std::string label) : label_(std::move(label)), thread_([this] { run(); }) {}
  ~Beat() {
    {
      const std::lock_guard lock(guard_);
      done_ = true;
    }
    over_.notify_one();
    thread_.join();
    std::fprintf(stderr, "\r\033[K");
  }
  // Silent while a count is shown, because both write to the same line
  void run() {
    std::unique_lock lock(guard_);
    for (int s = 1; !over_.wait_for(lock, std::chrono::seconds(1), [&] { return done_; }); ++s)
      if (counting == 0) std::fprintf(stderr, "\r%s %d s\033[K", label_.c_str(), s);
  }

  std::string label_;
  std::mutex guard_{};
  std::condition_variable over_{};
  bool done_ = false;
  std::thread thread_;  // last, so that all it needs is there
};

Heartbeat::Heartbeat(std::string label)
    : beat_(watched() ? std::make_unique<Beat>(std::move(label)) : nullptr) {}

Heartbeat::~Heartbeat() = default;

}  // namespace lattice
