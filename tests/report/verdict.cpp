// The judge: a print is met, missed, covered, or not decided; comparisons hold by more than the errors.

#include "report/verdict.hpp"

#include <cmath>

#include "report/table.hpp"
#include "support/check.hpp"
#include "support/scratch.hpp"

using namespace report;

namespace {

Case printing(const std::string& printed, const std::string& tolerance, const Estimate& ours) {
  Case one;
  one.claim.id = "a.one", one.claim.printed = printed, one.claim.tolerance = tolerance;
  one.found.answer = Quantity{{ours}};
  return one;
}

std::string on(const char* printed, const char* tolerance, double value, double error = 0) {
  return verdict(printing(printed, tolerance, {value, error}), {});
}

}  // namespace

TEST_CASE("a print is met, missed, or not decided", "[unit]") {
  CHECK(on("9e-4", "about", 9.9e-4, 1e-6) == "reproduced");
  CHECK(on("9e-4", "", 9.4e-4, 1e-6) == "reproduced");
  CHECK(on("9e-4", "", 9.6e-4, 1e-6) == "discrepant");
  CHECK(on("9e-4", "cut", 9.6e-4, 1e-6) == "reproduced");
  CHECK(on("9e-4", "", 9.4e-4, 1e-4) == "unresolved");
  CHECK(on("9e-4", "", 9e-4, std::nan("")) == "unresolved");
  CHECK(on("1.5e-9", "at most", 1e-14) == "reproduced");
  CHECK(on("1.5e-9", "at most", 1e-8) == "discrepant");
  CHECK(on("1e-14 to 1e-15", "order of magnitude", 3e-14) == "reproduced");
  CHECK(on("1e-14 to 1e-15", "order of magnitude", 3.3e-14) == "discrepant");
  CHECK(on("3 to 4 orders", "order of magnitude", 310) == "discrepant");
  CHECK(on("-1e-3", "order of magnitude", -2e-3) == "reproduced");
  CHECK(on("-1e-3", "order of magnitude", -4e-3) == "discrepant");
  CHECK(on("3 pi/2", "exact", 4.71238898038469) == "reproduced");
  CHECK(on("-0.53", "", -0.5349) == "reproduced");
  CHECK(on("-0.53", "", -0.5351) == "discrepant");
  CHECK(on("192", "exact", 192 + 1e-9) != "reproduced");
  CHECK(on("2030", "about", 2031.1) == "in part");  // a digit is a digit
  CHECK(on("excellent", "", 0.1, 0.01) == "quantified");
  for (const char* none : {"rel 1e-2", "abs 5e-3", "roughly"})
    CHECK_THROWS_AS(allowed(printing("1", none, 1).claim), std::invalid_argument);
}

TEST_CASE("a row that is not judged keeps its verdict, and one that is lost has none", "[unit]") {
  Case one = printing("1", "", 1);
  one.claim.assumption = "something that is not printed";
  CHECK(verdict(one, {}) == "reproduced, assuming");
  one.claim.covered_by = "method";
  CHECK(verdict(one, {}) == "quantified");
  one.claim.status = "discrepant", one.found.not_run = "sec1_demo";
  CHECK(verdict(one, {}) == "discrepant");  // as recorded
  one.found.not_run.clear(), one.found.lost = "no such table";
  CHECK(verdict(one, {}) == "unresolved");
  one.found.lost.clear(), one.found.controls = {{"", 2, 1}};
  CHECK(verdict(one, {}) == "unresolved");
}

TEST_CASE("all but the last of three digits is in part", "[unit]") {
  CHECK(on("5.446e-4", "about", 5.4449e-4, 1e-9) == "in part");
  CHECK(on("5.446e-4", "about", 5.4481e-4, 0) == "discrepant");
  CHECK(on("5.4e-4", "about", 5.55e-4, 0) == "discrepant");  // two digits
  CHECK(on("0.054", "about", 0.0556, 0) == "discrepant");    // zeros in front are none
  CHECK(on("5.446e-4", "", 5.4449e-4, 1e-7) == "unresolved");
}

TEST_CASE("an assertion holds, holds in part or not, and may assume something", "[unit]") {
  const auto with = [](std::vector<Comparison> ours, std::optional<Outcome> other) {
    Case one;
    one.found.comparisons = std::move(ours);
    if (other) one.found.readings = {{"another", {}, other}};
    return verdict(one, {});
  };
  const Comparison good{"", 1, 2}, bad{"", 2, 1}, open{"", Estimate(1, 1), Estimate(1.5, 1)};
  CHECK(with({good, good}, Outcome::holds) == "holds");
  CHECK(with({good}, Outcome::in_part) == "holds, assuming");
  CHECK(with({good}, Outcome::undecided) == "holds, assuming");
  CHECK(with({good, bad}, {}) == "in part");
  CHECK(with({good, bad}, Outcome::holds) == "in part");
  CHECK(with({bad}, Outcome::fails) == "discrepant");
  CHECK(with({bad}, Outcome::in_part) == "quantified");
  Case one;
  one.found.comparisons = {good, bad};
  one.found.readings = {{"2 in the place of 1", {}, Outcome::holds, true}};
  CHECK(verdict(one, {}) == "quantified");  // only our bound speaks against it
  CHECK(with({good, open}, {}) == "unresolved");
  CHECK(with({bad, open}, {}) == "unresolved");
  CHECK(with({good, bad, open}, {}) == "in part");
}

