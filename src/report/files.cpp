#include "report/files.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <fstream>
#include <system_error>

namespace lattice {

namespace fs = std::filesystem;

std::string why_not_writable(const fs::path& folder, const std::string& file) {
  std::error_code error, ignored;
  fs::create_directories(folder, error);
  const fs::path path = folder / file, part = path.string() + ".part";
  if (!error && fs::exists(path, error) && !fs::is_regular_file(path, ignored)) return "";
  if (!error) {
    const bool known = fs::exists(part, ignored);
    errno = 0;
    if (!std::ofstream(part, std::ios::app)) error.assign(errno, std::generic_category());
    if (!known) fs::remove(part, ignored);
  }
  return error ? error.message() : "";
}

void guard_channels() {
  for (int channel = STDIN_FILENO; channel <= STDERR_FILENO; ++channel)
    if (fcntl(channel, F_GETFD) == -1 && open("/dev/null", O_RDONLY) != channel) break;
  std::signal(SIGXFSZ, SIG_IGN);
}

fs::path executable() {
  std::error_code ignored;
  return fs::read_symlink("/proc/self/exe", ignored);
}

}  // namespace lattice
