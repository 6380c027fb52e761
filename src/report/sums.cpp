#include "report/sums.hpp"

#include <sha256.h>

#include <algorithm>
#include <fstream>

namespace report {

std::string sha256(const std::string& bytes) {
  char digits[SHA256_DIGEST_STRING_LENGTH];
  return SHA256Data(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(), digits);
}

std::string sha256_of(const std::filesystem::path& file) {
  char digits[SHA256_DIGEST_STRING_LENGTH];
  return SHA256File(file.c_str(), digits) ? digits : "";
}

Sums sums_in(const std::filesystem::path& folder) {
  Sums out;
  std::ifstream in(folder / "SHA256SUMS");
  for (std::string sum, name; in >> sum >> name;) out[name] = sum;
  return out;
}

void write_sums(const std::filesystem::path& folder, const Sums& sums) {
  std::string text;
  for (const auto& [name, sum] : sums) text += sum + "  " + name + "\n";
  write_whole(folder / "SHA256SUMS", text);
}

bool is_quick(const Table& table) {
  return std::ranges::any_of(table.meta, [](const auto& entry) {
    return entry.first == "parameters" && entry.second.find("quick = yes") != std::string::npos;
  });
}

}  // namespace report
