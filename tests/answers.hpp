#pragma once
// What the tests ask of claims, answers and the lock; `make lock` (lineage/lock.py) says what is locked.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
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

/// The programs that exist: one for each chapter in `src`.
inline std::set<std::string> programs_of(const std::filesystem::path& src) {
  std::set<std::string> out;
  for (const auto& entry : std::filesystem::directory_iterator(src)) {
    const auto name = entry.path().stem().string();
    if (entry.path().extension() == ".cpp" && name.rfind("sec", 0) == 0) out.insert(name);
  }
  return out;
}

/// One value of one program: the answer to a claim, or a fact.
struct Finding {
  double value = 0, error = 0;
  std::string unit, kind = "value";
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

/// What the programs have just written: answers, or answers and facts.
inline Findings read_findings(const std::filesystem::path& data, bool facts = true) {
  Findings out;
  for (const auto& folder : std::filesystem::directory_iterator(data)) {
    if (!std::filesystem::exists(folder.path() / "results.ecsv")) continue;
    add_findings(out, folder.path() / "results.ecsv", "id");
    if (facts) add_findings(out, folder.path() / "facts.ecsv", "quantity");
  }
  return out;
}

inline Findings read_lock(const std::filesystem::path& path) {
  const Table t = read(path);
  const auto program = t.texts("program"), id = t.texts("id"), unit = t.texts("unit"),
             kind = t.texts("kind");
  const auto value = t.numbers("value"), error = t.numbers("error");
  Findings out;
  for (std::size_t i = 0; i < id.size(); ++i)
    if (!out.emplace(std::pair(program[i], id[i]), Finding{value[i], error[i], unit[i], kind[i]})
             .second)
      throw std::runtime_error(path.string() + ": two rows for " + id[i]);
  return out;
}

/// How far apart are the locked and the fresh value, in units of what is allowed? Up to one they agree. Where one
/// of the two is not a number, the other must not be one either. Another compiler may round a logarithm
/// differently: a relative 1e-12 is always allowed. Of a residue, made of rounding, only the size counts.
inline double distance(const Finding& locked, const Finding& fresh) {
  const double never = std::numeric_limits<double>::infinity();
  if (locked.unit != fresh.unit) return never;
  if (std::isnan(locked.value) || std::isnan(fresh.value))
    return std::isnan(locked.value) && std::isnan(fresh.value) ? 0 : never;
  if (locked.kind == "residue") {
    const double size = std::abs(locked.value), unit = std::numeric_limits<double>::epsilon();
    return std::abs(fresh.value) / (10 * (size > 0 ? size : unit));
  }
  if (locked.value == fresh.value) return 0;
  const double size = std::max(std::abs(locked.value), std::abs(fresh.value));
  const double allowed = std::abs(locked.error) + std::abs(fresh.error) + 1e-12 * size;
  const double apart = std::abs(fresh.value - locked.value) / allowed;
  return std::isnan(apart) ? never : apart;
}

}  // namespace lattice
