#include "lattice/numerics/progress.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lattice {

std::string number_label(const std::string& what, double value) {
  char text[32];
  std::snprintf(text, sizeof text, " %.2g", value);
  return what + text;
}

void Forecast::see(double seconds, double share) {
  if (share > (seen_.empty() ? 0 : seen_.back().second)) seen_.emplace_back(seconds, share);
}

// From seconds = constant * share^power
std::optional<double> Forecast::left(double seconds) const {
  if (seen_.empty()) return {};
  const auto [last, share] = seen_.back();
  const auto later = std::upper_bound(seen_.begin(), seen_.end(), std::pair{last / 2, 1.0});
  double power = 1;
  if (later != seen_.begin())
    power = std::clamp(
        std::log(last / std::prev(later)->first) / std::log(share / std::prev(later)->second), 0.5,
        2.0);
  const double left = last * std::pow(share, -power) - seconds;
  return left >= 0 ? std::optional(left) : std::nullopt;
}

/**
The tree is small and changes seldom, so one lock serves all of it; counting needs none. In the browser there are no
threads, and so no mutex. */
namespace {

std::atomic_flag busy = ATOMIC_FLAG_INIT;
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

// The stage inside with the smallest share, the oldest of them
Progress* Progress::slowest() const {
  if (inside_.empty() || (inside_.size() > 1 && total_ > 0)) return nullptr;
  return *std::min_element(inside_.begin(), inside_.end(),
                           [](auto* a, auto* b) { return a->share() < b->share(); });
}

Watch::Watch(Clock clock) : root_(clock), before_(innermost) {
  innermost = &root_;
}

Watch::~Watch() {
  innermost = before_;
}

/**
A stage inside of another one is shown when it has lasted for a second, lest the line flicker. A forecast is worth saying
if the stage takes twenty seconds or more, and three have to pass before it means something. */
std::vector<ShownStage> Watch::stages() const {
  const TreeLock lock;
  std::vector<ShownStage> all;
  for (Progress* at = root_.slowest(); at; at = at->slowest()) {
    const double seconds = root_.clock_() - at->since_, share = at->share();
    if (seconds < 1 && !all.empty()) break;
    at->forecast_.see(seconds, share);
    std::optional<double> left = at->forecast_.left(seconds);
    if (seconds < 3 || (left && seconds + *left < 20)) left.reset();
    all.push_back({at->label_, share * double(at->total_), double(at->total_), left});
  }
  return all;
}

}  // namespace lattice
