#pragma once
/**
# What is claimed, and whether it is so

Programs compute and claim nothing. What the article prints stands in `paper/claims.ecsv`, one row a statement, with its
tolerance. Either a fact answers the row (`sec33_floquet.exchange_bond`), or conditions on facts decide it
(`sec34_impact.slower_speed > 0; sec34_impact.slower_peak > 0`), each of which has to hold by more than the error. Our
findings and the numbers of other authors are rows of the same form.

| verdict | meaning |
|---|---|
| reproduced | a printed number, met within its tolerance under the printed conditions |
| reproduced, assuming | the same, where a condition is not printed and a natural one reaches the number |
| holds | a statement of which all conditions hold |
| quantified | a word without a number, or a number that depends on what is not printed: ours stands beside it |
| within its own accuracy | missed by no more than the accuracy that the article itself prints |
| follows | missed because it is computed from another printed number, which is judged in its own row |
| discrepant | missed in every natural reading |
| unresolved | a fact is missing or not finite, or the error does not allow a verdict; no test accepts that | */

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "lattice/numerics/estimate.hpp"

namespace lattice {

/// Facts by their names, `program.quantity`.
struct Fact {
  double value, error;
  std::string unit = "";
};
using Facts = std::map<std::string, Fact>;

/// A row of a list of claims, findings or numbers of others; `kind` is its class. Texts that a list has not are empty.
struct Claim {
  std::string id, section, where, quantity, printed, unit, kind, tolerance, answer, criterion,
      assumption, covered_by, reason, status = "holds";
};
using Claims = std::vector<Claim>;

/// The rows of a list. Throws std::runtime_error for a row that could not be judged or contradicts its status.
Claims read_claims(const std::filesystem::path& path);

/// The facts of all runs in `data`, and of programs that have not run those of the reference values in `locks`.
Facts read_facts(const std::filesystem::path& data,
                 const std::vector<std::filesystem::path>& locks = {});

/// The values that agree with what is printed, from `low` to `high`; nan for words.
struct Range {
  double low, high;
};
Range allowed(const Claim& claim);

/// One condition of a criterion: `fact` is above (or below) `limit`, a number or the name of another fact.
struct Condition {
  std::string fact;
  bool above;
  std::string limit;

  /// What is left to the limit: positive on the right side; nan if a fact is missing.
  Estimate left(const Facts& facts) const;
};
std::vector<Condition> conditions(const Claim& claim);

/// The verdict on a row, which may be covered by another one of `all`.
std::string verdict(const Claim& claim, const Claims& all, const Facts& facts);

/// What was found: the answer with its error, or every condition with what is left to its limit.
std::string found(const Claim& claim, const Facts& facts);

/// The program whose facts decide the row.
std::string program_of(const Claim& claim);

}  // namespace lattice
