// Published against reproduced: every answered row of paper/published.ecsv is judged on the files from which the
// figures are drawn, here (judge.hpp) and by `lineage summary`; both have to come to the status that is recorded.

#include <algorithm>
#include <set>

#include "answers.hpp"
#include "certain.hpp"
#include "check.hpp"
#include "judge.hpp"
#include "report/checksum.hpp"

using namespace lattice;
namespace fs = std::filesystem;

namespace {

const fs::path root = SOURCE_DIR, data = DATA_DIR;

}  // namespace

TEST_CASE("published", "[published]") {
  const auto answers = read_findings(data);
  const auto claims = read_claims(root / "paper/published.ecsv");
  const Table judged = read(root / "build/report/published.ecsv");
  const auto id = judged.texts("id"), verdict = judged.texts("verdict");
  const auto value = judged.numbers("reproduced"), error = judged.numbers("error");
  REQUIRE(std::set<std::string>(id.begin(), id.end()).size() == claims.size());
  for (std::size_t i = 0; i < id.size(); ++i) {
    REQUIRE(claims.count(id[i]));
    const Claim& claim = claims.at(id[i]);
    if (claim.status == "open") continue;
    DYNAMIC_SECTION(id[i]) {
      const auto found = answers.find({claim.program, id[i]});
      REQUIRE(found != answers.end());
      CAPTURE(claim.printed, claim.tolerance, found->second.value, found->second.error);
      REQUIRE(std::isfinite(found->second.value));
      REQUIRE(std::isfinite(found->second.error));
      INFO("if build/report/published.ecsv is older than the answers: make summary");
      CHECK(value[i] == found->second.value);
      CHECK(error[i] == found->second.error);
      CHECK(lattice::verdict(id[i], claims, answers) == claim.status);
      CHECK(verdict[i] == claim.status);
      const bool missed =
          std::set<std::string>{"within", "follows", "discrepant"}.count(claim.status);
      CHECK(missed != claim.reason.empty());
    }
  }
}

TEST_CASE("every answer belongs to a row, and every row to at most one program", "[lineage]") {
  const auto claims = read_claims(root / "paper/published.ecsv");
  for (const auto& [id, claim] : claims) {
    CAPTURE(id);
    CHECK((claim.status == "open") == claim.program.empty());
    CHECK(std::set<std::string>{"open", "reproduced", "holds", "within", "measured", "follows",
                                "discrepant"}
              .count(claim.status));
  }
  for (const auto& [key, answer] : read_findings(data, false)) {
    CAPTURE(key.first, key.second);
    REQUIRE(claims.count(key.second));
    CHECK(claims.at(key.second).program == key.first);
  }
}

TEST_CASE("a print is met, missed, covered, or not decided", "[unit]") {
  const auto claim = [](std::string printed, std::string tolerance,
                        std::string kind = "converged") {
    return Claim{"p", "", "", std::move(printed), std::move(kind), std::move(tolerance), ""};
  };
  const auto on = [&](const char* printed, const char* tolerance, double value, double error = 0,
                      const char* unit = "", const char* kind = "converged") {
    return verdict(claim(printed, tolerance, kind), Finding{value, error, unit});
  };
  CHECK(on("9e-4", "rel 5e-2", 9.2e-4, 1e-6) == "reproduced");
  CHECK(on("9e-4", "rel 5e-2", 9.6e-4, 1e-6) == "discrepant");
  CHECK(on("9e-4", "rel 5e-2", 9.2e-4, 1e-4) == "unresolved");
  CHECK(on("9e-4", "rel 5e-2", 9e-4, std::nan("")) == "unresolved");
  CHECK(on("1.5e-9", "at most", 1e-14) == "reproduced");
  CHECK(on("1.5e-9", "at most", 1e-8) == "discrepant");
  CHECK(on("1e-14 to 1e-15", "order of magnitude", 9e-14) == "reproduced");
  CHECK(on("1e-14 to 1e-15", "order of magnitude", 3e-13) == "discrepant");
  CHECK(on("3 to 4 orders", "order of magnitude", 99) == "discrepant");
  CHECK(on("3 pi/2", "rel 1e-12", 4.71238898038469) == "reproduced");
  CHECK(on("-0.53", "", -0.5349) == "reproduced");
  CHECK(on("-0.53", "", -0.5351) == "discrepant");
  CHECK(on("192", "exact", 192 + 1e-9) == "discrepant");
  CHECK(on("7", "", 1, 0, "claim") == "unresolved");
  CHECK(on("7 sites", "", 1, 0, "claim") == "holds");
  CHECK(on("stable", "", 0, 0, "claim", "claim") == "discrepant");
  CHECK(on("stable", "", 1, 0.1, "claim", "claim") == "unresolved");
  CHECK(on("excellent", "", 0.1, 0.01, "", "claim") == "measured");
  // The article's own accuracy covers what is not farther, and a power of a missed number follows from it
  const Finding barrier{1.62e-11, 1e-19, ""};
  CHECK(is_within(claim("1.77e-11", "rel 5e-3"), barrier, {1.6e-12, 5e-14, ""}));
  CHECK_FALSE(is_within(claim("1.77e-11", "rel 5e-3"), barrier, {1.4e-12, 5e-14, ""}));
  CHECK_FALSE(is_within(claim("1.77e-11", "rel 5e-3"), barrier, {1.6e-12, 2e-13, ""}));
  const Finding half{9.909e-12, 1e-15, ""}, threshold{4.4518e-6, 1e-10, ""};
  const auto kick = claim("6.19e-6", "rel 1e-2"), energy = claim("1.92e-11", "rel 2e-2");
  CHECK(follows(energy, half, kick, threshold, 2));
  CHECK_FALSE(follows(energy, half, kick, threshold, 1));
  CHECK_FALSE(follows(energy, {1.2e-11, 1e-15, ""}, kick, threshold, 2));
  CHECK_FALSE(follows(energy, half, kick, {6.19e-6, 1e-10, ""}, 2));
}

TEST_CASE("what we found stays what we found", "[published]") {
  const auto programs = programs_of(root / "src");
  const Findings locked = read_lock(root / "paper/converged.ecsv");
  const Findings fresh = read_findings(data);
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

TEST_CASE("every table is what its program wrote", "[published]") {
  for (const auto& program : programs_of(root / "src"))
    for (const auto& complaint : altered_tables(data / program)) FAIL_CHECK(complaint);
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
