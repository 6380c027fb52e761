#pragma once
/**
# Answering a statement

The answer goes to the results, each condition and what is left of it to the facts, so that no
verdict stands without its margin. */

#include <string>

#include "lattice/numbers/criterion.hpp"
#include "lattice/report/program.hpp"

namespace lattice {

/// Decides claim `id`; facts are named after the part of the id behind its dot.
inline void judge(Report& report, const std::string& id, const Criterion& criterion) {
  report.results.claim(id, holds(criterion));
  const std::string prefix = id.substr(id.find('.') + 1) + "_";
  for (const Condition& c : criterion) {
    report.facts.add(prefix + c.name, c.value);
    report.facts.add(prefix + c.name + "_margin", c.margin());
  }
}

}  // namespace lattice
