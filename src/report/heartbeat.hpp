#pragma once
/**
# A sign of life

On a terminal, and never in a log, standard error shows one line that is overwritten once a second: who computes since
when, how far it is (progress.hpp), and how long it will take. */

#include <stop_token>
#include <string>
#include <thread>
#include <utility>

#include "lattice/numerics/progress.hpp"

namespace report {

using namespace lattice;  // whose numbers it writes

/// The line that is shown. It measures the pace of a stage from when it first saw it.
class ProgressLine {
 public:
  explicit ProgressLine(std::string who) : who_(std::move(who)) {}
  /// The line of now, `seconds` after the beginning.
  std::string at(double seconds, const Progress::Shown& stage);

 private:
  std::string who_;
  Progress::Shown first_{}, last_{};
  double since_ = 0;
};

/// Shows the line of `label` once a second, if somebody watches a terminal.
class Heartbeat {
 public:
  explicit Heartbeat(const std::string& label);
  ~Heartbeat();
  Heartbeat(const Heartbeat&) = delete;
  Heartbeat& operator=(const Heartbeat&) = delete;

 private:
  std::jthread thread_{};  ///< writes the line
  bool watched_;
};

}  // namespace report
