#pragma once
/**
# What is claimed, and whether it is so

What the article prints stands in `paper/claims.ecsv`, one row a statement, with its hedge; our findings and the numbers
of other authors are rows of the same form. What our tables say to it is found by the function of the same id in
`src/statements` (statement.hpp). Here both are put together. `paper/verdicts.ecsv` says what each verdict means. */

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "report/statement.hpp"

namespace report {

/// A row of a list of claims, findings or numbers of others. Texts that a list has not are empty.
struct Claim {
  std::string list, id, section, where, quantity, printed, unit, tolerance, assumption, covered_by,
      reason, status = "holds";
};
using Claims = std::vector<Claim>;

/// The rows of a list. Throws std::runtime_error for a row that could not be judged or contradicts its status.
Claims read_claims(const std::filesystem::path& path);

/// The values that agree with what is printed, from `low` to `high`; nan for words.
struct Range {
  double low, high;
};
Range allowed(const Claim& claim);

/// A row with what was found.
struct Case {
  Claim claim;
  Judged found;
};
using Cases = std::vector<Case>;

/// Whether another reading of a number agrees with what is printed, or how far that of an assertion holds; empty for a
/// number beside words.
std::string outcome(const OtherReading& reading, const Claim& claim);

/// What `paper/readings.ecsv` says of the choices: the text of each by (statement, name of the reading). Empty without the list.
using Choices = std::map<std::pair<std::string, std::string>, std::string>;
Choices read_choices(const std::filesystem::path& volume);

/// All rows of a volume's lists, judged on `tables`. Throws std::runtime_error for a row without a statement, for a
/// statement without a row, and for a reading that is not listed or not computed.
Cases judge(const std::filesystem::path& volume, Tables& tables);

/// All verdicts, in the order of `paper/verdicts.ecsv`.
inline constexpr const char* verdict_words[] = {
    "reproduced", "reproduced, assuming",    "holds",   "holds, assuming", "quantified",
    "in part",    "within its own accuracy", "follows", "discrepant",      "unresolved"};

/// Whether a row with this verdict agrees with what is printed, or is left open.
bool is_met(const std::string& verdict);

/// The verdict on a row, which may be covered by another one of `all`; the recorded one if a program has not run.
std::string verdict(const Case& one, const Cases& all);

}  // namespace report
