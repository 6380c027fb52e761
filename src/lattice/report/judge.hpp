#pragma once
/**
# Answering a statement

A yes-or-no statement of the article is decided by a criterion (criterion.hpp). The answer goes to the
results of a program, and every condition with its margin to its facts, so that no verdict stands
alone. */

#include <string>

#include "lattice/numbers/criterion.hpp"
#include "lattice/report/program.hpp"

namespace lattice {

/// Answers claim `id` in `report`. The facts are named after the part of the id behind its dot, followed
/// by the name of the condition.
inline void judge(Report& report, const std::string& id, const Criterion& criterion) {
  report.results.claim(id, holds(criterion));
  const std::string prefix = id.substr(id.find('.') + 1) + "_";
  for (const Condition& c : criterion) {
    report.facts.add(prefix + c.name, c.value);
    report.facts.add(prefix + c.name + "_margin", c.margin());
  }
}

}  // namespace lattice
