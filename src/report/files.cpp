#include "report/files.hpp"

#include <cerrno>
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

fs::path executable() {
  std::error_code ignored;
  return fs::read_symlink("/proc/self/exe", ignored);
}

}  // namespace lattice
