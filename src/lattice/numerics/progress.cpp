#include "lattice/numerics/progress.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace lattice {

std::string number_label(const std::string& what, double value) {
  char text[32];
  std::snprintf(text, sizeof text, " %.2g", value);
  return what + text;
}

// One lock serves all of the short list. In the browser there are no threads, and so no mutex
namespace {

std::atomic_flag busy;  // clear at first
struct ListLock {
  ListLock() {
    while (busy.test_and_set(std::memory_order_acquire)) {
    }
  }
  ~ListLock() { busy.clear(std::memory_order_release); }
};
std::vector<Progress*> alive;  // the oldest first
std::atomic<Clock> clock_of_watch{nullptr};

}  // namespace

Progress::Progress(std::string label, std::size_t total) : label_(std::move(label)), total_(total) {
  const Clock clock = clock_of_watch;
  if (!clock) return;
  since_ = clock();
  const ListLock lock;
  alive.push_back(this);
}

Progress::~Progress() {
  if (!since_) return;
  const ListLock lock;
  std::erase(alive, this);
}

double Progress::share() const {
  if (total_ == 0) return 0;
  return std::max(share_.load(std::memory_order_relaxed), double(parts_) / double(total_));
}

Watch::Watch(Clock clock) {
  clock_of_watch = clock;
}

Watch::~Watch() {
  clock_of_watch = nullptr;
}

// A stage that is younger than a second is not shown behind an older one, lest the line flicker. What is left is said if
// the stage takes twenty seconds or more, after the first three
std::vector<ShownStage> Watch::stages() const {
  const ListLock lock;
  std::vector<ShownStage> all;
  for (const Progress* at : alive) {
    const double seconds = clock_of_watch.load()() - *at->since_, share = at->share();
    if (seconds < 1 && !all.empty()) break;
    const bool says = seconds >= 3 && share > 0 && seconds >= 20 * share;
    all.push_back({at->label_, share * double(at->total_), double(at->total_),
                   says ? std::optional(seconds / share - seconds) : std::nullopt});
    if (at->total_ > 0) break;
  }
  return all;
}

}  // namespace lattice
