// Nothing dangles: every figure has its script, program and tables, every reference in the prose
// exists, and the README shows the current figures and verdicts.

#include <algorithm>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "check.hpp"
#include "lattice/report/claims.hpp"

using namespace lattice;
namespace fs = std::filesystem;

namespace {

const fs::path root = SOURCE_DIR, data = DATA_DIR;

std::string text_of(const fs::path& path) {
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

std::set<std::string> ids_of_figures() {
  const auto ids = read(root / "figures/figures.ecsv").texts("id");
  return {ids.begin(), ids.end()};
}

std::vector<fs::path> sources() {
  std::vector<fs::path> out;
  for (const auto& entry : fs::recursive_directory_iterator(root / "src")) {
    const auto extension = entry.path().extension();
    if (extension == ".cpp" || extension == ".hpp") out.push_back(entry.path());
  }
  std::sort(out.begin(), out.end());
  return out;
}

/// All matches of the first group of `pattern` in `text`.
std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
  std::vector<std::string> out;
  const std::regex expression(pattern);
  for (std::sregex_iterator it(text.begin(), text.end(), expression), end; it != end; ++it)
    out.push_back((*it)[1]);
  return out;
}

}  // namespace

TEST_CASE("every figure has its script, program and tables", "[lineage]") {
  const Table figures = read(root / "figures/figures.ecsv");
  const auto id = figures.texts("id"), script = figures.texts("script");
  const auto program = figures.texts("program"), tables = figures.texts("data");
  for (std::size_t i = 0; i < id.size(); ++i) {
    CAPTURE(id[i]);
    CHECK(fs::exists(root / "figures" / script[i]));
    CHECK(fs::exists(root / "src" / (program[i] + ".cpp")));
    std::istringstream names(tables[i]);
    for (std::string name; names >> name;) {
      CAPTURE(name);
      const auto path = data / program[i] / (name + ".ecsv");
      REQUIRE(fs::exists(path));
      const Table table = read(path);
      CHECK_FALSE(table.rows.empty());
      for (const Column& column : table.columns) CHECK_FALSE(column.description.empty());
    }
  }
}

TEST_CASE("every script draws from tables that its row names", "[lineage]") {
  const Table figures = read(root / "figures/figures.ecsv");
  const auto script = figures.texts("script"), program = figures.texts("program"),
             tables = figures.texts("data");
  for (std::size_t i = 0; i < script.size(); ++i)
    for (const auto& name : matches(text_of(root / "figures" / script[i]), "/(\\w+)\\.ecsv")) {
      CAPTURE(script[i], name);
      CHECK((" " + tables[i] + " ").find(" " + name + " ") != std::string::npos);
    }
}

TEST_CASE("references in the prose exist", "[lineage]") {
  const auto figures = ids_of_figures();
  std::set<std::string> numbers;
  for (const auto& [key, answer] : read_answers(data)) numbers.insert(key.second);
  for (const auto& entry : fs::directory_iterator(data))
    if (fs::exists(entry.path() / "facts.ecsv"))
      for (const auto& q : read(entry.path() / "facts.ecsv").texts("quantity"))
        numbers.insert(entry.path().filename().string() + "." + q);
  for (const auto& path : sources()) {
    CAPTURE(path);
    const std::string text = text_of(path);
    for (const auto& id : matches(text, "\\]\\(fig:(\\w+)\\)")) {
      CAPTURE(id);
      CHECK(figures.count(id) == 1);
    }
    for (const auto& id : matches(text, "\\]\\(num:([\\w.]+)\\)")) {
      CAPTURE(id);
      CHECK(numbers.count(id) == 1);
    }
  }
}

TEST_CASE("claims named in a chapter are rows", "[lineage]") {
  std::set<std::string> ids;
  for (const Claim& claim : read_claims(root / "paper/published.ecsv")) ids.insert(claim.id);
  for (const auto& path : sources())
    for (const auto& id : matches(text_of(path),
                                  "`((?:thm|dps|newton|pn|floquet|pinning|moving|"
                                  "impact|boomeron|scale|beam|cantilever|pre)\\.\\w+)`")) {
      CAPTURE(path, id);
      CHECK(ids.count(id) == 1);
    }
}

TEST_CASE("prose blocks are short and end before long code", "[lineage]") {
  for (const auto& path : sources())
    for (const auto& block : matches(text_of(path), "/\\*\\*((?:[^*]|\\*(?!/))*)\\*/")) {
      CAPTURE(path, block);
      CHECK(std::count(block.begin(), block.end(), '\n') <= 36);
    }
}

TEST_CASE("the README shows the current figures and verdicts", "[lineage]") {
  const std::string readme = text_of(root / "README.md");
  const Table figures = read(root / "figures/figures.ecsv");
  for (const auto& id : figures.texts("id"))
    CHECK(readme.find("| " + id + " |") != std::string::npos);
  const auto answers = read_answers(data);
  for (const Claim& claim : read_claims(root / "paper/published.ecsv")) {
    if (claim.status == "open") continue;
    CAPTURE(claim.id, claim.status);
    CHECK(readme.find("| `" + claim.id + "` |") != std::string::npos);
  }
}
