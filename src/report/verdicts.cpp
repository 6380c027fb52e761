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
#include "report/program.hpp"
#include "report/verdict.hpp"

namespace fs = std::filesystem;
using namespace lattice;

namespace {

struct Judged {
  std::string list;
  Claim claim;
  std::string verdict, found;
  Fact ours;
};

Table table_of(const std::vector<Judged>& rows) {
  Table out;
  for (const auto& [list, claim, verdict, found, ours] : rows)
    out.add({{"list", "claims of the article, our findings, or literature", list},
             {"id", "identifier", claim.id},
             {"where", "place in the article", claim.where},
             {"quantity", "what is claimed", claim.quantity},
             {"printed", "value or statement as printed", claim.printed},
             {"value", "converged value; nan where conditions decide", ours.value},
             {"error", "error of the value", ours.error},
             {"unit", "unit of value and error", ours.unit},
             {"verdict", "verdict, as explained in src/report/verdict.hpp", verdict},
             {"found", "the value, or every condition with the values found", found},
             {"program", "program whose facts decide", program_of(claim)}});
  out.meta = {{"program", "verdicts"}};
  return out;
}

/// Prints a list: how many rows have each verdict, and those that do not agree with what is printed.
void print(const std::string& title, const std::vector<Judged>& rows) {
  std::printf("%-11s: %zu\n", title.c_str(), rows.size());
  const std::vector<std::string> agree{"reproduced", "reproduced, assuming", "holds", "quantified"},
      others{"within its own accuracy", "follows", "discrepant", "unresolved"};
  const auto many = [&](const std::string& verdict) {
    const auto has = [&](const Judged& r) { return r.verdict == verdict; };
    const auto count = std::count_if(rows.begin(), rows.end(), has);
    if (count > 0) std::printf("  %-24s %3d\n", verdict.c_str(), int(count));
  };
  for (const std::string& verdict : agree) many(verdict);
  for (const std::string& verdict : others) {
    many(verdict);
    for (const Judged& r : rows)
      if (const std::string& printed = r.claim.printed; r.verdict == verdict)
        std::printf("    %-22s %s%s\n", r.claim.id.c_str(),
                    printed.empty() ? "" : ("printed " + printed + ", ours ").c_str(),
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
                     "' is not a folder (allowed: one that holds a folder of tables per program)");
  const Facts facts = read_facts(data, locks);
  std::vector<Judged> all;
  std::set<std::string> absent;
  for (const auto& [list, title] :
       {std::pair{"claims", "statements"}, {"findings", "findings"}, {"literature", "others"}}) {
    const fs::path path = root / "paper" / (std::string(list) + ".ecsv");
    if (!fs::exists(path)) continue;
    const Claims claims = read_claims(path);
    std::vector<Judged> rows;
    for (const Claim& c : claims) {
      const auto ours = facts.find(c.answer);
      rows.push_back({list, c, verdict(c, claims, facts), found(c, facts),
                      ours == facts.end() ? Fact{std::nan(""), std::nan("")} : ours->second});
      if (!fs::exists(data / program_of(c) / "facts.ecsv")) absent.insert(program_of(c));
    }
    print(title, rows);
    all.insert(all.end(), rows.begin(), rows.end());
  }
  if (all.empty())
    throw UsageError("--root: '" + root.string() +
                     "' has no list of claims (allowed: a folder with paper/claims.ecsv)");
  if (!absent.empty()) std::printf("not run    : reference values are used for");
  for (const std::string& program : absent) std::printf(" %s", program.c_str());
  if (!absent.empty()) std::printf("\n");
  write(to, table_of(all));
}

}  // namespace

/// Reads the line, judges, and answers bad input with one line.
int main(int argc, char** argv) {
  return exit_code("verdicts", [&] {
    std::string root = ".", data = "build/data", output = "build/report/claims.ecsv";
    std::deque<Offer> offers(1);
    offers[0].meaning = "compares published with reproduced values: one verdict per statement";
    offers[0].note =
        "A row is tested against the facts of the runs in --data; for a program that has not run, "
        "against the reference values in paper/converged.ecsv.";
    Parameters& p = offers[0].parameters;
    p.add("root", root, "folder of the volume, with its paper/claims.ecsv", not_empty());
    p.add("data", data, "folder that holds one folder of tables per program", not_empty());
    p.add("output", output, "table to write", not_empty());
    const Asked asked = read_line(offers, {argv + 1, argv + argc});
    if (asked.what == Asked::What::run)
      judge(root, data, output);
    else if (asked.what == Asked::What::version)
      std::cout << "verdicts " LATTICE_VERSION "\n";
    else
      std::cout << help_text("verdicts", offers, offers[0]);
  });
}
