#pragma once
/**
# The lock

`paper/converged.ecsv` holds what we found: the answer to every claim and every fact of every
program, with its error. A printed number locks only the rows that reproduce it; a row of ours may
be `discrepant` or `measured` with any value, unless that value is pinned as well. A fresh value
has to agree with the locked one within the sum of the two errors.

The programs give the same bits on every machine, but another compiler or mathematical library may
round a logarithm differently, so that a relative difference of 1e-12 is always allowed. A row of
kind `residue` is itself made of rounding (what an exact solution leaves when it is inserted): of
such a row only the size counts, and it may grow tenfold before the lock objects. */

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "report/table.hpp"

namespace lattice {

/// One value of one program: the answer to a claim, or a fact.
struct Finding {
  double value = 0, error = 0;
  std::string unit, kind = "value";
};

/// Findings by program and id; the id is a claim's or a fact's.
using Findings = std::map<std::pair<std::string, std::string>, Finding>;

/// The programs that exist: one for each chapter in `src`.
inline std::set<std::string> programs_of(const std::filesystem::path& src) {
  std::set<std::string> out;
  for (const auto& entry : std::filesystem::directory_iterator(src)) {
    const auto name = entry.path().stem().string();
    if (entry.path().extension() == ".cpp" && name.rfind("sec", 0) == 0) out.insert(name);
  }
  return out;
}

/**
What the programs have just written: `results.ecsv` with the claims and, where there is one,
`facts.ecsv`. A program without results is left out; the caller decides what that means. */
inline Findings read_findings(const std::filesystem::path& data,
                              const std::set<std::string>& programs) {
  Findings out;
  for (const auto& program : programs) {
    const auto results = data / program / "results.ecsv", facts = data / program / "facts.ecsv";
    if (!std::filesystem::exists(results)) continue;
    for (const auto& [path, name] : {std::pair(results, "id"), std::pair(facts, "quantity")}) {
      if (!std::filesystem::exists(path)) continue;
      const Table t = read(path);
      const auto id = t.texts(name), unit = t.texts("unit");
      const auto value = t.numbers("value"), error = t.numbers("error");
      for (std::size_t i = 0; i < id.size(); ++i)
        if (!out.emplace(std::pair(program, id[i]), Finding{value[i], error[i], unit[i]}).second)
          throw std::runtime_error(program + ": two values for " + id[i]);
    }
  }
  return out;
}

inline Findings read_lock(const std::filesystem::path& path) {
  const Table t = read(path);
  const auto program = t.texts("program"), id = t.texts("id"), unit = t.texts("unit"),
             kind = t.texts("kind");
  const auto value = t.numbers("value"), error = t.numbers("error");
  Findings out;
  for (std::size_t i = 0; i < id.size(); ++i) {
    if (kind[i] != "value" && kind[i] != "residue")
      throw std::runtime_error(path.string() + ": " + id[i] + ": unknown kind " + kind[i]);
    if (!out.emplace(std::pair(program[i], id[i]), Finding{value[i], error[i], unit[i], kind[i]})
             .second)
      throw std::runtime_error(path.string() + ": two rows for " + id[i]);
  }
  return out;
}

inline Table lock_table(const Findings& findings) {
  Table table{{label("program", "program that computes it"),
               label("id", "identifier of the claim or quantity of the program's facts"),
               number("value", "converged value; 1 or 0 where the unit is claim"),
               number("error", "absolute error; 0 for an exact value"),
               label("unit", "unit of value and error; claim for yes or no"),
               label("kind", "value, or residue: made of rounding, so that only its size counts")}};
  table.meta = {{"title", "What we found: a fresh value agrees within the sum of the errors"}};
  for (const auto& [key, f] : findings)
    table.add({key.first, key.second, f.value, f.error, f.unit, f.kind});
  return table;
}

/**
How far apart are the locked and the fresh value, in units of what is allowed? Up to one they
agree. Where one of the two is not a number, the other must not be one either. */
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

/// One difference between the lock and a fresh computation.
struct Difference {
  enum class What { moved, missing, added } what;
  std::string program, id;
  Finding locked, fresh;
  double distance = 0;  ///< in units of what is allowed
};

/**
All differences, moved values first of all those that differ by more than rounding. The test accepts
those within the errors; who renews the lock wants to see them too. */
inline std::vector<Difference> differences(const Findings& locked, const Findings& fresh) {
  using What = Difference::What;
  std::vector<Difference> out;
  for (const auto& [key, was] : locked) {
    const auto now = fresh.find(key);
    if (now == fresh.end()) {
      out.push_back({What::missing, key.first, key.second, was, {}});
      continue;
    }
    const double size = std::max(std::abs(was.value), std::abs(now->second.value));
    const double apart = distance(was, now->second);
    if (apart > 1 || std::abs(was.value - now->second.value) > 1e-12 * size)
      out.push_back({What::moved, key.first, key.second, was, now->second, apart});
  }
  for (const auto& [key, now] : fresh)
    if (!locked.count(key)) out.push_back({What::added, key.first, key.second, {}, now});
  return out;
}

/**
The renewed lock: fresh values with the kinds that stand. A program that has not been run keeps its
rows, a program that no longer exists loses them. */
inline Findings renewed(const Findings& locked, Findings fresh,
                        const std::set<std::string>& programs) {
  std::set<std::string> run;
  for (const auto& [key, finding] : fresh) run.insert(key.first);
  for (const auto& [key, was] : locked) {
    const auto now = fresh.find(key);
    if (now != fresh.end())
      now->second.kind = was.kind;
    else if (programs.count(key.first) && !run.count(key.first))
      fresh.emplace(key, was);
  }
  return fresh;
}

}  // namespace lattice
