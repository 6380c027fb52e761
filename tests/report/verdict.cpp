// The judge: a print is met, missed, covered, or not decided; a criterion holds by more than the errors.

#include "report/verdict.hpp"

#include <cmath>

#include "report/table.hpp"
#include "support/check.hpp"
#include "support/scratch.hpp"

using namespace lattice;

namespace {

Claim printing(const std::string& printed, const std::string& tolerance,
               const std::string& kind = "converged") {
  Claim claim;
  claim.id = "a.one", claim.printed = printed, claim.tolerance = tolerance, claim.kind = kind;
  claim.answer = "sec1_demo.one";
  return claim;
}

std::string on(const char* printed, const char* tolerance, double value, double error = 0,
               const char* kind = "converged") {
  return verdict(printing(printed, tolerance, kind), {}, {{"sec1_demo.one", {value, error}}});
}

std::string on(const std::string& criterion, const Facts& facts) {
  Claim claim;
  claim.criterion = criterion;
  return verdict(claim, {}, facts);
}

}  // namespace

TEST_CASE("a print is met, missed, or not decided", "[unit]") {
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
  CHECK(on("excellent", "", 0.1, 0.01, "claim") == "quantified");
  CHECK(verdict(printing("1", "rel 1e-2"), {}, {}) == "unresolved");  // without the fact
  Claim claim = printing("1", "rel 1e-2");
  const Facts one{{"sec1_demo.one", {1, 0}}};
  claim.assumption = "something that is not printed";
  CHECK(verdict(claim, {}, one) == "reproduced, assuming");
  claim.covered_by = "method";
  CHECK(verdict(claim, {}, one) == "quantified");
  CHECK_THROWS_AS(allowed(printing("1", "rel")), std::invalid_argument);
  CHECK_THROWS_AS(allowed(printing("1", "abs -1")), std::invalid_argument);
}

TEST_CASE("the article's own accuracy covers what is not farther", "[unit]") {
  const auto barrier = [](double accuracy, double error) {
    Claim claim = printing("1.77e-11", "rel 5e-3");
    claim.covered_by = "sec1_demo.accuracy";
    return verdict(
        claim, {claim},
        {{"sec1_demo.one", {1.62e-11, 1e-19}}, {"sec1_demo.accuracy", {accuracy, error}}});
  };
  CHECK(barrier(1.6e-12, 5e-14) == "within its own accuracy");
  CHECK(barrier(1.4e-12, 5e-14) == "discrepant");
  CHECK(barrier(1.6e-12, 2e-13) == "discrepant");
  CHECK(barrier(std::nan(""), 0) == "discrepant");
}

TEST_CASE("a power of a missed number follows from it", "[unit]") {
  const auto energy = [](const char* covered, double found, double threshold) {
    Claim kick = printing("6.19e-6", "rel 1e-2"), claim = printing("1.92e-11", "rel 2e-2");
    kick.id = "a.kick", kick.answer = "sec1_demo.kick", claim.covered_by = covered;
    return verdict(claim, {kick, claim},
                   {{"sec1_demo.one", {found, 1e-15}}, {"sec1_demo.kick", {threshold, 1e-10}}});
  };
  CHECK(energy("a.kick^2", 9.909e-12, 4.4518e-6) == "follows");
  CHECK(energy("a.kick", 9.909e-12, 4.4518e-6) == "discrepant");
  CHECK(energy("a.kick^2", 1.2e-11, 4.4518e-6) == "discrepant");
  CHECK(energy("a.kick^2", 9.909e-12, 6.19e-6) == "discrepant");
}

TEST_CASE("a criterion holds by more than the errors", "[unit]") {
  const Facts facts{{"p.a", {1.2, 0.1}},
                    {"p.b", {0.9, 0.1}},
                    {"p.c", {1.05, 0.1}},
                    {"p.none", {std::nan(""), 0}}};
  CHECK(on("p.a > 1", facts) == "holds");
  CHECK(on("p.a > 1; p.a > p.b", facts) == "holds");
  CHECK(on("p.a > 1; p.a < p.b", facts) == "discrepant");
  CHECK(on("p.c > 1", facts) == "unresolved");
  CHECK(on("p.a > p.c", facts) == "unresolved");  // both errors count
  CHECK(on("p.c > 1; p.b > 1.2", facts) == "unresolved");
  CHECK(on("p.a > 1; p.none < 5", facts) == "unresolved");
  CHECK(on("p.a > 1; p.lost > 0", facts) == "unresolved");
  for (const char* wrong : {"p.a >= 1", "p.a > ", "a > 1", "p.a > 1,2", "p.a > x"})
    CHECK_THROWS_AS(on(wrong, facts), std::invalid_argument);
}

TEST_CASE("a list that could not be judged is refused with its row", "[unit]") {
  const Claims good = read_claims(SOURCE_DIR "/paper/claims.ecsv");
  CHECK(good.size() == 115);
  const Table table = read(SOURCE_DIR "/paper/claims.ecsv");
  Scratch scratch;
  const auto refused = [&](const std::string& column, const std::string& text) {
    Table changed = table;
    changed.rows[1][changed.find(column)] = text;
    write(scratch.path / "claims.ecsv", changed);
    return refusal<std::runtime_error>([&] { read_claims(scratch.path / "claims.ecsv"); });
  };
  for (const auto& [column, text, said] : std::vector<std::array<std::string, 3>>{
           {"tolerance", "rel x", "the tolerance 'rel x' is unknown"},
           {"criterion", "a.b > 1", "either an answer or a criterion is needed, not both"},
           {"answer", "here", "'here' is not the name of a fact"},
           {"status", "fine", "the status 'fine' is unknown"},
           {"reason", "they erred", "a row needs a reason if it is missed"},
           {"id", "thm.mean_force", "two rows have this id"}}) {
    CAPTURE(column, text);
    check_line(refused(column, text), said);
    check_line(refused(column, text), "claims.ecsv: row 2: ");
  }
}
