#pragma once
/**
# Stopping a long computation

A library that computes inside another program gives up its work when that is interrupted: the caller lends it a flag, at
which the long loops of the library look. No result depends on it. */

#include <atomic>

#include "lattice/numerics/ieee.hpp"

namespace lattice {

/// Thrown by a computation that was asked to stop. It is no std::exception, so that nobody who is prepared
/// for a failure takes it for one.
struct Interrupted {};

/// The flag that this thread looks at, if there is one; `parallel_for` hands it on to its workers.
inline thread_local const std::atomic<bool>* stop_flag = nullptr;

/// As long as it lives the computations of this thread end soon after `flag` has been set.
class Interruptible {
 public:
  /// `flag` must live as long; null stands for no flag.
  explicit Interruptible(const std::atomic<bool>* flag) : before_(stop_flag) { stop_flag = flag; }
  ~Interruptible() { stop_flag = before_; }
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

 private:
  const std::atomic<bool>* before_;
};

/// Throws Interrupted if this thread was asked to stop.
inline void heed_stop() {
  if (stop_flag && stop_flag->load(std::memory_order_relaxed)) throw Interrupted{};
}

}  // namespace lattice
