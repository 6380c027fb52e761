// Published against reproduced: every row of the lists of claims, findings and numbers of others, judged on the files from
// which the figures are drawn. And no row is one that cannot fail: with a fact on the other side of its limit, or without it,
// the verdict is another one.

#include <cmath>
#include <filesystem>

#include "lattice/integrators/integrate.hpp"
#include "report/table.hpp"
#include "report/verdict.hpp"
#include "support/check.hpp"

using namespace lattice;

namespace fs = std::filesystem;

namespace {

/// The folder of the tables, which `make figures` computes, or `make beyond`.
fs::path tables_of_run() {
  if (!fs::exists(DATA_DIR)) FAIL("there are no tables in " DATA_DIR ": make figures");
  return DATA_DIR;
}

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
  const Facts facts = read_facts(tables_of_run());
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

TEST_CASE("no number of a program is without an error unless it is exact", "[published]") {
  for (const auto& folder : fs::directory_iterator(tables_of_run())) {
    const fs::path file = folder.path() / "facts.ecsv";
    if (!fs::exists(file)) continue;
    const Table t = read(file);
    const auto label = t.texts("quantity"), kind = t.texts("kind");
    const auto value = t.numbers("value"), error = t.numbers("error");
    for (std::size_t i = 0; i < kind.size(); ++i) {
      CAPTURE(file.string(), label[i], error[i], kind[i]);
      if (kind[i] == "exact")
        CHECK(error[i] == 0);
      else
        CHECK((error[i] > 0 || std::isnan(value[i])));
    }
  }
}

TEST_CASE("the ring of figure 26 starts from the phonon of Eq. (39), and arrives", "[published]") {
  const Table table = read(tables_of_run() / "sec4_precompression_mi/modulated_ring.ecsv");
  const auto start = table.numbers("y_start"), end = table.numbers("y");
  REQUIRE(start.size() == 200);
  const double q = M_PI / 4, v1 = 1.5 * std::sqrt(0.5),
               omega = std::sqrt(1 + 2 * v1 * (1 - std::cos(q)));
  const Fact round = read_facts(tables_of_run()).at("sec4_precompression_mi.splitting_round");
  check_close(round.value, 200 * omega / (v1 * std::sin(q)), 1e-10);
  State<double> state(200);
  for (std::size_t i = 0; i < 200; ++i) {
    const double n = double(i + 1), size = 0.15 * (1 + 0.01 * std::cos(M_PI * n / 100));
    state.y[i] = size * std::sin(q * n), state.v[i] = -omega * size * std::cos(q * n);
    check_close(start[i], state.y[i], 1e-14);
  }
  // Another splitting and another step come to the same state
  const Chain ring{200, Quartic{-1.0 / 6}, CompressedHertz{0.5}, Ends::periodic};
  evolve(Splitting{blanes_moan_6(), 0.1}, ring, state, 6619, 6619);
  for (std::size_t i = 0; i < 200; ++i) check_close(end[i], state.y[i], 1e-5);
}
