#include "lattice/numerics/parallel.hpp"

#ifdef __linux__
#include <sched.h>
#endif

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "lattice/numerics/progress.hpp"

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
  // This thread works too, alone where no other can start
  std::vector<std::thread> workers;
  try {
    for (std::size_t k = 1, all = std::min(threads(), count); k < all; ++k)
      workers.emplace_back(work);
  } catch (const std::exception&) {
  }
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

}  // namespace lattice
