/**
# Published against reproduced

This program ends `make figures`. It reads the list of claims of a volume (`paper/claims.ecsv`), what we found
(`paper/findings.ecsv`) and what other authors print (`paper/literature.ecsv`), judges every row by its statement
(statement.hpp, verdict.hpp), writes a table of all verdicts and prints what does not agree. Beside the table
`claims.ecsv` are all comparisons (`claims_comparisons.ecsv`) and all other readings (`claims_readings.ecsv`). Each
volume has its own, with the statements of its own chapters. */

#include <cstdio>
#include <iostream>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "report/command_line.hpp"
#include "report/program.hpp"
#include "report/verdict.hpp"

namespace fs = std::filesystem;
using namespace report;

namespace {

Table table_of(const Cases& rows) {
  Table out;
  for (const Case& one : rows) {
    const auto& [claim, found] = one;
    const Estimate none = undefined;
    out.add(
        {{"list", "claims of the article, our findings, or literature", claim.list},
         {"id", "identifier", claim.id},
         {"where", "place in the article", claim.where},
         {"quantity", "what is claimed", claim.quantity},
         {"printed", "value or statement as printed", claim.printed},
         {"value", "converged value; nan where comparisons decide",
          found.answer ? found.answer->value : none.value},
         {"error", "error of the value", found.answer ? found.answer->error : none.error},
         {"unit", "unit of value and error", found.answer ? found.answer->unit : ""},
         {"comparisons", "how many there are", std::int64_t(found.comparisons.size())},
         {"failures", "how many of them fail", std::int64_t(found.failures())},
         {"verdict", "verdict, as explained in paper/verdicts.ecsv", verdict(one, rows)},
         {"found", "the value, or up to three comparisons, of more the closest one", found.text()},
         {"state", "judged here; not run: the recorded verdict; quick: from coarse tables",
          !found.not_run.empty() ? "not run"
          : found.is_quick       ? "quick"
                                 : "judged"},
         {"program", "program whose tables decide", found.program}});
  }
  return out;
}

/// What other choices give where the article prints none, and half and twice of each bound of ours.
Table table_of_readings(const Cases& rows, const Choices& choices) {
  Table out;
  for (const auto& [claim, found] : rows)
    for (const OtherReading& other : found.readings) {
      const Estimate value = other.value ? Estimate(*other.value) : undefined;
      out.add({{"id", "statement", claim.id},
               {"reading", "name of the choice, or a bound of ours that is halved or doubled",
                other.name},
               {"choice", "what is chosen, and why it is natural",
                other.is_bound ? "a bound of ours" : choices.at({claim.id, other.name})},
               {"value", "value of a number; nan of an assertion", value.value},
               {"error", "error of the value", value.error},
               {"unit", "unit of value and error", other.value ? other.value->unit : ""},
               {"outcome",
                "a number is met, missed or undecided; an assertion holds, fails or both; empty "
                "beside words",
                outcome(other, claim)}});
    }
  return out;
}

/// All that decides: the sides of every comparison, with the cells that were read for it.
Table table_of_comparisons(const Cases& rows) {
  Table out;
  const auto add = [&](const Claim& claim, const char* role, const std::string& cells,
                       const Estimate& small, const Estimate& large, const char* outcome) {
    out.add({{"id", "statement", claim.id},
             {"role", "answer; claim: of the statement; control: of the measure", role},
             {"cells", "cells of the tables that were read for it", cells},
             {"small", "the side that has to be smaller, or the answer", small.value},
             {"small_error", "its error", small.error},
             {"large", "the other side; nan of an answer", large.value},
             {"large_error", "its error", large.error},
             {"outcome", "holds, fails or undecided; empty of an answer", outcome}});
  };
  const auto word = [](const Comparison& c) {
    return c.holds() ? "holds" : c.fails() ? "fails" : "undecided";
  };
  for (const auto& [claim, found] : rows) {
    if (found.answer) add(claim, "answer", found.answered_by, *found.answer, undefined, "");
    for (const Comparison& c : found.comparisons)
      add(claim, "claim", c.what, c.small, c.large, word(c));
    for (const Comparison& c : found.controls)
      add(claim, "control", c.what, c.small, c.large, word(c));
  }
  return out;
}

/// Prints a list: how many rows have each verdict, and those that do not agree with what is printed.
void print(const std::string& list, const std::string& title, const Cases& rows) {
  std::map<std::string, std::vector<const Case*>> by;
  int all = 0, quick = 0;
  for (const Case& one : rows) {
    if (one.claim.list != list) continue;
    by[verdict(one, rows)].push_back(&one);
    ++all, quick += one.found.is_quick;
  }
  if (all > 0) std::printf("%-11s: %d\n", title.c_str(), all);
  if (quick > 0) return void(std::printf("  quick, not compared      %3d\n", quick));
  for (const std::string word : verdict_words) {
    if (by.count(word)) std::printf("  %-24s %3d\n", word.c_str(), int(by[word].size()));
    if (is_met(word)) continue;
    for (const Case* one : by[word])
      std::printf(
          "    %-22s %s%s\n", one->claim.id.c_str(),
          one->claim.printed.empty() ? "" : ("printed " + one->claim.printed + ", ours ").c_str(),
          one->found.text().c_str());
  }
}

/// Judges the lists of the volume in `root`.
void judge_all(const fs::path& root, const fs::path& data, const fs::path& to) {
  if (!fs::is_directory(data))
    throw UsageError("--data: '" + data.string() +
                     "' is not a folder (allowed: one that holds a folder of tables per program)");
  if (!fs::exists(root / "paper/findings.ecsv"))
    throw UsageError("--root: '" + root.string() +
                     "' has no list of claims (allowed: a folder with paper/claims.ecsv)");
  Tables tables(data);
  const Cases rows = judge(root, tables);
  for (const auto& [list, title] :
       {std::pair{"claims", "statements"}, {"findings", "findings"}, {"literature", "others"}})
    print(list, title, rows);
  std::set<std::string> absent;
  for (const Case& one : rows) absent.insert(one.found.not_run);
  absent.erase("");
  if (!absent.empty()) std::printf("not run    : recorded verdicts are shown for");
  for (const std::string& program : absent) std::printf(" %s", program.c_str());
  if (!absent.empty()) std::printf("\n");
  const auto write_to = [](const fs::path& path, Table table) {
    table.meta = {{"program", "verdicts"}};
    if (table.rows.empty())
      fs::remove(path);
    else
      write(path, table);
  };
  const auto beside = [&](const char* what) {
    return to.parent_path() / (to.stem().string() + what + ".ecsv");
  };
  write_to(to, table_of(rows));
  write_to(beside("_readings"), table_of_readings(rows, read_choices(root)));
  write_to(beside("_comparisons"), table_of_comparisons(rows));
}

}  // namespace

/// Reads the line, judges, and answers bad input with one line.
int main(int argc, char** argv) {
  return exit_code("verdicts", [&] {
    std::string root = ".", data = "build/data", output = "build/report/claims.ecsv";
    std::deque<Offer> offers(1);
    offers[0].meaning = "compares published with reproduced values: one verdict per statement";
    offers[0].note =
        "Each statement of src/statements is judged on the tables in --data; where a program has "
        "not run, the recorded verdict is shown.";
    Parameters& p = offers[0].parameters;
    p.add("root", root, "folder of the volume, with its paper/claims.ecsv", not_empty());
    p.add("data", data, "folder that holds one folder of tables per program", not_empty());
    p.add("output", output, "table of the verdicts to write", not_empty());
    const Asked asked = read_line(offers, {argv + 1, argv + argc});
    if (asked.what == Asked::What::run)
      judge_all(root, data, output);
    else if (asked.what == Asked::What::version)
      std::cout << "verdicts " LATTICE_VERSION "\n";
    else if (asked.what == Asked::What::describe)
      std::cout << to_text(description("verdicts", offers));
    else
      std::cout << help_text("verdicts", offers, offers[0]);
  });
}
