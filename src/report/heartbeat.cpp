#include "report/heartbeat.hpp"

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <mutex>

namespace report {

// What is left is said if the stage takes twenty seconds or more, after the first three
std::string ProgressLine::at(double seconds, const Progress::Shown& stage) {
  if (stage.label != last_.label || stage.share < last_.share) first_ = stage, since_ = seconds;
  last_ = stage;
  char text[64];
  std::snprintf(text, sizeof text, " %.0f s", std::floor(seconds));
  std::string line = who_ + text;
  if (!stage.label.empty() || stage.share > 0) line += ", ";
  line += stage.label;
  if (!(stage.share > 0)) return line;
  std::snprintf(text, sizeof text, " %.0f %%", std::floor(100 * stage.share));
  line += stage.label.empty() ? text + 1 : text;
  const double took = seconds - since_, done = stage.share - first_.share,
               left = (1 - stage.share) * took / done;
  if (took < 3 || !(done > 0) || took + left < 20) return line;
  const bool minutes = left >= 300, hours = left >= 3 * 3600;
  std::snprintf(text, sizeof text, " (about %.*f %s more)", hours ? 1 : 0,
                left / (hours     ? 3600
                        : minutes ? 60
                                  : 1),
                hours     ? "h"
                : minutes ? "min"
                          : "s");
  return line + text;
}

// The line is cut where a terminal of eighty columns would break it, after which it could not be overwritten
static void show(const std::string& label, const std::stop_token& over) {
  const auto begin = std::chrono::steady_clock::now();
  ProgressLine line(label);
  std::mutex guard;
  std::unique_lock lock(guard);
  std::condition_variable_any ended;
  while (true) {
    ended.wait_for(lock, over, std::chrono::seconds(1), [] { return false; });
    if (over.stop_requested()) return;
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - begin;
    const std::string text = line.at(since.count(), Progress::shown());
    std::fprintf(stderr, "\r%.79s\033[K", text.c_str());
  }
}

Heartbeat::Heartbeat(const std::string& label) : watched_(isatty(STDERR_FILENO) != 0) {
  if (watched_) thread_ = std::jthread([label](const std::stop_token& over) { show(label, over); });
}

Heartbeat::~Heartbeat() {
  thread_ = {};  // stops and joins it
  if (watched_) std::fprintf(stderr, "\r\033[K");
}

}  // namespace report
