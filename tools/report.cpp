/**
# The report

`report` compares every answer under the data folder with the article's statements, writes the table
*published against reproduced* and prints its summary. `report lock` renews `paper/converged.ecsv` and
prints what moved. `report refresh` writes the locked values into the prose of the sources and the
tables of README.md and ARTIFACT.md; with `--check` it only says whether there is something to do.
`report macros` writes the same values for the paper. */

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <map>

#include "lock.hpp"
#include "macros.hpp"
#include "refresh.hpp"
#include "report/claims.hpp"

using namespace lattice;
namespace fs = std::filesystem;

namespace {

/// Where things are; `root` is the folder with `src`, `paper` and `figures`.
struct Places {
  std::string root = ".", data = "build/data", out = "build/report";

  fs::path file(const char* name) const { return fs::path(root) / name; }
  fs::path published() const { return file("paper/published.ecsv"); }
  fs::path lock() const { return file("paper/converged.ecsv"); }
};

Table compare_all(const std::vector<Claim>& claims, const fs::path& data) {
  const auto answers = read_answers(data);
  Table table{
      {label("id", "identifier"), label("where", "place in the article"),
       label("quantity", "what is claimed"), label("published", "value or statement as printed"),
       number("reproduced", "converged value; 1 or 0 where the unit is claim"),
       number("error", "error of the reproduced value"),
       label("unit", "unit of the reproduced value; claim for yes or no"),
       label("verdict", "reproduced, holds, discrepant, measured, unresolved or open"),
       label("program", "program that answers"), label("reason", "likely cause of a discrepancy")}};
  for (const Claim& c : claims) {
    const auto found = answers.find({c.program, c.id});
    const bool open = found == answers.end();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    table.add({c.id, c.where, c.quantity, c.printed, open ? nan : found->second.value,
               open ? nan : found->second.error,
               open || found->second.unit.empty() ? c.unit : found->second.unit,
               open ? std::string("open") : verdict(c, found->second), c.program, c.reason});
  }
  return table;
}

/**
The summary counts the verdicts and names what does not agree. */
void print_summary(const Table& table) {
  std::map<std::string, int> tally;
  for (const auto& v : table.texts("verdict")) ++tally[v];
  std::printf(
      "claims     : %d reproduced, %d hold, %d measured, %d discrepant, %d unresolved, %d open\n",
      tally["reproduced"], tally["holds"], tally["measured"], tally["discrepant"],
      tally["unresolved"], tally["open"]);
  const auto id = table.texts("id"), verdicts = table.texts("verdict");
  const auto printed = table.texts("published"), unit = table.texts("unit");
  const auto value = table.numbers("reproduced"), error = table.numbers("error");
  for (std::size_t i = 0; i < id.size(); ++i)
    if (verdicts[i] == "discrepant" && unit[i] == "claim")
      std::printf("  %-10s %-22s printed %s, does not hold by our criterion\n", verdicts[i].c_str(),
                  id[i].c_str(), printed[i].c_str());
    else if (verdicts[i] == "discrepant" || verdicts[i] == "unresolved")
      std::printf("  %-10s %-22s printed %s, converged %.6g +- %.1g %s\n", verdicts[i].c_str(),
                  id[i].c_str(), printed[i].c_str(), value[i], error[i], unit[i].c_str());
}

void report(const Places& places) {
  Table table = compare_all(read_claims(places.published()), places.data);
  table.meta = {{"program", "report"}, {"build", LATTICE_BUILD}};
  fs::create_directories(places.out);
  write(fs::path(places.out) / "published.ecsv", table);
  print_summary(table);
}

/**
## Renewing the lock

Whoever renews it has to see what they sign: every value that moved, in units of its error. */
void print(const Difference& d) {
  const char* id = d.id.c_str();
  const char* program = d.program.c_str();
  if (d.what == Difference::What::added)
    std::printf("  new      %s %s: %s\n", program, id, shown(d.fresh).c_str());
  if (d.what == Difference::What::missing)
    std::printf("  gone     %s %s: was %s\n", program, id, shown(d.locked).c_str());
  if (d.what == Difference::What::moved)
    std::printf("  moved    %s %s: %s -> %s, %.3g of the sum of the errors%s\n", program, id,
                number_text(d.locked.value).c_str(), number_text(d.fresh.value).c_str(), d.distance,
                d.distance > 1 ? "  <- outside" : "");
}

void lock(const Places& places) {
  const auto programs = programs_of(places.file("src"));
  const Findings locked = fs::exists(places.lock()) ? read_lock(places.lock()) : Findings{};
  const Findings fresh = renewed(locked, read_findings(places.data, programs), programs);
  const auto changes = differences(locked, fresh);
  for (const auto& d : changes) print(d);
  write(places.lock(), lock_table(fresh));
  std::printf("lock       : %zu values, %zu changes, in %s\n", fresh.size(), changes.size(),
              places.lock().string().c_str());
}

/**
## Refreshing the prose

Files are rewritten only where a text changes, so that nothing is compiled again without need. */
std::string text_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + path.string());
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

