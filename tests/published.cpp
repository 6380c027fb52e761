// Published against reproduced: every answered row of paper/published.ecsv has the status that is
// recorded there, judged on the files from which the figures are drawn.

#include <algorithm>
#include <set>

#include "check.hpp"
#include "lattice/report/claims.hpp"

using namespace lattice;
namespace fs = std::filesystem;

namespace {

const fs::path root = SOURCE_DIR, data = DATA_DIR;

Claim numeric(const std::string& printed, const std::string& tolerance) {
  Claim c;
  c.printed = printed;
  c.tolerance = tolerance;
  c.kind = "converged";
  return c;
}

}  // namespace

TEST_CASE("published", "[published]") {
  const auto answers = read_answers(data);
  for (const Claim& claim : read_claims(root / "paper/published.ecsv")) {
    if (claim.status == "open") continue;
    DYNAMIC_SECTION(claim.id) {
      const auto found = answers.find({claim.program, claim.id});
      REQUIRE(found != answers.end());
      CAPTURE(claim.printed, claim.tolerance, found->second.value, found->second.error);
      REQUIRE(std::isfinite(found->second.value));
      REQUIRE(std::isfinite(found->second.error));
      CHECK(verdict(claim, found->second) == claim.status);
      if (claim.status == "discrepant") CHECK_FALSE(claim.reason.empty());
    }
  }
}

TEST_CASE("every answer belongs to a row, and every row to at most one program", "[lineage]") {
  std::map<std::string, Claim> rows;
  for (const Claim& claim : read_claims(root / "paper/published.ecsv")) {
    CAPTURE(claim.id);
    CHECK(rows.emplace(claim.id, claim).second);
    CHECK((claim.status == "open") == claim.program.empty());
    CHECK(std::set<std::string>{"open", "claim", "reproduced", "discrepant"}.count(claim.status));
  }
  for (const auto& [key, answer] : read_answers(data)) {
    CAPTURE(key.first, key.second);
    REQUIRE(rows.count(key.second));
    CHECK(rows[key.second].program == key.first);
  }
}

TEST_CASE("what is plotted is known to one per cent, and says where it comes from", "[published]") {
  for (const auto& entry : fs::recursive_directory_iterator(data)) {
    if (entry.path().extension() != ".ecsv") continue;
    const Table table = read(entry.path());
    CAPTURE(entry.path());
    for (const char* key : {"program", "section", "command", "revision", "build"})
      CHECK(std::any_of(table.meta.begin(), table.meta.end(),
                        [&](const auto& pair) { return pair.first == key; }));
    for (const Column& column : table.columns) {
      const auto at = column.name.rfind("_error");
      if (at == std::string::npos) continue;
      CAPTURE(column.name);
      double largest = 0, error = 0;
      for (double x : table.numbers(column.name.substr(0, at)))
        if (std::isfinite(x)) largest = std::max(largest, std::abs(x));
      for (double x : table.numbers(column.name))
        if (std::isfinite(x)) error = std::max(error, x);
      CHECK(error <= 0.01 * largest);
    }
  }
}

TEST_CASE("a verdict is not given away", "[unit]") {
  CHECK(verdict(numeric("9e-4", "rel 5e-2"), {9.2e-4, 1e-6, ""}) == "reproduced");
  CHECK(verdict(numeric("9e-4", "rel 5e-2"), {9.6e-4, 1e-6, ""}) == "discrepant");
  CHECK(verdict(numeric("9e-4", "rel 5e-2"), {9.2e-4, 1e-4, ""}) == "unresolved");
  CHECK(verdict(numeric("9e-4", "rel 5e-2"), {std::nan(""), 0, ""}) == "unresolved");
  CHECK(verdict(numeric("9e-4", "rel 5e-2"), {9e-4, std::nan(""), ""}) == "unresolved");
  CHECK(verdict(numeric("1.5e-9", "at most"), {1e-14, 0, ""}) == "reproduced");
  CHECK(verdict(numeric("1.5e-9", "at most"), {1e-8, 0, ""}) == "discrepant");
  CHECK(verdict(numeric("1e-14 to 1e-15", "order of magnitude"), {3e-15, 0, ""}) == "reproduced");
  CHECK(verdict(numeric("1e-14 to 1e-15", "order of magnitude"), {3e-13, 0, ""}) == "discrepant");
  CHECK(verdict(numeric("238 to 241", "abs 15"), {250, 1, ""}) == "reproduced");
  CHECK(verdict(numeric("3 to 4 orders", "order of magnitude"), {5e3, 1, ""}) == "reproduced");
  CHECK(verdict(numeric("3 pi/2", "rel 1e-12"), {4.71238898038469, 0, ""}) == "reproduced");
  CHECK(verdict(numeric("2", ""), {2.4, 0, ""}) == "reproduced");
  CHECK(verdict(numeric("2", ""), {2.6, 0, ""}) == "discrepant");
  CHECK(verdict(numeric("192", "exact"), {192, 0, ""}) == "reproduced");
  CHECK(verdict(numeric("visually equal", ""), {0, 0, "claim"}) == "discrepant");
  CHECK(verdict(numeric("visually equal", ""), {1, 0, "claim"}) == "claim");
}
