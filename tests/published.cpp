// Published against reproduced: every answered row of paper/published.ecsv has the status that is
// recorded there, judged on the files from which the figures are drawn.

#include <algorithm>
#include <set>

#include "certain.hpp"
#include "check.hpp"
#include "claims.hpp"
#include "lock.hpp"

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
    CHECK(std::set<std::string>{"open", "reproduced", "holds", "measured", "discrepant"}.count(
        claim.status));
  }
  for (const auto& [key, answer] : read_answers(data)) {
    CAPTURE(key.first, key.second);
    REQUIRE(rows.count(key.second));
    CHECK(rows[key.second].program == key.first);
  }
}

TEST_CASE("the summary and the book judge as the tests do", "[published]") {
  const Table summary = read(root / "build/report/published.ecsv");
  const auto id = summary.texts("id"), given = summary.texts("verdict");
  const auto value = summary.numbers("reproduced"), error = summary.numbers("error");
  const auto answers = read_answers(data);
  const auto claims = read_claims(root / "paper/published.ecsv");
  REQUIRE(id.size() == claims.size());
  for (std::size_t i = 0; i < claims.size(); ++i) {
    CAPTURE(claims[i].id);
    INFO("stale, or lineage/claims.py and tests/claims.hpp differ: make summary");
    CHECK(id[i] == claims[i].id);
    const auto found = answers.find({claims[i].program, claims[i].id});
    if (found == answers.end()) {
      CHECK(given[i] == "open");
      continue;
    }
    CHECK(given[i] == verdict(claims[i], found->second));
    CHECK(value[i] == found->second.value);
    CHECK(error[i] == found->second.error);
  }
}

TEST_CASE("what we found stays what we found", "[published]") {
  const auto programs = programs_of(root / "src");
  const Findings locked = read_lock(root / "paper/converged.ecsv");
  const Findings fresh = read_findings(data, programs);
  CHECK(locked.size() > programs.size());
  for (const auto& program : programs) {
    CAPTURE(program);
    CHECK(fs::exists(data / program / "results.ecsv"));
  }
  for (const auto& [key, was] : locked) {
    const auto now = fresh.find(key);
    CAPTURE(key.first, key.second, was.value, was.error);
    INFO("a value moved or is missing; if that is meant: make lock");
    REQUIRE(now != fresh.end());
    CAPTURE(now->second.value, now->second.error);
    CHECK(distance(was, now->second) <= 1);
  }
}

TEST_CASE("a value is locked within the sum of the errors", "[unit]") {
  const auto finding = [](double value, double error, std::string unit = "",
                          std::string kind = "value") {
    return Finding{value, error, std::move(unit), std::move(kind)};
  };
  const double eps = 1e-16;
  CHECK(distance(finding(1, 1e-3), finding(1.0019, 1e-3)) < 1);
  CHECK(distance(finding(1, 1e-3), finding(1.0021, 1e-3)) > 1);
  CHECK(distance(finding(1.62e-11, 1e-20), finding(1.77e-11, 1e-20)) > 1e7);
  CHECK(distance(finding(1, 0), finding(1 + 5 * eps, 0)) < 1);
  CHECK(distance(finding(1, 0), finding(1 + 1e-11, 0)) > 1);
  CHECK(distance(finding(1, 0, "claim"), finding(0, 0, "claim")) > 1);
  CHECK(distance(finding(1, 0, "claim"), finding(1, 0, "")) > 1);
  CHECK(distance(finding(1, 1), finding(std::nan(""), 1)) > 1);
  CHECK(distance(finding(1, 1), finding(1.5, std::nan(""))) > 1);
  CHECK(distance(finding(std::nan(""), 1), finding(std::nan(""), 1)) == 0);
  CHECK(distance(finding(3e-16, 0, "", "residue"), finding(2e-15, 0)) < 1);
  CHECK(distance(finding(3e-16, 0, "", "residue"), finding(-4e-15, 0)) > 1);
  CHECK(distance(finding(0, 0, "", "residue"), finding(3e-16, 0)) < 1);
}

