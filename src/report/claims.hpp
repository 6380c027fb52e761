#pragma once
/**
# Published against reproduced

`paper/published.ecsv` lists what the article states, each row with the tolerance that was fixed before
anything was computed. This file compares a row with a computed value. The tests and the report both call
it, so there is only one notion of agreement, and one vocabulary:

- `reproduced`: a printed number, met within its tolerance;
- `holds`: a yes-or-no statement that our criterion confirms;
- `discrepant`: a printed number missed, or a statement that fails;
- `measured`: the article uses a word without a number; we give the number and pass no judgement;
- `unresolved`: the error bar does not allow a verdict, which no test accepts;
- `open`: not answered yet. */

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lattice {

/// One row of `paper/published.ecsv`.
struct Claim {
  std::string id, section, where, quantity, printed, unit, kind, tolerance, note, program, status,
      reason;
};

/// A computed answer.
struct Answer {
  double value = 0, error = 0;
  std::string unit;
};

/**
Claims come from one table, a row each, whose columns have the names of the fields. */
/// Throws like `read` and `Table::texts`.
std::vector<Claim> read_claims(const std::filesystem::path& path);

/**
Answers come from the `results.ecsv` that each program leaves in its folder under `data`. The keys are
program and id. */
std::map<std::pair<std::string, std::string>, Answer> read_answers(
    const std::filesystem::path& data);

/**
The row and the answer decide together. An answer with the unit `claim` is a yes or a no, which is no
answer to a printed number; a number that answers a word is a measurement. Only a printed number is
compared with the answer, and if the error bar straddles an edge of the interval of agreement there is no
verdict. */
std::string verdict(const Claim& claim, const Answer& answer);

}  // namespace lattice
