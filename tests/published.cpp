// Published against reproduced: every row of the lists of claims, findings and numbers of others, judged on the files from
// which the figures are drawn. And no row is one that cannot fail: with a fact on the other side of its limit, or without it,
// the verdict is another one.

#include <cmath>
#include <filesystem>

#include "report/table.hpp"
#include "report/verdict.hpp"
#include "support/check.hpp"
#include "support/run.hpp"

using namespace lattice;

namespace fs = std::filesystem;

namespace {

/// The same facts with the one of a condition mirrored at its limit.
Facts mirrored(Facts facts, const Condition& c) {
  facts.at(c.fact).value -= 2 * (c.above ? 1 : -1) * c.left(facts).value;
  return facts;
}

/// The same facts with the answer farther from the printed number than anything allowed.
Facts far_away(Facts facts, const Claim& claim) {
  const auto [low, high] = allowed(claim);
  Fact& f = facts.at(claim.answer);
  f.value = high + 2 * (f.error + std::abs(high)) + (std::isfinite(low) ? high - low : 0);
  return facts;
}

/// A row as it would be without what covers it, and without what it assumes.
Claim bare(Claim claim) {
  claim.covered_by.clear();
  return claim;
}

}  // namespace

TEST_CASE("published", "[published]") {
  const Facts facts = read_facts(DATA_DIR);
  for (const std::string list : {"claims", "findings", "literature"}) {
    const fs::path path = VOLUME_DIR "/paper/" + list + ".ecsv";
    if (!fs::exists(path)) continue;
    const Claims claims = read_claims(path);
    for (const Claim& claim : claims) DYNAMIC_SECTION(list << ": " << claim.id) {
        const auto range = allowed(claim);
        CAPTURE(claim.printed, claim.tolerance, range.low, range.high, found(claim, facts));
        CHECK(verdict(claim, claims, facts) == claim.status);
        for (const Condition& c : conditions(claim)) {
          CAPTURE(c.fact);
          CHECK(facts.count(c.fact));
          CHECK(verdict(claim, claims, mirrored(facts, c)) != "holds");
          Facts without = facts;
          without.erase(c.fact);
          CHECK(verdict(claim, claims, without) == "unresolved");
        }
        if (claim.answer.empty()) continue;
        Facts none = facts;
        none.at(claim.answer).value = std::nan("");
        CHECK(verdict(claim, claims, none) == "unresolved");
        if (claim.status != "quantified")
          CHECK(verdict(bare(claim), claims, far_away(facts, claim)) == "discrepant");
      }
  }
}

TEST_CASE("what was observed names its range in its sentence", "[published]") {
  const Table rows = read(VOLUME_DIR "/paper/findings.ecsv");
  const auto kind = rows.texts("kind"), sentence = rows.texts("sentence"),
             range = rows.texts("range");
  CHECK(rows.rows.size() <= 30);
  for (std::size_t i = 0; i < kind.size(); ++i)
    if (kind[i] == "observed")
      CHECK(sentence[i].find(range[i].substr(0, range[i].find(';'))) != std::string::npos);
}

namespace {

const std::filesystem::path data = DATA_DIR, tables = data / "sec2_nonexistence";

double number_of(const std::filesystem::path& table, const std::string& name,
                 const std::string& column) {
  const Table t = read(table);
  return t.numbers(column)[row_of(t, name)];
}

double fact(const std::string& name) {
  return number_of(tables / "facts.ecsv", name, "value");
}

}  // namespace

TEST_CASE("searches are counted completely, and the free chain has no end but two",
          "[published][mean_force]") {
  const Table t = read(tables / "searches.ecsv");
  const double all = fact("searches");
  CHECK(all == 100);
  for (const Column& column : t.columns) {
    if (column.name == "ends_in") continue;
    double sum = 0;
    for (double x : t.numbers(column.name)) sum += x;
    CAPTURE(column.name);
    CHECK(sum == all);
  }
  for (const char* end : {"localized", "extended", "doubtful"})
    for (const char* column : {"free", "free_fine", "free_large", "free_large_fine"})
      CHECK(number_of(tables / "searches.ecsv", end, column) == 0);
  CHECK(number_of(tables / "searches.ecsv", "localized", "wells") > all / 20);
  CHECK(number_of(tables / "searches.ecsv", "extended", "walls") > all / 20);
}

TEST_CASE("what is not periodic is not mistaken for a motion of the free chain",
          "[published][mean_force]") {
  CHECK(fact("mean_force_spread_not_periodic") > 1e4 * fact("mean_force_spread_uneven_ring"));
}
