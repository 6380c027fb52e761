#pragma once
/**
# How far a computation is

A long loop says where it is by a `Progress` that lives as long as the loop. To show it, a program
(report/heartbeat.hpp) makes a `Watch` and brings a clock; without one a `Progress` does nothing. No result depends on
it. */

#include <atomic>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lattice/numerics/ieee.hpp"

namespace lattice {

/// A stage as it is shown.
struct ShownStage {
  std::string label{};
  double done = 0, total = 0;    ///< a total of one is shown in per cent, zero is not known
  std::optional<double> left{};  ///< seconds, if that is worth saying
};

/// `step 0.05`: a label with a number, to two digits.
std::string number_label(const std::string& what, double value);

/// Seconds since some instant.
using Clock = double (*)();

/// A stage counts its parts with `tick` from any thread, or a single thread says by `reach` how much is done.
class Progress {
 public:
  /// A stage of `total` parts; one stands for a quantity that grows to one, zero for a number that nobody knows.
  explicit Progress(std::string label, std::size_t total = 0);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// One more part is done.
  void tick() { ++parts_; }
  /// So much is done of a total of one.
  void reach(double share) { share_.store(share, std::memory_order_relaxed); }

 private:
  friend class Watch;
  double share() const;

  std::string label_;
  std::size_t total_;
  std::atomic<std::size_t> parts_{0};
  std::atomic<double> share_{0};
  std::optional<double> since_{};  ///< if somebody watches
};

/// As long as it lives the stages of all threads can be seen; there is one at a time.
class Watch {
 public:
  explicit Watch(Clock clock);
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  /// The stages of now, from the oldest to the first one that counts. The seconds left are said of one that takes long.
  std::vector<ShownStage> stages() const;
};

}  // namespace lattice
