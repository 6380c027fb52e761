#pragma once
/**
# A sign of life

Whoever waits wants to see that something moves, and how long it will take. On a terminal, and never in a log, standard
error shows one line that is overwritten once a second: who computes since when, and how far it is (progress.hpp). */

#include <memory>
#include <string>
#include <vector>

#include "lattice/numerics/progress.hpp"

namespace lattice {

/// The line that is shown: who computes since how many seconds, and the stages, the oldest first.
std::string progress_line(const std::string& who, double seconds,
                          const std::vector<ShownStage>& stages);

/// Shows the line of `label`, once a second.
class Heartbeat {
 public:
  /// Begins at once if somebody watches a terminal.
  explicit Heartbeat(std::string label);
  ~Heartbeat();
  Heartbeat(const Heartbeat&) = delete;
  Heartbeat& operator=(const Heartbeat&) = delete;

 private:
  struct Beat;
  std::unique_ptr<Beat> beat_;
};

}  // namespace lattice
