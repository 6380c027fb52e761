// Nothing dangles: every figure has its script, program and tables, every claim and figure named in the
// prose exists, and the sources keep the shape that CONTRIBUTING.md asks for. That numbers in prose are the
// locked ones is asked in lineage/tests.

#include <algorithm>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "answers.hpp"
#include "check.hpp"
#include "shape.hpp"

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

/// The files under `folder` with one of the extensions, relative to the root, in a fixed order.
std::vector<fs::path> files(const std::string& folder, const std::set<std::string>& extensions) {
  std::vector<fs::path> out;
  for (const auto& entry : fs::recursive_directory_iterator(root / folder))
    if (extensions.count(entry.path().extension().string()))
      out.push_back(fs::relative(entry.path(), root));
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<fs::path> sources() {
  return files("src", {".cpp", ".hpp"});
}

/// All matches of the first group of `pattern` in `text`.
std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
  std::vector<std::string> out;
  const std::regex expression(pattern);
  for (std::sregex_iterator it(text.begin(), text.end(), expression), end; it != end; ++it)
    out.push_back((*it)[1]);
  return out;
}

/// What breaks a rule in `file` is told with its lines.
void none(const fs::path& file, const std::vector<std::string>& offences) {
  for (const auto& offence : offences) FAIL_CHECK(file.string() + ": " + offence);
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

TEST_CASE("every chapter has its cost", "[lineage]") {
  const Table costs = read(root / "bench/costs.ecsv");
  std::vector<std::string> chapters;
  for (const auto& path : files("src", {".cpp"}))
    if (path.parent_path() == "src") chapters.push_back(path.stem().string());
  CHECK(costs.texts("program") == chapters);
  for (const double seconds : costs.numbers("seconds")) CHECK(seconds >= 0);
}

TEST_CASE("every script draws from tables that its row names", "[lineage]") {
  const Table figures = read(root / "figures/figures.ecsv");
  const auto script = figures.texts("script"), tables = figures.texts("data");
  for (std::size_t i = 0; i < script.size(); ++i)
    for (const auto& name : matches(text_of(root / "figures" / script[i]), "/(\\w+)\\.ecsv")) {
      CAPTURE(script[i], name);
      CHECK((" " + tables[i] + " ").find(" " + name + " ") != std::string::npos);
    }
}

TEST_CASE("figures named in the prose exist", "[lineage]") {
  const auto figures = ids_of_figures();
  for (const auto& path : sources())
    for (const auto& id : matches(text_of(root / path), "\\]\\(fig:(\\w+)\\)")) {
      CAPTURE(path, id);
      CHECK(figures.count(id) == 1);
    }
}

TEST_CASE("claims named in a chapter are rows", "[lineage]") {
  const auto ids = read_claims(root / "paper/published.ecsv");
  for (const auto& path : sources())
    for (const auto& id :
         matches(text_of(root / path),
                 "`((?:thm|dps|newton|pn|floquet|pinning|moving|"
                 "impact|boomeron|scale|beam|cantilever|pre|outlook|chain)\\.\\w+)`")) {
      CAPTURE(path, id);
      CHECK(ids.count(id) == 1);
    }
}

TEST_CASE("no page of code is without a title", "[lineage]") {
  for (const auto& path : sources()) none(path, unreadable(text_of(root / path)));
}

TEST_CASE("equations are cited by the article's numbers", "[lineage]") {
  std::vector<fs::path> all{"README.md", "CONTRIBUTING.md"};
  for (const char* folder : {"src", "tests", "tools", "bench", "figures"})
    for (const auto& path : files(folder, {".cpp", ".hpp", ".py", ".gp", ".ecsv"}))
      all.push_back(path);
  for (const auto& path : all) none(path, misquoted(text_of(root / path)));
}

TEST_CASE("includes obey the order of the rooms, and a shelf uses no other", "[lineage]") {
  Includes library, shelves;
  for (const auto& path : sources()) {
    const std::string file = fs::relative(path, "src").string();
    if (file.find('/') == std::string::npos) continue;  // a chapter
    (file.rfind("lattice/", 0) == 0 || file.rfind("report/", 0) == 0 ? library : shelves)[file] =
        matches(text_of(root / path), "#include +([<\"][^>\"]+[>\"])");
  }
  CHECK(library.size() > 20);
  CHECK_FALSE(shelves.empty());
  for (const auto& offence : forbidden_arrows(library)) FAIL_CHECK(offence);
  for (const auto& offence : foreign_shelves(shelves)) FAIL_CHECK(offence);
  for (const auto& circle : circles(library)) FAIL_CHECK(circle);
}

TEST_CASE("no two headers of the library define one type", "[lineage]") {
  std::map<std::string, std::string> texts;
  for (const auto& path : files("src/lattice", {".hpp"}))
    texts[path.string()] = text_of(root / path);
  for (const auto& name : defined_twice(texts)) FAIL_CHECK(name);
}

TEST_CASE("no verdict without its margins", "[lineage]") {
  for (const auto& path : sources()) {
    CAPTURE(path);
    CHECK((path == fs::path("src/report/program.cpp") ||
           text_of(root / path).find(".claim(") == std::string::npos));
  }
}

TEST_CASE("the drawing in CONTRIBUTING.md shows every room and every shelf", "[lineage]") {
  const std::string text = text_of(root / "CONTRIBUTING.md");
  for (const auto& entry : fs::directory_iterator(root / "src/lattice")) {
    CAPTURE(entry.path());
    CHECK(floor_of(entry.path().filename().string()) >= 0);
  }
  for (const auto& [room, floor] : floors()) {
    CAPTURE(room, floor);
    CHECK(text.find("[" + room + "]") != std::string::npos);
  }
  const auto drawn = matches(text, "\\b(sec\\w+)(?=[,:])");
  for (const auto& entry : fs::directory_iterator(root / "src")) {
    const std::string name = entry.path().filename().string();
    CAPTURE(name);
    if (entry.is_directory() && name.rfind("sec", 0) == 0)
      CHECK(std::count(drawn.begin(), drawn.end(), name) > 0);
  }
}

TEST_CASE("the pages link to files that exist", "[lineage]") {
  for (const char* name : {"README.md", "ARTIFACT.md", "CONTRIBUTING.md"})
    for (const auto& link : matches(text_of(root / name), "(?:\\]\\(|src=\")([^)\"]+)[)\"]")) {
      CAPTURE(name, link);
      if (link.find(':') == std::string::npos && link.front() != '#')
        CHECK(fs::exists(root / link.substr(0, link.find('#'))));
    }
}