int renew(const fs::path& path, const std::string& text, bool check) {
  if (text == text_of(path)) return 0;
  if (!check) write_whole(path, text);
  std::printf("  %s  %s\n", check ? "stale" : "renewed", path.string().c_str());
  return 1;
}

std::map<std::string, double> measured_costs(const fs::path& folder) {
  std::map<std::string, double> out;
  if (!fs::exists(folder)) return out;
  for (const auto& entry : fs::directory_iterator(folder))
    if (std::ifstream in(entry.path()); in) in >> out[entry.path().filename().string()];
  return out;
}

/// Returns how many files differ.
int refresh(const Places& places, bool check) {
  const auto claims = read_claims(places.published());
  const Findings findings = read_lock(places.lock());
  const auto numbers = quotable(findings, claims);
  int changed = 0;
  for (const auto& entry : fs::recursive_directory_iterator(places.file("src"))) {
    const auto extension = entry.path().extension();
    if (extension != ".cpp" && extension != ".hpp") continue;
    try {
      changed += renew(entry.path(), with_numbers(text_of(entry.path()), numbers), check);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(entry.path().string() + ": " + error.what());
    }
  }
  const auto index = places.file("figures/figures.ecsv");
  const auto costs = measured_costs(fs::path(places.out) / "cost");
  const std::string figures = with_costs(text_of(index), costs);
  std::istringstream rows(figures);
  changed += renew(index, figures, check);
  const auto tables = generated_tables(claims, findings, from_text(rows));
  for (const char* name : {"README.md", "ARTIFACT.md"})
    changed += renew(places.file(name), fresh_page(text_of(places.file(name)), tables), check);
  return changed;
}

/**
## Numbers for the paper

A reference to nothing is found here, in the paper's own words, before TeX is called. */
std::vector<std::string> dangling_in(const fs::path& folder, const PaperTexts& texts,
                                     const std::set<std::string>& programs) {
  std::vector<std::string> out;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".tex") continue;
    const std::string paper = text_of(entry.path()), needed = chapter_needed(paper);
    if (!needed.empty() && !programs.count(needed)) continue;
    for (const auto& reference : dangling(paper, texts))
      out.push_back(entry.path().string() + ": nothing is there for " + reference);
  }
  std::sort(out.begin(), out.end());
  return out;
}

void macros(const Places& places) {
  const auto claims = read_claims(places.published());
  const Findings findings = read_lock(places.lock());
  const Table figures = read(places.file("figures/figures.ecsv"));
  const auto programs = programs_of(places.file("src"));
  const PaperTexts texts = paper_texts(claims, findings, figures);
  if (const auto missing = dangling_in(places.file("paper"), texts, programs); !missing.empty()) {
    for (const auto& line : missing) std::cerr << line << '\n';
    throw std::runtime_error(std::to_string(missing.size()) +
                             " references without a value (a new number: make lock)");
  }
  fs::create_directories(places.out);
  write_whole(fs::path(places.out) / "numbers.tex", paper_macros(texts, figures, programs));
  write_whole(fs::path(places.out) / "claims.tex", claim_rows(claims, findings));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Published against reproduced", "report"};
  Places places;
  bool check = false;
  app.add_option("--root", places.root, "folder of the repository")->capture_default_str();
  app.add_option("--data", places.data, "folder with one folder of tables a program")
      ->capture_default_str();
  app.add_option("--out", places.out, "folder for published.ecsv, and of the costs")
      ->capture_default_str();
  app.require_subcommand(0, 1)->fallthrough();
  CLI::App* locking = app.add_subcommand("lock", "renew paper/converged.ecsv, print what moved");
  CLI::App* refreshing = app.add_subcommand("refresh", "write the locked values into the prose");
  refreshing->add_flag("--check", check, "only say what would change; exit code 1 if anything");
  CLI::App* paper = app.add_subcommand("macros", "write the locked values for the paper to --out");
  try {
    app.parse(argc, argv);
    if (locking->parsed())
      lock(places);
    else if (refreshing->parsed())
      return refresh(places, check) > 0 && check;
    else if (paper->parsed())
      macros(places);
    else
      report(places);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    std::cerr << "report: " << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "report: " << error.what() << '\n';
    return 1;
  }
}