TEST_CASE("the list of verdicts has the words that are passed", "[unit]") {
  const Table list = read(SOURCE_DIR "/paper/verdicts.ecsv");
  const auto words = list.texts("verdict"), met = list.texts("met");
  CHECK(words == std::vector<std::string>(std::begin(verdict_words), std::end(verdict_words)));
  for (std::size_t k = 0; k < words.size(); ++k) CHECK(is_met(words[k]) == (met[k] == "yes"));
}

TEST_CASE("the article's own accuracy covers what is not farther", "[unit]") {
  const auto barrier = [](double accuracy, double error) {
    Case one = printing("1.77e-11", "about", {1.62e-11, 1e-19});
    one.found.accuracy = Quantity{{Estimate(accuracy, error)}};
    return verdict(one, {});
  };
  CHECK(barrier(1.6e-12, 5e-14) == "within its own accuracy");
  CHECK(barrier(1.4e-12, 5e-14) == "discrepant");
  CHECK(barrier(1.6e-12, 2e-13) == "unresolved");
  CHECK(barrier(std::nan(""), 0) == "unresolved");
}

TEST_CASE("a power of a missed number follows from it", "[unit]") {
  const auto energy = [](const char* covered, double found, double threshold) {
    Case kick = printing("6.19e-6", "about", {threshold, 1e-10}),
         one = printing("1.92e-11", "about", {found, 1e-15});
    kick.claim.id = "a.kick", one.claim.covered_by = covered;
    return verdict(one, {kick, one});
  };
  CHECK(energy("a.kick^2", 9.909e-12, 4.4518e-6) == "follows");
  CHECK(energy("a.kick", 9.909e-12, 4.4518e-6) == "discrepant");
  CHECK(energy("a.kick^2", 1.2e-11, 4.4518e-6) == "discrepant");
  CHECK(energy("a.kick^2", 9.909e-12, 6.19e-6) == "discrepant");
  CHECK(energy("a.none^2", 9.909e-12, 4.4518e-6) == "discrepant");
}

TEST_CASE("a list that could not be judged is refused with its row", "[unit]") {
  const Claims good = read_claims(SOURCE_DIR "/paper/claims.ecsv");
  CHECK(good.size() > 100);
  const Table table = read(SOURCE_DIR "/paper/claims.ecsv");
  Scratch scratch;
  const auto refused = [&](const std::string& column, const std::string& text) {
    Table changed = table;
    changed.rows[1][changed.find(column)] = text;
    write(scratch.path / "claims.ecsv", changed);
    return refusal<std::runtime_error>([&] { read_claims(scratch.path / "claims.ecsv"); });
  };
  for (const auto& [column, text, said] : std::vector<std::array<std::string, 3>>{
           {"tolerance", "rel 1e-2", "the tolerance 'rel 1e-2' is unknown"},
           {"status", "fine", "the status 'fine' is unknown"},
           {"reason", "they erred", "a row needs a reason if it is missed"},
           {"id", "thm.mean_force", "two rows have this id"}}) {
    CAPTURE(column, text);
    check_line(refused(column, text), said);
    check_line(refused(column, text), "claims.ecsv: row 2: ");
  }
}

TEST_CASE("a reading of a row without verdict is met or missed", "[unit]") {
  Case one = printing("0.76", "about", 0.76);
  one.claim.covered_by = "method";
  CHECK(outcome({"x", Quantity{Estimate(0.9, 1e-6)}}, one.claim) == "missed");
  CHECK(outcome({"x", Quantity{Estimate(0.76, 1e-6)}}, one.claim) == "met");
  CHECK(outcome({"x", Quantity{Estimate(0.77, 0.1)}}, one.claim) == "undecided");
  one.claim.printed = "robust";
  CHECK(outcome({"x", Quantity{Estimate(0.77, 0.1)}}, one.claim).empty());
}

TEST_CASE("a number is discrepant if it is missed by more than its readings spread", "[unit]") {
  const auto with = [](double error, const Estimate& other) {
    Case one = printing("0.76", "about", {0.83, error});
    one.found.readings = {{"another", Quantity{other}}};
    return verdict(one, {});
  };
  CHECK(with(1e-6, {0.80, 1e-6}) == "discrepant");
  CHECK(with(1e-6, {0.76, 1e-6}) == "quantified");
  CHECK(with(0.003, {0.891, 1e-6}) == "unresolved");
  CHECK(with(1e-6, {0.9, 10}) == "unresolved");
  CHECK(with(1e-6, {0.9, 1e-6}) == "quantified");
  CHECK(on("5.446e-4", "about", 5.4442e-4, 5e-8) == "unresolved");
}

TEST_CASE("nothing follows from a number that is met, lost or not certain", "[unit]") {
  Case kick = printing("6.2e-6", "about", {6.28e-6, 1e-10}),
       one = printing("1.9e-11", "about", {2.01e-11, 1e-15});
  kick.claim.id = "a.kick", one.claim.covered_by = "a.kick^2";
  CHECK(verdict(one, {kick, one}) == "discrepant");
  kick.found.answer = Quantity{Estimate(4.45e-6, 1e-10)};
  one.found.answer = Quantity{Estimate(9.9e-12, 1e-15)};
  CHECK(verdict(one, {kick, one}) == "follows");
  kick.found.lost = "x";
  CHECK(verdict(one, {kick, one}) == "discrepant");
  kick.found.lost.clear(), kick.found.controls = {{"", 2, 1}};
  CHECK(verdict(one, {kick, one}) == "discrepant");
}
