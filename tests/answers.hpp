#pragma once
// What the tests ask of claims and answers; whether a value is the locked one is asked in lineage/lock.py.

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "report/table.hpp"

namespace lattice {

/// A row of `paper/published.ecsv`, by what is asked of it.
struct Claim {
  std::string program, status, reason, printed = "", kind = "", tolerance = "", covered_by = "";
};

inline std::map<std::string, Claim> read_claims(const std::filesystem::path& path) {
  const Table t = read(path);
  const auto id = t.texts("id"), program = t.texts("program"), status = t.texts("status"),
             reason = t.texts("reason"), printed = t.texts("printed"), kind = t.texts("class"),
             tolerance = t.texts("tolerance"), covered_by = t.texts("covered_by");
  std::map<std::string, Claim> out;
  for (std::size_t i = 0; i < id.size(); ++i)
    if (!out.emplace(id[i], Claim{program[i], status[i], reason[i], printed[i], kind[i],
                                  tolerance[i], covered_by[i]})
             .second)
      throw std::runtime_error(path.string() + ": two claims for " + id[i]);
  return out;
}

/// One value of one program: the answer to a claim, or a fact.
struct Finding {
  double value = 0, error = 0;
  std::string unit;
};

/// Findings by program and id; the id is a claim's or a fact's.
using Findings = std::map<std::pair<std::string, std::string>, Finding>;

inline void add_findings(Findings& out, const std::filesystem::path& path, const char* name) {
  const Table t = read(path);
  const auto id = t.texts(name), unit = t.texts("unit");
  const auto value = t.numbers("value"), error = t.numbers("error");
  const auto program = path.parent_path().filename().string();
  for (std::size_t i = 0; i < id.size(); ++i)
    if (!out.emplace(std::pair(program, id[i]), Finding{value[i], error[i], unit[i]}).second)
      throw std::runtime_error(path.string() + ": two values for " + id[i]);
}

/// What the programs have just written: answers and facts.
inline Findings read_findings(const std::filesystem::path& data) {
  Findings out;
  for (const auto& folder : std::filesystem::directory_iterator(data)) {
    if (!std::filesystem::exists(folder.path() / "results.ecsv")) continue;
    add_findings(out, folder.path() / "results.ecsv", "id");
    add_findings(out, folder.path() / "facts.ecsv", "quantity");
  }
  return out;
}

}  // namespace lattice
