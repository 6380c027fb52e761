// Published against reproduced: every answered row of paper/published.ecsv is judged on the files from which the
// figures are drawn, here (judge.hpp) and by `lineage summary`; both have to come to the status that is recorded.

#include <set>

#include "answers.hpp"
#include "check.hpp"
#include "judge.hpp"

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
