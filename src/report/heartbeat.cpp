#include "report/heartbeat.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

namespace report {
namespace {

/// Seconds to two digits: `7 s`, `140 s`, `23 min`, `4.5 h`.
std::string rounded(double seconds) {
  const double unit = seconds < 300 ? 1 : seconds < 3 * 3600 ? 60 : 3600;
  const double value = std::max(seconds / unit, 1.0);
  const double digit = std::pow(10, std::floor(std::log10(value)) - 1);
  char text[32];
  std::snprintf(text, sizeof text, "%.*f %s", unit == 3600 && value < 10 ? 1 : 0,
                std::round(value / digit) * digit,
                unit == 1    ? "s"
                : unit == 60 ? "min"
                             : "h");
  return text;
}

std::string counted(const ShownStage& at) {
  char text[48];
  if (at.total == 1)
    std::snprintf(text, sizeof text, "%.0f %%", std::floor(100 * at.done));
  else
    std::snprintf(text, sizeof text, "%.0f/%.0f", at.done, at.total);
  const std::string joint = at.label.empty() ? "" : at.total == 1 ? ": " : " ";
  return at.label + joint + text + (at.left ? " (about " + rounded(*at.left) + " more)" : "");
}

}  // namespace

// A stage without a count introduces the next one
std::string progress_line(const std::string& who, double seconds,
                          const std::vector<ShownStage>& stages) {
  char since[32];
  std::snprintf(since, sizeof since, " %.0f s", std::floor(seconds));
  std::string line = who + since, joint = ", ";
  for (const ShownStage& at : stages) {
    const bool counts_parts = at.total > 0;
    line += joint + (counts_parts ? counted(at) : at.label);
    joint = counts_parts ? ", " : ": ";
  }
  return line;
}

static double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Columns that a line may have without being broken, after which it could not be overwritten.
static int width() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1 ? size.ws_col - 1 : 159;
}

Heartbeat::Heartbeat(const std::string& label) {
  if (isatty(STDERR_FILENO) == 0) return;
  watch_.emplace(now);
  try {
    thread_ = std::jthread([this, label](const std::stop_token& over) { show(label, over); });
  } catch (const std::system_error&) {
    // No thread can start, and no line is shown
  }
}

Heartbeat::~Heartbeat() {
  thread_ = {};  // stops and joins it
  if (watch_) std::fprintf(stderr, "\r\033[K");
}

void Heartbeat::show(const std::string& label, const std::stop_token& over) const {
  const double since = now();
  std::mutex guard;
  std::unique_lock lock(guard);
  std::condition_variable_any ended;
  while (true) {
    ended.wait_for(lock, over, std::chrono::seconds(1), [] { return false; });
    if (over.stop_requested()) return;
    const std::string line = progress_line(label, now() - since, watch_->stages());
    std::fprintf(stderr, "\r%.*s\033[K", width(), line.c_str());
  }
}

}  // namespace report
