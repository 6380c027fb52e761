#include "lattice/numerics/progress.hpp"

#include <algorithm>
#include <cstdio>

namespace lattice {

std::string number_label(const std::string& what, double value) {
  char text[32];
  std::snprintf(text, sizeof text, " %.2g", value);
  return what + text;
}

/**
The tree is small and changes seldom, so one lock serves all of it; counting needs none. In the browser there are no
threads, and so no mutex. */
namespace {

std::atomic_flag busy;  // clear at first
struct TreeLock {
  TreeLock() {
    while (busy.test_and_set(std::memory_order_acquire)) {
    }
  }
  ~TreeLock() { busy.clear(std::memory_order_release); }
};
thread_local Progress* innermost = nullptr;

}  // namespace

Progress* Progress::here() {
  return innermost;
}

void Progress::join(Progress* stage) {
  innermost = stage;
}

// A stage begins inside of the innermost one of its thread, if somebody watches
Progress::Progress(std::string label, std::size_t total) : around_(innermost) {
  if (!around_) return;
  label_ = std::move(label);
  total_ = total;
  clock_ = around_->clock_;
  since_ = clock_();
  innermost = this;
  const TreeLock lock;
  around_->inside_.push_back(this);
}

Progress::~Progress() {
  if (!around_) return;
  innermost = around_;
  const TreeLock lock;
  std::erase(around_->inside_, this);
}

double Progress::share() const {
  if (total_ == 0) return 0;
  return std::max(share_.load(std::memory_order_relaxed), double(parts_) / double(total_));
}

Progress* Progress::inner() const {
  return inside_.empty() || (inside_.size() > 1 && total_ > 0) ? nullptr : inside_.front();
}

Watch::Watch(Clock clock) : root_(clock), before_(innermost) {
  innermost = &root_;
}

Watch::~Watch() {
  innermost = before_;
}

/**
A stage inside of another one is shown when it has lasted for a second, lest the line flicker. What is left, at the pace
so far, is worth saying if the stage takes twenty seconds or more, and three have to pass before it means something. */
std::vector<ShownStage> Watch::stages() const {
  const TreeLock lock;
  std::vector<ShownStage> all;
  for (Progress* at = root_.inner(); at; at = at->inner()) {
    const double seconds = root_.clock_() - at->since_, share = at->share();
    if (seconds < 1 && !all.empty()) break;
    const bool says = seconds >= 3 && share > 0 && seconds >= 20 * share;
    all.push_back({at->label_, share * double(at->total_), double(at->total_),
                   says ? std::optional(seconds / share - seconds) : std::nullopt});
  }
  return all;
}

}  // namespace lattice
