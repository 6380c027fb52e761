#pragma once
/**
# How far a computation is

A long loop says where it is by a `Progress` that lives as long as the loop. A program on a terminal shows it
(report/heartbeat.hpp). No result depends on it. */

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

}  // namespace lattice
