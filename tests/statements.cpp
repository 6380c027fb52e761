// Published against reproduced: every row of the lists of claims, findings and numbers of others, judged on the files from
// which the figures are drawn. And no row is one that cannot fail: with a comparison on the other side, or with another
// value in a table, the verdict is another one.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "lattice/integrators/integrate.hpp"
#include "report/table.hpp"
#include "report/verdict.hpp"
#include "support/check.hpp"
#include "support/scratch.hpp"

using namespace lattice;
using namespace report;

namespace fs = std::filesystem;

namespace {

/// The folder of the tables, which `make figures` computes, or `make beyond`.
fs::path tables_of_run() {
  if (!fs::exists(DATA_DIR)) FAIL("there are no tables in " DATA_DIR ": make figures");
  return DATA_DIR;
}

/// What is recorded of a row: its verdict, and of one that holds in part how often it fails.
struct Decision {
  std::string verdict;
  int failures;
  bool operator==(const Decision&) const = default;
};
Decision decision(const Case& one, const Cases& all) {
  return {verdict(one, all), one.found.failures()};
}

/// What is decided if one of the comparisons, or of the controls, had the other outcome.
Decision flipped(Case one, std::vector<Comparison> Judged::*of, std::size_t comparison,
                 const Cases& all) {
  (one.found.*of)[comparison].is_flipped = true;
  return decision(one, all);
}

/// The verdict on a row if its answer were farther from the printed number than anything allowed, and nothing covered it.
std::string far_away(Case one, const Cases& all) {
  const auto [low, high] = allowed(one.claim);
  Quantity& answer = *one.found.answer;
  answer.value = high + 2 * (answer.error + std::abs(high)) + (std::isfinite(low) ? high - low : 0);
  one.claim.covered_by.clear(), one.found.accuracy.reset(), one.found.readings.clear();
  return verdict(one, all);
}

/// Whether the verdict becomes another decided one when what stands in the tables is another number: with the other sign,
/// twice or half as large; a count also one larger; an answer that is missed also as it is printed.
bool follows(const Case& one, const Cases& all, Tables& tables, const Change& cells) {
  const auto differs = [&](double factor, double offset) {
    tables.change = cells;
    tables.change->factor = factor, tables.change->offset = offset;
    const Decision now = decision({one.claim, statements().at(one.claim.id).judge(tables)}, all);
    tables.change.reset();
    return now != decision(one, all) && now.verdict != "unresolved";
  };
  const Table& table = tables.of(cells.program, cells.table);
  if (table.columns[table.find(cells.column)].kind == Kind::integer && differs(1, 1)) return true;
  if (one.found.answer && one.claim.status == "discrepant" &&
      differs(0, (allowed(one.claim).low + allowed(one.claim).high) / 2))
    return true;
  return differs(-1, 0) || differs(2, 0) || differs(0.5, 0);
}

/// A column as a whole, or, where that moves both sides of a comparison alike, one of its cells; of many two dozen are tried.
bool follows(const Case& one, const Cases& all, Tables& tables, const CellRead& column) {
  const auto& [program, table, name, row] = column;
  if (follows(one, all, tables, Change{program, table, name})) return true;
  std::vector<std::size_t> rows;
  for (const CellRead& cell : one.found.cells)
    if (cell.program == program && cell.table == table && cell.column == name)
      rows.push_back(cell.row);
  const std::size_t every = 1 + rows.size() / 24;
  for (std::size_t i = 0; i < rows.size(); i += every)
    if (follows(one, all, tables, Change{program, table, name, rows[i]})) return true;
  return false;
}

}  // namespace

TEST_CASE("statements", "[statements]") {
  static Tables tables(tables_of_run());  // once, and not for each section
  static const Cases all = judge(VOLUME_DIR, tables);
  for (const Case& one : all) DYNAMIC_SECTION(one.claim.list << ": " << one.claim.id) {
      const auto range = allowed(one.claim);
      CAPTURE(one.claim.printed, one.claim.tolerance, range.low, range.high, one.found.text());
      CHECK(one.found.not_run.empty());
      CHECK_FALSE(one.found.is_quick);
      CHECK(verdict(one, all) == one.claim.status);
      for (std::size_t i = 0; i < one.found.comparisons.size(); ++i)
        CHECK(flipped(one, &Judged::comparisons, i, all) != decision(one, all));
      for (std::size_t i = 0; i < one.found.controls.size(); ++i)
        CHECK(flipped(one, &Judged::controls, i, all).verdict == "unresolved");
      if (one.claim.status == "reproduced, assuming") CHECK_FALSE(one.found.readings.empty());
      // No reading is the answer again
      for (const OtherReading& other : one.found.readings)
        if (other.value) CHECK(other.value->value != one.found.answer->value);
      if (one.found.answer && one.claim.status != "quantified")
        CHECK(far_away(one, all) == "discrepant");
    }
}

