#pragma once
/**
# How far a computation is, and stopping it

A long loop says where it is by a `Progress` that lives as long as the loop. A program on a terminal shows it
(report/heartbeat.hpp). A library that computes inside another program gives up its work when that is interrupted: the
caller lends it a flag, at which the long loops look. No result depends on either. */

#include <atomic>
#include <cstddef>
#include <string>

#include "lattice/numerics/ieee.hpp"

namespace lattice {

/// `step 0.05`: a label with a number, to two digits.
std::string number_label(const std::string& what, double value);

/// A stage counts its parts with `tick` from any thread, or a single thread says by `reach` how much is done.
class Progress {
 public:
  /// A stage of `total` parts; one stands for a quantity that grows to one, zero for a number that nobody knows.
  explicit Progress(std::string label, std::size_t total = 0);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// One more part is done.
  void tick() { reach(double(++parts_) / double(total_)); }
  /// So much is done of a total of one.
  void reach(double share) { share_.store(share, std::memory_order_relaxed); }

  /// What is shown: the labels from the oldest stage of all threads to the first that counts, and the share of that one.
  struct Shown {
    std::string label{};
    double share = 0;
  };
  static Shown shown();

 private:
  std::string label_;
  std::size_t total_;
  std::atomic<std::size_t> parts_{0};
  std::atomic<double> share_{0};
};

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