TEST_CASE("what is plotted is known to one per cent, and says where it comes from", "[published]") {
  for (const auto& entry : fs::recursive_directory_iterator(data)) {
    if (entry.path().extension() != ".ecsv") continue;
    const Table table = read(entry.path());
    CAPTURE(entry.path());
    for (const char* key : {"program", "section", "command", "revision", "build"})
      CHECK(std::any_of(table.meta.begin(), table.meta.end(),
                        [&](const auto& pair) { return pair.first == key; }));
    for (const auto& doubt : doubts(table)) FAIL_CHECK(doubt);
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
}

TEST_CASE("words are answered by yes or no, or measured", "[unit]") {
  Claim words = numeric("visually equal", "");
  words.kind = "claim";
  CHECK(verdict(words, {1, 0, "claim"}) == "holds");
  CHECK(verdict(words, {0, 0, "claim"}) == "discrepant");
  CHECK(verdict(words, {0.5, 0, "claim"}) == "unresolved");
  CHECK(verdict(words, {1, 0.1, "claim"}) == "unresolved");
  CHECK(verdict(words, {5.3e-12, 2e-12, "relative"}) == "measured");
  CHECK(verdict(words, {1, 0, ""}) == "measured");
  CHECK(verdict(words, {std::nan(""), 0, ""}) == "unresolved");
  Claim moves = numeric("moves", "");
  moves.kind = "statistical";
  CHECK(verdict(moves, {1, 0, "claim"}) == "holds");
  // A number in words ("7 sites") may be confirmed; a printed value wants a value.
  Claim sites = numeric("7", "");
  CHECK(verdict(sites, {1, 0, "claim"}) == "unresolved");
  sites.kind = "claim";
  CHECK(verdict(sites, {1, 0, "claim"}) == "holds");
}

TEST_CASE("certainty is asked for point by point", "[unit]") {
  const auto with = [](std::vector<double> x, std::vector<double> error, std::string note = "") {
    Table t{{number("x", "a quantity"), number("x_error", "two resolutions" + note)}};
    for (std::size_t i = 0; i < x.size(); ++i) t.add({x[i], error[i]});
    return doubts(t).size();
  };
  const double nan = std::nan("");
  CHECK(with({1, 1e-6}, {1e-3, 1e-9}) == 0);
  CHECK(with({1, 1e-6}, {1e-3, 1e-7}) == 1);  // far below the largest, but ten per cent of its own
  CHECK(with({1, 1e-6}, {1e-3, 1e-7}, ", against the largest of the column") == 0);
  CHECK(with({1, -0.5, 1e-4, 0.5, 1}, {1e-3, 1e-3, 1e-3, 1e-3, 1e-3}) == 1);
  CHECK(with({1, -0.5, 1e-4, 0.5, 1}, {1e-3, 1e-3, 1e-3, 1e-3, 1e-3},
             ", against the neighbouring rows") == 0);
  CHECK(with({1, 1e-3, 1e-6, 1e-9}, {1e-4, 1e-4, 1e-4, 1e-4}, ", against the neighbouring rows") >
        0);
  CHECK(with({1, 1e-6}, {1e-3, 1e-3}, " (relative)") == 0);
  CHECK(with({1, 1e-6}, {1e-3, 2e-2}, " (relative)") == 1);
  CHECK(with({nan, nan}, {nan, nan}) > 0);
  CHECK(with({nan, nan}, {nan, nan}, "; nan where it has left") > 0);
  CHECK(with({1, nan}, {1e-3, nan}, "; nan where it has left") == 0);
  CHECK(with({1, nan}, {1e-3, nan}) == 1);
  CHECK(with({1, 1}, {1e-3, nan}) == 1);
  CHECK(with({1, 1}, {1e-3, -1e-3}) == 1);
  CHECK(with({1, 1}, {0, 0}) == 1);  // two identical runs are no convergence
  CHECK(with({1, 1}, {0, 0}, ", exact") == 0);
}