TEST_CASE("a verdict follows the values that it was read from", "[statements]") {
  Tables tables(tables_of_run());
  const Cases all = judge(VOLUME_DIR, tables);
  const Table exceptions = read(VOLUME_DIR "/tests/insensitive.ecsv");
  std::set<std::pair<std::string, std::string>> listed;
  for (std::size_t i = 0; i < exceptions.rows.size(); ++i)
    listed.emplace(exceptions.texts("id")[i], exceptions.texts("value")[i]);
  for (const Case& one : all) {
    if (one.claim.status == "quantified") continue;  // nothing is decided
    std::set<CellRead> columns;
    for (CellRead cell : one.found.cells) {
      cell.row = 0;
      columns.insert(cell);
    }
    for (const CellRead& column : columns) {
      const std::string name = column.table + "." + column.column;
      const bool is_listed = listed.erase({one.claim.id, name}) > 0;
      CAPTURE(one.claim.id, name);
      CHECK(follows(one, all, tables, column) != is_listed);
    }
  }
  for (const auto& [id, value] : listed) FAIL_CHECK(id << " does not read " << value);
}

TEST_CASE("a table that is cut short decides nothing", "[statements]") {
  Tables tables(tables_of_run());
  const Cases all = judge(VOLUME_DIR, tables);
  for (const Case& one : all) {
    std::map<std::pair<std::string, std::string>, std::size_t> read;  // the last row of each
    for (const CellRead& cell : one.found.cells) {
      std::size_t& last = read[{cell.program, cell.table}];
      last = std::max(last, cell.row);
    }
    for (const auto& [of, last] : read) {
      const auto& [program, table] = of;
      const std::size_t rows = tables.of(program, table).rows.size();
      CAPTURE(one.claim.id, table, rows);
      tables.cut(program, table, std::min<std::size_t>(last, 1));
      CHECK(statements().at(one.claim.id).judge(tables).lost != "");
      tables.restore();
    }
  }
}

TEST_CASE("every row has its statement, and every statement its row", "[statements]") {
  Tables tables(tables_of_run());
  Scratch scratch;
  const fs::path list = scratch.path / "paper/findings.ecsv";
  fs::create_directory(scratch.path / "paper");
  Table rows = read(VOLUME_DIR "/paper/findings.ecsv");
  rows.rows[0][rows.find("id")] = "none.such";
  write(list, rows);
  check_line(refusal<std::runtime_error>([&] { judge(scratch.path, tables); }),
             "none.such: no statement in src/statements judges it");
  rows.rows.erase(rows.rows.begin());
  write(list, rows);
  check_line(refusal<std::runtime_error>([&] { judge(scratch.path, tables); }),
             "no list has such a row");
}

TEST_CASE("readings are those that are listed, and all of them", "[statements]") {
  if (!fs::exists(VOLUME_DIR "/paper/readings.ecsv")) return;
  Tables tables(tables_of_run());
  Scratch scratch;
  fs::copy(VOLUME_DIR "/paper", scratch.path / "paper", fs::copy_options::recursive);
  const fs::path list = scratch.path / "paper/readings.ecsv";
  const Table whole = read(list);
  const auto refuses = [&](const Table& rows, const char* said) {
    write(list, rows);
    check_line(refusal<std::runtime_error>([&] { judge(scratch.path, tables); }), said);
  };
  Table fewer = whole, more = whole, twice = whole;
  fewer.rows.pop_back();
  refuses(fewer, "is not listed");
  more.rows.push_back(whole.rows[0]);
  more.rows.back()[more.find("reading")] = "none such";
  refuses(more, "the reading 'none such' is not computed");
  twice.rows.push_back(whole.rows[0]);
  refuses(twice, "two rows of");
}

TEST_CASE("what was observed names its range in its sentence", "[statements]") {
  const Table rows = read(VOLUME_DIR "/paper/findings.ecsv");
  const auto kind = rows.texts("kind"), sentence = rows.texts("sentence"),
             range = rows.texts("range");
  CHECK(rows.rows.size() <= 30);
  for (std::size_t i = 0; i < kind.size(); ++i)
    if (kind[i] == "observed")
      CHECK(sentence[i].find(range[i].substr(0, range[i].find(';'))) != std::string::npos);
}

TEST_CASE("the ring of figure 26 starts from the phonon of Eq. (39), and arrives", "[statements]") {
  const Table table = read(tables_of_run() / "sec4_precompression_mi/modulated_ring.ecsv");
  const auto start = table.numbers("y_start"), end = table.numbers("y");
  REQUIRE(start.size() == 200);
  const double q = M_PI / 4, v1 = 1.5 * std::sqrt(0.5),
               omega = std::sqrt(1 + 2 * v1 * (1 - std::cos(q)));
  const Table splitting = read(tables_of_run() / "sec4_precompression_mi/splitting.ecsv");
  check_close(splitting.numbers("round").at(0), 200 * omega / (v1 * std::sin(q)), 1e-10);
  State<double> state(200);
  for (std::size_t i = 0; i < 200; ++i) {
    const double n = double(i + 1), size = 0.15 * (1 + 0.01 * std::cos(M_PI * n / 100));
    state.y[i] = size * std::sin(q * n), state.v[i] = -omega * size * std::cos(q * n);
    check_close(start[i], state.y[i], 1e-14);
  }
  // Another splitting and another step come to the same state
  const Chain ring{200, Quartic{-1.0 / 6}, CompressedHertz{0.5}, Ends::periodic};
  evolve(Splitting{blanes_moan_6(), 0.1}, ring, state, 6619);
  for (std::size_t i = 0; i < 200; ++i) check_close(end[i], state.y[i], 1e-5);
}
