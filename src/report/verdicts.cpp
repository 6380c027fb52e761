/**
# Published against reproduced

This program ends `make figures`. It reads the list of claims of a volume (`paper/claims.ecsv`), what we found
(`paper/findings.ecsv`) and what other authors print (`paper/literature.ecsv`), judges every row on the facts that the
programs have written (verdict.hpp), writes a table of all verdicts and prints what does not agree. */

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <set>

#include "report/command_line.hpp"
#include "report/files.hpp"
#include "report/verdict.hpp"

namespace fs = std::filesystem;
using namespace lattice;

namespace {

struct Judged {
  std::string list;
  const Claim* claim;
  std::string verdict, found;
  Fact ours;
};

/// All rows of a list, judged.
std::vector<Judged> judged(const std::string& list, const Claims& claims, const Facts& facts) {
  std::vector<Judged> out;
  for (const Claim& c : claims) {
    const auto ours = facts.find(c.answer);
    out.push_back({list, &c, verdict(c, claims, facts), found(c, facts),
                   ours == facts.end() ? Fact{std::nan(""), std::nan("")} : ours->second});
  }
  return out;
}

Table table_of(const std::vector<Judged>& rows) {
  Table out{label("list", "claims of the article, findings of ours, or literature"),
            label("id", "identifier"),
            label("where", "place in the article"),
            label("quantity", "what is claimed"),
            label("printed", "value or statement as printed"),
            number("value", "converged value; nan where conditions decide"),
            number("error", "its error"),
            label("unit", "its unit"),
            label("verdict", "as src/report/verdict.hpp explains"),
            label("found", "the answer, or every condition with what was found"),
            label("program", "program whose facts decide")};
  for (const Judged& r : rows)
    out.add({r.list, r.claim->id, r.claim->where, r.claim->quantity, r.claim->printed, r.ours.value,
             r.ours.error, r.ours.unit, r.verdict, r.found, program_of(*r.claim)});
  out.meta = {{"program", "verdicts"}};
  return out;
}

/// Prints a list: how many rows have each verdict, and those that do not agree with what is printed.
void print(const std::string& title, const std::vector<Judged>& rows) {
  std::printf("%-11s: %zu\n", title.c_str(), rows.size());
  for (const char* verdict : {"reproduced", "reproduced, assuming", "holds", "quantified",
                              "within its own accuracy", "follows", "discrepant", "unresolved"}) {
    const bool agrees =
        std::set<std::string>{"reproduced", "reproduced, assuming", "holds", "quantified"}.count(
            verdict);
    const auto has = [&](const Judged& r) { return r.verdict == verdict; };
    const auto many = std::count_if(rows.begin(), rows.end(), has);
    if (many > 0) std::printf("  %-24s %3d\n", verdict, int(many));
    for (const Judged& r : rows)
      if (has(r) && !agrees)
        std::printf(
            "    %-22s %s%s\n", r.claim->id.c_str(),
            r.claim->printed.empty() ? "" : ("printed " + r.claim->printed + ", ours ").c_str(),
            r.found.c_str());
  }
}

/// Judges the lists of the volume in `root`; volume two stands on the facts of both.
void judge(const fs::path& root, const fs::path& data, const fs::path& to) {
  const bool is_article = fs::exists(root / "paper/claims.ecsv");
  std::vector<fs::path> locks;
  for (const fs::path& volume : {root, is_article ? root : root / ".."})
    if (fs::exists(volume / "paper/converged.ecsv"))
      locks.push_back(volume / "paper/converged.ecsv");
  if (!fs::is_directory(data))
    throw UsageError("--data: '" + data.string() +
                     "' is no folder (allowed: one with a folder of tables a program)");
  const Facts facts = read_facts(data, locks);
  std::vector<Judged> all;
  std::deque<Claims> lists;
  std::set<std::string> absent;
  for (const auto& [list, title] :
       {std::pair{"claims", "statements"}, {"findings", "findings"}, {"literature", "others"}}) {
    const fs::path path = root / "paper" / (std::string(list) + ".ecsv");
    if (!fs::exists(path)) continue;
    const auto rows = judged(list, lists.emplace_back(read_claims(path)), facts);
    print(title, rows);
    all.insert(all.end(), rows.begin(), rows.end());
    for (const Judged& r : rows)
      if (!fs::exists(data / program_of(*r.claim) / "facts.ecsv"))
        absent.insert(program_of(*r.claim));
  }
  if (all.empty())
    throw UsageError("--root: '" + root.string() +
                     "' has no list of claims (allowed: a folder with paper/claims.ecsv)");
  if (!absent.empty()) std::printf("not run    : judged on locked values are");
  for (const std::string& program : absent) std::printf(" %s", program.c_str());
  if (!absent.empty()) std::printf("\n");
  write(to, table_of(all));
}

}  // namespace

/// Reads the line, judges, and answers bad input with one line.
int main(int argc, char** argv) {
  std::string root = ".", data = "build/data", output = "build/report/claims.ecsv";
  std::deque<Offer> offers(1);
  offers[0].meaning = "published against reproduced: a verdict on every statement";
  Parameters& p = offers[0].parameters;
  p.add("root", root, "folder of the volume, with its paper/claims.ecsv", not_empty());
  p.add("data", data, "folder with one folder of tables a program", not_empty());
  p.add("output", output, "table to write", not_empty());
  guard_channels();
  try {
    const Asked asked = read_line(offers, {argv + 1, argv + argc});
    if (asked.what == Asked::What::run)
      judge(root, data, output);
    else if (asked.what == Asked::What::version)
      std::cout << "verdicts " LATTICE_VERSION "\n";
    else
      std::cout << help_text(
          "verdicts", offers, offers[0],
          "A row is judged on the facts of the runs in --data, and "
          "where a program has not run on the locked ones, paper/converged.ecsv.");
    return 0;
  } catch (const UsageError& error) {
    std::cerr << "verdicts: " << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "verdicts: " << error.what() << '\n';
    return 1;
  }
}
