#pragma once
/**
# A sign of life

On a terminal, and never in a log, standard error shows one line that is overwritten once a second: who computes since
when, how far it is (progress.hpp), and how long it will take. */

#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "lattice/numerics/progress.hpp"

namespace report {

using namespace lattice;  // whose numbers it writes

/// The line that is shown: who computes since how many seconds, and the stages, the oldest first.
std::string progress_line(const std::string& who, double seconds,
                          const std::vector<ShownStage>& stages);

/// Shows the line of `label` once a second, if somebody watches a terminal.
class Heartbeat {
 public:
  explicit Heartbeat(const std::string& label);
  ~Heartbeat();
  Heartbeat(const Heartbeat&) = delete;
  Heartbeat& operator=(const Heartbeat&) = delete;

 private:
  void show(const std::string& label, const std::stop_token& over) const;

  std::optional<Watch> watch_{};  ///< if somebody watches
  std::jthread thread_{};         ///< writes the line
};

}  // namespace report
