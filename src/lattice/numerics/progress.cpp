#include "lattice/numerics/progress.hpp"

#include <cstdio>
#include <utility>
#include <vector>

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

}  // namespace

Progress::Progress(std::string label, std::size_t total) : label_(std::move(label)), total_(total) {
  const ListLock lock;
  alive.push_back(this);
}

Progress::~Progress() {
  const ListLock lock;
  std::erase(alive, this);
}

Progress::Shown Progress::shown() {
  const ListLock lock;
  Shown all;
  for (const Progress* at : alive) {
    all.label += (all.label.empty() || at->label_.empty() ? "" : ", ") + at->label_;
    all.share = at->share_.load(std::memory_order_relaxed);
    if (at->total_ > 0) break;
  }
  return all;
}

}  // namespace lattice
